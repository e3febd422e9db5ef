// SPDX-License-Identifier: Apache-2.0
// Supersampling as the job's scene stage composes it: which attributes it reaches, in which sizes and encodings.
#include "core/render/scene_stage.h"

#include <gmock/gmock.h>

#include "tests/gl/gbuffer/scene_fixture.h"

namespace burin::render {
namespace {

using gbuffer::Attribute;
using gbuffer::Float;
using gbuffer::Must;
using gbuffer::Unorm;
using image::Encoding;

class SceneStageTest : public gbuffer::GbufferTest {
 protected:
  struct Wanted {
    Attribute attribute;
    gl::Format format;
    Encoding encoding = Encoding::kSceneLinear;
    int scale = 1;
  };

  SceneStageTest() {
    test_.AddNode(test_.AddMesh(gbuffer::Sphere(test_.AddMaterial(gbuffer::Unlit({0.8f, 0.4f, 0.2f, 1})), 24)),
                  gbuffer::Translate(0.1f, 0, -4));
    test_.AddNode(test_.AddMesh(gbuffer::Square(test_.AddMaterial(gbuffer::Unlit({0.1f, 0.2f, 0.9f, 1})))),
                  glm::rotate(gbuffer::Translate(0.3f, 0.4f, -5), 0.5f, glm::vec3(0.3f, 0.2f, 1)));
  }

  std::vector<Picture> Fill(int samples, const std::vector<Wanted>& wanted) {
    const auto pictures = Must(PictureStage::Create(image::SrgbTransform()));
    SceneOptions options;
    options.samples = samples;
    options.background = background_;
    const auto stage = Must(SceneStage::Create(test_.scene, options, *pictures));
    SceneFrame frame;
    frame.pose = scene::EvaluatePose(test_.scene, {}, 0.0);
    frame.items = scene::BuildDrawItems(test_.scene, frame.pose, frame.pose);
    frame.view = frame.previous_view = gbuffer::Orthographic();
    std::vector<gl::Texture> targets;
    for (const Wanted& want : wanted) {
      targets.push_back(Must(gl::Texture::Create(want.format, kWidth * want.scale, kHeight * want.scale, 1, "target")));
    }
    std::vector<gbuffer::Request> requests;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      requests.push_back({wanted[i].attribute, &targets[i], wanted[i].encoding});
    }
    const Result<void> filled = stage->Fill(frame, requests);
    EXPECT_TRUE(filled) << filled.error().message;
    std::vector<Picture> read;
    for (const gl::Texture& target : targets) read.push_back(ReadPicture(target));
    return read;
  }

  static constexpr int kWidth = 24;
  static constexpr int kHeight = 20;
  gbuffer::TestScene test_;
};

/// The transfer function of IEC 61966-2-1, linear to display.
float Display(float c) { return c <= 0.0031308f ? 12.92f * c : 1.055f * std::pow(c, 1.0f / 2.4f) - 0.055f; }

TEST_F(SceneStageTest, IdsAndDataAreTheSameWhateverTheSamples) {
  const std::vector<Wanted> wanted = {{Attribute::kObjectId, Float()},    {Attribute::kMaterialId, Unorm()},
                                      {Attribute::kPrimitiveId, Float()}, {Attribute::kDepth, Float()},
                                      {Attribute::kNormal, Float()},      {Attribute::kAlbedo, Float()},
                                      {Attribute::kColor, Float()}};
  const std::vector<Picture> plain = Fill(1, wanted);
  const std::vector<Picture> sampled = Fill(16, wanted);
  for (std::size_t i = 0; i + 1 < wanted.size(); ++i) {
    EXPECT_EQ(sampled[i].values, plain[i].values) << gbuffer::Info(wanted[i].attribute).name;
  }
  EXPECT_NE(sampled.back().values, plain.back().values);
}

TEST_F(SceneStageTest, IntensityAndAlphaFollowFromTheMean) {
  const auto read =
      Fill(4, {{Attribute::kColor, Float()}, {Attribute::kIntensity, Float()}, {Attribute::kAlpha, Float()}});
  bool has_partial = false;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const std::vector<float> color = read[0].At(x, y);
      has_partial |= color[3] > 0 && color[3] < 1;
      EXPECT_NEAR(read[1].At(x, y)[0], 0.2126f * color[0] + 0.7152f * color[1] + 0.0722f * color[2], 1e-6f);
      EXPECT_EQ(read[2].At(x, y)[0], color[3]);
    }
  }
  EXPECT_TRUE(has_partial);
}

TEST_F(SceneStageTest, TheMeanIsEncodedNotTheSamples) {
  background_ = {0, 0, 0, 1};
  const auto read = Fill(16, {{Attribute::kColor, Float()}, {Attribute::kColor, Float(), Encoding::kDisplay}});
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(read[1].At(x, y)[c], Display(read[0].At(x, y)[c]), 2e-6f) << x << " " << y;
      }
    }
  }
}

TEST_F(SceneStageTest, ALargerTargetIsSampledAtItsOwnSize) {
  const auto read = Fill(4, {{Attribute::kColor, Float(), Encoding::kSceneLinear, 3}, {Attribute::kColor, Float()}});
  const auto plain = Fill(1, {{Attribute::kColor, Float(), Encoding::kSceneLinear, 6}});
  for (int y = 0; y < 3 * kHeight; ++y) {
    for (int x = 0; x < 3 * kWidth; ++x) {
      float sum = 0;
      for (int i = 0; i < 4; ++i) sum += plain[0].At(2 * x + i % 2, 2 * y + i / 2)[0];
      EXPECT_NEAR(read[0].At(x, y)[0], sum / 4, 1e-6f) << x << " " << y;
    }
  }
}

}  // namespace
}  // namespace burin::render
