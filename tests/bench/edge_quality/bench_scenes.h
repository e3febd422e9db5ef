// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/scene/scene.h"

namespace burin::bench {

/// A scene of the tables; made in code, or read where the shared data is there.
struct BenchScene {
  std::string name;
  bool is_clean = true;  ///< the tables' first column; else the second
  /// Nothing where the file is not there.
  std::function<std::optional<scene::Scene>()> make;
};

/// Every scene, clean ones first. `shared_data`: the folder of real models.
[[nodiscard]] std::vector<BenchScene> BenchScenes(const std::string& shared_data);

/// A white half-plane in the plane z = 0, below the line through the origin at this angle to the x axis.
[[nodiscard]] scene::Scene HalfPlane(double angle_rad, double offset);

}  // namespace burin::bench
