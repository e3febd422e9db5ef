// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/gbuffer/attribute_renderer.h"
#include "core/gbuffer/face_samples.h"
#include "core/gbuffer/geometry_pass.h"
#include "core/gl/handle.h"
#include "core/gl/program.h"
#include "core/gl/texture.h"

namespace burin::gbuffer {

/// Shades points of faces as the geometry pass shades pixels, all of one item at once: they lie close in a table, so a
/// thousand short edges cost little more than as many pixels.
class FaceColorTable {
 public:
  explicit FaceColorTable(const scene::Scene& scene);
  /// As FaceShader says; frame and light blocks bound. Other states are left changed. Errors: kFailed when memory is
  /// short or there are more points than a texture holds.
  [[nodiscard]] Result<const gl::Texture*> Shade(std::span<const FaceEdge> edges, const FrameInput& frame,
                                                 const FrameDraws& draws, const SampleView& view,
                                                 MaterialStore& materials, std::vector<std::uint32_t>& first);

 private:
  void Gather(std::span<const FaceEdge> edges, const FrameInput& frame, const SampleView& view);
  [[nodiscard]] Result<void> Reserve(std::uint32_t blocks);
  [[nodiscard]] Result<const gl::Program*> ProgramOf(std::uint32_t features, const TranslucencyStage* translucency);

  const scene::Scene* scene_;
  SamplePlan plan_;
  std::vector<FaceSample> samples_;
  gl::BufferHandle buffer_;
  gl::VertexArrayHandle vertex_array_;
  gl::Texture colors_;
  std::map<std::uint32_t, gl::Program> programs_;
};

/// GLSL: vec4 FaceColor(sampler2D table, uint first, uint points, float t), the colour on an edge at the share t of the
/// part that was shaded.
[[nodiscard]] std::string_view FaceColorFunctions();

}  // namespace burin::gbuffer
