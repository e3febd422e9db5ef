// SPDX-License-Identifier: Apache-2.0
// Tessellation speed against factor (Moreton's figures 23 and 24) beside other ways to the same vertices, in one run.
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <functional>
#include <vector>

#include "core/tessellation/tessellate.h"
#include "tests/support/bezier_networks.h"

namespace {

using burin::geometry::BezierPatches;
using burin::tessellation::Factors;
using burin::tessellation::Options;
using burin::tessellation::Pattern;
using burin::tessellation::Surface;

double NowMs() {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double MedianMs(const std::function<void()>& work) {
  work();
  std::vector<double> times;
  const double start = NowMs();
  while (times.size() < 5 || (NowMs() - start < 60.0 && times.size() < 2000)) {
    const double begin = NowMs();
    work();
    times.push_back(NowMs() - begin);
  }
  std::ranges::nth_element(times, times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2));
  return times[times.size() / 2];
}

}  // namespace

int main() {
  const auto teapot = burin::test::ReadBpt(burin::test::SharedData("bezier/teapot_32.bpt"));
  if (!teapot) return 1;
  for (const float f : {2.0f, 4.0f, 8.0f, 16.0f, 32.0f, 64.0f, 128.0f, 256.0f}) {
    const std::vector<Factors> factors(teapot->patches.size(), Factors{f, f, f, f});
    Surface surface;
    Options options{.pattern = Pattern::kInteger, .wants_patch_uv = false, .wants_patch_ids = false, .is_parallel = false};
    burin::tessellation::Tessellator tessellator;
    const auto run = [&](Options o) {
      return MedianMs([&] { tessellator.Tessellate(*teapot, factors, o, surface); });
    };
    const double one = run(options);
    options.uses_avx2 = false;
    const double plain = run(options);
    options.uses_avx2 = true;
    options.pattern = Pattern::kFractional;
    const double fractional = run(options);
    options.is_parallel = true;
    const double two = run(options);
    options.is_parallel = false;
    options.wants_patch_uv = options.wants_patch_ids = true;
    const double all = run(options);
    const double mtri = static_cast<double>(surface.indices.size()) / 3e3;
    const std::size_t bytes = surface.positions.size() * 24 + surface.indices.size() * 4;
    std::vector<char> from(bytes, 1), to(bytes);
    const double copy = MedianMs([&] { std::memcpy(to.data(), from.data(), bytes); });
    fmt::print("{:>4}: avx2 {:.0f} plain {:.0f} frac {:.0f} all cpus {:.0f} uv+id {:.0f} memcpy {:.0f} Mtri/s, {:.2f} of memcpy\n", f,
               mtri / one, mtri / plain, mtri / fractional, mtri / two, mtri / all, mtri / copy, copy / one);
  }
}
