// SPDX-License-Identifier: Apache-2.0
#include "core/effect/host_value.h"

#include <gtest/gtest.h>

#include "tests/unit/effect/hand_built_effect.h"

namespace burin::effect {
namespace {

const fx::Type kMatrix = fx::MatrixType(fx::Scalar::kFloat, 4, 4);
const fx::Type kFloat = fx::ScalarType(fx::Scalar::kFloat);
const fx::Type kFloat4 = fx::VectorType(fx::Scalar::kFloat, 4);

struct Found {
  std::optional<HostValue> host;
  std::vector<std::string> warnings;
};

// `is_of_others`: not a file of the extension's, so that names may mean something.
Found Find(const fx::Type& type, const std::string& semantic, const std::string& name = "p",
           bool is_of_others = false) {
  EffectBuilder builder;
  builder.effect.uses_extension = !is_of_others;
  builder.Texture("GBAcolor_A8R8G8B8_S3", fx::AttributeRole{"color", false});
  const fx::Parameter& parameter = builder.Parameter(name, type, semantic);
  Found found;
  found.host = FindHostValue(builder.effect, parameter, found.warnings);
  return found;
}

TEST(HostValue, EveryMatrixOfEverySpelling) {
  for (const char* product : {"World", "View", "Projection", "WorldView", "ViewProjection", "WorldViewProjection"}) {
    for (const char* suffix : {"", "Inverse", "Transpose", "InverseTranspose"}) {
      const Found found = Find(kMatrix, std::string(product) + suffix);
      ASSERT_TRUE(found.host) << product << suffix;
      EXPECT_EQ(found.host->kind, HostValue::Kind::kMatrix);
      const std::string name(product);
      EXPECT_EQ(found.host->world, name.find("World") != std::string::npos);
      EXPECT_EQ(found.host->view, name.find("View") != std::string::npos);
      EXPECT_EQ(found.host->projection, name.find("Projection") != std::string::npos);
      EXPECT_EQ(found.host->inverse, std::string(suffix).starts_with("Inverse"));
      EXPECT_EQ(found.host->transpose, std::string(suffix).ends_with("Transpose"));
      EXPECT_TRUE(found.warnings.empty());
    }
  }
  EXPECT_EQ(Find(kMatrix, "WORLDVIEWPROJ").host, Find(kMatrix, "worldviewprojection").host);
  EXPECT_EQ(Find(kMatrix, "ModelViewProjection").host, Find(kMatrix, "worldviewprojection").host);
  EXPECT_EQ(Find(kMatrix, "WorldIT").host, Find(kMatrix, "WorldInverseTranspose").host);
  EXPECT_EQ(Find(kMatrix, "ViewI").host, Find(kMatrix, "ViewInverse").host);
  EXPECT_EQ(Find(kMatrix, "VIEWINV").host, Find(kMatrix, "ViewInverse").host);
  EXPECT_EQ(Find(kMatrix, "WorldT").host, Find(kMatrix, "WorldTranspose").host);
}

TEST(HostValue, UnknownSemanticsAreWarnedOf) {
  const Found found = Find(kFloat, "WindSpeed", "gust");
  EXPECT_FALSE(found.host);
  EXPECT_EQ(found.warnings,
            (std::vector<std::string>{"test.fx: parameter 'gust' stays at its default: unknown semantic 'WindSpeed'"}));
}

TEST(HostValue, KnownOnesWithoutAValueAreNot) {
  for (const char* semantic : {"DIFFUSE", "StandardsGlobal", "MousePosition", "Specular", "Position"}) {
    const Found found = Find(kFloat4, semantic);
    EXPECT_FALSE(found.host) << semantic;
    EXPECT_TRUE(found.warnings.empty()) << semantic;
  }
}

TEST(HostValue, ATypeThatCannotHoldTheValueIsWarnedOf) {
  const Found found = Find(kFloat, "WorldViewProjection", "m");
  EXPECT_FALSE(found.host);
  EXPECT_EQ(found.warnings,
            (std::vector<std::string>{
                "test.fx: parameter 'm' stays at its default: a float cannot hold 'WorldViewProjection'"}));
}

TEST(HostValue, TheExtensionsNames) {
  EXPECT_EQ(Find(kFloat4, "", "TexelSize").host->kind, HostValue::Kind::kTexelSize);
  EXPECT_EQ(Find(kFloat4, "", "TexelSize_GBAcolor_A8R8G8B8_S3").host->texture, 0u);
  EXPECT_EQ(Find(kFloat, "", "Time").host->kind, HostValue::Kind::kTime);
  EXPECT_EQ(Find(fx::ScalarType(fx::Scalar::kInt), "", "Frame").host->kind, HostValue::Kind::kFrame);
  EXPECT_EQ(Find(fx::VectorType(fx::Scalar::kFloat, 2), "", "FrameSize").host->kind, HostValue::Kind::kFrameSize);
  EXPECT_FALSE(Find(kFloat, "", "TexelSize").host) << "one number cannot hold a size";
  EXPECT_FALSE(Find(kFloat4, "", "texelsize").host) << "names keep their case";
  const Found missing = Find(kFloat4, "", "TexelSize_GBAdepth_R32F");
  EXPECT_FALSE(missing.host);
  EXPECT_EQ(missing.warnings,
            (std::vector<std::string>{
                "test.fx: parameter 'TexelSize_GBAdepth_R32F' stays at its default: there is no texture "
                "'GBAdepth_R32F'"}));
}

TEST(HostValue, TexelSizeIsTheReciprocalWithZeros) {
  FrameContext context;
  context.width = 4;
  context.height = 8;
  const std::vector<glm::ivec2> sizes = {{12, 24}};
  std::vector<double> numbers(4, 9);
  Evaluate(*Find(kFloat4, "", "TexelSize").host, context, sizes, kFloat4, false, numbers);
  EXPECT_EQ(numbers, (std::vector<double>{0.25, 0.125, 0, 0}));
  Evaluate(*Find(kFloat4, "", "TexelSize_GBAcolor_A8R8G8B8_S3").host, context, sizes, kFloat4, false, numbers);
  EXPECT_FLOAT_EQ(static_cast<float>(numbers[0]), 1.0f / 12);
}

TEST(HostValue, MatricesAreWrittenAsRows) {
  FrameContext context;
  context.world_from_object[3] = {5, 6, 7, 1};  // a translation: the last row for row vectors
  std::vector<double> numbers(16, 0);
  Evaluate(*Find(kMatrix, "World").host, context, {}, kMatrix, false, numbers);
  EXPECT_EQ(numbers, (std::vector<double>{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1}));
  Evaluate(*Find(kMatrix, "World").host, context, {}, kMatrix, true, numbers);
  EXPECT_EQ(numbers, (std::vector<double>{1, 0, 0, 5, 0, 1, 0, 6, 0, 0, 1, 7, 0, 0, 0, 1}));
  const fx::Type narrow = fx::MatrixType(fx::Scalar::kFloat, 4, 3);
  numbers.assign(12, 0);
  Evaluate(*Find(narrow, "World").host, context, {}, narrow, false, numbers);
  EXPECT_EQ(numbers, (std::vector<double>{1, 0, 0, 0, 1, 0, 0, 0, 1, 5, 6, 7}));
}

}  // namespace
}  // namespace burin::effect
