// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/glsl/names.h"

#include <algorithm>
#include <iterator>

#include "fx_parser/glsl/interface.h"

namespace burin::fx {
namespace {

// GLSL 4.50 section 3.6, the keywords and reserved words that HLSL lets struct members be called.
constexpr std::string_view kReserved[] = {
    "active",        "asm",       "atomic_uint",   "attribute",     "bool",       "break",
    "buffer",        "bvec2",     "bvec3",         "bvec4",         "case",       "cast",
    "centroid",      "class",     "coherent",      "common",        "const",      "continue",
    "default",       "discard",   "dmat2",         "dmat3",         "dmat4",      "do",
    "double",        "dvec2",     "dvec3",         "dvec4",         "else",       "enum",
    "extern",        "external",  "false",         "filter",        "fixed",      "flat",
    "float",         "for",       "fvec2",         "fvec3",         "fvec4",      "goto",
    "half",          "highp",     "hvec2",         "hvec3",         "hvec4",      "if",
    "image1D",       "image2D",   "image3D",       "imageCube",     "in",         "inline",
    "inout",         "input",     "int",           "interface",     "invariant",  "isampler2D",
    "ivec2",         "ivec3",     "ivec4",         "layout",        "long",       "lowp",
    "mat2",          "mat2x2",    "mat2x3",        "mat2x4",        "mat3",       "mat3x2",
    "mat3x3",        "mat3x4",    "mat4",          "mat4x2",        "mat4x3",     "mat4x4",
    "mediump",       "namespace", "noinline",      "noperspective", "out",        "output",
    "partition",     "patch",     "precise",       "precision",     "public",     "readonly",
    "resource",      "restrict",  "return",        "sample",        "sampler1D",  "sampler2D",
    "sampler2DRect", "sampler3D", "samplerBuffer", "samplerCube",   "shared",     "short",
    "sizeof",        "smooth",    "static",        "struct",        "subroutine", "superp",
    "switch",        "template",  "this",          "true",          "typedef",    "uint",
    "uniform",       "union",     "unsigned",      "using",         "usampler2D", "uvec2",
    "uvec3",         "uvec4",     "varying",       "vec2",          "vec3",       "vec4",
    "void",          "volatile",  "while",         "writeonly"};

}  // namespace

std::string SanitisedName(std::string_view name) {
  std::string result;
  for (const char c : name) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    const char next = letter ? c : '_';
    if (next == '_' && !result.empty() && result.back() == '_') continue;
    result += next;
  }
  return result;
}

std::string PublicName(std::string_view name) {
  std::string result(name);
  for (std::size_t at = result.find("::"); at != std::string::npos; at = result.find("::", at))
    result.replace(at, 2, "_");
  return result;
}

std::string NameTable::Unique(std::string_view prefix, std::string_view base) {
  const std::string stem = SanitisedName(std::string(prefix) + std::string(base));
  std::string name = stem;
  for (int i = 1; !taken_.insert(name).second; ++i) {
    name = stem + (stem.back() == '_' ? "" : "_") + std::to_string(i);
  }
  return name;
}

std::string GlslMemberName(std::string_view member) {
  const bool reserved = std::find(std::begin(kReserved), std::end(kReserved), member) != std::end(kReserved);
  return reserved || member.starts_with("gl_") ? "m_" + std::string(member) : std::string(member);
}

}  // namespace burin::fx
