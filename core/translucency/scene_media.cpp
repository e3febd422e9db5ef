// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <cmath>

#include "core/translucency/medium_spec.h"

namespace burin::translucency {
namespace {

// "materials[2] \"Wax\""
std::string NameOf(const scene::Scene& scene, std::size_t index) {
  const std::string& name = scene.materials[index].name;
  return name.empty() ? fmt::format("materials[{}]", index) : fmt::format("materials[{}] \"{}\"", index, name);
}

Result<std::optional<Medium>> OwnMedium(const scene::Material& material, double unit_mm) {
  if (!material.translucency.empty()) return ParseMedium(material.translucency);
  const bool transmits = material.diffuse_transmission > 0.0f && std::isfinite(material.attenuation_distance);
  if (!transmits) return std::optional<Medium>();
  const double distance_mm = static_cast<double>(material.attenuation_distance) * unit_mm;
  Medium medium = MediumFromAttenuation(material.diffuse_transmission_color, material.attenuation_color,
                                        static_cast<float>(distance_mm), std::clamp(material.ior, 1.0f, 4.0f));
  medium.name = material.name.empty() ? "of the file's material" : material.name;
  return std::optional<Medium>(std::move(medium));
}

std::string ListMaterials(const scene::Scene& scene) {
  constexpr std::size_t kMost = 8;
  std::string list;
  for (std::size_t i = 0; i < std::min(scene.materials.size(), kMost); ++i) {
    list += fmt::format("{}\"{}\"", i == 0 ? "" : ", ", scene.materials[i].name);
  }
  if (scene.materials.size() > kMost) list += fmt::format(" and {} more", scene.materials.size() - kMost);
  return list;
}

}  // namespace

Result<SceneMedia> ResolveMedia(const scene::Scene& scene, const std::vector<Assignment>& assignments, double unit_mm) {
  SceneMedia media;
  media.of_material.resize(scene.materials.size());
  std::vector<bool> is_used(assignments.size(), false);
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    Result<std::optional<Medium>> own = OwnMedium(scene.materials[i], unit_mm);
    if (!own) {
      return Fail(ErrorKind::kInput,
                  fmt::format("{}: {}.extras.translucency: {}", scene.path, NameOf(scene, i), own.error().message));
    }
    media.of_material[i] = *std::move(own);
    for (std::size_t a = 0; a < assignments.size(); ++a) {
      if (fnmatch(assignments[a].glob.c_str(), scene.materials[i].name.c_str(), 0) != 0) continue;
      is_used[a] = true;
      media.of_material[i] = assignments[a].medium;
    }
    if (!media.of_material[i]) continue;
    for (std::string& warning : CheckMedium(*media.of_material[i])) {
      if (std::ranges::find(media.warnings, warning) == media.warnings.end()) {
        media.warnings.push_back(std::move(warning));
      }
    }
  }
  for (std::size_t a = 0; a < assignments.size(); ++a) {
    if (is_used[a]) continue;
    media.warnings.push_back(
        scene.materials.empty()
            ? fmt::format("--translucency \"{}\": {} has no materials", assignments[a].glob, scene.path)
            : fmt::format("--translucency \"{}\": no material has such a name; {} has {}", assignments[a].glob,
                          scene.path, ListMaterials(scene)));
  }
  return media;
}

}  // namespace burin::translucency
