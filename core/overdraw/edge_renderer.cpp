// SPDX-License-Identifier: Apache-2.0
#include "core/overdraw/edge_renderer.h"

#include <fmt/format.h>

#include "core/gbuffer/frame_blocks.h"
#include "core/overdraw/edge_attribute_pass.h"
#include "core/overdraw/edge_lines.h"
#include "core/overdraw/edge_quad_buffer.h"
#include "core/overdraw/line_edges.h"
#include "core/overdraw/resolve_pass.h"
#include "core/overdraw/scene_edges.h"

namespace burin::overdraw {
namespace {

// Where so much of a frame lies near edges, they are finer than its pixels.
constexpr float kManyEdges = 0.5f;

class Renderer final : public EdgeRenderer {
 public:
  Renderer(const scene::Scene& scene, const EdgeOptions& options) : options_(options), edges_(scene, options) {}

  void BeginFrame() override { frame_ = nullptr; }
  std::vector<std::string> TakeNotes() override {
    std::vector<std::string> notes = edges_.TakeNotes();
    if (resolve_.share() && !told_share_) {
      told_share_ = true;
      notes.push_back(fmt::format("{:.0f} % of the frame lies within 2 pixels of a visible edge{}",
                                  100.0f * *resolve_.share(),
                                  *resolve_.share() > kManyEdges ? ": --samples 4 or 16 serves it better" : ""));
    }
    return notes;
  }
  [[nodiscard]] bool antialiases() const override { return options_.mode == EdgeMode::kResolve; }
  [[nodiscard]] bool draws_lines() const override {
    return options_.mode == EdgeMode::kUnsorted || options_.mode == EdgeMode::kSorted;
  }

  Result<std::span<const gbuffer::ShadedLine>> Lines(const gbuffer::FrameInput& frame, int width, int height) override {
    if (auto found = FindEdges(frame); !found) return std::unexpected(found.error());
    BuildShadedLines(frame_->segments, gbuffer::ClipFromWorld(frame.view), width, height, shaded_lines_);
    return std::span<const gbuffer::ShadedLine>(shaded_lines_);
  }

  Result<void> Antialias(const gbuffer::FrameInput& frame, const gbuffer::Request& color, const gl::Texture& depth,
                         const gbuffer::LineDrawer& draw_lines) override {
    if (auto found = FindEdges(frame); !found) return found;
    BuildQuads(frame_->segments, frame, depth, true);
    BuildAreaLines(frame_->segments, gbuffer::ClipFromWorld(frame.view), depth.width(), depth.height(), area_lines_);
    const gbuffer::Storage storage{color.attribute, color.target->format(), color.encoding};
    return resolve_.Draw(*color.target, storage, depth, quads_, area_lines_, draw_lines);
  }

  Result<void> Fill(const gbuffer::FrameInput& frame, std::span<const gbuffer::Request> requests,
                    const gl::Texture& depth) override {
    if (auto found = FindEdges(frame); !found) return found;
    SelectLines(frame_->segments, options_.crease_angle_deg, lines_);
    BuildQuads(lines_, frame, depth, false);
    return attributes_.Draw(requests, depth, quads_);
  }

 private:
  Result<void> FindEdges(const gbuffer::FrameInput& frame) {
    if (frame_ != nullptr) return {};
    Result<const FrameEdges*> found = edges_.Extract(frame.items, frame.view);
    if (!found) return std::unexpected(found.error());
    frame_ = *found;
    return {};
  }

  /// For a picture of the size of `depth`.
  void BuildQuads(std::span<const EdgeSegment> segments, const gbuffer::FrameInput& frame, const gl::Texture& depth,
                  bool sums_folds) {
    QuadOptions options;
    options.clip_from_world = gbuffer::ClipFromWorld(frame.view);
    options.width = depth.width();
    options.height = depth.height();
    options.sums_folds = sums_folds;
    BuildEdgeQuads(segments, options, vertices_);
    quads_.Upload(vertices_);
  }

  EdgeOptions options_;
  SceneEdges edges_;
  const FrameEdges* frame_ = nullptr;
  std::vector<EdgeSegment> lines_;
  std::vector<EdgeVertex> vertices_;
  std::vector<gbuffer::ShadedLine> shaded_lines_;
  AreaLines area_lines_;
  EdgeQuadBuffer quads_;
  ResolvePass resolve_;
  bool told_share_ = false;
  EdgeAttributePass attributes_;
};

}  // namespace

std::unique_ptr<EdgeRenderer> EdgeRenderer::Create(const scene::Scene& scene, const EdgeOptions& options) {
  return std::make_unique<Renderer>(scene, options);
}

}  // namespace burin::overdraw
