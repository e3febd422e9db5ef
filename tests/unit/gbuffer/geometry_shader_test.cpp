// SPDX-License-Identifier: Apache-2.0
#include "core/gbuffer/geometry_shader.h"

#include <epoxy/gl.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

namespace burin::gbuffer {
namespace {

Output Of(Attribute attribute, int location = 0) {
  Output output;
  output.location = location;
  output.storage.attribute = attribute;
  output.storage.format.internal = GL_RGBA8;
  output.storage.format.swizzle = {GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA};
  output.storage.encoding = image::Encoding::kDisplay;
  return output;
}

constexpr std::uint32_t kEverything = (1u << 13) - 1;

TEST(GeometryShader, AttributesDependOnlyOnWhatTheyShow) {
  const std::uint32_t opaque = kEverything & ~(kIsMasked | kIsBlend | kIsBlendedColor);
  EXPECT_EQ(RelevantFeatures({Of(Attribute::kDepth)}, opaque), 0u);
  EXPECT_EQ(RelevantFeatures({Of(Attribute::kAlbedo)}, opaque), kHasBaseColorTexture);
  EXPECT_EQ(RelevantFeatures({Of(Attribute::kRoughness)}, opaque), kHasMetallicRoughnessTexture);
  EXPECT_EQ(RelevantFeatures({Of(Attribute::kNormal)}, opaque), kHasNormals | kHasNormalTexture | kHasTangents);
  EXPECT_EQ(RelevantFeatures({Of(Attribute::kNormal)}, opaque & ~kHasNormalTexture), kHasNormals);
}

TEST(GeometryShader, AMaskNeedsItsTextureForEveryAttribute) {
  EXPECT_EQ(RelevantFeatures({Of(Attribute::kDepth)}, kIsMasked | kHasBaseColorTexture | kHasEmissiveTexture),
            kIsMasked | kHasBaseColorTexture);
}

TEST(GeometryShader, AnUnlitColourNeedsNoShading) {
  EXPECT_EQ(RelevantFeatures({Of(Attribute::kColor)},
                             kIsUnlit | kHasNormals | kHasBaseColorTexture | kHasNormalTexture | kHasLights),
            kIsUnlit | kHasNormals | kHasBaseColorTexture);
}

class Validator {
 public:
  Validator() : folder_(testing::TempDir() + fmt::format("burin_glsl_{}", getpid())) {}
  static bool IsThere() { return std::system("command -v glslangValidator > /dev/null") == 0; }
  // Empty: valid.
  std::string Check(const std::string& text, const char* stage) const {
    const std::string path = folder_ + "." + stage;
    std::ofstream(path) << text;
    std::string log;
    std::FILE* pipe = popen(("glslangValidator " + path).c_str(), "r");
    char buffer[256];
    while (pipe != nullptr && std::fgets(buffer, sizeof(buffer), pipe) != nullptr) log += buffer;
    const int status = pipe == nullptr ? 1 : pclose(pipe);
    std::remove(path.c_str());
    return status == 0 ? std::string() : log;
  }

 private:
  std::string folder_;
};

TEST(GeometryShader, EveryTextValidates) {
  if (!Validator::IsThere()) GTEST_SKIP() << "no glslangValidator here (Debian package glslang-tools)";
  const Validator validator;
  EXPECT_EQ(validator.Check(GeometryVertexText(0), "vert"), "");
  // Eight attributes at a time, with every feature, with none, and with each one alone.
  std::vector<std::uint32_t> variants = {0, kEverything, kEverything & ~kHasTangents};
  for (int bit = 0; bit < 13; ++bit) variants.push_back(1u << bit);
  std::vector<Attribute> drawn;
  for (const AttributeInfo& info : AllAttributes()) {
    const bool is_drawn = info.attribute != Attribute::kVideo && !IsEdgeAttribute(info.attribute);
    if (is_drawn) drawn.push_back(info.attribute);
  }
  for (const std::uint32_t features : variants) {
    EXPECT_EQ(validator.Check(GeometryFragmentText({}, features), "frag"), "") << "depth alone " << features;
  }
  for (const std::uint32_t features : variants) {
    Output color = Of(Attribute::kColor);
    color.is_blended = true;
    EXPECT_EQ(validator.Check(GeometryFragmentText({color}, features | kIsSample), "frag"), "")
        << "samples " << features;
  }
  for (std::size_t first = 0; first < drawn.size(); first += 8) {
    std::vector<Output> outputs;
    for (std::size_t i = first; i < std::min(first + 8, drawn.size()); ++i) {
      outputs.push_back(Of(drawn[i], static_cast<int>(i - first)));
    }
    for (const std::uint32_t features : variants) {
      EXPECT_EQ(validator.Check(GeometryFragmentText(outputs, features), "frag"), "") << first << " " << features;
    }
  }
}

}  // namespace
}  // namespace burin::gbuffer
