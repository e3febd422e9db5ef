// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace burin::translucency {

/// kPaper: the paper's kernel of one mean free path and its global term (paper_glsl.h). The others gather the whole
/// dipole.
enum class Scattering : std::uint8_t { kPaper, kFast, kFull, kHigh };

/// What the gathering ways differ in.
struct Quality {
  int face_texels = 256;     ///< of a face's longer side
  int receiver_shift = 1;    ///< log2 of face texels a receiver
  int lattice = 2;           ///< spacing of the receivers that are all gathered; a power of two, 8 at most
  int window = 3;            ///< M: a level is gathered over 2M x 2M texels, but for the M x M that finer ones take
  float nearness = 1.8f;     ///< K: finer texels are taken where one lies nearer than K of its sizes
  int shadow_texels = 1024;  ///< of a shadow map's side
  int kernel = 0;            ///< above 0: the paper's way, so many samples across
  [[nodiscard]] constexpr bool is_paper() const { return kernel > 0; }
  bool operator==(const Quality&) const = default;
};

[[nodiscard]] constexpr Quality QualityOf(Scattering scattering) {
  switch (scattering) {
    case Scattering::kPaper:
      return {.face_texels = 128,
              .receiver_shift = 1,
              .lattice = 1,
              .window = 0,
              .nearness = 0.0f,
              .shadow_texels = 1024,
              .kernel = 5};
    case Scattering::kFull:
      return {};
    case Scattering::kFast:
      return {
          .face_texels = 128, .receiver_shift = 1, .lattice = 4, .window = 2, .nearness = 1.6f, .shadow_texels = 1024};
    case Scattering::kHigh:
      return {.face_texels = 256, .receiver_shift = 1, .window = 4, .nearness = 2.3f, .shadow_texels = 2048};
  }
  return {};
}

}  // namespace burin::translucency
