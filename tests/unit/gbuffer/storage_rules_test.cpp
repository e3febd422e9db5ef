// SPDX-License-Identifier: Apache-2.0
#include <epoxy/gl.h>
#include <gmock/gmock.h>

#include "core/gbuffer/storage.h"

namespace burin::gbuffer {
namespace {

using testing::ElementsAre;
using testing::FloatNear;

Storage Of(Attribute attribute, gl::Numeric numeric, int bits,
           image::Encoding encoding = image::Encoding::kSceneLinear) {
  Storage storage;
  storage.attribute = attribute;
  storage.format.swizzle = {GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA};
  storage.format.numeric = numeric;
  storage.format.bits = bits;
  storage.encoding = encoding;
  return storage;
}

TEST(StorageRules, SignedBackgroundsAreHalvedInUnorm) {
  EXPECT_THAT(StoredBackground(Of(Attribute::kNormal, gl::Numeric::kUnorm, 8), {}), ElementsAre(0.5f, 0.5f, 0.5f, 0));
  EXPECT_THAT(StoredBackground(Of(Attribute::kNormal, gl::Numeric::kFloat, 16), {}), ElementsAre(0, 0, 0, 0));
  EXPECT_THAT(StoredBackground(Of(Attribute::kVelocity, gl::Numeric::kUnorm, 8), {}), ElementsAre(0.5f, 0.5f, 0, 0));
  EXPECT_THAT(StoredBackground(Of(Attribute::kFacing, gl::Numeric::kUnorm, 8), {}), ElementsAre(0.5f, 0.5f, 0.5f, 0));
}

TEST(StorageRules, FarIsTheLargestHalfInHalves) {
  EXPECT_EQ(StoredBackground(Of(Attribute::kDepth, gl::Numeric::kFloat, 32), {})[0], 1e10f);
  EXPECT_EQ(StoredBackground(Of(Attribute::kDepth, gl::Numeric::kFloat, 16), {})[0], 65504.0f);
}

TEST(StorageRules, AColourBackgroundIsEncodedForItsTarget) {
  const std::array<float, 4> background = {0.25f, 0.0f, 0.5f, 0.5f};
  const auto display =
      StoredBackground(Of(Attribute::kColor, gl::Numeric::kUnorm, 8, image::Encoding::kDisplay), background);
  EXPECT_THAT(display, ElementsAre(FloatNear(0.735357f, 1e-5f), 0, FloatNear(1.0f, 1e-5f), 0.5f));
  EXPECT_THAT(StoredBackground(Of(Attribute::kColor, gl::Numeric::kFloat, 16), background),
              ElementsAre(0.25f, 0, 0.5f, 0.5f));
  EXPECT_THAT(StoredBackground(Of(Attribute::kAlpha, gl::Numeric::kFloat, 16), background),
              ElementsAre(0.5f, 0.5f, 0.5f, 0));
}

}  // namespace
}  // namespace burin::gbuffer
