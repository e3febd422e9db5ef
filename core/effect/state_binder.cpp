// SPDX-License-Identifier: Apache-2.0
#include "core/effect/state_binder.h"

#include <epoxy/gl.h>

namespace burin::effect {
namespace {

GLenum Compare(int d3d) { return static_cast<GLenum>(GL_NEVER + d3d - 1); }  // both count never, less, equal ... always

GLenum StencilOp(int d3d) {
  constexpr GLenum kOps[] = {GL_KEEP, GL_ZERO, GL_REPLACE, GL_INCR, GL_DECR, GL_INVERT, GL_INCR_WRAP, GL_DECR_WRAP};
  return kOps[d3d - 1];
}

GLenum BlendOp(int d3d) {
  constexpr GLenum kOps[] = {GL_FUNC_ADD, GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT, GL_MIN, GL_MAX};
  return kOps[d3d - 1];
}

GLenum Blend(int d3d) {
  constexpr GLenum kFactors[] = {GL_ZERO,
                                 GL_ONE,
                                 GL_SRC_COLOR,
                                 GL_ONE_MINUS_SRC_COLOR,
                                 GL_SRC_ALPHA,
                                 GL_ONE_MINUS_SRC_ALPHA,
                                 GL_DST_ALPHA,
                                 GL_ONE_MINUS_DST_ALPHA,
                                 GL_DST_COLOR,
                                 GL_ONE_MINUS_DST_COLOR,
                                 GL_SRC_ALPHA_SATURATE,
                                 GL_SRC_ALPHA,
                                 GL_ONE_MINUS_SRC_ALPHA,
                                 GL_CONSTANT_COLOR,
                                 GL_ONE_MINUS_CONSTANT_COLOR};
  return kFactors[d3d - 1];
}

struct Factors {
  GLenum src, dest;
};

// D3DBLEND_BOTHSRCALPHA and BOTHINVSRCALPHA, as the source factor, set the destination's too.
Factors BlendFactors(int src, int dest) {
  constexpr int kBothSrcAlpha = 12;
  constexpr int kBothInvSrcAlpha = 13;
  if (src == kBothSrcAlpha) return {GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA};
  if (src == kBothInvSrcAlpha) return {GL_ONE_MINUS_SRC_ALPHA, GL_SRC_ALPHA};
  return {Blend(src), Blend(dest)};
}

void Switch(GLenum capability, bool on) {
  if (on) {
    glEnable(capability);
  } else {
    glDisable(capability);
  }
}

void BindBlending(const RenderStates& states) {
  Switch(GL_BLEND, states.blend);
  if (!states.blend) return;
  const Factors color = BlendFactors(states.src_blend, states.dest_blend);
  const Factors alpha = states.separate_alpha ? BlendFactors(states.src_blend_alpha, states.dest_blend_alpha) : color;
  glBlendFuncSeparate(color.src, color.dest, alpha.src, alpha.dest);
  glBlendEquationSeparate(BlendOp(states.blend_op),
                          BlendOp(states.separate_alpha ? states.blend_op_alpha : states.blend_op));
  glBlendColor(states.blend_factor[0], states.blend_factor[1], states.blend_factor[2], states.blend_factor[3]);
}

void BindStencilFace(GLenum face, const RenderStates& states, const RenderStates::Stencil& stencil) {
  glStencilFuncSeparate(face, Compare(stencil.func), states.stencil_ref, states.stencil_mask);
  glStencilOpSeparate(face, StencilOp(stencil.fail), StencilOp(stencil.zfail), StencilOp(stencil.pass));
}

void BindDepthStencil(const RenderStates& states, bool has_buffer) {
  Switch(GL_DEPTH_TEST, has_buffer && states.z_enable);
  glDepthFunc(Compare(states.z_func));
  glDepthMask(states.z_write);
  Switch(GL_STENCIL_TEST, has_buffer && states.stencil);
  if (has_buffer && states.stencil) {
    BindStencilFace(GL_FRONT, states, states.front);
    BindStencilFace(GL_BACK, states, states.two_sided_stencil ? states.ccw : states.front);
    glStencilMask(states.stencil_write_mask);
  }
  // Direct3D's bias is in units of depth, GL's in the smallest step of a floating buffer: 2^-24 from 0.5 to 1.
  constexpr float kStepsOfDepth = 16777216.0f;
  const bool biased = states.depth_bias != 0 || states.slope_scale_depth_bias != 0;
  Switch(GL_POLYGON_OFFSET_FILL, biased);
  if (biased) glPolygonOffset(states.slope_scale_depth_bias, states.depth_bias * kStepsOfDepth);
}

void BindRaster(const RenderStates& states, bool front_is_clockwise) {
  constexpr int kCullNone = 1;
  constexpr int kCullClockwise = 2;
  // GL names windings in clip space as the upper-left origin of glClipControl shows them on the screen.
  glFrontFace(front_is_clockwise ? GL_CW : GL_CCW);
  Switch(GL_CULL_FACE, states.cull != kCullNone);
  glCullFace(states.cull == kCullClockwise ? GL_FRONT : GL_BACK);
  constexpr GLenum kFill[] = {GL_POINT, GL_LINE, GL_FILL};
  glPolygonMode(GL_FRONT_AND_BACK, kFill[states.fill - 1]);
}

void BindColorMasks(const RenderStates& states, std::span<const int> writable) {
  for (std::size_t i = 0; i < writable.size(); ++i) {
    const int bits = writable[i] & (i < states.color_write.size() ? states.color_write[i] : 15);
    glColorMaski(static_cast<GLuint>(i), (bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0, (bits & 8) != 0);
  }
}

}  // namespace

void BindStates(const RenderStates& states, const DrawTargets& targets, bool front_is_clockwise) {
  BindBlending(states);
  BindDepthStencil(states, targets.has_depth_stencil);
  BindRaster(states, front_is_clockwise);
  BindColorMasks(states, targets.writable);
  Switch(GL_FRAMEBUFFER_SRGB, states.srgb_write);
  glDisable(GL_SCISSOR_TEST);
}

}  // namespace burin::effect
