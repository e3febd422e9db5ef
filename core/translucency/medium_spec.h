// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/scene/scene.h"
#include "core/translucency/medium.h"

namespace burin::translucency {

/// A medium as users write it, on the command line and in glTF's extras (burin-render(1), TRANSLUCENCY):
///   Skin1                                            a measured material's name
///   none                                             opaque: an empty result
///   scattering:R,G,B;absorption:R,G,B[;ior:N]        coefficients, 1/mm; one number stands for all three
///   albedo:R,G,B;path:R,G,B[;ior:N]                  diffuse albedo and mean free path in mm
/// Errors: kUsage, saying what was found and what was expected.
[[nodiscard]] Result<std::optional<Medium>> ParseMedium(std::string_view text);

/// Which materials become which medium: "GLOB=MEDIUM".
struct Assignment {
  std::string glob;  ///< of material names, as the shell's; case matters
  std::optional<Medium> medium;
};
[[nodiscard]] Result<Assignment> ParseAssignment(const std::string& text);

/// The scene's media and what is to be said about them.
struct SceneMedia {
  std::vector<std::optional<Medium>> of_material;  ///< one a material of the scene
  std::vector<std::string> warnings;
};

/// The last assignment that fits a material's name; else its own extras; else what its
/// KHR_materials_diffuse_transmission and KHR_materials_volume say. `unit_mm`: millimetres a scene unit. Errors:
/// kInput, naming file and material, for extras that can't be read.
[[nodiscard]] Result<SceneMedia> ResolveMedia(const scene::Scene& scene, const std::vector<Assignment>& assignments,
                                              double unit_mm);

/// What is likely to be wrong with a medium, a sentence each: coefficients that look exchanged, nothing that scatters.
[[nodiscard]] std::vector<std::string> CheckMedium(const Medium& medium);

/// What is likely to be wrong with a medium in an object of this size (its largest extent): a mean free path below a
/// texel or above the object, so that the unit is likely to be wrong. Empty: nothing.
[[nodiscard]] std::string CheckScale(const Medium& medium, double object_mm, double texel_mm, double unit_mm);

}  // namespace burin::translucency
