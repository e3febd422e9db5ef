// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "fx_parser/effect/effect.h"

namespace burin::effect {

/// What an OFFSCREENRENDERTARGET of MikuMikuEffect shows.
struct OffscreenContent {
  enum class Kind {
    kNothing,  ///< its ClearColor
    kScene,    ///< the source as it is shown without effects
    kEffect    ///< the scene by the effect `file`
  };
  Kind kind = Kind::kScene;
  std::string file;
};

/// By the annotation DefaultEffect, "self = hide; *.pmx = mask.fx; * = none;": what it says of a model. The scene is a
/// model and never what carries the effect ("self").
[[nodiscard]] OffscreenContent ContentOf(const fx::Texture& texture);

}  // namespace burin::effect
