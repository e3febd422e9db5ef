// SPDX-License-Identifier: Apache-2.0
#include <epoxy/gl.h>
#include <fmt/format.h>

#include <cstdio>

#include "core/gl/context.h"
#include "tests/bench/tessellation/rivals.h"

namespace burin::bench {
namespace {

constexpr const char* kVertex = R"(#version 450
layout(location = 0) in vec4 position;
out vec3 point;
void main() { point = position.xyz; })";

constexpr const char* kControl = R"(#version 450
layout(vertices = 16) out;
uniform float factor;
in vec3 point[];
out vec3 control[];
void main() {
  control[gl_InvocationID] = point[gl_InvocationID];
  gl_TessLevelOuter[0] = gl_TessLevelOuter[1] = gl_TessLevelOuter[2] = gl_TessLevelOuter[3] = factor;
  gl_TessLevelInner[0] = gl_TessLevelInner[1] = factor;
})";

constexpr const char* kEvaluation = R"(#version 450
layout(quads, equal_spacing, ccw) in;
in vec3 control[];
out vec3 position;
out vec3 normal;
void main() {
  vec2 t = gl_TessCoord.xy, s = 1.0 - t;
  vec4 u = vec4(s.x * s.x * s.x, 3.0 * s.x * s.x * t.x, 3.0 * s.x * t.x * t.x, t.x * t.x * t.x);
  vec4 v = vec4(s.y * s.y * s.y, 3.0 * s.y * s.y * t.y, 3.0 * s.y * t.y * t.y, t.y * t.y * t.y);
  vec4 du = vec4(-s.x * s.x, s.x * (s.x - 2.0 * t.x), t.x * (2.0 * s.x - t.x), t.x * t.x);
  vec4 dv = vec4(-s.y * s.y, s.y * (s.y - 2.0 * t.y), t.y * (2.0 * s.y - t.y), t.y * t.y);
  vec3 a = vec3(0.0), b = vec3(0.0);
  position = vec3(0.0);
  for (int j = 0; j < 4; ++j) {
    vec3 value = u.x * control[4 * j] + u.y * control[4 * j + 1] + u.z * control[4 * j + 2] + u.w * control[4 * j + 3];
    a += v[j] * (du.x * control[4 * j] + du.y * control[4 * j + 1] + du.z * control[4 * j + 2] + du.w * control[4 * j + 3]);
    b += dv[j] * value;
    position += v[j] * value;
  }
  normal = normalize(cross(a, b));
})";

GLuint MakeProgram() {
  const GLuint program = glCreateProgram();
  const std::pair<GLenum, const char*> stages[] = {
      {GL_VERTEX_SHADER, kVertex}, {GL_TESS_CONTROL_SHADER, kControl}, {GL_TESS_EVALUATION_SHADER, kEvaluation}};
  for (const auto& [stage, text] : stages) {
    const GLuint shader = glCreateShader(stage);
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    glAttachShader(program, shader);
    glDeleteShader(shader);
  }
  const char* const outputs[] = {"position", "normal"};
  glTransformFeedbackVaryings(program, 2, outputs, GL_INTERLEAVED_ATTRIBS);
  glLinkProgram(program);
  GLint linked = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  return linked != 0 ? program : 0;
}

}  // namespace

struct GlTessellation::State {
  std::unique_ptr<gl::Context> context;
  GLuint program = 0, vertex_array = 0, control_points = 0, output = 0, framebuffer = 0;
  std::size_t patches = 0;
};

GlTessellation::GlTessellation(const geometry::BezierPatches& patches) : state_(std::make_unique<State>()) {
  gl::SetDriverEnvironment(0);
  auto context = gl::Context::Create({});
  if (!context) {
    fmt::print(stderr, "no GL: {}\n", context.error().message);
    return;
  }
  state_->context = *std::move(context);
  state_->program = MakeProgram();
  state_->patches = patches.patches.size();
  glCreateBuffers(1, &state_->control_points);
  glNamedBufferStorage(state_->control_points, static_cast<GLsizeiptr>(patches.positions.size() * sizeof(glm::vec4)),
                       patches.positions.data(), 0);
  glCreateVertexArrays(1, &state_->vertex_array);
  glVertexArrayVertexBuffer(state_->vertex_array, 0, state_->control_points, 0, sizeof(glm::vec4));
  glEnableVertexArrayAttrib(state_->vertex_array, 0);
  glVertexArrayAttribFormat(state_->vertex_array, 0, 4, GL_FLOAT, GL_FALSE, 0);
  glVertexArrayAttribBinding(state_->vertex_array, 0, 0);
  // Nothing is drawn, but without a surface draws need a framebuffer of their own.
  glCreateFramebuffers(1, &state_->framebuffer);
  glNamedFramebufferParameteri(state_->framebuffer, GL_FRAMEBUFFER_DEFAULT_WIDTH, 1);
  glNamedFramebufferParameteri(state_->framebuffer, GL_FRAMEBUFFER_DEFAULT_HEIGHT, 1);
  glBindFramebuffer(GL_FRAMEBUFFER, state_->framebuffer);
}

GlTessellation::~GlTessellation() {
  if (!state_->context) return;
  glDeleteFramebuffers(1, &state_->framebuffer);
  glDeleteProgram(state_->program);
  glDeleteVertexArrays(1, &state_->vertex_array);
  glDeleteBuffers(1, &state_->control_points);
  glDeleteBuffers(1, &state_->output);
}

TimedWork GlTessellation::At(std::uint32_t segments) {
  if (!state_->context || state_->program == 0 || segments > 64) return {};
  const double triangles = 2.0 * segments * segments * static_cast<double>(state_->patches);
  glDeleteBuffers(1, &state_->output);
  glCreateBuffers(1, &state_->output);
  glNamedBufferStorage(state_->output, static_cast<GLsizeiptr>(triangles * 3.0 * 24.0), nullptr, 0);
  // Mesa 22.3.6 loses vertices, without an error, in draws that make more than this.
  const auto per_draw = static_cast<GLsizei>(65'535u / (6 * segments * segments));
  if (per_draw == 0) return {};
  State* const state = state_.get();
  const auto run = [state, segments, per_draw] {
    glUseProgram(state->program);
    glUniform1f(glGetUniformLocation(state->program, "factor"), static_cast<float>(segments));
    glBindVertexArray(state->vertex_array);
    glPatchParameteri(GL_PATCH_VERTICES, 16);
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, state->output);
    glEnable(GL_RASTERIZER_DISCARD);
    glBeginTransformFeedback(GL_TRIANGLES);
    const auto patches = static_cast<GLsizei>(state->patches);
    for (GLsizei p = 0; p < patches; p += per_draw)
      glDrawArrays(GL_PATCHES, 16 * p, 16 * (patches - p < per_draw ? patches - p : per_draw));
    glEndTransformFeedback();
    glDisable(GL_RASTERIZER_DISCARD);
    glFinish();
    if (const GLenum error = glGetError(); error != GL_NO_ERROR) fmt::print(stderr, "GL error 0x{:x}\n", error);
  };
  return {run, triangles};
}

}  // namespace burin::bench
