// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "fx_parser/effect/effect.h"

namespace burin::effect {

/// What MikuMikuEffect's CONTROLOBJECT parameters get. Of "(self)", which is whatever carries the effect: an object at
/// the origin that is shown, unturned, opaque and of the usual size (10, as MikuMikuDance counts an accessory's scale).
/// Of other models, which are not here: zeros, with a warning that names the model. Empty: the parameter names none.
[[nodiscard]] std::optional<std::array<double, 4>> ControlObjectValue(const fx::Effect& effect,
                                                                      const fx::Parameter& parameter,
                                                                      std::vector<std::string>& warnings);

}  // namespace burin::effect
