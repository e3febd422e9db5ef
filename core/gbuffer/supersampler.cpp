// SPDX-License-Identifier: Apache-2.0
#include "core/gbuffer/supersampler.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <array>
#include <string>

#include "core/gl/state.h"

namespace burin::gbuffer {
namespace {

constexpr std::string_view kVertex = R"(#version 450 core
layout(location = 0) in vec4 position;
void main() { gl_Position = position; }
)";

// Summed in pairs: k * k equal samples add up without rounding, so flat areas keep the bits they have unsampled.
constexpr std::string_view kFragment = R"(#version 450 core
layout(binding = 0) uniform sampler2D samples;
layout(location = 0) out vec4 mean;
vec4 Four(ivec2 p) {
  return (texelFetch(samples, p, 0) + texelFetch(samples, p + ivec2(1, 0), 0)) +
         (texelFetch(samples, p + ivec2(0, 1), 0) + texelFetch(samples, p + ivec2(1, 1), 0));
}
void main() {
  ivec2 first = ivec2(gl_FragCoord.xy) * PER_AXIS;
#if PER_AXIS == 2
  mean = Four(first) / 4.0;
#else
  mean = ((Four(first) + Four(first + ivec2(2, 0))) + (Four(first + ivec2(0, 2)) + Four(first + ivec2(2, 2)))) / 16.0;
#endif
}
)";

std::string FragmentText(int per_axis) {
  std::string text(kFragment);
  text.insert(text.find('\n') + 1, fmt::format("#define PER_AXIS {}\n", per_axis));
  return text;
}

}  // namespace

Result<std::unique_ptr<Supersampler>> Supersampler::Create(int samples) {
  const int per_axis = samples == 16 ? 4 : 2;
  Result<gl::FullscreenQuad> quad = gl::FullscreenQuad::Create();
  if (!quad) return std::unexpected(quad.error());
  Result<gl::Program> program = gl::Program::Create(kVertex, FragmentText(per_axis), "supersampling");
  if (!program) return std::unexpected(program.error());
  return std::unique_ptr<Supersampler>(new Supersampler(per_axis, *std::move(quad), *std::move(program)));
}

Result<Supersampler::Buffers*> Supersampler::BuffersOf(int width, int height) {
  const auto found = buffers_.find({width, height});
  if (found != buffers_.end()) return &found->second;
  const gl::Format format = gl::PlainFormat(gl::Numeric::kFloat, 32, 4);
  Buffers buffers;
  Result<gl::Texture> samples =
      gl::Texture::Create(format, width * per_axis_, height * per_axis_, 1, "supersampled colour");
  if (!samples) return std::unexpected(samples.error());
  buffers.samples = *std::move(samples);
  Result<gl::Texture> mean = gl::Texture::Create(format, width, height, 1, "mean of the samples");
  if (!mean) return std::unexpected(mean.error());
  buffers.mean = *std::move(mean);
  const std::array<const gl::Texture*, 1> targets = {&buffers.mean};
  Result<gl::Framebuffer> framebuffer = gl::Framebuffer::Create(targets, nullptr, "mean of the samples");
  if (!framebuffer) return std::unexpected(framebuffer.error());
  buffers.framebuffer = *std::move(framebuffer);
  return &buffers_.emplace(std::pair(width, height), std::move(buffers)).first->second;
}

void Supersampler::Average(const Buffers& buffers) const {
  gl::ResetState();
  buffers.framebuffer.Bind();
  glUseProgram(program_.id());
  glBindTextureUnit(0, buffers.samples.id());
  glBindSampler(0, 0);
  quad_.Draw();
}

Result<const gl::Texture*> Supersampler::Render(SceneRenderer& renderer, const FrameInput& frame, int width,
                                                int height) {
  const Result<Buffers*> buffers = BuffersOf(width, height);
  if (!buffers) return std::unexpected(buffers.error());
  const Request request{Attribute::kColor, &(*buffers)->samples, image::Encoding::kSceneLinear};
  if (Result<void> rendered = renderer.Render(frame, {&request, 1}); !rendered) {
    return std::unexpected(rendered.error());
  }
  Average(**buffers);
  return &(*buffers)->mean;
}

}  // namespace burin::gbuffer
