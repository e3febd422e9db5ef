// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "core/translucency/medium_spec.h"
#include "core/translucency/scattering_quality.h"

namespace burin::translucency {

struct TranslucencyOptions {
  std::vector<Assignment> assignments;
  Scattering scattering = Scattering::kFull;
  int paper_kernel = 5;     ///< kPaper: samples across its kernel
  double unit_mm = 1000.0;  ///< millimetres a scene unit: glTF's is the metre
  /// What all objects' maps may take on the device; a frame that needs more fails.
  std::size_t most_map_bytes = std::size_t{4} << 30;
};

}  // namespace burin::translucency
