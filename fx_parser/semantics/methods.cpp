// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/semantics/methods.h"

#include <algorithm>
#include <array>
#include <string>

namespace burin::fx {
namespace {

// learn.microsoft.com, "Texture-Object" of shader model 4.
constexpr Intrinsic kMethods[] = {
    {"Sample", "4:pf", "texture($0, $1)", kImplicitDerivatives},
    {"Sample", "4:q2", "texture($0, $1)", kImplicitDerivatives},
    {"Sample", "4:r3", "texture($0, $1)", kImplicitDerivatives},
    {"Sample", "4:c3", "texture($0, $1)", kImplicitDerivatives},
    {"SampleBias", "4:pff", "texture($0, $1, $2)", kImplicitDerivatives | kFragmentOnly},
    {"SampleBias", "4:q2f", "texture($0, $1, $2)", kImplicitDerivatives | kFragmentOnly},
    {"SampleBias", "4:r3f", "texture($0, $1, $2)", kImplicitDerivatives | kFragmentOnly},
    {"SampleBias", "4:c3f", "texture($0, $1, $2)", kImplicitDerivatives | kFragmentOnly},
    {"SampleLevel", "4:pff", "textureLod($0, $1, $2)"},
    {"SampleLevel", "4:q2f", "textureLod($0, $1, $2)"},
    {"SampleLevel", "4:r3f", "textureLod($0, $1, $2)"},
    {"SampleLevel", "4:c3f", "textureLod($0, $1, $2)"},
    {"SampleGrad", "4:pfff", "textureGrad($0, $1, $2, $3)"},
    {"SampleGrad", "4:q222", "textureGrad($0, $1, $2, $3)"},
    {"SampleGrad", "4:r333", "textureGrad($0, $1, $2, $3)"},
    {"SampleGrad", "4:c333", "textureGrad($0, $1, $2, $3)"},
};

enum class Gives : std::uint8_t { kElement, kFloat, kFloat4, kNothing };
struct Foreign {
  std::string_view name;
  Gives gives;
};
constexpr Foreign kForeign[] = {{"Sample", Gives::kElement},
                                {"SampleBias", Gives::kElement},
                                {"SampleLevel", Gives::kElement},
                                {"SampleGrad", Gives::kElement},
                                {"SampleCmp", Gives::kFloat},
                                {"SampleCmpLevelZero", Gives::kFloat},
                                {"Load", Gives::kElement},
                                {"Load2", Gives::kFloat4},
                                {"Load3", Gives::kFloat4},
                                {"Load4", Gives::kFloat4},
                                {"Gather", Gives::kFloat4},
                                {"GatherRed", Gives::kFloat4},
                                {"GatherGreen", Gives::kFloat4},
                                {"GatherBlue", Gives::kFloat4},
                                {"GatherAlpha", Gives::kFloat4},
                                {"GatherCmp", Gives::kFloat4},
                                {"GatherCmpRed", Gives::kFloat4},
                                {"CalculateLevelOfDetail", Gives::kFloat},
                                {"GetDimensions", Gives::kNothing},
                                {"GetSamplePosition", Gives::kFloat4},
                                {"Append", Gives::kNothing},
                                {"RestartStrip", Gives::kNothing},
                                {"Consume", Gives::kElement},
                                {"Store", Gives::kNothing},
                                {"CalculateLevelOfDetailUnclamped", Gives::kFloat}};

}  // namespace

std::span<const Intrinsic> Methods() { return kMethods; }

int FindMethod(const Type& texture, std::string_view name, std::span<const Type> arguments) {
  if (texture.kind != TypeKind::kTexture || texture.is_array()) return -1;
  const Dimension dimension = texture.dimension == Dimension::kUnknown ? Dimension::k2D : texture.dimension;
  for (std::size_t i = 0; i < std::size(kMethods); ++i) {
    const Intrinsic& method = kMethods[i];
    if (method.name == name && LookupDimension(method) == dimension && ResolveIntrinsic(method, arguments))
      return static_cast<int>(i);
  }
  return -1;
}

std::optional<Type> ForeignMethod(const Type& object, std::string_view name) {
  const auto found = std::ranges::find(kForeign, name, &Foreign::name);
  if (found == std::end(kForeign)) return std::nullopt;
  switch (found->gives) {
    case Gives::kFloat:
      return ScalarType(Scalar::kFloat);
    case Gives::kFloat4:
      return VectorType(Scalar::kFloat, 4);
    case Gives::kNothing:
      return Type{.kind = TypeKind::kVoid, .structure = nullptr, .array = {}};
    case Gives::kElement:
      break;
  }
  return TextureElement(object);
}

Type TextureElement(const Type& texture) {
  if (texture.kind != TypeKind::kTexture || !texture.is_vector) return VectorType(Scalar::kFloat, 4);
  return texture.columns == 1 ? ScalarType(texture.scalar) : VectorType(texture.scalar, texture.columns);
}

}  // namespace burin::fx
