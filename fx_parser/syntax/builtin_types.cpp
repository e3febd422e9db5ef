// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/syntax/builtin_types.h"

#include <algorithm>
#include <iterator>

#include "fx_parser/syntax/token.h"

namespace burin::fx {

namespace {

struct ScalarName {
  std::string_view name;
  Scalar scalar;
};

// `fixed` is Cg's, the min... types are Direct3D 11's hints; both are at least as precise as half.
constexpr ScalarName kScalars[] = {
    {"float", Scalar::kFloat},     {"half", Scalar::kHalf},       {"int", Scalar::kInt},
    {"bool", Scalar::kBool},       {"uint", Scalar::kUint},       {"double", Scalar::kDouble},
    {"dword", Scalar::kUint},      {"DWORD", Scalar::kUint},      {"fixed", Scalar::kHalf},
    {"min16float", Scalar::kHalf}, {"min10float", Scalar::kHalf}, {"min16int", Scalar::kInt},
    {"min12int", Scalar::kInt},    {"min16uint", Scalar::kUint},
};

struct ObjectName {
  std::string_view name;
  TypeKind kind;
  Dimension dimension = Dimension::kUnknown;
};

constexpr ObjectName kObjects[] = {
    {"texture", TypeKind::kTexture},
    {"texture1D", TypeKind::kTexture, Dimension::k1D},
    {"texture2D", TypeKind::kTexture, Dimension::k2D},
    {"texture3D", TypeKind::kTexture, Dimension::k3D},
    {"textureCUBE", TypeKind::kTexture, Dimension::kCube},
    {"textureRECT", TypeKind::kTexture, Dimension::k2D},
    {"sampler", TypeKind::kSampler},
    {"sampler1D", TypeKind::kSampler, Dimension::k1D},
    {"sampler2D", TypeKind::kSampler, Dimension::k2D},
    {"sampler3D", TypeKind::kSampler, Dimension::k3D},
    {"samplerCUBE", TypeKind::kSampler, Dimension::kCube},
    {"samplerRECT", TypeKind::kSampler, Dimension::k2D},
    {"SamplerState", TypeKind::kSampler},
    {"SamplerComparisonState", TypeKind::kSampler},
    {"string", TypeKind::kString},
    {"VertexShader", TypeKind::kVertexShader},
    {"PixelShader", TypeKind::kPixelShader},
    {"stateblock", TypeKind::kStateBlock},
    {"BlendState", TypeKind::kStateBlock},
    {"DepthStencilState", TypeKind::kStateBlock},
    {"RasterizerState", TypeKind::kStateBlock},
};

// Direct3D 10 and 11's and those of D3DX's fragment linker. Their case counts: `buffer` is a name like any other.
constexpr std::string_view kForeignObjects[] = {"Texture1DArray",
                                                "Texture2DArray",
                                                "TextureCubeArray",
                                                "Texture2DMS",
                                                "Texture2DMSArray",
                                                "Buffer",
                                                "StructuredBuffer",
                                                "ByteAddressBuffer",
                                                "RWBuffer",
                                                "RWTexture1D",
                                                "RWTexture2D",
                                                "RWTexture3D",
                                                "RWTexture1DArray",
                                                "RWTexture2DArray",
                                                "RWStructuredBuffer",
                                                "RWByteAddressBuffer",
                                                "ConsumeStructuredBuffer",
                                                "AppendStructuredBuffer",
                                                "ConstantBuffer",
                                                "PointStream",
                                                "LineStream",
                                                "TriangleStream",
                                                "InputPatch",
                                                "OutputPatch",
                                                "GeometryShader",
                                                "HullShader",
                                                "DomainShader",
                                                "ComputeShader",
                                                "vertexfragment",
                                                "pixelfragment"};

Type Numeric(Scalar scalar) {
  Type type;
  type.kind = TypeKind::kNumeric;
  type.scalar = scalar;
  return type;
}

std::uint8_t Digit(char c) { return c >= '1' && c <= '4' ? static_cast<std::uint8_t>(c - '0') : std::uint8_t{0}; }

// "float", "float3" or "float3x4" after the scalar's name.
bool ApplyShape(std::string_view shape, Type& type) {
  if (shape.empty()) return true;
  type.rows = 1;
  type.columns = Digit(shape[0]);
  if (shape.size() == 1) {
    type.is_vector = true;
    return type.columns != 0;
  }
  if (shape.size() != 3 || shape[1] != 'x') return false;
  type.rows = type.columns;
  type.columns = Digit(shape[2]);
  type.is_matrix = true;
  return type.rows != 0 && type.columns != 0;
}

}  // namespace

std::optional<Scalar> FindScalar(std::string_view name) {
  for (const ScalarName& scalar : kScalars) {
    if (scalar.name == name) return scalar.scalar;
  }
  return std::nullopt;
}

std::optional<Type> FindBuiltinType(std::string_view name) {
  for (const ScalarName& scalar : kScalars) {
    Type type = Numeric(scalar.scalar);
    if (name.starts_with(scalar.name) && ApplyShape(name.substr(scalar.name.size()), type)) return type;
  }
  Type type;
  if (name == "void") {
    type.kind = TypeKind::kVoid;
    return type;
  }
  for (const ObjectName& object : kObjects) {
    if (!EqualsIgnoringCase(object.name, name)) continue;
    type.kind = object.kind;
    type.dimension = object.dimension;
    return type;
  }
  if (std::ranges::find(kForeignObjects, name) != std::end(kForeignObjects)) {
    type.kind = TypeKind::kObject;
    return type;
  }
  type = Numeric(Scalar::kFloat);
  if (EqualsIgnoringCase(name, "vector") && ApplyShape("4", type)) return type;
  if (EqualsIgnoringCase(name, "matrix") && ApplyShape("4x4", type)) return type;
  return std::nullopt;
}

std::vector<std::string> BuiltinTypeNames() {
  std::vector<std::string> names{"void", "vector", "matrix"};
  for (const std::string_view scalar : {"float", "half", "int", "bool"}) {
    names.emplace_back(scalar);
    for (const std::string_view shape : {"2", "3", "4", "3x3", "4x3", "4x4"}) {
      names.push_back(std::string(scalar) + std::string(shape));
    }
  }
  for (const ObjectName& object : kObjects) names.emplace_back(object.name);
  return names;
}

}  // namespace burin::fx
