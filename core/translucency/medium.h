// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a translucent object is made of. No GL.

#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"

namespace burin::translucency {

/// A scattering medium. Coefficients per millimetre, for red, green and blue.
struct Medium {
  std::string name;                    ///< a measured material's, or what it was given as
  glm::vec3 reduced_scattering{1.0f};  ///< sigma_s'
  glm::vec3 absorption{0.0f};          ///< sigma_a
  float ior = 1.3f;                    ///< eta
  bool operator==(const Medium&) const = default;

  /// sigma_t' = sigma_a + sigma_s'.
  [[nodiscard]] glm::vec3 ReducedExtinction() const { return reduced_scattering + absorption; }
  /// alpha' = sigma_s' / sigma_t'; 0 where nothing scatters or absorbs.
  [[nodiscard]] glm::vec3 ReducedAlbedo() const;
  /// sigma_tr = sqrt(3 sigma_a sigma_t'); 0 without absorption.
  [[nodiscard]] glm::vec3 EffectiveTransport() const;
};

/// The twelve materials of Jensen et al. 2001, "A Practical Model for Subsurface Light Transport", figure 5.
[[nodiscard]] std::span<const Medium> MeasuredMedia();
/// One of them by name; case ignored.
[[nodiscard]] std::optional<Medium> FindMeasuredMedium(std::string_view name);

/// The medium whose uniformly lit flat surface gives off `albedo` (0 to below 1) of what enters it, and in which light
/// goes `mean_free_path_mm` = 1 / sigma_t' between scatterings. The inverse of TotalReflectance (dipole.h).
[[nodiscard]] Medium MediumFromAlbedo(const glm::vec3& albedo, const glm::vec3& mean_free_path_mm, float ior);

/// The medium through which light falls off as `attenuation` over `distance_mm`: sigma_tr = -ln(attenuation) /
/// distance. `albedo` as above. How KHR_materials_volume and KHR_materials_diffuse_transmission are read.
[[nodiscard]] Medium MediumFromAttenuation(const glm::vec3& albedo, const glm::vec3& attenuation, float distance_mm,
                                           float ior);

}  // namespace burin::translucency
