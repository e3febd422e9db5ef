// SPDX-License-Identifier: Apache-2.0
#pragma once
// Triangles as quads (Moreton, section 7).

#include <array>
#include <cstdint>
#include <glm/ext/vector_double2.hpp>
#include <vector>

#include "core/tessellation/net.h"

namespace burin::tessellation {

/// Part of a triangle as the unit square of (s, t).
enum class TrianglePart : std::uint8_t {
  kCorner0,  ///< between corner (0, 0), the middles of its two sides and the centre
  kCorner1,
  kCorner2,
  kWhole,  ///< side t = 1 is the corner (0, 1)
};

/// (u, v) of the part's corners (s, t) = (0, 0), (1, 0), (0, 1), (1, 1). Between them both are bilinear.
[[nodiscard]] std::array<glm::dvec2, 4> PartCorners(TrianglePart part);

/// What takes a triangle's control points to the quad's, both of one degree: a matrix, sparse by rows.
struct Reparameterization {
  struct Entry {
    std::uint32_t from;
    double weight;
  };
  std::vector<std::uint32_t> row_ends;  ///< of quad point j * (degree + 1) + i, in `entries`
  std::vector<Entry> entries;
};

/// Made once a part and degree (0 to 13); from any thread.
[[nodiscard]] const Reparameterization& ReparameterizationOf(TrianglePart part, int degree);

void Reparameterize(const Net& triangle, TrianglePart part, Net& quad);

}  // namespace burin::tessellation
