// SPDX-License-Identifier: Apache-2.0
#pragma once
// Control nets in double precision, and the little algebra that derivative and normal patches need.

#include <array>
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

/// The control points along one side, in its direction (Factors says which sides there are). Returns their degree.
int SideCurve(const Net& net, std::uint32_t side, Lanes* points);

/// Binomial coefficient, n up to 21.
[[nodiscard]] double Choose(int n, int k);

}  // namespace burin::tessellation
