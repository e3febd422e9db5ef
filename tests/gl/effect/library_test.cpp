// SPDX-License-Identifier: Apache-2.0
// The shipped effects: each compiles and runs, and gives what an independent computation on the CPU gives.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include "core/gl/fullscreen_quad.h"
#include "fx_parser/source/file_system.h"
#include "tests/gl/effect/effect_fixture.h"

namespace burin::effect {
namespace {

namespace fs = std::filesystem;

constexpr int kWidth = 37;
constexpr int kHeight = 23;

std::vector<std::string> ShippedEffects() {
  std::vector<std::string> paths;
  for (const auto& entry : fs::recursive_directory_iterator(SourceFolder() + "/effects")) {
    if (entry.path().extension() == ".fx") {
      paths.push_back(fs::relative(entry.path(), SourceFolder()).string());
    }
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

using Channel = std::function<float(int, int)>;

// The picture's channel with its border repeated.
Channel Clamped(const PixelMap& map, std::size_t channel) {
  return [&map, channel](int x, int y) {
    return map.at(std::clamp(x, 0, map.width - 1), std::clamp(y, 0, map.height - 1))[channel];
  };
}

PixelMap ToMap(const image::Image& picture) {
  PixelMap map{picture.width, picture.height, {}};
  const std::size_t count = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
  for (std::size_t i = 0; i < count; ++i) {
    Rgba pixel{};
    for (std::size_t c = 0; c < 4; ++c) {
      pixel[c] = picture.type == image::SampleType::kF32
                     ? picture.As<float>()[i * 4 + c]
                     : static_cast<float>(picture.As<std::uint8_t>()[i * 4 + c]) / 255.0f;
    }
    map.pixels.push_back(pixel);
  }
  return map;
}

// Fails where a channel is more than `tolerance` away from `expected`, at most once.
void ExpectChannel(const PixelMap& frame, std::size_t channel, const Channel& expected, float tolerance) {
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      ASSERT_NEAR(frame.at(x, y)[channel], expected(x, y), tolerance)
          << "channel " << channel << " at " << x << "," << y;
    }
  }
}

TEST(Library, EveryEffectRunsWithEachOfItsTechniques) {
  const auto paths = ShippedEffects();
  ASSERT_GE(paths.size(), 10u);
  for (const std::string& path : paths) {
    SCOPED_TRACE(path);
    const auto effect = CompileFile(path);
    ASSERT_TRUE(effect);
    for (const fx::Technique& technique : effect->techniques) {
      if (!technique.custom_attribute.empty()) continue;
      Bench bench(effect, 16, 9, {}, technique.name);
      const SceneDraws none = []() -> Result<std::vector<SceneDraw>> { return std::vector<SceneDraw>{}; };
      ASSERT_NE(bench.Run(none), nullptr);
      EXPECT_TRUE(bench.runner->warnings().empty()) << bench.runner->warnings().front();
    }
  }
}

TEST(Library, EveryEffectSaysWhatItIsInItsFirstComment) {
  for (const std::string& path : ShippedEffects()) {
    const auto text = fx::DiskFileSystem().Read(SourceFolder() + "/" + path);
    ASSERT_TRUE(text.has_value());
    EXPECT_TRUE(text->starts_with("// SPDX-License-Identifier: Apache-2.0\n// ")) << path;
    const std::size_t begin = text->find("\n// ") + 4;
    const std::string summary = text->substr(begin, text->find('\n', begin) - begin);
    EXPECT_LE(summary.size(), 110u) << path;
    EXPECT_TRUE(summary.ends_with('.')) << path << ": " << summary;
  }
}

TEST(Library, TheManualsExampleRuns) {
  const auto manual = fx::DiskFileSystem().Read(SourceFolder() + "/man/burin-fx.7");
  ASSERT_TRUE(manual.has_value());
  const std::size_t begin = manual->find(".EX\n") + 4;
  std::string text = manual->substr(begin, manual->find(".EE\n", begin) - begin);
  for (std::size_t at = text.find("\\-"); at != std::string::npos; at = text.find("\\-", at)) text.replace(at, 2, "-");
  Bench bench(CompileText(text), kWidth, kHeight);
  bench.Fill("intensity", MakeImage(kWidth, kHeight, image::SampleType::kU8, [](int x, int) {
               const float value = x < 10 ? 0.0f : 1.0f;
               return Rgba{value, value, value, 1};
             }));
  // Marked at 9, broadened to the right.
  ExpectChannel(
      bench.RunPixels(), 0, [](int x, int) { return x == 9 || x == 10 ? 0.0f : 1.0f; }, 0);
}

TEST(Library, IdentityCopiesBits) {
  const auto effect = CompileFile("effects/basic/identity.fx");
  for (const auto& [width, height] : {std::pair{1, 1}, std::pair{37, 23}, std::pair{256, 255}}) {
    const image::Image picture = MakeNoise(width, height, image::SampleType::kU8, 7);
    Bench display(effect, width, height);
    display.Fill("color", picture);
    EXPECT_EQ(display.RunImage(image::SampleType::kU8).pixels, picture.pixels);
    const image::Image floats = MakeNoise(width, height, image::SampleType::kF32, 8);
    Bench linear(effect, width, height, {}, "Linear");
    linear.Fill("color", floats);
    EXPECT_EQ(linear.RunImage(image::SampleType::kF32).pixels, floats.pixels);
  }
}

TEST(Library, SobelIsTheLengthOfTheGradientByChannel) {
  const image::Image picture = MakeNoise(kWidth, kHeight, image::SampleType::kU8, 11);
  const PixelMap map = ToMap(picture);
  Bench bench(CompileFile("effects/edges/sobel.fx"), kWidth, kHeight, {{"Strength", "0.25"}});
  bench.Fill("color", picture);
  const PixelMap frame = bench.RunPixels();
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const Channel p = Clamped(map, channel);
    ExpectChannel(
        frame, channel,
        [&](int x, int y) {
          float gx = 0;
          float gy = 0;
          for (int i = -1; i <= 1; ++i) {
            const float weight = i == 0 ? 2.0f : 1.0f;
            gx += weight * (p(x + 1, y + i) - p(x - 1, y + i));
            gy += weight * (p(x + i, y + 1) - p(x + i, y - 1));
          }
          return std::min(1.0f, 0.25f * std::hypot(gx, gy));
        },
        0.51f / 255);
  }
  ExpectChannel(
      frame, 3, [](int, int) { return 1.0f; }, 0);
}

TEST(Library, RobertsIsTheLengthOfBothDiagonals) {
  const image::Image picture = MakeNoise(kWidth, kHeight, image::SampleType::kU8, 12);
  const PixelMap map = ToMap(picture);
  Bench bench(CompileFile("effects/edges/roberts.fx"), kWidth, kHeight, {{"Strength", "0.5"}});
  bench.Fill("color", picture);
  const Channel p = Clamped(map, 1);
  ExpectChannel(
      bench.RunPixels(), 1,
      [&](int x, int y) { return 0.5f * std::hypot(p(x, y) - p(x + 1, y + 1), p(x + 1, y) - p(x, y + 1)); },
      0.51f / 255);
}

// A bright square on black, so that thresholds are far from any value.
image::Image Square() {
  return MakeImage(kWidth, kHeight, image::SampleType::kU8, [](int x, int y) {
    const float value = x >= 10 && x < 20 && y >= 5 && y < 15 ? 0.8f : 0.0f;
    return Rgba{value, value, value, 1};
  });
}

TEST(Library, DilatedEdgesAreBlackAroundTheRobertsCross) {
  const image::Image picture = Square();
  const PixelMap map = ToMap(picture);
  Bench bench(CompileFile("effects/edges/dilated_edges.fx"), kWidth, kHeight);
  bench.Fill("intensity", picture);
  const Channel p = Clamped(map, 0);
  const auto is_edge = [&](int x, int y) {
    return std::abs(p(x, y) - p(x + 1, y + 1)) + std::abs(p(x + 1, y) - p(x, y + 1)) > 0.09f;
  };
  ExpectChannel(
      bench.RunPixels(), 0,
      [&](int x, int y) {
        for (int j = -1; j <= 1; ++j) {
          for (int i = -1; i <= 1; ++i) {
            if (is_edge(std::clamp(x + i, 0, kWidth - 1), std::clamp(y + j, 0, kHeight - 1))) return 0.0f;
          }
        }
        return 1.0f;
      },
      0);
}

TEST(Library, ThePapersListingWrapsRoundTheBorder) {
  // Bright in the top rows only: with WRAP the row above the first is the last, which is dark.
  const image::Image picture = MakeImage(kWidth, kHeight, image::SampleType::kU8, [](int, int y) {
    const float value = y < 8 ? 1.0f : 0.0f;
    return Rgba{value, value, value, 1};
  });
  Bench bench(CompileFile("effects/edges/roberts_paper.fx"), kWidth, kHeight);
  bench.Fill("intensity", picture);
  ExpectChannel(
      bench.RunPixels(), 0,
      [&](int, int y) {
        // Row 0 and row 8 differ from the row above; dilation adds the rows beside them (clamped, not wrapped).
        return y <= 1 || (y >= 7 && y <= 9) ? 0.0f : 1.0f;
      },
      0);
}

TEST(Library, SupersamplingWithAWideGaussianIsTheMeanOfNine) {
  const image::Image large = MakeNoise(3 * kWidth, 3 * kHeight, image::SampleType::kF32, 13);
  Bench bench(CompileFile("effects/filter/supersample.fx"), kWidth, kHeight, {{"Sigma", "1000"}});
  bench.Fill("color", large);
  const PixelMap map = ToMap(large);
  const PixelMap frame = bench.RunPixels();
  for (std::size_t channel = 0; channel < 4; ++channel) {
    ExpectChannel(
        frame, channel,
        [&](int x, int y) {
          float sum = 0;
          for (int j = 0; j < 3; ++j) {
            for (int i = 0; i < 3; ++i) sum += map.at(3 * x + i, 3 * y + j)[channel];
          }
          return sum / 9;
        },
        1e-3f);  // the attribute holds halves
  }
}

TEST(Library, SupersamplingWeighsByTheGaussianAndSplits) {
  const image::Image large = MakeNoise(3 * kWidth, 3 * kHeight, image::SampleType::kF32, 14);
  Bench bench(CompileFile("effects/filter/supersample.fx"), kWidth, kHeight, {{"Sigma", "0.7"}, {"Split", "0.5"}});
  bench.Fill("color", large);
  const PixelMap map = ToMap(large);
  ExpectChannel(
      bench.RunPixels(), 2,
      [&](int x, int y) {
        if ((static_cast<float>(x) + 0.5f) / kWidth < 0.5f) return map.at(3 * x + 1, 3 * y + 1)[2];
        double sum = 0;
        double total = 0;
        for (int j = -1; j <= 1; ++j) {
          for (int i = -1; i <= 1; ++i) {
            const double weight = std::exp(-0.5 * (i * i + j * j) / (0.7 * 0.7));
            sum += weight * static_cast<double>(map.at(3 * x + 1 + i, 3 * y + 1 + j)[2]);
            total += weight;
          }
        }
        return static_cast<float>(sum / total);
      },
      1e-3f);
}

TEST(Library, GaussianConvolvesInTwoDimensions) {
  constexpr double kSigma = 1.7;
  const image::Image picture = MakeImage(kWidth, kHeight, image::SampleType::kU8, [](int x, int y) {
    const float value = (x * 7 + y * 13) % 5 == 0 ? 1.0f : 0.1f;
    return Rgba{value, 1 - value, value, 1};
  });
  const PixelMap map = ToMap(picture);
  Bench bench(CompileFile("effects/filter/gaussian.fx"), kWidth, kHeight, {{"Sigma", "1.7"}});
  bench.Fill("color", picture);
  const Channel p = Clamped(map, 1);
  const int radius = static_cast<int>(std::ceil(3 * kSigma));
  ExpectChannel(
      bench.RunPixels(), 1,
      [&](int x, int y) {
        double sum = 0;
        double total = 0;
        for (int j = -radius; j <= radius; ++j) {
          for (int i = -radius; i <= radius; ++i) {
            const double weight = std::exp(-0.5 * (i * i + j * j) / (kSigma * kSigma));
            sum += weight * static_cast<double>(p(x + i, y + j));
            total += weight;
          }
        }
        return static_cast<float>(sum / total);
      },
      0.6f / 255);
}

TEST(Library, GaussianOfZeroLeavesThePictureAlone) {
  const image::Image picture = MakeImage(kWidth, kHeight, image::SampleType::kU8, [](int x, int y) {
    return Rgba{static_cast<float>(x) / kWidth, static_cast<float>(y) / kHeight, 0.3f, 1};
  });
  Bench bench(CompileFile("effects/filter/gaussian.fx"), kWidth, kHeight, {{"Sigma", "0"}});
  bench.Fill("color", picture);
  EXPECT_EQ(bench.RunImage(image::SampleType::kU8).pixels, picture.pixels);
}

// Half of the picture is dark, a quarter bright, a quarter empty.
TEST(Library, HistogramCountsWhatIsThere) {
  constexpr int kColumns = 128;
  constexpr int kRows = 64;
  constexpr int kBin = 8;
  Bench bench(CompileFile("effects/filter/histogram.fx"), kColumns, kRows, {{"Height", "1"}});
  bench.Fill("color", MakeImage(kColumns, kRows, image::SampleType::kU8, [](int x, int y) {
               if (x < kColumns / 2) return Rgba{0.1f, 0.1f, 0.1f, 1};
               return Rgba{0.8f, 0.8f, 0.8f, y < kRows / 2 ? 1.0f : 0.0f};
             }));
  const PixelMap frame = bench.RunPixels();
  for (int bin = 0; bin < kColumns / kBin; ++bin) {
    int bar = 0;
    for (int y = 0; y < kRows; ++y) {
      const auto i = static_cast<std::size_t>(y * kColumns + bin * kBin + kBin / 2);
      if (frame.pixels[i][0] < 0.5f) ++bar;
    }
    EXPECT_EQ(bar, bin == 1 ? kRows : bin == 12 ? kRows / 2 : 0) << "bin " << bin;
  }
}

TEST(Library, ScreensKeepTheTone) {
  constexpr int kSize = 256;
  for (const char* technique : {"Lines", "Dots"}) {
    for (const float tone : {0.0f, 0.1f, 0.25f, 0.5f, 0.75f, 0.9f, 1.0f}) {
      SCOPED_TRACE(testing::Message() << technique << " at " << tone);
      Bench bench(CompileFile("effects/npr/screening.fx"), kSize, kSize,
                  {{"Contrast", "1"}, {"Brightness", "0"}, {"EdgeThreshold", "2"}, {"Period", "8"}, {"Angle", "20"}},
                  technique);
      bench.Fill("intensity", MakeImage(kSize, kSize, image::SampleType::kU8, [&](int, int) {
                   return Rgba{tone, tone, tone, 1};
                 }));
      bench.Fill("alpha", MakeImage(kSize, kSize, image::SampleType::kU8, [](int, int) { return Rgba{1, 1, 1, 1}; }));
      const PixelMap frame = bench.RunPixels();
      double sum = 0;
      for (const Rgba& pixel : frame.pixels) sum += static_cast<double>(pixel[0]);
      // A step of 6 bits.
      EXPECT_NEAR(sum / static_cast<double>(frame.pixels.size()), tone, 1.0 / 64);
    }
  }
}

TEST(Library, ComparisonSplitsBetweenItsDetectors) {
  const image::Image picture = Square();
  Bench roberts(CompileFile("effects/edges/roberts_vs_sobel.fx"), kWidth, kHeight, {{"Split", "1"}});
  roberts.Fill("intensity", picture);
  Bench sobel(CompileFile("effects/edges/roberts_vs_sobel.fx"), kWidth, kHeight, {{"Split", "0"}});
  sobel.Fill("intensity", picture);
  const auto edges = [](const PixelMap& frame) {
    int count = 0;
    for (const Rgba& pixel : frame.pixels) count += pixel[0] == 0.0f;
    return count;
  };
  // A square of 10x10: the Roberts cross marks one texel along its outline, Sobel one on either side.
  EXPECT_EQ(edges(roberts.RunPixels()), 40);
  EXPECT_EQ(edges(sobel.RunPixels()), (12 * 12 - 10 * 10) + (10 * 10 - 8 * 8));
}

TEST(Library, GbufferEdgesFollowIdsDepthAndNormals) {
  constexpr int kSize = 24;
  const auto run = [&](const std::function<Rgba(int, int)>& id, const std::function<Rgba(int, int)>& depth,
                       const std::function<Rgba(int, int)>& normal) {
    Bench bench(CompileFile("effects/edges/gbuffer_edges.fx"), kSize, kSize, {{"ColorAmount", "0"}});
    bench.Fill("color", MakeImage(kSize, kSize, image::SampleType::kU8, [](int, int) { return Rgba{1, 0, 0, 1}; }));
    bench.Fill("objectid", MakeImage(kSize, kSize, image::SampleType::kF32, id));
    bench.Fill("depth", MakeImage(kSize, kSize, image::SampleType::kF32, depth));
    bench.Fill("normal", MakeImage(kSize, kSize, image::SampleType::kF32, normal));
    int lines = 0;
    for (const Rgba& pixel : bench.RunPixels().pixels) lines += pixel[0] < 0.5f;
    return lines;
  };
  const auto one = [](int, int) { return Rgba{1, 1, 1, 1}; };
  const auto up = [](int, int) { return Rgba{0, 1, 0, 1}; };
  const auto slope = [](int x, int) { return Rgba{5.0f + 0.1f * static_cast<float>(x), 1, 1, 1}; };
  EXPECT_EQ(run(one, one, up), 0);
  EXPECT_EQ(run(one, slope, up), 0) << "a slanting plane has no edges";
  // Steep, in perspective: the reciprocal of the depth is what grows evenly over the picture.
  EXPECT_EQ(run(
                one,
                [](int x, int) {
                  return Rgba{1.0f / (0.05f + 0.04f * static_cast<float>(x)), 1, 1, 1};
                },
                up),
            0);
  EXPECT_EQ(run([](int x, int) { return Rgba{x < 12 ? 1.0f : 2.0f, 1, 1, 1}; }, one, up), 2 * kSize);
  EXPECT_EQ(run(
                one,
                [](int x, int) {
                  return Rgba{x < 12 ? 1.0f : 2.0f, 1, 1, 1};
                },
                up),
            2 * kSize);
  EXPECT_EQ(run(one, one, [](int x, int) { return x < 12 ? Rgba{0, 1, 0, 1} : Rgba{1, 0, 0, 1}; }), 2 * kSize);
}

TEST(Library, InkLinesAreAsWideAsAsked) {
  constexpr int kSize = 32;
  // An edge at x = 16 + shift; an outline's surface lies to its right.
  const auto ink_of_a_row = [&](bool is_outline, float shift, const char* parameter, const char* width) {
    Bench bench(CompileFile("effects/npr/ink.fx"), kSize, kSize,
                {{"Weight", "0"}, {"Wash", "0"}, {"InkColor", "0,0,0"}, {"PaperColor", "1,1,1"}, {parameter, width}});
    const auto distance = [&](int x) { return 16.0f + shift - (static_cast<float>(x) + 0.5f); };
    bench.Fill("color", MakeImage(kSize, kSize, image::SampleType::kU8, [](int, int) { return Rgba{1, 0, 0, 1}; }));
    bench.Fill("edgedist", MakeImage(kSize, kSize, image::SampleType::kF32, [&](int x, int) {
                 return Rgba{is_outline ? distance(x) : std::abs(distance(x)), 1, 1, 1};
               }));
    bench.Fill("edges", MakeImage(kSize, kSize, image::SampleType::kU8, [&](int x, int) {
                 const float coverage = std::max(0.0f, 1.0f - std::abs(distance(x)));
                 return is_outline ? Rgba{coverage, 0, 0, 0} : Rgba{0, coverage, 0, 0};
               }));
    const PixelMap frame = bench.RunPixels();
    float ink = 0;
    for (int x = 0; x < kSize; ++x) ink += 1.0f - frame.at(x, 16)[0];
    return ink;
  };
  for (const float shift : {0.0f, 0.25f, 0.5f, 0.8f}) {
    SCOPED_TRACE(shift);
    EXPECT_NEAR(ink_of_a_row(true, shift, "OutlineWidth", "3"), 3.0f, 0.02f);
    EXPECT_NEAR(ink_of_a_row(true, shift, "OutlineWidth", "6.5"), 6.5f, 0.02f);
    EXPECT_NEAR(ink_of_a_row(true, shift, "OutlineWidth", "0"), 0.0f, 0.02f);
    EXPECT_NEAR(ink_of_a_row(false, shift, "CreaseWidth", "1.5"), 1.5f, 0.02f);
    EXPECT_NEAR(ink_of_a_row(false, shift, "CreaseWidth", "4"), 4.0f, 0.02f);
    EXPECT_NEAR(ink_of_a_row(false, shift, "CreaseWidth", "0"), 0.0f, 0.02f);
  }
}

TEST(Library, GoochShadesBetweenCoolAndWarm) {
  auto quad = gl::FullscreenQuad::Create();
  ASSERT_TRUE(quad.has_value());
  Bench bench(CompileFile("effects/npr/gooch.fx"), 8, 8, {{"HighlightAmount", "0"}});
  ASSERT_TRUE(bench.runner);
  const auto ids = MakeImage(8, 8, image::SampleType::kF32, [](int, int) { return Rgba{1, 1, 1, 1}; });
  bench.Fill("objectid", ids);
  bench.Fill("normal", MakeImage(8, 8, image::SampleType::kF32, [](int, int) { return Rgba{0, 0, 1, 1}; }));
  // The quadrilateral has no normals: GL gives (0,0,0,1), which normalises to nothing, half-way between cool and warm.
  const SceneDraws plane = [&]() -> Result<std::vector<SceneDraw>> {
    return std::vector{SceneDraw{glm::mat4(1.0f), [&] { quad->Draw(); }}};
  };
  // cool = (0.175, 0.175, 0.725), warm = (0.65, 0.65, 0.35)
  EXPECT_RGBA8(bench.RunPixels(plane).at(4, 4), 0.4125f, 0.4125f, 0.5375f, 1);
}

}  // namespace
}  // namespace burin::effect
