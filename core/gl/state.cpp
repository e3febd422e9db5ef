// SPDX-License-Identifier: Apache-2.0
#include "core/gl/state.h"

#include <epoxy/gl.h>

#include <initializer_list>

namespace burin::gl {

void SetConventions() {
  glClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glDisable(GL_DITHER);
  glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  ResetState();
}

void ResetState() {
  for (const GLenum capability :
       {GL_DEPTH_TEST, GL_STENCIL_TEST, GL_BLEND, GL_SCISSOR_TEST, GL_CULL_FACE, GL_POLYGON_OFFSET_FILL,
        GL_FRAMEBUFFER_SRGB, GL_MULTISAMPLE, GL_SAMPLE_ALPHA_TO_COVERAGE, GL_PROGRAM_POINT_SIZE, GL_DEPTH_CLAMP,
        GL_COLOR_LOGIC_OP, GL_RASTERIZER_DISCARD}) {
    glDisable(capability);
  }
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthMask(GL_TRUE);
  glDepthFunc(GL_LEQUAL);
  glDepthRange(0.0, 1.0);
  glStencilMask(0xFFFFFFFF);
  glStencilFunc(GL_ALWAYS, 0, 0xFFFFFFFF);
  glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  glBlendFunc(GL_ONE, GL_ZERO);
  glBlendEquation(GL_FUNC_ADD);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glPolygonOffset(0.0f, 0.0f);
  glPointSize(1.0f);
  glLineWidth(1.0f);
  glCullFace(GL_BACK);
  glFrontFace(GL_CCW);
}

}  // namespace burin::gl
