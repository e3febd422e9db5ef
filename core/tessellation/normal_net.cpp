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

void CopyShape(const Net& from, Net& to) {
  to.domain = from.domain;
  to.u_degree = from.u_degree;
  to.v_degree = from.v_degree;
}

void ScaleUp(const Net& net, Net& scaled) {
  CopyShape(net, scaled);
  for (int j = 0; j <= net.v_degree; ++j) {
    const int row = net.Index(0, j);
    for (int i = 0; i < net.RowLength(j); ++i) scaled.value[row + i] = net.value[row + i] * Scale(net, i, j);
  }
}

/// The products' components come as y, z, x (see Kernels::convolve_cross).
void ScaleDownRotated(Net& net) {
  for (int j = 0; j <= net.v_degree; ++j) {
    const int row = net.Index(0, j);
    for (int i = 0; i < net.RowLength(j); ++i) {
      Lanes& value = net.value[row + i];
      value = Lanes{value[1], value[2], value[0], 0.0} * InverseScale(net, i, j);
    }
  }
}

void StartProduct(const Net& a, const Net& b, Net& product) {
  product.domain = a.domain;
  product.u_degree = a.u_degree + b.u_degree;
  product.v_degree = a.v_degree + b.v_degree;
  for (int k = 0; k < product.Count(); ++k) product.value[k] = Lanes{};
}

void Rotate(const Net& net, Net& rotated) {
  CopyShape(net, rotated);
  for (int k = 0; k < net.Count(); ++k) {
    const Lanes& value = net.value[k];
    rotated.value[k] = Lanes{value[1], value[2], value[0], 0.0};
  }
}

/// All in scaled form.
void MultiplyCross(const Kernels& kernels, const Net& a, const Net& b, Net& product) {
  StartProduct(a, b, product);
  Net rotated;
  Rotate(b, rotated);
  for (int ja = 0; ja <= a.v_degree; ++ja) {
    for (int jb = 0; jb <= b.v_degree; ++jb)
      kernels.convolve_cross(&a.At(0, ja), a.RowLength(ja), &b.At(0, jb), &rotated.At(0, jb), b.RowLength(jb),
                             &product.At(0, ja + jb));
  }
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
  ScaleUp(du, scaled_du);
  ScaleUp(dv, scaled_dv);
  if (is_rational) {
    Net scaled_position;
    ScaleUp(position, scaled_position);
    MultiplyRational(kernels, scaled_position, scaled_du, scaled_dv, normal);
  } else {
    MultiplyCross(kernels, scaled_du, scaled_dv, normal);
  }
  ScaleDownRotated(normal);
}

}  // namespace burin::tessellation
