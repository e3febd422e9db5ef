// SPDX-License-Identifier: Apache-2.0
#include "core/translucency/medium.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <glm/common.hpp>
#include <glm/exponential.hpp>

#include "core/translucency/dipole.h"

namespace burin::translucency {
namespace {

// Jensen et al. 2001, figure 5; 1/mm. Refractive indices are those that the figure's diffuse reflectances follow from.
const std::array<Medium, 12> kMeasured = {{
    {"Apple", {2.29f, 2.39f, 1.97f}, {0.0030f, 0.0034f, 0.046f}, 1.3f},
    {"Chicken1", {0.15f, 0.21f, 0.38f}, {0.015f, 0.077f, 0.19f}, 1.3f},
    {"Chicken2", {0.19f, 0.25f, 0.32f}, {0.018f, 0.088f, 0.20f}, 1.3f},
    {"Cream", {7.38f, 5.47f, 3.15f}, {0.0002f, 0.0028f, 0.0163f}, 1.3f},
    {"Ketchup", {0.18f, 0.07f, 0.03f}, {0.061f, 0.97f, 1.45f}, 1.3f},
    {"Marble", {2.19f, 2.62f, 3.00f}, {0.0021f, 0.0041f, 0.0071f}, 1.5f},
    {"Potato", {0.68f, 0.70f, 0.55f}, {0.0024f, 0.0090f, 0.12f}, 1.3f},
    {"Skimmilk", {0.70f, 1.22f, 1.90f}, {0.0014f, 0.0025f, 0.0142f}, 1.3f},
    {"Skin1", {0.74f, 0.88f, 1.01f}, {0.032f, 0.17f, 0.48f}, 1.3f},
    {"Skin2", {1.09f, 1.59f, 1.79f}, {0.013f, 0.070f, 0.145f}, 1.3f},
    {"Spectralon", {11.6f, 20.4f, 14.9f}, {0.0f, 0.0f, 0.0f}, 1.3f},
    {"Wholemilk", {2.55f, 3.21f, 3.77f}, {0.0011f, 0.0024f, 0.014f}, 1.3f},
}};

bool EqualIgnoringCase(std::string_view a, std::string_view b) {
  return std::ranges::equal(a, b, [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

constexpr double kMostAlbedo = 0.9999;  // of 1 the medium absorbs nothing, and no attenuation tells its scattering

// TotalReflectance grows with alpha' from 0 to 1.
double AlphaOf(double albedo, double ior) {
  double low = 0.0;
  double high = 1.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (TotalReflectance(middle, ior) < albedo ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

// Near white 1 - alpha' is a millionth: doubles.
glm::dvec3 AlphaOf(const glm::vec3& albedo, float ior) {
  glm::dvec3 alpha;
  for (int c = 0; c < 3; ++c) {
    alpha[c] = AlphaOf(std::clamp(static_cast<double>(albedo[c]), 0.0, kMostAlbedo), static_cast<double>(ior));
  }
  return alpha;
}

Medium FromExtinction(const glm::dvec3& alpha, const glm::dvec3& extinction, float ior) {
  Medium medium;
  medium.reduced_scattering = glm::vec3(alpha * extinction);
  medium.absorption = glm::vec3((1.0 - alpha) * extinction);
  medium.ior = ior;
  return medium;
}

}  // namespace

glm::vec3 Medium::ReducedAlbedo() const {
  const glm::vec3 extinction = ReducedExtinction();
  glm::vec3 alpha(0.0f);
  for (int c = 0; c < 3; ++c) {
    if (extinction[c] > 0.0f) alpha[c] = reduced_scattering[c] / extinction[c];
  }
  return alpha;
}

glm::vec3 Medium::EffectiveTransport() const { return glm::sqrt(3.0f * absorption * ReducedExtinction()); }

std::span<const Medium> MeasuredMedia() { return kMeasured; }

std::optional<Medium> FindMeasuredMedium(std::string_view name) {
  const auto* found =
      std::ranges::find_if(kMeasured, [&](const Medium& medium) { return EqualIgnoringCase(medium.name, name); });
  if (found == kMeasured.end()) return std::nullopt;
  return *found;
}

Medium MediumFromAlbedo(const glm::vec3& albedo, const glm::vec3& mean_free_path_mm, float ior) {
  return FromExtinction(AlphaOf(albedo, ior), 1.0 / glm::max(glm::dvec3(mean_free_path_mm), 1e-6), ior);
}

Medium MediumFromAttenuation(const glm::vec3& albedo, const glm::vec3& attenuation, float distance_mm, float ior) {
  const glm::dvec3 alpha = AlphaOf(albedo, ior);
  const glm::dvec3 kept = glm::clamp(glm::dvec3(attenuation), 1e-4, 0.9999);
  const glm::dvec3 transport = -glm::log(kept) / std::max(static_cast<double>(distance_mm), 1e-6);
  return FromExtinction(alpha, transport / glm::sqrt(3.0 * (1.0 - alpha)), ior);
}

}  // namespace burin::translucency
