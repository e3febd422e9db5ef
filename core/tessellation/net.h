// SPDX-License-Identifier: Apache-2.0
#pragma once
// Control nets in double precision, and the little algebra that derivative and normal patches need.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/geometry/bezier_patches.h"
#include "core/tessellation/lanes.h"

namespace burin::tessellation {

/// Packed as geometry::ControlNet says. Triangles have one degree, in both members.
struct Net {
  geometry::PatchDomain domain = geometry::PatchDomain::kQuad;
  int u_degree = 0, v_degree = 0;
  std::array<Lanes, kMaxNetOrder * kMaxNetOrder> value;

  [[nodiscard]] bool is_quad() const { return domain == geometry::PatchDomain::kQuad; }
  [[nodiscard]] int RowLength(int j) const { return is_quad() ? u_degree + 1 : u_degree + 1 - j; }
  [[nodiscard]] int Count() const { return Index(0, v_degree) + RowLength(v_degree); }
  [[nodiscard]] int Index(int i, int j) const { return j * (u_degree + 1) + i - (is_quad() ? 0 : j * (j - 1) / 2); }
  [[nodiscard]] Lanes& At(int i, int j) { return value[static_cast<std::size_t>(Index(i, j))]; }
  [[nodiscard]] const Lanes& At(int i, int j) const { return value[static_cast<std::size_t>(Index(i, j))]; }
};

/// Takes one attribute's control points. Negative zeros become positive ones: neighbours' points are equal, not always
/// by bits.
template <class Value>
void LoadNet(geometry::PatchDomain domain, const geometry::ControlNet& from, std::span<const Value> values, Net& net) {
  net.domain = domain;
  net.u_degree = from.u_order - 1;
  net.v_degree = from.v_order - 1;
  const std::uint32_t count = geometry::ValueCount(domain, from);
  for (std::uint32_t k = 0; k < count; ++k) {
    const Value& value = values[from.first + k];
    Lanes lanes{};
    for (int c = 0; c < Value::length(); ++c) lanes[c] = static_cast<double>(value[c]) + 0.0;
    net.value[k] = lanes;
  }
}

/// The derivative's net: differences of neighbouring points times the degree (Moreton, section 6). Of a constant: 0.
void DeriveU(const Net& net, Net& derivative);
void DeriveV(const Net& net, Net& derivative);

/// Control points on a line of a net.
struct NetLine {
  const Lanes* points;
  std::ptrdiff_t stride;
  int degree;
};

/// Of quads, the control points along a side (Factors says which), `depth` lines inwards.
[[nodiscard]] NetLine QuadLine(const Net& net, std::uint32_t side, int depth);

/// Of triangles, which value is point k of a side, in the side's direction.
[[nodiscard]] inline int TrianglePoint(const Net& net, std::uint32_t side, int k) {
  const int n = net.u_degree;
  return side == 0 ? net.Index(k, 0) : side == 1 ? net.Index(n - k, k) : net.Index(0, n - k);
}

/// Binomial coefficients up to n = 21. A plain array, for the code that is built for AVX2 as well (kernels.inl).
struct ChooseTable {
  static constexpr int kRows = 22;
  double rows[kRows][kRows];
  double inverse_rows[kRows][kRows];
};
inline constexpr ChooseTable kChoose = [] {
  ChooseTable table{};
  for (int n = 0; n < ChooseTable::kRows; ++n) {
    table.rows[n][0] = 1.0;
    for (int k = 1; k <= n; ++k) table.rows[n][k] = table.rows[n - 1][k - 1] + table.rows[n - 1][k];
    for (int k = 0; k <= n; ++k) table.inverse_rows[n][k] = 1.0 / table.rows[n][k];
  }
  return table;
}();

[[nodiscard]] inline double Choose(int n, int k) { return kChoose.rows[n][k]; }
[[nodiscard]] inline double InverseChoose(int n, int k) { return kChoose.inverse_rows[n][k]; }

}  // namespace burin::tessellation
