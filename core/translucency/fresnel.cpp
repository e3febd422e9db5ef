// SPDX-License-Identifier: Apache-2.0
#include "core/translucency/fresnel.h"

#include <algorithm>
#include <cmath>

namespace burin::translucency {

double FresnelReflectance(double cosine, double ior) {
  const double c = std::clamp(cosine, 0.0, 1.0);
  const double under_root = ior * ior - 1.0 + c * c;
  if (under_root <= 0.0) return 1.0;
  // g = eta cos(theta_t), after Cook and Torrance 1982.
  const double g = std::sqrt(under_root);
  const double s = (g - c) / (g + c);
  const double p = (c * (g + c) - 1.0) / (c * (g - c) + 1.0);
  return 0.5 * s * s * (1.0 + p * p);
}

double DiffuseFresnelFit(double ior) {
  const double i = 1.0 / ior;
  if (ior >= 1.0) return -1.440 * i * i + 0.710 * i + 0.668 + 0.0636 * ior;
  return -0.4399 + 0.7099 * i - 0.3319 * i * i + 0.0636 * i * i * i;
}

double DiffuseFresnelExact(double ior) {
  constexpr int kSteps = 20000;
  double sum = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const double c = (i + 0.5) / kSteps;
    sum += FresnelReflectance(c, 1.0 / ior) * c;
  }
  return 2.0 * sum / kSteps;
}

double BoundaryFactor(double ior) {
  const double f = DiffuseFresnelFit(ior);
  return (1.0 + f) / (1.0 - f);
}

}  // namespace burin::translucency
