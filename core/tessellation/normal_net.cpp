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

Lanes Rotated(const Lanes& a) { return Lanes{a[1], a[2], a[0], 0.0}; }

Lanes Cross(const Lanes& a, const Lanes& b) { return Rotated(a * Rotated(b) - Rotated(a) * b); }

Lanes TimesWeight(const Lanes& a, const Lanes& weighted) { return a * weighted[3]; }

/// Adds sign * combine(a, b) to `sum`; all three in scaled form, `sum` of the degrees of a product.
template <class Combine>
void Accumulate(const Net& a, const Net& b, double sign, const Combine& combine, Net& sum) {
  for (int ja = 0; ja <= a.v_degree; ++ja) {
    for (int jb = 0; jb <= b.v_degree; ++jb) {
      for (int ia = 0; ia < a.RowLength(ja); ++ia) {
        for (int ib = 0; ib < b.RowLength(jb); ++ib)
          sum.At(ia + ib, ja + jb) += sign * combine(a.At(ia, ja), b.At(ib, jb));
      }
    }
  }
}

void StartProduct(const Net& a, const Net& b, Net& product) {
  product.domain = a.domain;
  product.u_degree = a.u_degree + b.u_degree;
  product.v_degree = a.v_degree + b.v_degree;
  for (int j = 0; j <= product.v_degree; ++j) {
    for (int i = 0; i < product.RowLength(j); ++i) product.At(i, j) = Lanes{};
  }
}

template <class Combine>
void Multiply(const Net& a, const Net& b, const Combine& combine, Net& product) {
  StartProduct(a, b, product);
  Accumulate(a, b, 1.0, combine, product);
}

void ScaleUp(const Net& net, Net& scaled) {
  scaled.domain = net.domain;
  scaled.u_degree = net.u_degree;
  scaled.v_degree = net.v_degree;
  for (int j = 0; j <= net.v_degree; ++j) {
    for (int i = 0; i < net.RowLength(j); ++i) scaled.At(i, j) = net.At(i, j) * Scale(net, i, j);
  }
}

void ScaleDown(Net& net) {
  for (int j = 0; j <= net.v_degree; ++j) {
    for (int i = 0; i < net.RowLength(j); ++i) net.At(i, j) /= Scale(net, i, j);
  }
}

/// With x = P / w: w^3 (x_u x x_v) = w (P_u x P_v) - w_v (P_u x P) - w_u (P x P_v).
void AccumulateRational(const Net& p, const Net& du, const Net& dv, Net& normal) {
  Net product;
  Multiply(du, dv, Cross, product);
  StartProduct(product, p, normal);
  Accumulate(product, p, 1.0, TimesWeight, normal);
  Multiply(du, p, Cross, product);
  Accumulate(product, dv, -1.0, TimesWeight, normal);
  Multiply(p, dv, Cross, product);
  Accumulate(product, du, -1.0, TimesWeight, normal);
}

}  // namespace

void MakeNormalNet(const Net& position, const Net& du, const Net& dv, bool is_rational, Net& normal) {
  Net scaled_du, scaled_dv;
  ScaleUp(du, scaled_du);
  ScaleUp(dv, scaled_dv);
  if (is_rational) {
    Net scaled_position;
    ScaleUp(position, scaled_position);
    AccumulateRational(scaled_position, scaled_du, scaled_dv, normal);
  } else {
    Multiply(scaled_du, scaled_dv, Cross, normal);
  }
  ScaleDown(normal);
}

}  // namespace burin::tessellation
