// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "core/effect/frame_context.h"
#include "core/effect/host_value.h"
#include "core/effect/parameter_override.h"
#include "fx_parser/effect/effect.h"

namespace burin::effect {

/// The value of every parameter of one effect: an override, else the host's, else the default. A version counts each
/// parameter's changes, so that a program uploads only what is new to it.
class ParameterValues {
 public:
  /// `texture_sizes`: of Effect::textures, for TexelSize_<texture>. Appends to `warnings`.
  ParameterValues(const fx::Effect& effect, const Overrides& overrides, std::vector<glm::ivec2> texture_sizes,
                  std::vector<std::string>& warnings);

  void SetFrame(const FrameContext& context);
  /// Only what depends on the object that is drawn.
  void SetObject(const FrameContext& context);

  /// Of a script's loop: the first component.
  void Set(std::size_t parameter, double number);

  /// Whether a parameter gets the diffuse colour of objects.
  [[nodiscard]] bool has_material_color() const;
  [[nodiscard]] const fx::Value& value(std::size_t parameter) const { return values_[parameter]; }
  [[nodiscard]] std::uint64_t version(std::size_t parameter) const { return versions_[parameter]; }

 private:
  struct HostBinding {
    std::size_t parameter;
    HostPart part;
  };
  void Update(const HostBinding& binding, const FrameContext& context);

  std::vector<fx::Value> values_;
  std::vector<std::uint64_t> versions_;
  std::vector<HostBinding> bindings_;
  std::vector<glm::ivec2> texture_sizes_;
  std::vector<double> scratch_;
  bool column_vectors_ = false;
};

}  // namespace burin::effect
