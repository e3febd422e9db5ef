// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/syntax/glsl_words.h"

#include <algorithm>
#include <iterator>

namespace burin::fx {
namespace {

struct Pair {
  std::string_view glsl, hlsl;
};
constexpr Pair kPairs[] = {{"vec2", "float2"},
                           {"vec3", "float3"},
                           {"vec4", "float4"},
                           {"ivec2", "int2"},
                           {"ivec3", "int3"},
                           {"ivec4", "int4"},
                           {"bvec2", "bool2"},
                           {"bvec3", "bool3"},
                           {"bvec4", "bool4"},
                           {"mat2", "float2x2"},
                           {"mat3", "float3x3"},
                           {"mat4", "float4x4"},
                           {"mix", "lerp"},
                           {"fract", "frac"},
                           {"mod", "fmod"},
                           {"inversesqrt", "rsqrt"},
                           {"dFdx", "ddx"},
                           {"dFdy", "ddy"},
                           {"texture2D", "tex2D"},
                           {"texture", "tex2D"},
                           {"textureLod", "tex2Dlod"},
                           {"textureGrad", "tex2Dgrad"},
                           {"textureProj", "tex2Dproj"},
                           {"textureCube", "texCUBE"},
                           {"texture3D", "tex3D"},
                           {"lessThan", "<"},
                           {"greaterThan", ">"},
                           {"equal", "=="},
                           {"matrixCompMult", "*"}};

}  // namespace

std::string_view HlslWordFor(std::string_view glsl_word) {
  const auto found = std::ranges::find(kPairs, glsl_word, &Pair::glsl);
  return found == std::end(kPairs) ? std::string_view() : found->hlsl;
}

}  // namespace burin::fx
