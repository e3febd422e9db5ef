// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "core/geometry/bezier_patches.h"
#include "core/tessellation/kernels.h"
#include "core/tessellation/net.h"

namespace burin::tessellation {

/// What is evaluated at each vertex.
enum class Channel : std::uint8_t {
  kPosition,
  kNormal,
  kTexcoord0,
  kTexcoord1,
  kColor,
  // Only for tangents: derivatives along the patch's u and v.
  kPositionDu,
  kPositionDv,
  kTexcoordDu,
  kTexcoordDv,
};
inline constexpr std::size_t kChannelCount = 9;

/// One patch's nets in its own domain. Normals are scaled so that the largest component is about 1.
struct PatchNets {
  std::array<Net, kChannelCount> net;
  std::array<bool, kChannelCount> has{};

  [[nodiscard]] bool Has(Channel channel) const { return has[static_cast<std::size_t>(channel)]; }
  [[nodiscard]] Net& operator[](Channel channel) { return net[static_cast<std::size_t>(channel)]; }

  void Load(const Kernels& kernels, const geometry::BezierPatches& patches, const geometry::BezierPatch& patch,
            bool wants_tangents);
};

}  // namespace burin::tessellation
