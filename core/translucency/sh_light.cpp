// SPDX-License-Identifier: Apache-2.0
// Ramamoorthi and Hanrahan 2001, "An Efficient Representation for Irradiance Environment Maps", for the plan; the basis
// up to band 4 after Sloan 2008, "Stupid Spherical Harmonics Tricks", appendix A2.
#include "core/translucency/sh_light.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include "core/gbuffer/cube_face.h"
#include "core/translucency/fresnel.h"

namespace burin::translucency {
namespace {

constexpr double kPi = glm::pi<double>();

void Add(ShRadiance& sum, const glm::vec3& pixel, const glm::dvec3& direction, double solid_angle) {
  glm::dvec3 light(0.0);
  for (int c = 0; c < 3; ++c) {
    if (std::isfinite(pixel[c])) light[c] = static_cast<double>(pixel[c]) * solid_angle;
  }
  const std::array<double, kShTerms> basis = ShBasis(direction);
  for (std::size_t i = 0; i < kShTerms; ++i) sum[i] += light * basis[i];
}

double Legendre(std::size_t band, double c) {
  const double c2 = c * c;
  switch (band) {
    case 0:
      return 1.0;
    case 1:
      return c;
    case 2:
      return 0.5 * (3.0 * c2 - 1.0);
    case 3:
      return 0.5 * c * (5.0 * c2 - 3.0);
    default:
      return 0.125 * (35.0 * c2 * c2 - 30.0 * c2 + 3.0);
  }
}

std::size_t BandOf(std::size_t term) {
  std::size_t band = 0;
  while ((band + 1) * (band + 1) <= term) ++band;
  return band;
}

}  // namespace

std::array<double, kShTerms> ShBasis(const glm::dvec3& n) {
  const double x = n.x;
  const double y = n.y;
  const double z = n.z;
  const double x2 = x * x;
  const double y2 = y * y;
  const double z2 = z * z;
  return {0.28209479177387814,
          0.4886025119029199 * y,
          0.4886025119029199 * z,
          0.4886025119029199 * x,
          1.0925484305920792 * x * y,
          1.0925484305920792 * y * z,
          0.31539156525252005 * (3.0 * z2 - 1.0),
          1.0925484305920792 * x * z,
          0.5462742152960396 * (x2 - y2),
          0.5900435899266435 * y * (3.0 * x2 - y2),
          2.890611442640554 * x * y * z,
          0.4570457994644658 * y * (5.0 * z2 - 1.0),
          0.3731763325901154 * z * (5.0 * z2 - 3.0),
          0.4570457994644658 * x * (5.0 * z2 - 1.0),
          1.445305721320277 * z * (x2 - y2),
          0.5900435899266435 * x * (x2 - 3.0 * y2),
          2.5033429417967046 * x * y * (x2 - y2),
          1.7701307697799304 * y * z * (3.0 * x2 - y2),
          0.9461746957575601 * x * y * (7.0 * z2 - 1.0),
          0.6690465435572892 * y * z * (7.0 * z2 - 3.0),
          0.10578554691520431 * (35.0 * z2 * z2 - 30.0 * z2 + 3.0),
          0.6690465435572892 * x * z * (7.0 * z2 - 3.0),
          0.47308734787878004 * (x2 - y2) * (7.0 * z2 - 1.0),
          1.7701307697799304 * x * z * (x2 - 3.0 * y2),
          0.6258357354491761 * (x2 * (x2 - 3.0 * y2) - y2 * (3.0 * x2 - y2))};
}

ShRadiance ProjectLatLong(std::span<const glm::vec3> pixels, int width, int height) {
  ShRadiance sum{};
  for (int row = 0; row < height; ++row) {
    const double top = kPi * (0.5 - static_cast<double>(row) / height);
    const double bottom = kPi * (0.5 - (row + 1.0) / height);
    const double latitude = 0.5 * (top + bottom);
    const double solid_angle = 2.0 * kPi / width * (std::sin(top) - std::sin(bottom));
    for (int column = 0; column < width; ++column) {
      const double longitude = 2.0 * kPi * ((column + 0.5) / width - 0.5);
      const glm::dvec3 direction(std::cos(latitude) * std::sin(longitude), std::sin(latitude),
                                 -std::cos(latitude) * std::cos(longitude));
      const auto i = static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column);
      Add(sum, pixels[i], direction, solid_angle);
    }
  }
  return sum;
}

double CubeTexelSolidAngle(int x, int y, int size) {
  // The solid angle of the corner rectangle from the face's centre to (s, t) is atan2(s t, sqrt(s^2 + t^2 + 1)).
  const auto corner = [](double s, double t) { return std::atan2(s * t, std::sqrt(s * s + t * t + 1.0)); };
  const double s0 = 2.0 * x / size - 1.0;
  const double s1 = 2.0 * (x + 1) / size - 1.0;
  const double t0 = 2.0 * y / size - 1.0;
  const double t1 = 2.0 * (y + 1) / size - 1.0;
  return corner(s1, t1) - corner(s0, t1) - corner(s1, t0) + corner(s0, t0);
}

ShRadiance ProjectCube(std::span<const glm::vec3> pixels, int size) {
  ShRadiance sum{};
  std::size_t i = 0;
  for (int face = 0; face < 6; ++face) {
    for (int y = 0; y < size; ++y) {
      for (int x = 0; x < size; ++x, ++i) {
        const glm::dvec3 direction =
            gbuffer::CubeFaceDirection(face, (2.0 * x + 1.0) / size - 1.0, (2.0 * y + 1.0) / size - 1.0);
        Add(sum, pixels[i], glm::normalize(direction), CubeTexelSolidAngle(x, y, size));
      }
    }
  }
  return sum;
}

std::array<double, kShBands> IrradianceLobe(double ior) {
  constexpr int kSteps = 20000;
  std::array<double, kShBands> lobe{};
  for (int i = 0; i < kSteps; ++i) {
    const double c = (i + 0.5) / kSteps;
    const double weight = 2.0 * kPi / kSteps * (1.0 - FresnelReflectance(c, ior)) * c;
    for (std::size_t band = 0; band < lobe.size(); ++band) lobe[band] += weight * Legendre(band, c);
  }
  return lobe;
}

std::array<double, kShBands> HanningWindow() {
  std::array<double, kShBands> window{};
  for (std::size_t band = 0; band < window.size(); ++band) {
    window[band] = 0.5 * (1.0 + std::cos(kPi * static_cast<double>(band) / kShBands));
  }
  return window;
}

std::array<glm::vec3, kShTerms> FoldIrradiance(const ShRadiance& radiance, double ior, bool is_windowed) {
  const std::array<double, kShBands> lobe = IrradianceLobe(ior);
  const std::array<double, kShBands> window = HanningWindow();
  std::array<glm::vec3, kShTerms> folded{};
  for (std::size_t i = 0; i < kShTerms; ++i) {
    const std::size_t band = BandOf(i);
    folded[i] = glm::vec3(radiance[i] * lobe[band] * (is_windowed ? window[band] : 1.0));
  }
  return folded;
}

glm::dvec3 EvaluateIrradiance(const std::array<glm::vec3, kShTerms>& folded, const glm::dvec3& normal) {
  const std::array<double, kShTerms> basis = ShBasis(normal);
  glm::dvec3 sum(0.0);
  for (std::size_t i = 0; i < kShTerms; ++i) sum += glm::dvec3(folded[i]) * basis[i];
  return glm::max(sum, glm::dvec3(0.0));
}

}  // namespace burin::translucency
