// SPDX-License-Identifier: Apache-2.0
// Products of Bézier polynomials: with every control point times its binomial (trinomial) coefficient, a product's
// points are the convolution of its factors' (Farin, "Curves and Surfaces for CAGD", on products of polynomials).
#include "core/tessellation/normal_net.h"

#include <algorithm>

namespace burin::tessellation {
namespace {

/// The factor between a control point and its scaled form.
double Scale(const Net& net, int i, int j) {
  if (net.is_quad()) return Choose(net.u_degree, i) * Choose(net.v_degree, j);
  return Choose(net.u_degree, j) * Choose(net.u_degree - j, i);
}

double InverseScale(const Net& net, int i, int j) {
  if (net.is_quad()) return InverseChoose(net.u_degree, i) * InverseChoose(net.v_degree, j);
  return InverseChoose(net.u_degree, j) * InverseChoose(net.u_degree - j, i);
}

NetShape ShapeOf(const Net& net) { return {net.u_degree + 1, net.v_degree + 1, !net.is_quad()}; }

template <class ScaleOf>
void ScaleBy(const Kernels& kernels, const Net& net, const ScaleOf& scale_of, Net& scaled) {
  std::array<double, kMaxNetOrder * kMaxNetOrder> scales;
  for (int j = 0; j <= net.v_degree; ++j) {
    const int row = net.Index(0, j);
    for (int i = 0; i < net.RowLength(j); ++i) scales[static_cast<std::size_t>(row + i)] = scale_of(net, i, j);
  }
  scaled.domain = net.domain;
  scaled.u_degree = net.u_degree;
  scaled.v_degree = net.v_degree;
  kernels.scale(net.value.data(), scales.data(), net.Count(), scaled.value.data());
}

void StartProduct(const Net& a, const Net& b, Net& product) {
  product.domain = a.domain;
  product.u_degree = a.u_degree + b.u_degree;
  product.v_degree = a.v_degree + b.v_degree;
}

/// All in scaled form.
void MultiplyCross(const Kernels& kernels, const Net& a, const Net& b, Net& product) {
  StartProduct(a, b, product);
  kernels.multiply_cross(a.value.data(), ShapeOf(a), b.value.data(), ShapeOf(b), product.value.data());
}

/// Adds sign * a * the weight of b to `sum`; all in scaled form.
void AccumulateWeighted(const Net& a, const Net& b, double sign, Net& sum) {
  for (int ja = 0; ja <= a.v_degree; ++ja) {
    for (int jb = 0; jb <= b.v_degree; ++jb) {
      for (int ia = 0; ia < a.RowLength(ja); ++ia) {
        for (int ib = 0; ib < b.RowLength(jb); ++ib)
          sum.At(ia + ib, ja + jb) += a.At(ia, ja) * (sign * b.At(ib, jb)[3]);
      }
    }
  }
}

/// With x = P / w: w^3 (x_u x x_v) = w (P_u x P_v) - w_v (P_u x P) - w_u (P x P_v).
void MultiplyRational(const Kernels& kernels, const Net& p, const Net& du, const Net& dv, Net& normal) {
  Net product;
  MultiplyCross(kernels, du, dv, product);
  StartProduct(product, p, normal);
  std::fill_n(normal.value.begin(), normal.Count(), Lanes{});
  AccumulateWeighted(product, p, 1.0, normal);
  MultiplyCross(kernels, du, p, product);
  AccumulateWeighted(product, dv, -1.0, normal);
  MultiplyCross(kernels, p, dv, product);
  AccumulateWeighted(product, du, -1.0, normal);
}

}  // namespace

void MakeNormalNet(const Kernels& kernels, const Net& position, const Net& du, const Net& dv, bool is_rational,
                   Net& normal) {
  Net scaled_du, scaled_dv;
  ScaleBy(kernels, du, Scale, scaled_du);
  ScaleBy(kernels, dv, Scale, scaled_dv);
  if (is_rational) {
    Net scaled_position;
    ScaleBy(kernels, position, Scale, scaled_position);
    MultiplyRational(kernels, scaled_position, scaled_du, scaled_dv, normal);
  } else {
    MultiplyCross(kernels, scaled_du, scaled_dv, normal);
  }
  ScaleBy(kernels, normal, InverseScale, normal);
}

}  // namespace burin::tessellation
