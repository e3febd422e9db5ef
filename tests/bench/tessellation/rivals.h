// SPDX-License-Identifier: Apache-2.0
#pragma once
// Other ways to tessellated bicubic patches, for comparison. All patches get `segments` equal segments along each side.

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "core/geometry/bezier_patches.h"

namespace burin::bench {

/// What each writes: six floats a vertex (position, unit normal) and three indices a triangle.
struct PlainMesh {
  std::vector<float> vertices;
  std::vector<std::uint32_t> indices;
};

/// Each vertex alone: the tensor-product de Casteljau scheme in float, and the same indices for every patch copied.
void TessellateByVertex(const geometry::BezierPatches& patches, std::uint32_t segments, PlainMesh& mesh);

/// De Casteljau along v once a row, then along u for eight vertices at once, AVX2.
void TessellateByRow(const geometry::BezierPatches& patches, std::uint32_t segments, PlainMesh& mesh);

/// Work to be timed, and how many triangles it makes each time.
struct TimedWork {
  std::function<void()> run;
  double triangles = 0.0;
};

/// OpenSubdiv's CpuEvaluator: limit positions and both derivatives on the patches of a Catmull-Clark torus of as many
/// patches; no indices. No run where OpenSubdiv is not there.
[[nodiscard]] TimedWork OpenSubdivPatches(std::size_t patch_count, std::uint32_t segments);

/// The same by limit stencils: each vertex a weighted sum of control points.
[[nodiscard]] TimedWork OpenSubdivStencils(std::size_t patch_count, std::uint32_t segments);

/// GL's tessellation stage, positions and normals read by transform feedback, in draws of fewer than 65,536 vertices.
/// No run without a GL context or where `segments` is beyond its limit.
class GlTessellation {
 public:
  explicit GlTessellation(const geometry::BezierPatches& patches);
  ~GlTessellation();
  GlTessellation(const GlTessellation&) = delete;
  GlTessellation& operator=(const GlTessellation&) = delete;
  [[nodiscard]] TimedWork At(std::uint32_t segments);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace burin::bench
