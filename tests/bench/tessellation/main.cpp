// SPDX-License-Identifier: Apache-2.0
// Tessellation speed and size against factor (Moreton's figures 23 and 24), beside other ways to the same vertices, in
// one run. Usage: bench_tessellation [MODEL.bpt]; without it the teapot of the shared data, or a bumpy sheet.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "core/base/cpu.h"
#include "core/tessellation/tessellate.h"
#include "tests/bench/tessellation/rivals.h"
#include "tests/support/bezier_networks.h"

namespace {

using burin::bench::TimedWork;
using burin::geometry::BezierPatches;
using burin::tessellation::Factors;
using burin::tessellation::Options;
using burin::tessellation::Pattern;
using burin::tessellation::Surface;

constexpr std::uint32_t kSegments[] = {2, 4, 8, 16, 32, 64, 128, 256};
constexpr double kLeastMs = 60.0;  // that each figure is measured for

double NowMs() {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double MedianMs(const std::function<void()>& work) {
  work();
  std::vector<double> times;
  for (const double start = NowMs(); times.size() < 5 || (NowMs() - start < kLeastMs && times.size() < 3000);) {
    const double begin = NowMs();
    work();
    times.push_back(NowMs() - begin);
  }
  std::ranges::nth_element(times, times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2));
  return times[times.size() / 2];
}

std::string Rate(const TimedWork& work) {
  return work.run ? fmt::format("{:.1f}", work.triangles / 1e3 / MedianMs(work.run)) : "-";
}

BezierPatches Sheet() {
  BezierPatches patches;
  for (int n = 0; n < 32; ++n) {
    burin::test::AddQuad(patches, 4, 4, [&](int i, int j) {
      const float x = static_cast<float>(n % 8) + static_cast<float>(i) / 3.0f;
      const float y = static_cast<float>(n / 8) + static_cast<float>(j) / 3.0f;
      return glm::vec4(x, y, std::sin(1.7f * x) * std::cos(2.1f * y), 1.0f);
    });
  }
  return patches;
}

/// Ours, the ways it can be run.
class Runs {
 public:
  Runs(const BezierPatches& patches, std::uint32_t segments) : patches_(patches) {
    const float f = static_cast<float>(segments);
    factors_.assign(patches.patches.size(), Factors{f, f, f, f});
    // Each patch with factors of its own, as few less as it takes, so that no two share a pattern.
    for (std::size_t p = 0; p < factors_.size(); ++p) {
      const auto less = [&](std::size_t n) { return std::max(1.0f, f - static_cast<float>(n)); };
      various_.push_back({f, less(p % 6), f, less(p / 6)});
    }
  }
  /// Million triangles a second.
  double Rate(const Options& options) { return RateOf(factors_, options); }
  double RateOfVarious(const Options& options) { return RateOf(various_, options); }
  [[nodiscard]] const Surface& surface() const { return surface_; }

 private:
  double RateOf(const std::vector<Factors>& factors, const Options& options) {
    burin::tessellation::Tessellator kept;
    // A new one each time would share what it made for the first patch with the others of the same frame.
    const double ms = MedianMs([&] {
      if (&factors == &factors_) {
        kept.Tessellate(patches_, factors, options, surface_);
      } else {
        burin::tessellation::Tessellate(patches_, factors, options, surface_);
      }
    });
    return static_cast<double>(surface_.indices.size()) / 3e3 / ms;
  }

