// SPDX-License-Identifier: Apache-2.0
#pragma once
// Silhouettes by looking at every edge: first one bit a face, front or back, then the edges whose two bits differ.

#include <cstdint>
#include <glm/vec4.hpp>
#include <vector>

#include "core/base/cpu.h"
#include "core/overdraw/face_planes.h"
#include "core/overdraw/silhouette_edges.h"

namespace burin::overdraw {

/// Whether this processor runs the AVX2 code of the scan and the tree.
using base::HasAvx2;

struct ScanOptions {
  bool uses_avx2 = HasAvx2();  ///< else portable code with the same result
  bool is_parallel = false;    ///< on the threads of TBB, with the same result
};

/// Appends to `found` the index in `edges` of each edge with one front and one back face, in order.
/// `local_eye` as from FacePlanes::LocalEye.
void ScanSilhouettes(const FacePlanes& planes, const SilhouetteEdges& edges, const glm::vec4& local_eye,
                     const ScanOptions& options, std::vector<std::uint32_t>& found);

}  // namespace burin::overdraw
