// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>

#include "core/base/error.h"
#include "core/gbuffer/material_store.h"
#include "core/gl/handle.h"
#include "core/gl/program.h"
#include "core/translucency/body.h"
#include "core/translucency/body_maps.h"

namespace burin::translucency {

/// The passes from a body's triangles to the radiosity of its faces, in this order. The body's uniform blocks are
/// bound.
class BodyPasses {
 public:
  explicit BodyPasses(const Quality& quality);

  [[nodiscard]] Result<void> DrawDepth(const BodyItems& body, const BodyBlock& block, std::uint32_t draw_blocks,
                                       const BodyMaps& maps);
  /// Shadow maps and lights are bound.
  [[nodiscard]] Result<void> DrawSources(const BodyItems& body, const BodyBlock& block, std::uint32_t draw_blocks,
                                         gbuffer::MaterialStore& materials, const BodyMaps& maps);
  [[nodiscard]] Result<void> BuildPyramid(const BodyMaps& maps);
  [[nodiscard]] Result<void> Gather(const BodyMaps& maps, bool has_parts);

 private:
  [[nodiscard]] Result<const gl::Program*> SourceProgram(std::uint32_t features);

  Quality quality_;
  gl::VertexArrayHandle no_vertices_;
  gl::BufferHandle frame_block_;
  SourceSums sums_;
  gl::Program depth_program_;
  std::map<std::uint32_t, gl::Program> source_programs_;
  gl::Program base_program_;
  gl::Program level_program_;
  std::map<bool, gl::Program> receiver_programs_;
};

}  // namespace burin::translucency
