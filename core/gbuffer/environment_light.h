// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <glm/vec4.hpp>
#include <optional>

#include "core/gbuffer/environment.h"
#include "core/gl/handle.h"

namespace burin::gbuffer {

/// An environment on the device. Filtering it takes up to a third of a second, so it waits until a colour is wanted.
class EnvironmentLight {
 public:
  /// No map: the built-in studio.
  explicit EnvironmentLight(std::optional<EnvironmentMap> map) : map_(std::move(map)), is_builtin_(!map_.has_value()) {}

  [[nodiscard]] bool is_builtin() const { return is_builtin_; }
  /// Filters and uploads on the first call; later ones do nothing.
  void Prepare();
  /// After Prepare(). Binds the reflections to `unit`.
  void Bind(unsigned unit) const;
  [[nodiscard]] const std::array<glm::vec4, 9>& irradiance() const { return irradiance_; }
  [[nodiscard]] int last_level() const { return last_level_; }

 private:
  std::optional<EnvironmentMap> map_;
  bool is_builtin_;
  gl::TextureHandle reflections_;
  std::array<glm::vec4, 9> irradiance_{};
  int last_level_ = 0;
};

}  // namespace burin::gbuffer
