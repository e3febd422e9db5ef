// SPDX-License-Identifier: Apache-2.0
#include "core/overdraw/edge_renderer.h"

#include <fmt/format.h>

#include "core/gbuffer/frame_blocks.h"
#include "core/overdraw/edge_attribute_pass.h"
#include "core/overdraw/edge_quad_buffer.h"
#include "core/overdraw/edge_records.h"
#include "core/overdraw/line_edges.h"
#include "core/overdraw/line_glsl.h"
#include "core/overdraw/resolve_glsl.h"
#include "core/overdraw/scene_edges.h"
#include "core/overdraw/tile_pass.h"

namespace burin::overdraw {
namespace {

// Where so much of a frame lies near edges, they are finer than its pixels.
constexpr float kManyEdges = 0.5f;

TilePass PassOf(EdgeMode mode) {
  return mode == EdgeMode::kResolve ? TilePass("edges: resolve", ResolveBody(), 0.0f)
                                    : TilePass("edges: lines", LineBody(), kLineReach);
}

class Renderer final : public EdgeRenderer {
 public:
  Renderer(const scene::Scene& scene, const EdgeOptions& options)
      : options_(options), edges_(scene, options), pass_(PassOf(options.mode)) {}

  void BeginFrame() override { frame_ = nullptr; }
  std::vector<std::string> TakeNotes() override {
    std::vector<std::string> notes = edges_.TakeNotes();
    if (pass_.share() && !told_share_) {
      told_share_ = true;
      notes.push_back(fmt::format("{:.0f} % of the frame lies within 2 pixels of a visible edge{}",
                                  100.0f * *pass_.share(),
                                  *pass_.share() > kManyEdges ? ": --samples 4 or 16 serves it better" : ""));
    }
    return notes;
  }
  [[nodiscard]] bool antialiases() const override { return options_.mode != EdgeMode::kOff; }
  [[nodiscard]] bool precedes_blended() const override { return options_.mode != EdgeMode::kResolve; }

  Result<void> Antialias(const gbuffer::FrameInput& frame, const gbuffer::Request& color, const gl::Texture& depth,
                         const gbuffer::FaceShader& shade) override {
    if (auto found = FindEdges(frame); !found) return found;
    const PictureView view{gbuffer::ClipFromWorld(frame.view), depth.width(), depth.height()};
    const bool is_resolve = options_.mode == EdgeMode::kResolve;
    (is_resolve ? BuildAreas : BuildLines)(frame_->segments, view, records_);
    if (records_.records.empty()) return {};
    const auto shades = shade(records_.faces, places_);
    if (!shades) return std::unexpected(shades.error());
    records_.SetPlaces(places_);
    const gbuffer::Storage storage{color.attribute, color.target->format(), color.encoding};
    return pass_.Draw(*color.target, storage, depth, records_.records, **shades);
  }

  Result<void> Fill(const gbuffer::FrameInput& frame, std::span<const gbuffer::Request> requests,
                    const gl::Texture& depth) override {
    if (auto found = FindEdges(frame); !found) return found;
    SelectLines(frame_->segments, options_.crease_angle_deg, lines_);
    BuildQuads(lines_, frame, depth);
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
  void BuildQuads(std::span<const EdgeSegment> segments, const gbuffer::FrameInput& frame, const gl::Texture& depth) {
    QuadOptions options;
    options.clip_from_world = gbuffer::ClipFromWorld(frame.view);
    options.width = depth.width();
    options.height = depth.height();
    BuildEdgeQuads(segments, options, vertices_);
    quads_.Upload(vertices_);
  }

  EdgeOptions options_;
  SceneEdges edges_;
  const FrameEdges* frame_ = nullptr;
  std::vector<EdgeSegment> lines_;
  std::vector<EdgeVertex> vertices_;
  EdgeRecords records_;
  std::vector<std::uint32_t> places_;
  EdgeQuadBuffer quads_;
  TilePass pass_;
  bool told_share_ = false;
  EdgeAttributePass attributes_;
};

}  // namespace

std::unique_ptr<EdgeRenderer> EdgeRenderer::Create(const scene::Scene& scene, const EdgeOptions& options) {
  return std::make_unique<Renderer>(scene, options);
}

}  // namespace burin::overdraw
