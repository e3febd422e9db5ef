// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/gbuffer/attribute_renderer.h"
#include "core/overdraw/edge_options.h"
#include "core/scene/scene.h"

namespace burin::overdraw {

/// The edge-overdraw stage of one scene: finds a frame's discontinuity edges when something asks for them, antialiases
/// colour, and fills the attributes of edges. Context's thread only.
class EdgeRenderer : public gbuffer::EdgeStage {
 public:
  /// `scene` outlives this.
  [[nodiscard]] static std::unique_ptr<EdgeRenderer> Create(const scene::Scene& scene, const EdgeOptions& options);
  /// Before each frame's first use: what was found for the last frame is forgotten.
  virtual void BeginFrame() = 0;
  /// What is worth a line of --verbose, each once.
  [[nodiscard]] virtual std::vector<std::string> TakeNotes() = 0;
};

}  // namespace burin::overdraw
