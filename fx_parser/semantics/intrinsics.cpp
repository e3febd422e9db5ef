// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/semantics/intrinsics.h"

#include <algorithm>

#include "fx_parser/semantics/conversion.h"

namespace burin::fx {
namespace {

constexpr unsigned kLookup = kImplicitDerivatives;
constexpr unsigned kDerivative = kImplicitDerivatives | kFragmentOnly;

// Signatures: learn.microsoft.com "Intrinsic Functions (DirectX HLSL)", shader models 1 to 3. rcp, mad, isnan of later
// models and trunc occur in files of shader model 3 and are harmless.
constexpr Intrinsic kIntrinsics[] = {
    {"abs", "N:N", "abs"},
    {"acos", "F:F", "acos"},
    {"all", "b:N", "all"},
    {"any", "b:N", "any"},
    {"asfloat", "R:N", ""},
    {"asin", "F:F", "asin"},
    {"asint", "I:N", ""},
    {"asuint", "U:N", ""},
    {"atan", "F:F", "atan"},
    {"atan2", "F:FF", "burin_atan2"},
    {"ceil", "F:F", "ceil"},
    {"clamp", "N:NNN", "burin_clamp"},
    {"clip", "v:F", "burin_clip", kFragmentOnly | kHasEffect},
    {"cos", "F:F", "cos"},
    {"cosh", "F:F", "cosh"},
    {"cross", "3:33", "cross"},
    {"D3DCOLORtoUBYTE4", "i:4", "burin_ubyte4"},
    {"ddx", "F:F", "dFdx", kDerivative},
    {"ddx_coarse", "F:F", "dFdxCoarse", kDerivative},
    {"ddx_fine", "F:F", "dFdxFine", kDerivative},
    {"ddy", "F:F", "dFdy", kDerivative},
    {"ddy_coarse", "F:F", "dFdyCoarse", kDerivative},
    {"ddy_fine", "F:F", "dFdyFine", kDerivative},
    {"degrees", "F:F", "degrees"},
    {"determinant", "f:Q", "determinant"},
    {"distance", "f:VV", "distance"},
    {"dot", "f:VV", "dot"},
    {"dst", "4:44", "burin_dst"},
    {"exp", "F:F", "exp"},
    {"exp2", "F:F", "exp2"},
    {"faceforward", "V:VVV", "faceforward"},
    {"floor", "F:F", "floor"},
    {"fmod", "F:FF", "burin_fmod"},
    {"frac", "F:F", "fract"},
    {"frexp", "F:F>F", "burin_frexp", kHasEffect},
    {"fwidth", "F:F", "fwidth", kDerivative},
    {"isfinite", "B:F", "burin_isfinite"},
    {"isinf", "B:F", "isinf"},
    {"isnan", "B:F", "isnan"},
    {"ldexp", "F:FF", "burin_ldexp"},
    {"length", "f:V", "length"},
    {"lerp", "F:FFF", "mix"},
    {"lit", "4:fff", "burin_lit"},
    {"log", "F:F", "burin_log"},
    {"log10", "F:F", "burin_log10"},
    {"log2", "F:F", "burin_log2"},
    {"mad", "N:NNN", "(($0) * ($1) + ($2))"},
    {"max", "N:NN", "max"},
    {"min", "N:NN", "min"},
    {"modf", "F:F>F", "burin_modf", kHasEffect},
    {"mul", "*:**", ""},
    {"noise", "f:V", "burin_noise"},
    {"normalize", "V:V", "burin_normalize"},
    {"pow", "F:FF", "burin_pow"},
    {"radians", "F:F", "radians"},
    {"rcp", "F:F", "burin_rcp"},
    {"reflect", "V:VV", "reflect"},
    {"refract", "V:VVf", "refract"},
    {"round", "F:F", "burin_round"},
    {"rsqrt", "F:F", "burin_rsqrt"},
    {"saturate", "F:F", "burin_saturate"},
    {"sign", "I:N", "sign"},
    {"sin", "F:F", "sin"},
    {"sincos", "v:F>F>F", "burin_sincos", kHasEffect},
    {"sinh", "F:F", "sinh"},
    {"smoothstep", "F:FFF", "burin_smoothstep"},
    {"sqrt", "F:F", "burin_sqrt"},
    {"step", "F:FF", "step"},
    {"tan", "F:F", "tan"},
    {"tanh", "F:F", "tanh"},
    {"tex1D", "4:pf", "texture($0, $1)", kLookup},
    {"tex1D", "4:pfff", "textureGrad($0, $1, $2, $3)"},
    {"tex1Dbias", "4:p4", "texture($0, ($1).x, ($1).w)", kLookup},
    {"tex1Dgrad", "4:pfff", "textureGrad($0, $1, $2, $3)"},
    {"tex1Dlod", "4:p4", "textureLod($0, ($1).x, ($1).w)"},
    {"tex1Dproj", "4:p4", "textureProj($0, $1)", kLookup},
    {"tex2D", "4:q2", "texture($0, $1)", kLookup},
    {"tex2D", "4:q222", "textureGrad($0, $1, $2, $3)"},
    {"tex2Dbias", "4:q4", "texture($0, ($1).xy, ($1).w)", kLookup},
    {"tex2Dgrad", "4:q222", "textureGrad($0, $1, $2, $3)"},
    {"tex2Dlod", "4:q4", "textureLod($0, ($1).xy, ($1).w)"},
    {"tex2Dproj", "4:q4", "textureProj($0, $1)", kLookup},
    {"tex2Dproj", "4:q3", "textureProj($0, $1)", kLookup},  // Cg's
    {"tex3D", "4:r3", "texture($0, $1)", kLookup},
    {"tex3D", "4:r333", "textureGrad($0, $1, $2, $3)"},
    {"tex3Dbias", "4:r4", "texture($0, ($1).xyz, ($1).w)", kLookup},
    {"tex3Dgrad", "4:r333", "textureGrad($0, $1, $2, $3)"},
    {"tex3Dlod", "4:r4", "textureLod($0, ($1).xyz, ($1).w)"},
    {"tex3Dproj", "4:r4", "textureProj($0, $1)", kLookup},
    {"texCUBE", "4:c3", "texture($0, $1)", kLookup},
    {"texCUBE", "4:c333", "textureGrad($0, $1, $2, $3)"},
    {"texCUBEbias", "4:c4", "texture($0, ($1).xyz, ($1).w)", kLookup},
    {"texCUBEgrad", "4:c333", "textureGrad($0, $1, $2, $3)"},
    {"texCUBElod", "4:c4", "textureLod($0, ($1).xyz, ($1).w)"},
    {"texCUBEproj", "4:c4", "texture($0, ($1).xyz / ($1).w)", kLookup},
    // Cg's look-ups by pixel, and those of its old profiles that say what they return.
    {"texRECT", "4:q2", "texture($0, ($1) / vec2(textureSize($0, 0)))", kLookup},
    {"texRECTproj", "4:q4", "texture($0, ($1).xy / ($1).w / vec2(textureSize($0, 0)))", kLookup},
    {"f1tex1D", "f:pf", "texture($0, $1)", kLookup},
    {"f1tex2D", "f:q2", "texture($0, $1)", kLookup},
    {"f1tex2Dproj", "f:q4", "textureProj($0, $1)", kLookup},
    {"f1tex3D", "f:r3", "texture($0, $1)", kLookup},
    {"f1texCUBE", "f:c3", "texture($0, $1)", kLookup},
    {"f1texRECT", "f:q2", "texture($0, ($1) / vec2(textureSize($0, 0)))", kLookup},
    {"f2tex1D", "2:pf", "texture($0, $1)", kLookup},
    {"f2tex2D", "2:q2", "texture($0, $1)", kLookup},
    {"f2tex2Dproj", "2:q4", "textureProj($0, $1)", kLookup},
    {"f2tex3D", "2:r3", "texture($0, $1)", kLookup},
    {"f2texCUBE", "2:c3", "texture($0, $1)", kLookup},
    {"f2texRECT", "2:q2", "texture($0, ($1) / vec2(textureSize($0, 0)))", kLookup},
    {"f3tex1D", "3:pf", "texture($0, $1)", kLookup},
    {"f3tex2D", "3:q2", "texture($0, $1)", kLookup},
    {"f3tex2Dproj", "3:q4", "textureProj($0, $1)", kLookup},
    {"f3tex3D", "3:r3", "texture($0, $1)", kLookup},
    {"f3texCUBE", "3:c3", "texture($0, $1)", kLookup},
    {"f3texRECT", "3:q2", "texture($0, ($1) / vec2(textureSize($0, 0)))", kLookup},
    {"f4tex1D", "4:pf", "texture($0, $1)", kLookup},
    {"f4tex2D", "4:q2", "texture($0, $1)", kLookup},
    {"f4tex2Dproj", "4:q4", "textureProj($0, $1)", kLookup},
    {"f4tex3D", "4:r3", "texture($0, $1)", kLookup},
    {"f4texCUBE", "4:c3", "texture($0, $1)", kLookup},
    {"f4texRECT", "4:q2", "texture($0, ($1) / vec2(textureSize($0, 0)))", kLookup},
    {"h1tex1D", "f:pf", "texture($0, $1)", kLookup},
    {"h1tex2D", "f:q2", "texture($0, $1)", kLookup},
    {"h1tex2Dproj", "f:q4", "textureProj($0, $1)", kLookup},
    {"h1tex3D", "f:r3", "texture($0, $1)", kLookup},
    {"h1texCUBE", "f:c3", "texture($0, $1)", kLookup},
    {"h1texRECT", "f:q2", "texture($0, ($1) / vec2(textureSize($0, 0)))", kLookup},
    {"h2tex1D", "2:pf", "texture($0, $1)", kLookup},
    {"h2tex2D", "2:q2", "texture($0, $1)", kLookup},
    {"h2tex2Dproj", "2:q4", "textureProj($0, $1)", kLookup},
    {"h2tex3D", "2:r3", "texture($0, $1)", kLookup},
    {"h2texCUBE", "2:c3", "texture($0, $1)", kLookup},
    {"h2texRECT", "2:q2", "texture($0, ($1) / vec2(textureSize($0, 0)))", kLookup},
    {"h3tex1D", "3:pf", "texture($0, $1)", kLookup},
    {"h3tex2D", "3:q2", "texture($0, $1)", kLookup},
    {"h3tex2Dproj", "3:q4", "textureProj($0, $1)", kLookup},
    {"h3tex3D", "3:r3", "texture($0, $1)", kLookup},
    {"h3texCUBE", "3:c3", "texture($0, $1)", kLookup},
    {"h3texRECT", "3:q2", "texture($0, ($1) / vec2(textureSize($0, 0)))", kLookup},
    {"h4tex1D", "4:pf", "texture($0, $1)", kLookup},
    {"h4tex2D", "4:q2", "texture($0, $1)", kLookup},
    {"h4tex2Dproj", "4:q4", "textureProj($0, $1)", kLookup},
    {"h4tex3D", "4:r3", "texture($0, $1)", kLookup},
    {"h4texCUBE", "4:c3", "texture($0, $1)", kLookup},
    {"h4texRECT", "4:q2", "texture($0, ($1) / vec2(textureSize($0, 0)))", kLookup},
    {"transpose", "m:M", "transpose"},
    {"trunc", "F:F", "trunc"},
};

bool IsGeneric(char c) { return c == 'F' || c == 'N' || c == 'V'; }

Type FixedType(char c) {
  Type sampler;
  sampler.kind = TypeKind::kSampler;
  switch (c) {
    case 'f':
      return ScalarType(Scalar::kFloat);
    case 'b':
      return ScalarType(Scalar::kBool);
    case 'i':
      return VectorType(Scalar::kInt, 4);
    case '2':
      return VectorType(Scalar::kFloat, 2);
    case '3':
      return VectorType(Scalar::kFloat, 3);
    case '4':
      return VectorType(Scalar::kFloat, 4);
    case 'p':
      sampler.dimension = Dimension::k1D;
      return sampler;
    case 'q':
      sampler.dimension = Dimension::k2D;
      return sampler;
    case 'r':
      sampler.dimension = Dimension::k3D;
      return sampler;
    case 'c':
      sampler.dimension = Dimension::kCube;
      return sampler;
    default: {
      Type none;
      none.kind = TypeKind::kVoid;
      return none;
    }
  }
}

/// mul: a vector on the left is a row, on the right a column; the inner sizes shrink to the smaller one.
std::optional<IntrinsicCall> ResolveMul(const Type& a, const Type& b) {
  if (!a.is_numeric() || !b.is_numeric()) return std::nullopt;
  const Scalar scalar = CommonScalar(a.scalar, b.scalar);
  IntrinsicCall call;
  call.is_out = {false, false};
  const bool a_scalar = !a.is_vector && !a.is_matrix;
  const bool b_scalar = !b.is_vector && !b.is_matrix;
  if (a_scalar || b_scalar) {
    const Type shape = WithScalar(a_scalar ? b : a, scalar);
    call.result = shape;
    call.parameters = {a_scalar ? ScalarType(scalar) : shape, b_scalar ? ScalarType(scalar) : shape};
    return call;
  }
  const int inner = std::min(a.columns, b.is_matrix ? b.rows : b.columns);
  if (a.is_vector && b.is_vector) {
    call.result = ScalarType(scalar);
    call.parameters = {VectorType(scalar, inner), VectorType(scalar, inner)};
  } else if (a.is_vector) {
    call.result = VectorType(scalar, b.columns);
    call.parameters = {VectorType(scalar, inner), MatrixType(scalar, inner, b.columns)};
  } else if (b.is_vector) {
    call.result = VectorType(scalar, a.rows);
    call.parameters = {MatrixType(scalar, a.rows, inner), VectorType(scalar, inner)};
  } else {
    call.result = MatrixType(scalar, a.rows, b.columns);
    call.parameters = {MatrixType(scalar, a.rows, inner), MatrixType(scalar, inner, b.columns)};
  }
  return call;
}

/// The shape and scalar that all generic parameters of one call share.
std::optional<Type> GenericType(std::string_view letters, std::span<const Type> arguments) {
  std::optional<Type> common;
  for (std::size_t i = 0; i < letters.size(); ++i) {
    if (!IsGeneric(letters[i])) continue;
    if (!arguments[i].is_numeric()) return std::nullopt;
    Type shape = arguments[i];
    shape.row_major = false;
    if (letters[i] != 'N' && !IsFloating(shape.scalar)) shape.scalar = Scalar::kFloat;
    if (shape.scalar == Scalar::kBool) shape.scalar = Scalar::kInt;
    if (letters[i] == 'V' && shape.is_matrix) return std::nullopt;
    common = common ? CommonType(*common, shape) : std::optional(shape);
    if (!common) return std::nullopt;
  }
  return common;
}

struct Parsed {
  char result = 'v';
  std::string letters;
  std::vector<bool> is_out;
};

Parsed ParseSignature(std::string_view signature) {
  Parsed parsed;
  parsed.result = signature[0];
  bool out = false;
  for (const char c : signature.substr(2)) {
    if (c == '>') {
      out = true;
      continue;
    }
    parsed.letters += c;
    parsed.is_out.push_back(out);
    out = false;
  }
  return parsed;
}

Type ResultType(char letter, const std::optional<Type>& generic) {
  switch (letter) {
    case 'F':
    case 'N':
    case 'V':
      return *generic;
    case 'B':
      return WithScalar(*generic, Scalar::kBool);
    case 'I':
      return WithScalar(*generic, Scalar::kInt);
    case 'U':
      return WithScalar(*generic, Scalar::kUint);
    case 'R':
      return WithScalar(*generic, Scalar::kFloat);
    default:
      return FixedType(letter);
  }
}

}  // namespace

std::span<const Intrinsic> Intrinsics() { return kIntrinsics; }

bool IsIntrinsic(std::string_view name) {
  return std::any_of(std::begin(kIntrinsics), std::end(kIntrinsics),
                     [&](const Intrinsic& i) { return i.name == name; });
}

std::optional<IntrinsicCall> ResolveIntrinsic(const Intrinsic& intrinsic, std::span<const Type> arguments) {
  const Parsed parsed = ParseSignature(intrinsic.signature);
  if (parsed.letters.size() != arguments.size()) return std::nullopt;
  if (parsed.result == '*') return ResolveMul(arguments[0], arguments[1]);
  const std::optional<Type> generic = GenericType(parsed.letters, arguments);
  IntrinsicCall call;
  call.is_out = parsed.is_out;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const char letter = parsed.letters[i];
    if (IsGeneric(letter)) {
      if (!generic) return std::nullopt;
      call.parameters.push_back(*generic);
    } else if (letter == 'M' || letter == 'Q') {
      if (!arguments[i].is_numeric() || !arguments[i].is_matrix) return std::nullopt;
      if (letter == 'Q' && arguments[i].rows != arguments[i].columns) return std::nullopt;
      const Scalar scalar = IsFloating(arguments[i].scalar) ? arguments[i].scalar : Scalar::kFloat;
      call.parameters.push_back(MatrixType(scalar, arguments[i].rows, arguments[i].columns));
    } else {
      call.parameters.push_back(FixedType(letter));
    }
    const bool fits = parsed.is_out[i] ? ImplicitConversion(call.parameters[i], arguments[i]).has_value()
                                       : ImplicitConversion(arguments[i], call.parameters[i]).has_value();
    if (!fits) return std::nullopt;
  }
  if (parsed.result == 'm') {
    call.result = MatrixType(call.parameters[0].scalar, call.parameters[0].columns, call.parameters[0].rows);
  } else {
    call.result = ResultType(parsed.result, generic);
  }
  return call;
}

