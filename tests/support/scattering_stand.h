// SPDX-License-Identifier: Apache-2.0
#pragma once
// One translucent surface, lit and drawn, and its pictures against the brute-force reference. A context is current.

#include <cstdio>
#include <cstdlib>
#include <glm/gtc/matrix_transform.hpp>
#include <optional>
#include <random>
#include <string>

#include "core/gbuffer/attribute_renderer.h"
#include "core/gl/readback.h"
#include "core/image/convert.h"
#include "core/scene/pose.h"
#include "core/translucency/translucency_renderer.h"
#include "tests/support/scattering_shapes.h"

namespace burin::translucency {

template <class T>
T Take(Result<T> result) {
  if (!result) {
    std::fprintf(stderr, "%s\n", result.error().message.c_str());
    std::abort();
  }
  return std::move(*result);
}

inline image::Image FloatMap(int width, int height, const std::function<glm::dvec3(const glm::dvec3&)>& radiance) {
  image::Image map = image::MakeImage(width, height, 3, image::SampleType::kF32, image::Encoding::kSceneLinear);
  std::size_t i = 0;
  for (int y = 0; y < height; ++y) {
    const double latitude = glm::pi<double>() * (0.5 - (y + 0.5) / height);
    for (int x = 0; x < width; ++x) {
      const double longitude = 2.0 * glm::pi<double>() * ((x + 0.5) / width - 0.5);
      const glm::dvec3 color = radiance(
          {std::cos(latitude) * std::sin(longitude), std::sin(latitude), -std::cos(latitude) * std::cos(longitude)});
      for (int c = 0; c < 3; ++c) map.As<float>()[i++] = static_cast<float>(color[c]);
    }
  }
  return map;
}

/// What lights the surface: a lamp, or a sky that nothing hides.
struct Lighting {
  std::optional<glm::dvec3> lamp;  ///< mm
  double intensity = 14000.0;      ///< about 2.9 lux at 70 mm: automatic exposure leaves it alone
  std::function<glm::dvec3(const glm::dvec3&)> sky = [](const glm::dvec3&) { return glm::dvec3(0.0); };
};

inline glm::dvec3 Gradient(const glm::dvec3& d) {
  return glm::dvec3(0.6, 0.7, 0.9) * (0.5 + 0.5 * d.y) +
         glm::dvec3(2.0, 1.6, 1.0) *
             std::pow(std::max(0.0, glm::dot(d, glm::normalize(glm::dvec3(1.0, 1.0, 0.5)))), 6.0);
}

/// Pictures of one view, rows top first.
struct Shot {
  int size = 0;
  std::vector<glm::vec3> radiosity;
  std::vector<glm::vec3> position;
  std::vector<glm::vec3> normal;
  std::vector<float> area;  ///< of the surface that a pixel sees, mm^2; 0: background
};

class Stand {
 public:
  Stand(const Surface& surface, const Medium& medium, const Lighting& lighting, Scattering scattering)
      : medium_(medium) {
    scene::Material material;
    material.name = "medium";
    material.metallic = 0.0f;
    scene_.materials.push_back(material);
    scene_.meshes.emplace_back();
    scene_.meshes[0].primitives.push_back(ToPrimitive(surface, 0));
    scene_.nodes.emplace_back();
    scene_.nodes[0].mesh = 0;
    scene_.roots = {0};
    if (lighting.lamp) {
      scene::Light light;
      light.type = scene::LightType::kPoint;
      light.intensity = static_cast<float>(lighting.intensity);
      scene_.lights.push_back(light);
      scene_.nodes.emplace_back();
      scene_.nodes[1].light = 0;
      scene_.nodes[1].transform.translation = glm::vec3(*lighting.lamp);
      scene_.roots.push_back(1);
    }
    const image::Image environment = FloatMap(128, 64, lighting.sky);
    TranslucencyOptions options;
    options.unit_mm = 1.0;
    options.scattering = scattering;
    options.assignments = {{"medium", medium}};
    stage_ = Take(TranslucencyRenderer::Create(scene_, &environment, options));
    renderer_ = Take(gbuffer::SceneRenderer::Create(scene_, &environment));
  }

