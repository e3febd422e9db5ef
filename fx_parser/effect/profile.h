// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace burin::fx {

enum class ProfileStage { kVertex, kPixel, kEither, kOther, kUnknown };

/// A compile target as stage and hint: its limits are not enforced.
struct Profile {
  ProfileStage stage = ProfileStage::kUnknown;
  int shader_model = 3;
};

/// Direct3D's vs_1_1 to ps_5_0, Cg's arbvp1 to gp5fp, glslv, glslf, latest; case is ignored.
[[nodiscard]] Profile FindProfile(std::string_view name);

}  // namespace burin::fx
