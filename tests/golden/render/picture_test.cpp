// SPDX-License-Identifier: Apache-2.0
// Whole pictures through the whole program: scenes, shipped effects, attributes.
#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <filesystem>

#include "core/render/render.h"
#include "tests/golden/render/golden_image.h"

namespace burin::golden {
namespace {

namespace fs = std::filesystem;

/// Errors fail the test; nothing else is of interest here.
class SilentProgress final : public render::Progress {
 public:
  void DeviceChosen(const std::string&) override {}
  void Started(long) override {}
  void FrameDone(long, const std::string&) override {}
  void FrameFailed(long, const std::string& message) override { ADD_FAILURE() << message; }
  void Warning(const std::string&) override {}
  void Info(const std::string&) override {}
  void Diagnostics(const std::string& text) override { diagnostics += text; }
  [[nodiscard]] bool wants_color() const override { return false; }
  void Finished(const Result<void>& result, long) override {
    EXPECT_TRUE(result) << (result ? "" : result.error().message) << "\n" << diagnostics;
  }
  std::string diagnostics;
};

struct Case {
  const char* name;
  const char* effect;     ///< shipped; empty: none
  const char* scene;      ///< in examples/
  const char* attribute;  ///< empty: the frame
  long frame;
  Tolerance tolerance;
  scene::TessellationMode tessellation = scene::TessellationMode::kAuto;
};

std::ostream& operator<<(std::ostream& stream, const Case& test) { return stream << test.name; }

std::string Source(const std::string& path) {
  const char* const folder = std::getenv("BURIN_SOURCE_DIR");
  return std::string(folder != nullptr ? folder : ".") + "/" + path;
}

class Picture : public testing::TestWithParam<Case> {};

TEST_P(Picture, IsTheGoldenOne) {
  const Case& test = GetParam();
  const fs::path out =
      fs::temp_directory_path() / ("burin_golden_" + std::to_string(getpid()) + "_" + test.name + ".png");
  render::Job job;
  job.source = Source(std::string("examples/") + test.scene);
  job.output = out.string();
  job.size = std::pair(160, 120);
  job.frames = {test.frame};
  job.tessellation.mode = test.tessellation;
  job.background = std::array<float, 4>{0.8f, 0.8f, 0.8f, 1.0f};
  if (*test.effect != '\0') job.effects = {Source(std::string("effects/") + test.effect)};
  if (*test.attribute != '\0') job.attributes = {test.attribute};
  job.alpha = render::AlphaOutput::kDrop;
  job.device = "software";  // rasterises the same everywhere, which cards do not
  SilentProgress progress;
  const std::atomic<bool> stop{false};
  if (render::Run(job, progress, stop)) ExpectGolden(out.string(), test.name, test.tolerance);
  fs::remove(out);
}

constexpr const char* kStill = "still_life.glb";
constexpr const char* kWalk = "walk.glb";
constexpr const char* kJug = "jug.bpt";

INSTANTIATE_TEST_SUITE_P(
    Golden, Picture,
    testing::Values(Case{"still_life", "", kStill, "", 1, kShaded}, Case{"walk_1", "", kWalk, "", 1, kShaded},
                    Case{"walk_13", "", kWalk, "", 13, kShaded}, Case{"normal", "", kStill, "normal", 1, kShaded},
                    Case{"albedo", "", kStill, "albedo", 1, kShaded},
                    Case{"dilated_edges", "edges/dilated_edges.fx", kStill, "", 1, kThresholded},
                    Case{"roberts_vs_sobel", "edges/roberts_vs_sobel.fx", kStill, "", 1, kThresholded},
                    Case{"sobel", "edges/sobel.fx", kStill, "", 1, kShaded},
                    Case{"gbuffer_edges", "edges/gbuffer_edges.fx", kStill, "", 1, kThresholded},
                    Case{"supersample", "filter/supersample.fx", kStill, "", 1, kShaded},
                    Case{"gaussian", "filter/gaussian.fx", kStill, "", 1, kShaded},
                    Case{"screening", "npr/screening.fx", kStill, "", 1, kThresholded},
                    Case{"ink", "npr/ink.fx", kStill, "", 1, kThresholded},
                    Case{"gooch", "npr/gooch.fx", kStill, "", 1, kShaded}, Case{"jug", "", kJug, "", 1, kShaded},
                    Case{"jug_ink", "npr/ink.fx", kJug, "", 1, kThresholded},
                    Case{"jug_patchuv", "", kJug, "patchuv", 1, kShaded},
                    Case{"walk_smooth", "", kWalk, "", 13, kShaded, scene::TessellationMode::kFractional}),
    [](const auto& parameter) { return std::string(parameter.param.name); });

}  // namespace
}  // namespace burin::golden
