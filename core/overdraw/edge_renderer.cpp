// SPDX-License-Identifier: Apache-2.0
#include "core/overdraw/edge_renderer.h"

#include "core/gbuffer/frame_blocks.h"
#include "core/overdraw/edge_lines.h"
#include "core/overdraw/edge_quad_buffer.h"
#include "core/overdraw/resolve_pass.h"
#include "core/overdraw/scene_edges.h"

namespace burin::overdraw {
namespace {

class Renderer final : public EdgeRenderer {
 public:
  Renderer(const scene::Scene& scene, const EdgeOptions& options) : mode_(options.mode), edges_(scene, options) {}

  void BeginFrame() override { frame_ = nullptr; }
  std::vector<std::string> TakeNotes() override { return edges_.TakeNotes(); }
  [[nodiscard]] bool antialiases() const override { return mode_ == EdgeMode::kResolve; }
  [[nodiscard]] bool draws_lines() const override { return mode_ == EdgeMode::kUnsorted || mode_ == EdgeMode::kSorted; }

  Result<std::span<const gbuffer::ShadedLine>> Lines(const gbuffer::FrameInput& frame, int width, int height) override {
    if (auto found = FindEdges(frame); !found) return std::unexpected(found.error());
    BuildShadedLines(frame_->segments, gbuffer::ClipFromWorld(frame.view), width, height, lines_);
    return std::span<const gbuffer::ShadedLine>(lines_);
  }

  Result<void> Antialias(const gbuffer::FrameInput& frame, const gbuffer::Request& color,
                         const gl::Texture& depth) override {
    if (auto built = BuildQuads(frame, depth, 0.0f); !built) return built;
    const gbuffer::Storage storage{color.attribute, color.target->format(), color.encoding};
    return resolve_.Draw(*color.target, storage, depth, quads_);
  }

  Result<void> Fill(const gbuffer::FrameInput&, std::span<const gbuffer::Request>, const gl::Texture&) override {
    return {};
  }

 private:
  Result<void> FindEdges(const gbuffer::FrameInput& frame) {
    if (frame_ != nullptr) return {};
    Result<const FrameEdges*> found = edges_.Extract(frame.items, frame.view);
    if (!found) return std::unexpected(found.error());
    frame_ = *found;
    return {};
  }

  /// The frame's edges, in quads for a picture of the size of `depth`.
  Result<void> BuildQuads(const gbuffer::FrameInput& frame, const gl::Texture& depth, float reach) {
    if (auto found = FindEdges(frame); !found) return found;
    QuadOptions options;
    options.clip_from_world = gbuffer::ClipFromWorld(frame.view);
    options.width = depth.width();
    options.height = depth.height();
    options.reach = reach;
    BuildEdgeQuads(frame_->segments, options, vertices_);
    quads_.Upload(vertices_);
    return {};
  }

  EdgeMode mode_;
  SceneEdges edges_;
  const FrameEdges* frame_ = nullptr;
  std::vector<EdgeVertex> vertices_;
  std::vector<gbuffer::ShadedLine> lines_;
  EdgeQuadBuffer quads_;
  ResolvePass resolve_;
};

}  // namespace

std::unique_ptr<EdgeRenderer> EdgeRenderer::Create(const scene::Scene& scene, const EdgeOptions& options) {
  return std::make_unique<Renderer>(scene, options);
}

}  // namespace burin::overdraw
