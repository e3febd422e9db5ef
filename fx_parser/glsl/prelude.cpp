// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/glsl/prelude.h"

#include <map>
#include <string_view>
#include <vector>

namespace burin::fx {
namespace {

/// `scalar` and `vector` are the two forms; $T is the type, $B the bool vector of its size. `needs` are helpers of the
/// same type. The order of the table is the order of definition.
struct Definition {
  std::string_view name;
  std::string_view scalar;
  std::string_view vector;
  std::vector<std::string_view> needs = {};
};

// The largest float stands where Direct3D 9 hardware gives a large number for the reciprocal or logarithm of 0.
const std::vector<Definition>& Definitions() {
  static const std::vector<Definition> definitions = {
      {"burin_select", "$T burin_select(bool c, $T a, $T b) { return c ? a : b; }\n",
       "$T burin_select(bool c, $T a, $T b) { return c ? a : b; }\n"},
      {"burin_mix", "$T burin_mix(bool c, $T a, $T b) { return c ? a : b; }\n",
       "$T burin_mix($B c, $T a, $T b) { return mix(b, a, c); }\n"},
      {"burin_and", "bool burin_and(bool a, bool b) { return a && b; }\n",
       "$T burin_and($T a, $T b) { return $T(uvec$N(a) & uvec$N(b)); }\n"},
      {"burin_or", "bool burin_or(bool a, bool b) { return a || b; }\n",
       "$T burin_or($T a, $T b) { return $T(uvec$N(a) | uvec$N(b)); }\n"},
      {"burin_div", "float burin_div(float a, float b) { return b == 0.0 ? a * 3.402823466e38 : a / b; }\n",
       "$T burin_div($T a, $T b) { return mix(a / b, a * 3.402823466e38, equal(b, $T(0.0))); }\n"},
      {"burin_idiv", "$T burin_idiv($T a, $T b) { return b == $T(0) ? $T(0) : a / b; }\n",
       "$T burin_idiv($T a, $T b) { $B z = equal(b, $T(0)); return mix(a / mix(b, $T(1), z), $T(0), z); }\n"},
      {"burin_imod", "$T burin_imod($T a, $T b) { return b == $T(0) ? $T(0) : a - b * (a / b); }\n",
       "$T burin_imod($T a, $T b) { $B z = equal(b, $T(0)); $T d = mix(b, $T(1), z); return mix(a - d * (a / d), "
       "$T(0), z); }\n"},
      {"burin_fmod", "float burin_fmod(float a, float b) { return b == 0.0 ? 0.0 : a - b * trunc(a / b); }\n",
       "$T burin_fmod($T a, $T b) { return mix(a - b * trunc(a / b), $T(0.0), equal(b, $T(0.0))); }\n"},
      {"burin_saturate", "float burin_saturate(float x) { return x > 0.0 ? min(x, 1.0) : 0.0; }\n",
       "$T burin_saturate($T x) { return mix($T(0.0), min(x, $T(1.0)), greaterThan(x, $T(0.0))); }\n"},
      {"burin_round", "float burin_round(float x) { return floor(x + 0.5); }\n",
       "$T burin_round($T x) { return floor(x + 0.5); }\n"},
      {"burin_sqrt", "float burin_sqrt(float x) { return sqrt(abs(x)); }\n",
       "$T burin_sqrt($T x) { return sqrt(abs(x)); }\n"},
      {"burin_rcp", "float burin_rcp(float x) { return x == 0.0 ? 3.402823466e38 : 1.0 / x; }\n",
       "$T burin_rcp($T x) { return mix(1.0 / x, $T(3.402823466e38), equal(x, $T(0.0))); }\n"},
      {"burin_rsqrt", "float burin_rsqrt(float x) { return x == 0.0 ? 3.402823466e38 : inversesqrt(abs(x)); }\n",
       "$T burin_rsqrt($T x) { return mix(inversesqrt(abs(x)), $T(3.402823466e38), equal(x, $T(0.0))); }\n"},
      {"burin_log2", "float burin_log2(float x) { return x == 0.0 ? -3.402823466e38 : log2(abs(x)); }\n",
       "$T burin_log2($T x) { return mix(log2(abs(x)), $T(-3.402823466e38), equal(x, $T(0.0))); }\n"},
      {"burin_log", "float burin_log(float x) { return x == 0.0 ? -3.402823466e38 : log(abs(x)); }\n",
       "$T burin_log($T x) { return mix(log(abs(x)), $T(-3.402823466e38), equal(x, $T(0.0))); }\n"},
      {"burin_log10",
       "float burin_log10(float x) { return burin_log(x) * 0.434294482; }\n",
       "$T burin_log10($T x) { return burin_log(x) * 0.434294482; }\n",
       {"burin_log"}},
      {"burin_pow", "float burin_pow(float x, float y) { return y == 0.0 ? 1.0 : pow(abs(x), y); }\n",
       "$T burin_pow($T x, $T y) { return mix(pow(abs(x), y), $T(1.0), equal(y, $T(0.0))); }\n"},
      {"burin_atan2", "float burin_atan2(float y, float x) { return x == 0.0 && y == 0.0 ? 0.0 : atan(y, x); }\n",
       "$T burin_atan2($T y, $T x) { $T r; for (int i = 0; i < $N; ++i) r[i] = x[i] == 0.0 && y[i] == 0.0 ? 0.0 : "
       "atan(y[i], x[i]); return r; }\n"},
      {"burin_clamp", "$T burin_clamp($T x, $T a, $T b) { return min(max(x, a), b); }\n",
       "$T burin_clamp($T x, $T a, $T b) { return min(max(x, a), b); }\n"},
      {"burin_smoothstep",
       "float burin_smoothstep(float a, float b, float x) { float t = burin_saturate(burin_div(x - a, b - a)); return "
       "t * t * (3.0 - 2.0 * t); }\n",
       "$T burin_smoothstep($T a, $T b, $T x) { $T t = burin_saturate(burin_div(x - a, b - a)); return t * t * (3.0 - "
       "2.0 * t); }\n",
       {"burin_saturate", "burin_div"}},
      {"burin_normalize", "float burin_normalize(float x) { return sign(x); }\n",
       "$T burin_normalize($T x) { float d = dot(x, x); return d > 0.0 ? x * inversesqrt(d) : $T(0.0); }\n"},
      {"burin_isfinite", "bool burin_isfinite(float x) { return !isnan(x) && !isinf(x); }\n",
       "$B burin_isfinite($T x) { return equal(x - x, $T(0.0)); }\n"},
      {"burin_ldexp", "float burin_ldexp(float x, float e) { return x * exp2(e); }\n",
       "$T burin_ldexp($T x, $T e) { return x * exp2(e); }\n"},
      {"burin_modf", "float burin_modf(float x, out float i) { i = trunc(x); return x - i; }\n",
       "$T burin_modf($T x, out $T i) { i = trunc(x); return x - i; }\n"},
      {"burin_frexp",
       "float burin_frexp(float x, out float e) { e = x == 0.0 ? 0.0 : floor(log2(abs(x))) + 1.0; float m = x * "
       "exp2(-e); "
       "if (abs(m) >= 1.0) { m *= 0.5; e += 1.0; } if (x != 0.0 && abs(m) < 0.5) { m *= 2.0; e -= 1.0; } return m; }\n",
       "$T burin_frexp($T x, out $T e) { $T m; for (int i = 0; i < $N; ++i) { float p; m[i] = burin_frexp(x[i], p); "
       "e[i] = p; } return m; }\n",
       {"burin_frexp:float"}},
      {"burin_sincos", "void burin_sincos(float x, out float s, out float c) { s = sin(x); c = cos(x); }\n",
       "void burin_sincos($T x, out $T s, out $T c) { s = sin(x); c = cos(x); }\n"},
      {"burin_clip", "void burin_clip(float x) { if (x < 0.0) discard; }\n",
       "void burin_clip($T x) { if (any(lessThan(x, $T(0.0)))) discard; }\n"},
      {"burin_lit",
       "vec4 burin_lit(float l, float h, float m) { return vec4(1.0, max(l, 0.0), l < 0.0 || h < 0.0 ? 0.0 : m == 0.0 "
       "? 1.0 : pow(h, m), 1.0); }\n",
       ""},
      {"burin_dst", "", "vec4 burin_dst(vec4 a, vec4 b) { return vec4(1.0, a.y * b.y, a.z, b.w); }\n"},
      {"burin_ubyte4", "", "ivec4 burin_ubyte4(vec4 c) { return ivec4(c.zyxw * 255.002); }\n"},
      // Perlin, "Improving Noise" (SIGGRAPH 2002), with an integer hash (PCG's output mix) in place of the permutation
      // table. Gradients point to the middles of a cube's edges; in four dimensions, to those of a tesseract's cubes.
      {"burin_hash",
       "uint burin_hash(uint x) { x = x * 747796405u + 2891336453u; x = ((x >> ((x >> 28) + 4u)) ^ x) * 277803737u; "
       "return (x >> 22) ^ x; }\n",
       "",
       {}},
      {"burin_gradient",
       "",
       "float burin_gradient(ivec4 c, vec4 d) {\n"
       "  uint h = burin_hash(uint(c.x) + burin_hash(uint(c.y) + burin_hash(uint(c.z) + burin_hash(uint(c.w)))));\n"
       "  uint zero = (h >> 4) & 3u;\n"
       "  vec4 g = vec4((h & 1u) == 0u ? 1.0 : -1.0, (h & 2u) == 0u ? 1.0 : -1.0, (h & 4u) == 0u ? 1.0 : -1.0, (h & "
       "8u) == 0u ? 1.0 : -1.0);\n"
       "  g[zero] = 0.0;\n"
       "  return dot(g, d);\n"
       "}\n",
       {"burin_hash:float"}},
      {"burin_noise4",
       "",
       "float burin_noise4(vec4 p) {\n"
       "  vec4 b = floor(p), f = p - b, w = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);\n"
       "  float sum = 0.0;\n"
       "  for (int i = 0; i < 16; ++i) {\n"
       "    vec4 o = vec4(i & 1, (i >> 1) & 1, (i >> 2) & 1, (i >> 3) & 1);\n"
       "    vec4 k = mix(1.0 - w, w, o);\n"
       "    sum += k.x * k.y * k.z * k.w * burin_gradient(ivec4(b + o), f - o);\n"
       "  }\n"
       "  return clamp(sum * 0.9, -1.0, 1.0);\n"
       "}\n",
       {"burin_gradient:vec4"}},
      {"burin_noise",
       "float burin_noise(float x) { return burin_noise4(vec4(x, 0.0, 0.0, 0.0)); }\n",
       "float burin_noise($T x) { vec4 p = vec4(0.0); for (int i = 0; i < $N; ++i) p[i] = x[i]; return "
       "burin_noise4(p); }\n",
       {"burin_noise4:vec4"}},
  };
  return definitions;
}

std::size_t IndexOf(std::string_view name) {
  const auto& definitions = Definitions();
  for (std::size_t i = 0; i < definitions.size(); ++i) {
    if (definitions[i].name == name) return i;
  }
  return definitions.size();
}

std::string Instantiate(std::string_view form, const std::string& type) {
  const bool is_vector = type.back() >= '2' && type.back() <= '4' && type.find('v') != std::string::npos;
  const std::string size = is_vector ? type.substr(type.size() - 1) : "1";
  std::string text;
  for (std::size_t i = 0; i < form.size(); ++i) {
    if (form[i] != '$') {
      text += form[i];
      continue;
    }
    ++i;
    if (form[i] == 'T')
      text += type;
    else if (form[i] == 'N')
      text += size;
    else
      text += is_vector ? "bvec" + size : "bool";
  }
  return text;
}

using Wanted = std::map<std::pair<std::size_t, std::string>, bool>;

void Add(Wanted& wanted, std::string_view name, const std::string& type) {
  const std::size_t index = IndexOf(name);
  if (index == Definitions().size() || !wanted.emplace(std::pair(index, type), true).second) return;
  for (const std::string_view need : Definitions()[index].needs) {
    const std::size_t colon = need.find(':');
    if (colon == std::string_view::npos)
      Add(wanted, need, type);
    else if (const auto fixed = std::string(need.substr(colon + 1)); need.substr(0, colon) != name || fixed != type)
      Add(wanted, need.substr(0, colon), fixed);
  }
}

}  // namespace

std::string PreludeText(const std::set<PreludeFunction>& functions) {
  Wanted wanted;
  for (const PreludeFunction& function : functions) Add(wanted, function.name, function.type);
  std::string text;
  for (const auto& [key, unused] : wanted) {
    const Definition& definition = Definitions()[key.first];
    const bool is_scalar = key.second == "float" || key.second == "int" || key.second == "uint" || key.second == "bool";
    const std::string_view form =
        (is_scalar && !definition.scalar.empty()) || definition.vector.empty() ? definition.scalar : definition.vector;
    text += Instantiate(form, key.second);
  }
  return text;
}

}  // namespace burin::fx