  const BezierPatches& patches_;
  std::vector<Factors> factors_, various_;
  Surface surface_;
};

double CopyRate(std::size_t bytes, double triangles) {
  std::vector<char> from(bytes, 1), to(bytes);
  return triangles / 1e3 / MedianMs([&] { std::memcpy(to.data(), from.data(), bytes); });
}

void PrintOurs(const BezierPatches& patches) {
  fmt::print("million triangles a second; positions and unit normals, but for the last column\n");
  fmt::print("{:>6} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9}\n", "factor", "integer", "kept", "various",
             "fract.", "portable", "all cpus", "all attr.", "memcpy", "of memcpy");
  for (const std::uint32_t segments : kSegments) {
    Runs runs(patches, segments);
    const Options one{
        .pattern = Pattern::kInteger, .wants_patch_uv = false, .wants_patch_ids = false, .is_parallel = false};
    Options fractional = one, portable = one, all = one, attributes = one, kept = one;
    kept.revision = 1;
    fractional.pattern = Pattern::kFractional;
    portable.uses_avx2 = false;
    all.is_parallel = true;
    attributes.wants_patch_uv = attributes.wants_patch_ids = attributes.wants_tangents = true;
    const double various = runs.RateOfVarious(one), attributes_rate = runs.Rate(attributes),
                 fractional_rate = runs.Rate(fractional), kept_rate = runs.Rate(kept),
                 portable_rate = runs.Rate(portable), all_rate = runs.Rate(all), integer = runs.Rate(one);
    const Surface& surface = runs.surface();
    const double copy = CopyRate(24 * surface.positions.size() + 4 * surface.indices.size(),
                                 static_cast<double>(surface.indices.size()) / 3.0);
    fmt::print("{:>6} {:>9.1f} {:>9.1f} {:>9.1f} {:>9.1f} {:>9.1f} {:>9.1f} {:>9.1f} {:>9.1f} {:>9.2f}\n", segments,
               integer, kept_rate, various, fractional_rate, portable_rate, all_rate, attributes_rate, copy,
               integer / copy);
    std::fflush(stdout);
  }
}

void PrintRivals(const BezierPatches& patches) {
  fmt::print("\nthe same by others (one thread, but for GL), and how many times as fast ours is\n");
  fmt::print("{:>6} {:>9} {:>9} {:>6} {:>9} {:>6} {:>9} {:>6} {:>9} {:>6} {:>9} {:>6}\n", "factor", "ours", "by vertex",
             "", "by row", "", "OSD patch", "", "OSD sten.", "", "GL", "");
  burin::bench::GlTessellation gl(patches);
  for (const std::uint32_t segments : kSegments) {
    Runs runs(patches, segments);
    burin::bench::PlainMesh mesh;
    const double triangles = 2.0 * segments * segments * static_cast<double>(patches.patches.size());
    const TimedWork others[] = {
        {[&] { TessellateByVertex(patches, segments, mesh); }, triangles},
        burin::base::HasAvx2() ? TimedWork{[&] { TessellateByRow(patches, segments, mesh); }, triangles} : TimedWork{},
        segments <= 128 ? burin::bench::OpenSubdivPatches(patches.patches.size(), segments) : TimedWork{},
        segments <= 64 ? burin::bench::OpenSubdivStencils(patches.patches.size(), segments) : TimedWork{},
        gl.At(segments)};
    const double ours = runs.Rate(
        {.pattern = Pattern::kInteger, .wants_patch_uv = false, .wants_patch_ids = false, .is_parallel = false});
    std::string line = fmt::format("{:>6} {:>9.1f}", segments, ours);
    for (const TimedWork& other : others) {
      const std::string rate = Rate(other);
      line += fmt::format(" {:>9} {:>6}", rate, other.run ? fmt::format("x{:.1f}", ours / std::stod(rate)) : "");
    }
    fmt::print("{}\n", line);
    std::fflush(stdout);
  }
}

void PrintSizes(const BezierPatches& patches) {
  fmt::print("\nbytes a triangle: control points in, vertices (24 bytes) and indices out; vertices a triangle\n");
  for (const std::uint32_t segments : kSegments) {
    Runs runs(patches, segments);
    (void)runs.Rate({.wants_patch_uv = false, .wants_patch_ids = false});
    const double triangles = static_cast<double>(runs.surface().indices.size()) / 3.0;
    const double vertices = static_cast<double>(runs.surface().positions.size());
    fmt::print("{:>6} {:>9.3f} {:>9.2f} {:>9.3f}\n", segments,
               static_cast<double>(patches.positions.size()) * 16.0 / triangles, vertices * 24.0 / triangles + 12.0,
               vertices / triangles);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const std::string path = argc > 1 ? argv[1] : burin::test::SharedData("bezier/teapot_32.bpt");
  const auto model = burin::test::ReadBpt(path);
  if (!model && argc > 1) {
    fmt::print(stderr, "{} can't be read\n", path);
    return 1;
  }
  const BezierPatches patches = model ? *model : Sheet();
  fmt::print("{}: {} patches, {} threads, {}\n", model ? path : "a sheet", patches.patches.size(),
             burin::base::AvailableThreads(), burin::base::HasAvx2() ? "AVX2" : "no AVX2");
  PrintOurs(patches);
  PrintRivals(patches);
  PrintSizes(patches);
  return 0;
}