int FindIntrinsic(std::string_view name, std::span<const Type> arguments) {
  for (std::size_t i = 0; i < std::size(kIntrinsics); ++i) {
    if (kIntrinsics[i].name == name && ResolveIntrinsic(kIntrinsics[i], arguments)) return static_cast<int>(i);
  }
  return -1;
}

Dimension LookupDimension(const Intrinsic& intrinsic) {
  const Type first = FixedType(intrinsic.signature.size() > 2 ? intrinsic.signature[2] : 'v');
  return first.kind == TypeKind::kSampler ? first.dimension : Dimension::kUnknown;
}

std::string DescribeIntrinsic(const Intrinsic& intrinsic) {
  const auto describe = [](char letter) -> std::string {
    switch (letter) {
      case 'F':
        return "float<>";
      case 'N':
        return "numeric<>";
      case 'B':
        return "bool<>";
      case 'I':
        return "int<>";
      case 'U':
        return "uint<>";
      case 'R':
        return "float<>";
      case 'V':
        return "vector<>";
      case 'M':
      case 'm':
        return "matrix<>";
      case 'Q':
        return "square matrix<>";
      case '*':
        return "numeric<>";
      default:
        return ToString(FixedType(letter));
    }
  };
  const Parsed parsed = ParseSignature(intrinsic.signature);
  std::string text = describe(parsed.result) + " " + std::string(intrinsic.name) + "(";
  for (std::size_t i = 0; i < parsed.letters.size(); ++i) {
    if (i > 0) text += ", ";
    if (parsed.is_out[i]) text += "out ";
    text += describe(parsed.letters[i]);
  }
  return text + ")";
}

}  // namespace burin::fx
