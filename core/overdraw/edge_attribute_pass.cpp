// SPDX-License-Identifier: Apache-2.0
#include "core/overdraw/edge_attribute_pass.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>

#include "core/gl/state.h"
#include "core/overdraw/edge_attribute_glsl.h"

namespace burin::overdraw {
namespace {

using gbuffer::Attribute;

// What a pixel can be away from a line one pixel wide that touches it.
constexpr float kCoverageReach = 1.0f;

gbuffer::Storage StorageOf(const gbuffer::Request& request) {
  return {request.attribute, request.target->format(), request.encoding};
}

Result<void> Ensure(gl::Program& program, const std::string& vertex, const std::string& fragment, const char* label) {
  if (program) return {};
  Result<gl::Program> made = gl::Program::Create(vertex, fragment, label);
  if (!made) return std::unexpected(made.error());
  program = std::move(*made);
  return {};
}

void BindForReading(const gl::Texture& texture) {
  glBindSampler(0, 0);
  glBindTextureUnit(0, texture.id());
}

}  // namespace

Result<EdgeAttributePass::Scratch*> EdgeAttributePass::ScratchFor(Attribute attribute, int width, int height) {
  const auto fits = [&](const Scratch& scratch) {
    return scratch.attribute == attribute && scratch.texture.width() == width && scratch.texture.height() == height;
  };
  if (const auto found = std::ranges::find_if(scratches_, fits); found != scratches_.end()) return &*found;
  const gl::Format format = attribute == Attribute::kEdges ? gl::PlainFormat(gl::Numeric::kFloat, 16, 4)
                                                           : gl::PlainFormat(gl::Numeric::kFloat, 32, 4);
  Result<gl::Texture> texture = gl::Texture::Create(format, width, height, 1, "attributes of edges: gathered");
  if (!texture) return std::unexpected(texture.error());
  Scratch scratch{.attribute = attribute, .texture = std::move(*texture), .framebuffer = {}};
  const std::array<const gl::Texture*, 1> targets = {&scratch.texture};
  Result<gl::Framebuffer> framebuffer = gl::Framebuffer::Create(targets, nullptr, "attributes of edges: gathered");
  if (!framebuffer) return std::unexpected(framebuffer.error());
  scratch.framebuffer = std::move(*framebuffer);
  return &scratches_.emplace_back(std::move(scratch));
}

Result<const gl::Program*> EdgeAttributePass::StoreProgram(const gbuffer::Storage& storage) {
  const auto found = std::ranges::find(stores_, storage, &Store::storage);
  if (found != stores_.end()) return &found->program;
  Store store{storage, {}};
  if (auto made = Ensure(store.program, EdgeStoreVertexText(), EdgeStoreFragmentText(storage), "attributes of edges");
      !made) {
    return std::unexpected(made.error());
  }
  return &stores_.emplace_back(std::move(store)).program;
}

Result<const gl::Texture*> EdgeAttributePass::Gather(Attribute attribute, const gl::Texture& depth,
                                                     const EdgeQuadBuffer& quads) {
  const bool is_coverage = attribute == Attribute::kEdges;
  gl::Program& program = is_coverage ? coverage_program_ : distance_program_;
  if (auto made =
          Ensure(program, EdgeLineVertexText(), is_coverage ? EdgeCoverageFragmentText() : EdgeDistanceFragmentText(),
                 is_coverage ? "edges" : "edgedist");
      !made) {
    return std::unexpected(made.error());
  }
  const Result<Scratch*> scratch = ScratchFor(attribute, depth.width(), depth.height());
  if (!scratch) return std::unexpected(scratch.error());

  (*scratch)->framebuffer.Bind();
  const float none = is_coverage ? 0.0f : static_cast<float>(kNoEdgeDistance);
  const std::array<float, 4> empty = {none, none, none, none};
  glClearNamedFramebufferfv((*scratch)->framebuffer.id(), GL_COLOR, 0, empty.data());
  glEnable(GL_BLEND);
  glBlendEquation(is_coverage ? GL_MAX : GL_MIN);
  glUseProgram(program.id());
  glUniform1f(program.UniformLocation("reach"),
              is_coverage ? kCoverageReach : static_cast<float>(kLargestEdgeDistance));
  BindForReading(depth);
  quads.Draw();
  glBlendEquation(GL_FUNC_ADD);
  glDisable(GL_BLEND);
  return &(*scratch)->texture;
}

Result<void> EdgeAttributePass::StoreInto(const gbuffer::Request& request, const gl::Texture& gathered) {
  const Result<const gl::Program*> program = StoreProgram(StorageOf(request));
  if (!program) return std::unexpected(program.error());
  const std::array<const gl::Texture*, 1> targets = {request.target};
  const Result<gl::Framebuffer> framebuffer = gl::Framebuffer::Create(targets, nullptr, "attributes of edges");
  if (!framebuffer) return std::unexpected(framebuffer.error());
  framebuffer->Bind();
  glUseProgram((*program)->id());
  BindForReading(gathered);
  quad_->Draw();
  return {};
}

Result<void> EdgeAttributePass::Draw(std::span<const gbuffer::Request> requests, const gl::Texture& depth,
                                     const EdgeQuadBuffer& quads) {
  if (!quad_) {
    Result<gl::FullscreenQuad> made = gl::FullscreenQuad::Create();
    if (!made) return std::unexpected(made.error());
    quad_ = std::move(*made);
  }
  gl::ResetState();
  std::map<Attribute, const gl::Texture*> gathered;
  for (const gbuffer::Request& request : requests) {
    if (quads.empty()) {
      const std::array<float, 4> empty = gbuffer::StoredBackground(StorageOf(request), {});
      glClearTexImage(request.target->id(), 0, GL_RGBA, GL_FLOAT, empty.data());
      continue;
    }
    const gl::Texture*& found = gathered[request.attribute];
    if (found == nullptr) {
      const Result<const gl::Texture*> texture = Gather(request.attribute, depth, quads);
      if (!texture) return std::unexpected(texture.error());
      found = *texture;
    }
    if (auto stored = StoreInto(request, *found); !stored) return stored;
  }
  return {};
}

}  // namespace burin::overdraw
