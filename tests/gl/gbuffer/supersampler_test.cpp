// SPDX-License-Identifier: Apache-2.0
#include "core/gbuffer/supersampler.h"

#include <gmock/gmock.h>

#include "tests/gl/gbuffer/scene_fixture.h"

namespace burin::gbuffer {
namespace {

class SupersamplerTest : public GbufferTest {
 protected:
  /// A turned lit square before a turned glass one: slanted edges, shading, partial alpha.
  static TestScene Squares() {
    TestScene test;
    scene::Material lit;
    lit.base_color = {0.9f, 0.3f, 0.1f, 1};
    scene::Material glass = Unlit({0.2f, 0.5f, 3.0f, 0.4f});
    glass.alpha_mode = scene::AlphaMode::kBlend;
    const glm::vec3 axis(0.2f, 0.1f, 1.0f);
    test.AddNode(test.AddMesh(Square(test.AddMaterial(lit))),
                 glm::rotate(Translate(-0.3f, 0.1f, -4), 0.3f, axis) * glm::scale(glm::mat4(1), glm::vec3(0.5f)));
    test.AddNode(test.AddMesh(Square(test.AddMaterial(glass))),
                 glm::rotate(Translate(0.2f, -0.1f, -3), 0.8f, axis) * glm::scale(glm::mat4(1), glm::vec3(0.4f)));
    return test;
  }

  Picture Supersampled(const TestScene& test, int samples, int width, int height) {
    const auto renderer = Must(SceneRenderer::Create(test.scene, nullptr));
    const auto supersampler = Must(Supersampler::Create(samples));
    return Again(test, *renderer, *supersampler, width, height);
  }

  Picture Again(const TestScene& test, SceneRenderer& renderer, Supersampler& supersampler, int width, int height) {
    const scene::Pose pose = scene::EvaluatePose(test.scene, {}, 0.0);
    const std::vector<scene::DrawItem> items = scene::BuildDrawItems(test.scene, pose, pose);
    FrameInput frame;
    frame.view = frame.previous_view = Orthographic();
    frame.pose = &pose;
    frame.items = items;
    frame.background = background_;
    return ReadPicture(*Must(supersampler.Render(renderer, frame, width, height)));
  }

  /// The largest difference between `picture` and the means of k x k pixels of an independent rendering.
  float DifferenceFromMeans(const TestScene& test, const Picture& picture, int k, int width, int height) {
    const Picture large = Render(test, Orthographic(), Attribute::kColor, Float(), width * k, height * k);
    float most = 0;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        std::array<double, 4> sum{};
        for (int i = 0; i < k * k; ++i) {
          const std::vector<float> sample = large.At(x * k + i % k, y * k + i / k);
          for (std::size_t c = 0; c < 4; ++c) sum[c] += sample[c];
        }
        for (std::size_t c = 0; c < 4; ++c) {
          const auto mean = static_cast<float>(sum[c] / (k * k));
          most = std::max(most, std::abs(picture.At(x, y)[c] - mean));
        }
      }
    }
    return most;
  }
};

// 16 additions of numbers up to 3 round by no more.
constexpr float kRounding = 3e-6f;

TEST_F(SupersamplerTest, APixelIsTheMeanOfItsSamplesInLinearLight) {
  background_ = {0.1f, 0.2f, 0.05f, 0.5f};
  const TestScene test = Squares();
  for (const int k : {2, 4}) {
    const Picture picture = Supersampled(test, k * k, 37, 23);
    EXPECT_LT(DifferenceFromMeans(test, picture, k, 37, 23), kRounding) << k;
  }
}

TEST_F(SupersamplerTest, EdgesTakeIntermediateValues) {
  TestScene test;
  test.AddNode(test.AddMesh(Square(test.AddMaterial(Unlit({1, 1, 1, 1})))), Translate(1.15625f, 0, -3));
  // The square's left edge is at x = 0.15625, 2.3125 pixels of 4: 1 of 2 columns of samples and 3 of 4 are on its
  // right.
  EXPECT_EQ(Supersampled(test, 4, 4, 4).At(2, 1), (std::vector<float>{0.5f, 0.5f, 0.5f, 0.5f}));
  EXPECT_EQ(Supersampled(test, 16, 4, 4).At(2, 1), (std::vector<float>{0.75f, 0.75f, 0.75f, 0.75f}));
  EXPECT_EQ(Supersampled(test, 16, 4, 4).At(1, 1), (std::vector<float>{0, 0, 0, 0}));
}

TEST_F(SupersamplerTest, FlatAreasKeepTheirBits) {
  background_ = {0.1f, 1.0f / 3.0f, 1e-7f, 0.7f};
  TestScene test;
  test.AddNode(test.AddMesh(Square(test.AddMaterial(Unlit({0.3f, 0.7f, 1.0f / 7.0f, 1})))), Translate(1, 0, -3));
  const Picture plain = Render(test, Orthographic(), Attribute::kColor, Float(), 8, 8);
  for (const int samples : {4, 16}) EXPECT_EQ(Supersampled(test, samples, 8, 8).values, plain.values) << samples;
}

TEST_F(SupersamplerTest, SizesMayTakeTurns) {
  const TestScene test = Squares();
  const auto renderer = Must(SceneRenderer::Create(test.scene, nullptr));
  const auto supersampler = Must(Supersampler::Create(4));
  const Picture first = Again(test, *renderer, *supersampler, 16, 16);
  const Picture wide = Again(test, *renderer, *supersampler, 48, 16);
  EXPECT_EQ(Again(test, *renderer, *supersampler, 16, 16).values, first.values);
  EXPECT_LT(DifferenceFromMeans(test, wide, 2, 48, 16), kRounding);
}

TEST_F(SupersamplerTest, ASizeOverTheDevicesLimitIsRefused) {
  const TestScene test = Squares();
  const auto renderer = Must(SceneRenderer::Create(test.scene, nullptr));
  const auto supersampler = Must(Supersampler::Create(16));
  const int limit = context_->info().max_texture_size;
  const auto refused = supersampler->Render(*renderer, FrameInput(), limit / 4 + 1, 1);
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().kind, ErrorKind::kFailed);
  EXPECT_THAT(refused.error().message, testing::StartsWith("supersampled colour: a texture of " +
                                                           std::to_string((limit / 4 + 1) * 4) + "x4 pixels"));
}

}  // namespace
}  // namespace burin::gbuffer
