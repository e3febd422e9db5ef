// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <span>

#include "core/base/error.h"
#include "core/gbuffer/attribute_renderer.h"
#include "core/gbuffer/geometry_pass.h"
#include "core/gl/handle.h"
#include "core/gl/program.h"

namespace burin::gbuffer {

/// Draws shaded lines over the scene-linear colour that a geometry pass has drawn (Sander et al., "Discontinuity Edge
/// Overdraw", 2001: depth is tested, not written; colour is blended over what is there).
class LinePass {
 public:
  LinePass();
  /// Into the bound framebuffer, frame and light blocks bound; `location` is its colour. Other outputs are left alone.
  [[nodiscard]] Result<void> Draw(std::span<const ShadedLine> lines, const FrameDraws& draws, int location,
                                  int output_count, MaterialStore& materials);
  /// As LineDrawer says; frame and light blocks bound. `depth`: what hides edges.
  [[nodiscard]] Result<void> AddAreas(std::span<const ShadedLine> lines, const FrameDraws& draws,
                                      const gl::Texture& depth, MaterialStore& materials);

 private:
  [[nodiscard]] Result<void> DrawAll(std::span<const ShadedLine> lines, const FrameDraws& draws, std::uint32_t feature,
                                     MaterialStore& materials);
  [[nodiscard]] Result<const gl::Program*> ProgramOf(std::uint32_t features, const TranslucencyStage* translucency);
  void Upload(std::span<const ShadedLine> lines);

  gl::BufferHandle indices_;
  gl::BufferHandle records_;
  std::map<std::uint32_t, gl::Program> programs_;
};

}  // namespace burin::gbuffer
