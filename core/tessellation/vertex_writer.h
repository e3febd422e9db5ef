// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <glm/ext/vector_double2.hpp>

#include "core/tessellation/kernels.h"
#include "core/tessellation/patch_nets.h"
#include "core/tessellation/tessellate.h"

namespace burin::tessellation {

/// Consecutive vertices along a line of the patch's domain, from `from` (parameter 0) to `to` (parameter 1).
struct VertexRun {
  std::uint32_t first = 0, count = 0;  ///< in the surface
  const double* parameters = nullptr;  ///< one a vertex
  glm::dvec2 from{0.0}, to{0.0};
};

/// One array a channel, one value a vertex of a run.
using ChannelValues = std::array<const Lanes*, kChannelCount>;

/// Turns evaluated channels of one patch into the surface's vertices.
struct VertexWriter {
  const Kernels* kernels = nullptr;
  Surface* surface = nullptr;
  const geometry::BezierPatches* patches = nullptr;
  const geometry::BezierPatch* patch = nullptr;

  void Write(const ChannelValues& values, const VertexRun& run) const;

 private:
  void WriteNormals(const ChannelValues& values, const VertexRun& run) const;
  void WriteTexcoords(std::size_t set, const Lanes* values, const VertexRun& run) const;
  void WriteColors(const Lanes* values, const VertexRun& run) const;
  void WriteTangents(const ChannelValues& values, const VertexRun& run) const;
};

}  // namespace burin::tessellation
