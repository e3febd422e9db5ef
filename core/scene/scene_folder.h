// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"

namespace burin::scene {

/// Reads a regular file whole. Refuses directories, devices, pipes and files over `max_bytes` before allocating.
/// Messages lack the path: the caller names the file.
[[nodiscard]] Result<std::vector<std::byte>> ReadRegularFile(const std::string& path, std::uint64_t max_bytes);

/// "%20" to " "; fails on a bad escape or an escaped NUL.
[[nodiscard]] Result<std::string> PercentDecode(std::string_view text);

/// The folder of a scene file: the only place that its relative references may name.
class SceneFolder {
 public:
  explicit SceneFolder(const std::string& scene_path);

  /// The absolute path of the existing file that a relative URI reference names. Refuses URLs, absolute paths, and
  /// whatever leaves the folder by "..", directly or through a symbolic link.
  [[nodiscard]] Result<std::string> Resolve(std::string_view uri) const;

 private:
  std::string folder_;
};

}  // namespace burin::scene
