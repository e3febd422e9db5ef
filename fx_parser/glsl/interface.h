// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the GLSL that we write and its host agree on.
//
// Vertex inputs:   layout(location = VertexInputLocation(semantic)) in vec4 burin_in_<SEMANTIC><n>;
//                  missing components come from GL's (0,0,0,1).
// Interpolants:    vec4 burin_v_<SEMANTIC><n>, at one location per semantic in both stages; what the pixel shader reads
//                  and the vertex shader never writes is written as 0.
// Fragment outputs: layout(location = n) out vec4 burin_out<n>; DEPTH goes to gl_FragDepth.
// Parameters:      a plain uniform each, `uniform T burin_p_<name>`; bool and int parameters are carried as written.
//                  A matrix is uploaded as its HLSL rows: `uniform mat<R>x<C>` in GLSL's columns-by-rows naming holds
//                  HLSL row r in GLSL column r, so that HLSL M[r] is GLSL m[r] and mul(v, M) is m * v in the emitted
//                  text. Structs and arrays are flattened by GL's own rules (`burin_p_lights[1].color`).
// Samplers:        `uniform sampler2D burin_s_<name>`, texture units in the order of ShaderProgram::samplers.
// Host values:     the uniforms named below, declared only when the text needs them.
// Coordinates:     glClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE).

#include <optional>
#include <string>
#include <string_view>

namespace burin::fx {

/// vec4: xy is added to gl_Position.xy times w. (0,0) for files that use the extension's names, Direct3D 9's half pixel
/// for others.
inline constexpr std::string_view kUniformPixelOffset = "burin_pixel_offset";
/// ivec2 is not used: x = comparison (D3DCMP 1..8; 8 = always), y = reference 0..1, as vec2.
inline constexpr std::string_view kUniformAlphaTest = "burin_alpha_test";
/// vec4, of procedural textures: a texel's width, height and depth in texture coordinates, and the slice; of cubes the
/// depth is 0 and the last the face, 0 to 5 as +x, -x, +y, -y, +z, -z.
inline constexpr std::string_view kUniformTexel = "burin_texel";
/// vec4[kFixedSlots], of programs with a fixed stage: fx_parser/effect/fixed_function.h says what lies where.
inline constexpr std::string_view kUniformFixed = "burin_fixed";
/// vec4: the target's size in pixels and its reciprocal (VPOS and ddy need no flip, so only rarely declared).
inline constexpr std::string_view kUniformTargetSize = "burin_target_size";

inline constexpr int kMaxTexCoords = 16;
inline constexpr int kMaxTargets = 8;

/// POSITION 0, NORMAL 1, TANGENT 2, BINORMAL 3, COLOR0 4, COLOR1 5, BLENDWEIGHT 6, BLENDINDICES 7, TEXCOORD0..7 8..15.
/// `semantic` in upper case with its index ("TEXCOORD0"); empty for a semantic that is no vertex input.
[[nodiscard]] std::optional<int> VertexInputLocation(std::string_view semantic);

/// The name that a struct's member has in the text: its own, unless GLSL reserves that ("sample" is "m_sample").
[[nodiscard]] std::string GlslMemberName(std::string_view member);

}  // namespace burin::fx
