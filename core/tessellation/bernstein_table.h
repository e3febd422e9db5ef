// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/tessellation/kernels.h"

namespace burin::tessellation {

/// Bernstein polynomials at the parameters of a patch's rows, kept for the next patch that has the same rows.
class BernsteinTable {
 public:
  /// degree + 1 weights a parameter, valid until the next call with this degree.
  [[nodiscard]] const double* Weights(const Kernels& kernels, int degree, std::span<const double> parameters) {
    Rows& rows = rows_[static_cast<std::size_t>(degree)];
    if (!std::ranges::equal(rows.parameters, parameters)) {
      rows.parameters.assign(parameters.begin(), parameters.end());
      rows.weights.resize(parameters.size() * static_cast<std::size_t>(degree + 1));
      kernels.bernstein(parameters.data(), static_cast<std::uint32_t>(parameters.size()), degree, rows.weights.data());
    }
    return rows.weights.data();
  }

 private:
  struct Rows {
    std::vector<double> parameters, weights;
  };
  std::array<Rows, kMaxNetOrder> rows_;
};

}  // namespace burin::tessellation
