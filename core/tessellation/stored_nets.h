// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/tessellation/patch_nets.h"

namespace burin::tessellation {

/// Nets of patches that stay as they are from frame to frame, normals among them, as far as there is room.
class StoredNets {
 public:
  /// What is stored beyond this is loaded anew each time.
  static constexpr std::size_t kMaxBytes = std::size_t{16} << 20;

  /// Before each frame. Forgets everything unless `revision` (not 0), the number of patches and whether there are
  /// tangents are the last frame's.
  void Start(std::uint64_t revision, std::size_t patch_count, bool has_tangents);

  /// These may be called for different patches at the same time. Restore returns whether the patch was stored.
  [[nodiscard]] bool Restore(std::size_t patch, PatchNets& nets) const;
  void Store(std::size_t patch, const PatchNets& nets);

 private:
  struct Shape {
    std::int8_t u_degree = -1, v_degree = -1;  ///< -1: the patch has no such channel
  };
  struct Entry {
    geometry::PatchDomain domain = geometry::PatchDomain::kQuad;
    std::array<Shape, kChannelCount> shapes;
    std::unique_ptr<Lanes[]> values;  ///< one net after the other
  };

  std::uint64_t revision_ = 0;
  bool has_tangents_ = false;
  std::vector<Entry> entries_;
  std::atomic<std::size_t> bytes_ = 0;
};

}  // namespace burin::tessellation
