// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/gbuffer/environment.h"
#include "core/image/cube_layout.h"

namespace burin::gbuffer {

/// The same surroundings as an equirectangular map four faces wide. The front is what a camera at rest looks at, -z.
[[nodiscard]] EnvironmentMap EquirectangularOf(const EnvironmentMap& faces, image::CubeLayout layout);

}  // namespace burin::gbuffer
