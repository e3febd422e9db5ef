// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec4.hpp>
#include <initializer_list>
#include <map>
#include <utility>

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
                                         const ShadowBlock& shadows, gbuffer::MaterialStore& materials,
                                         const BodyMaps& maps);
  [[nodiscard]] Result<void> BuildPyramid(const BodyBlock& block, const BodyMaps& maps);
  [[nodiscard]] Result<void> Gather(const BodyMaps& maps, bool has_parts);

 private:
  struct ReceiverPrograms {
    gl::Program choice;
    gl::Program gather;
  };
  [[nodiscard]] Result<const gl::Program*> SourceProgram(std::uint32_t features, int fixed_lights);
  /// Of all faces, `side` receivers along each: offset, spacing, distance to those around (receiver_glsl.h).
  void GatherLattices(const ReceiverPrograms& programs, int side, std::initializer_list<glm::ivec4> lattices);

  Quality quality_;
  gl::VertexArrayHandle no_vertices_;
  gl::BufferHandle frame_block_;
  SourceSums sums_;
  gl::Program depth_program_;
  std::map<std::pair<std::uint32_t, int>, gl::Program> source_programs_;  ///< by features and FixedLights
  std::array<gl::Program, 2> base_programs_;                              ///< by the level that they write
  gl::Program level_program_;
  std::map<bool, ReceiverPrograms> receiver_programs_;  ///< by whether near and far are told apart
  gl::BufferHandle wanted_;                             ///< receivers to gather
};

}  // namespace burin::translucency
