// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/effect/effect_runner.h"
#include "core/image/image.h"

namespace burin::effect {

using Rgba = std::array<float, 4>;
using Settings = std::vector<std::pair<std::string, std::string>>;

/// The effect of a text, with a test failure that shows the diagnostics when there are errors.
[[nodiscard]] std::shared_ptr<const fx::Effect> CompileText(const std::string& text,
                                                            const std::string& path = "test.fx");
/// A file of the project, by its path from the project's folder.
[[nodiscard]] std::shared_ptr<const fx::Effect> CompileFile(const std::string& path);
[[nodiscard]] std::string SourceFolder();

/// Pictures on the CPU. `at(x, y)` gives a pixel.
[[nodiscard]] image::Image MakeImage(int width, int height, image::SampleType type,
                                     const std::function<Rgba(int, int)>& at);
/// Pixels of noise with a fixed seed.
[[nodiscard]] image::Image MakeNoise(int width, int height, image::SampleType type, unsigned seed);

struct PixelMap {
  int width = 0;
  int height = 0;
  std::vector<Rgba> pixels;
  [[nodiscard]] const Rgba& at(int x, int y) const {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
  }
};

/// One effect at one size, with its attributes filled from pictures.
class Bench {
 public:
  Bench(std::shared_ptr<const fx::Effect> effect, int width, int height, const Settings& parameters = {},
        const std::string& technique = {}, TextureLoader loader = {});

  /// Puts a picture into every target of the attribute (the sizes must be the same).
  void Fill(const std::string& attribute, const image::Image& picture);
  [[nodiscard]] const gl::Texture* Run(const SceneDraws& scene = {});
  /// The frame's raw components.
  [[nodiscard]] PixelMap RunPixels(const SceneDraws& scene = {});
  [[nodiscard]] image::Image RunImage(image::SampleType type);

  FrameContext context;
  std::unique_ptr<EffectRunner> runner;
};

[[nodiscard]] PixelMap ReadPixels(const gl::Texture& texture);

/// The frame of a technique without attributes, in 32-bit floats: `body` is the text of the file.
[[nodiscard]] PixelMap RunText(const std::string& text, int width, int height, const Settings& parameters = {});

/// `expression` (a float4) as a pixel shader computes it, with `globals` in front.
[[nodiscard]] Rgba Evaluate(const std::string& expression, const std::string& globals = {},
                            const Settings& parameters = {});

[[nodiscard]] ::testing::AssertionResult Near(const Rgba& actual, const Rgba& expected, float tolerance);
#define EXPECT_RGBA(actual, ...) EXPECT_TRUE(::burin::effect::Near(actual, ::burin::effect::Rgba{__VA_ARGS__}, 1e-6f))
// To half a step of 8 bits, and what rounding adds to it.
#define EXPECT_RGBA8(actual, ...) \
  EXPECT_TRUE(::burin::effect::Near(actual, ::burin::effect::Rgba{__VA_ARGS__}, 0.51f / 255.0f))

}  // namespace burin::effect
