// SPDX-License-Identifier: Apache-2.0
#pragma once
// Watertight tessellation of Bézier patches by forward differencing (Moreton, "Watertight Tessellation using Forward
// Differencing", 2001; the rules of GL_NV_evaluators).

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <span>
#include <vector>

#include "core/base/cpu.h"
#include "core/geometry/bezier_patches.h"

namespace burin::tessellation {

inline constexpr float kMaxFactor = 256.0f;

enum class Pattern : std::uint8_t {
  kInteger,     ///< ceil(factor) equal segments an edge, the fewest and best-shaped triangles
  kFractional,  ///< symmetric about each edge's middle; vertices move continuously with the factors
};

/// Segments along each side. Quads: u sides at v = 0 and v = 1, then v sides at u = 0 and u = 1 (NV_evaluators' nu0,
/// nu1, nv0, nv1). Triangles: (0,0)-(1,0), (1,0)-(0,1), (0,1)-(0,0); the fourth is not used.
/// Fractional quads: the last two are of the lines inside, along u and along v, where a patch is wider or narrower
/// inside than at its sides. 0, and always in the other patterns: the larger of the two opposite sides' factors.
using Factors = std::array<float, 6>;
inline constexpr std::size_t kInsideU = 4, kInsideV = 5;

/// How long a boundary may be in pixels before it is split, and from where that is seen.
struct ScreenMetric {
  glm::mat4 clip_from_object{1.0f};
  int width = 0, height = 0;  ///< pixels
  float edge_length_px = 8.0f;
  /// Patches that lie outside the picture, by all of their control points, get 1 on all sides. Beside the eye they
  /// would be cut finest of all. Sides that they share with others are outside too, where no crack can be seen.
  bool skips_invisible = false;
};

/// One set of factors a patch, from the screen-space length of each boundary's own control polygon, so that two patches
/// with the same boundary get the same factor. Inside, quads get the larger factor of the two opposite sides or, if
/// far more, the mean of three lines': a patch next to a pole may be wide in the middle. Clamped to [1, kMaxFactor].
/// `clamped`: how many sides met the maximum.
[[nodiscard]] std::vector<Factors> ScreenFactors(const geometry::BezierPatches& patches, const ScreenMetric& metric,
                                                 std::size_t* clamped = nullptr);

struct Options {
  Pattern pattern = Pattern::kFractional;
  /// Vertices a thread holds at once beyond what it writes (the paper's swatches); 0: a whole patch. The mesh is the
  /// same for every value.
  std::uint32_t swatch_vertices = 0;
  bool wants_tangents = false;  ///< along u of the first texture coordinates (of the patch where it has none)
  bool wants_patch_uv = true;
  bool wants_patch_ids = true;
  /// Not 0: a number that changes whenever the patches do (other than their factors). A Tessellator then keeps what it
  /// derives from them, such as the control nets of their normals.
  std::uint64_t revision = 0;
  bool is_parallel = true;           ///< on the threads of TBB
  bool uses_avx2 = base::HasAvx2();  ///< else code for every processor, with the same result
};

/// How much Tessellate would write.
struct SurfaceSize {
  std::size_t vertices = 0, triangles = 0;
};
[[nodiscard]] SurfaceSize MeasureSurface(const geometry::BezierPatches& patches, std::span<const Factors> factors,
                                         Pattern pattern);

/// Triangles of all patches, in patch order. Each patch has vertices of its own; positions on a boundary that two
/// patches share are the same bits in both. Arrays have one entry a vertex; empty where no patch has the attribute.
/// Patches without an attribute that others have get texture coordinates 0 and the colour white.
/// A side whose control points are all at one place has vertices but no triangles that would have no area.
struct Surface {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;   ///< unit length, towards the side from which u, v turn counterclockwise
  std::vector<glm::vec4> tangents;  ///< glTF's: xyz and handedness
  std::array<std::vector<glm::vec2>, 2> texcoords;
  std::vector<glm::vec4> colors;
  std::vector<glm::vec2> patch_uv;
  std::vector<std::uint32_t> patch_ids;  ///< BezierPatch::face
  std::vector<std::uint32_t> indices;    ///< three a triangle, counterclockwise as seen from the normals' side
};

/// Tessellates frame after frame and keeps what frames have in common: the triangles of patches that are cut alike,
/// and what is derived from patches that stay the same (Options::revision).
/// For one thread at a time.
class Tessellator {
 public:
  Tessellator();
  ~Tessellator();
  Tessellator(Tessellator&&) noexcept;
  Tessellator& operator=(Tessellator&&) noexcept;

  /// As the function below.
  void Tessellate(const geometry::BezierPatches& patches, std::span<const Factors> factors, const Options& options,
                  Surface& surface);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Tessellates every patch alone, in parallel; the bits do not depend on threads, processor or swatches. `factors`: one
/// a patch, clamped to [1, kMaxFactor] (NaN: 1; inside 0). `surface`'s arrays are reused. Patches must have passed
/// CheckPatches, and MeasureSurface must give fewer than 2^32 vertices.
void Tessellate(const geometry::BezierPatches& patches, std::span<const Factors> factors, const Options& options,
                Surface& surface);

}  // namespace burin::tessellation
