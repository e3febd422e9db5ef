// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/semantics/type.h"

#include "fx_parser/syntax/ast.h"

namespace burin::fx {
namespace {

std::string ScalarName(Scalar scalar) {
  switch (scalar) {
    case Scalar::kBool:
      return "bool";
    case Scalar::kInt:
      return "int";
    case Scalar::kUint:
      return "uint";
    case Scalar::kHalf:
      return "half";
    case Scalar::kFloat:
      return "float";
    case Scalar::kDouble:
      return "double";
  }
  return "float";
}

std::string DimensionSuffix(Dimension dimension) {
  switch (dimension) {
    case Dimension::kUnknown:
      return "";
    case Dimension::k1D:
      return "1D";
    case Dimension::k2D:
      return "2D";
    case Dimension::k3D:
      return "3D";
    case Dimension::kCube:
      return "CUBE";
  }
  return "";
}

std::string BaseName(const Type& type) {
  switch (type.kind) {
    case TypeKind::kError:
      return "<error>";
    case TypeKind::kVoid:
      return "void";
    case TypeKind::kString:
      return "string";
    case TypeKind::kTexture:
      return "texture" + DimensionSuffix(type.dimension);
    case TypeKind::kSampler:
      return "sampler" + DimensionSuffix(type.dimension);
    case TypeKind::kVertexShader:
      return "vertexshader";
    case TypeKind::kPixelShader:
      return "pixelshader";
    case TypeKind::kStateBlock:
      return "stateblock";
    case TypeKind::kObject:
      return "object of shader model 4";
    case TypeKind::kStruct:
      if (type.structure == nullptr || type.structure->name.empty()) return "struct <unnamed>";
      return type.structure->name;
    case TypeKind::kNumeric:
      break;
  }
  std::string name = ScalarName(type.scalar);
  if (type.is_matrix) return name + std::to_string(type.rows) + "x" + std::to_string(type.columns);
  if (type.is_vector) return name + std::to_string(type.columns);
  return name;
}

}  // namespace

Type ScalarType(Scalar scalar) {
  Type type;
  type.kind = TypeKind::kNumeric;
  type.scalar = scalar;
  return type;
}

Type VectorType(Scalar scalar, int columns) {
  Type type = ScalarType(scalar);
  type.columns = static_cast<std::uint8_t>(columns);
  type.is_vector = true;
  return type;
}

Type MatrixType(Scalar scalar, int rows, int columns) {
  Type type = ScalarType(scalar);
  type.rows = static_cast<std::uint8_t>(rows);
  type.columns = static_cast<std::uint8_t>(columns);
  type.is_matrix = true;
  return type;
}

std::string ToString(const Type& type) {
  std::string name = BaseName(type);
  for (const std::uint32_t size : type.array) name += "[" + std::to_string(size) + "]";
  return name;
}

}  // namespace burin::fx