  /// From `eye` (mm) towards the origin; fits 34 mm.
  Shot Look(const glm::vec3& eye, int size) {
    const glm::vec3 up = std::abs(glm::normalize(eye).y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    scene::View view;
    view.view_from_world = glm::lookAt(eye, glm::vec3(0.0f), up);
    const float yfov = 2.0f * std::atan(24.0f / glm::length(eye));
    view.clip_from_view = glm::perspectiveRH_ZO(yfov, 1.0f, 5.0f, 500.0f);
    view.znear = 5.0f;
    view.zfar = 500.0f;
    using gbuffer::Attribute;
    const gl::Format format = gl::PlainFormat(gl::Numeric::kFloat, 32, 4);
    std::vector<gl::Texture> targets;
    std::vector<gbuffer::Request> requests;
    constexpr std::array kAttributes = {Attribute::kTranslucency, Attribute::kPosition, Attribute::kNormal,
                                        Attribute::kObjectId};
    for (std::size_t i = 0; i < kAttributes.size(); ++i) {
      targets.push_back(Take(gl::Texture::Create(format, size, size, 1, "stand")));
    }
    for (std::size_t i = 0; i < kAttributes.size(); ++i) {
      requests.push_back({kAttributes[i], &targets[i], image::Encoding::kSceneLinear});
    }
    const scene::Pose pose = scene::EvaluatePose(scene_, {}, 0.0);
    const std::vector<scene::DrawItem> items = scene::BuildDrawItems(scene_, pose, pose);
    gbuffer::FrameInput input{view, view, &pose, items, glm::vec4(0.0f), nullptr, stage_.get()};
    if (auto drawn = renderer_->Render(input, requests); !drawn) {
      std::fprintf(stderr, "%s\n", drawn.error().message.c_str());
      std::abort();
    }
    return Read(targets, eye, size, yfov);
  }

  [[nodiscard]] TranslucencyRenderer& stage() { return *stage_; }
  [[nodiscard]] const scene::Scene& scene() const { return scene_; }

 private:
  Shot Read(const std::vector<gl::Texture>& targets, const glm::vec3& eye, int size, float yfov) const {
    Shot shot;
    shot.size = size;
    std::vector<image::Image> images;
    for (const gl::Texture& target : targets) {
      images.push_back(gl::Read(target, image::SampleType::kF32, 4, image::Encoding::kData));
    }
    const float pixel = 2.0f * std::tan(0.5f * yfov) / static_cast<float>(size);
    for (std::size_t i = 0; i < static_cast<std::size_t>(size) * static_cast<std::size_t>(size); ++i) {
      const auto at = [&](std::size_t image) {
        const float* p = images[image].As<float>().data() + 4 * i;
        return glm::vec3(p[0], p[1], p[2]);
      };
      const glm::vec3 position = at(1);
      const glm::vec3 normal = at(2);
      const glm::vec3 to_eye = eye - position;
      const float distance = glm::length(to_eye);
      const float cosine = glm::dot(normal, to_eye) / distance;
      const bool is_surface = at(3).x > 0.5f && cosine > 0.1f;
      const auto leaving =
          static_cast<float>(1.0 - FresnelReflectance(static_cast<double>(cosine), static_cast<double>(medium_.ior)));
      shot.radiosity.push_back(is_surface ? at(0) * (glm::pi<float>() / leaving) : glm::vec3(0.0f));
      shot.position.push_back(position);
      shot.normal.push_back(normal);
      shot.area.push_back(is_surface ? pixel * pixel * distance * distance / cosine : 0.0f);
    }
    return shot;
  }

  Medium medium_;
  scene::Scene scene_;
  std::unique_ptr<TranslucencyRenderer> stage_;
  std::unique_ptr<gbuffer::SceneRenderer> renderer_;
};

/// How far pictures are from the reference, over the surface.
struct Deviation {
  double rmse = 0.0;      ///< over the reference's mean
  double bias = 0.0;      ///< of the mean
  double gradient = 0.0;  ///< largest step between neighbouring pixels over the reference's largest
  double mean = 0.0;      ///< of the reference
  bool is_finite = true;
  float least = 0.0f;
};

/// `points`: compared. `eyes`: where from.
inline Deviation Compare(Stand& stand, const Pieces& pieces, const Medium& medium, std::size_t points,
                         const std::vector<glm::vec3>& eyes, int size = 128) {
  const std::array<Dipole, 3> dipoles = MakeDipoles(medium);
  std::mt19937 random(7);
  Deviation result;
  double square = 0.0, weight = 0.0, mean = 0.0, ours = 0.0;
  double steepest = 0.0, steepest_reference = 0.0;
  for (const glm::vec3& eye : eyes) {
    const Shot shot = stand.Look(eye, size);
    std::vector<std::size_t> surface;
    std::vector<std::pair<float, std::size_t>> steps;
    for (std::size_t i = 0; i < shot.area.size(); ++i) {
      if (!(shot.area[i] > 0.0f)) continue;
      surface.push_back(i);
      for (int c = 0; c < 3; ++c) {
        result.is_finite = result.is_finite && std::isfinite(shot.radiosity[i][c]);
        result.least = std::min(result.least, shot.radiosity[i][c]);
      }
      if (i + 1 >= shot.area.size() || !(shot.area[i + 1] > 0.0f)) continue;
      // Neighbours on one surface: a jump in depth is no seam.
      if (glm::distance(shot.position[i], shot.position[i + 1]) > 4.0f * 48.0f / static_cast<float>(size)) continue;
      steps.emplace_back(glm::length(shot.radiosity[i] - shot.radiosity[i + 1]), i);
    }
    std::shuffle(surface.begin(), surface.end(), random);
    const std::size_t count = std::min(points / eyes.size(), surface.size());
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t i = surface[k];
      const glm::dvec3 reference = pieces.Gather(glm::dvec3(shot.position[i]), dipoles);
      const glm::dvec3 d = glm::dvec3(shot.radiosity[i]) - reference;
      const double area = static_cast<double>(shot.area[i]);
      square += area * glm::dot(d, d) / 3.0;
      mean += area * (reference.r + reference.g + reference.b) / 3.0;
      ours += area * static_cast<double>(shot.radiosity[i].r + shot.radiosity[i].g + shot.radiosity[i].b) / 3.0;
      weight += area;
    }
    // The reference's steepest places are among ours, or among any: both are asked.
    std::sort(steps.rbegin(), steps.rend());
    for (std::size_t k = 0; k < std::min<std::size_t>(steps.size(), points / 20); ++k) {
      steepest = std::max(steepest, static_cast<double>(steps[k].first));
      for (const std::size_t j : {k, (k * 7919) % steps.size()}) {
        const std::size_t i = steps[j].second;
        steepest_reference =
            std::max(steepest_reference, glm::length(pieces.Gather(glm::dvec3(shot.position[i]), dipoles) -
                                                     pieces.Gather(glm::dvec3(shot.position[i + 1]), dipoles)));
      }
    }
  }
  result.mean = mean / weight;
  result.rmse = std::sqrt(square / weight) / result.mean;
  result.bias = ours / mean - 1.0;
  result.gradient = steepest / std::max(steepest_reference, 1e-300);
  return result;
}

}  // namespace burin::translucency
