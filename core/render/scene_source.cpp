// SPDX-License-Identifier: Apache-2.0
// Scenes: each frame is posed, deformed and looked at here, on the decoding thread.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/gbuffer/key_light.h"
#include "core/render/source.h"
#include "core/scene/add_tangents.h"
#include "core/scene/item_tessellator.h"
#include "core/scene/morph_to_sphere.h"
#include "core/scene/read_scene.h"

namespace burin::render {
namespace {

/// How many moments of the animation the automatic camera looks at. Independent of the frames that are asked for, so
/// that one frame alone has the same bits as in a full run.
constexpr int kBoundsSamples = 16;

/// Sides of a surface are cut in so many for its bounds: a quarter of a circle is then exact to a 200th of its radius.
constexpr float kBoundsFactor = 8.0f;
constexpr float kManyPatchesFactor = 2.0f;
constexpr std::size_t kManyPatches = 500;

/// Of patch models, or triangles that may become patches.
std::size_t CountPatches(const scene::Scene& scene) {
  std::size_t count = 0;
  for (const scene::Mesh& mesh : scene.meshes) {
    for (const scene::Primitive& p : mesh.primitives)
      count += p.patches ? p.patches->patches.size() : p.indices.size() / 3;
  }
  return count;
}

/// Calls `see` with the scene's items, surfaces included, at moments all over its animation.
template <class See>
void OverTime(const scene::Scene& scene, const scene::AnimationSelection& animations,
              const scene::TessellationOptions& tessellation, float morph, const See& see) {
  const double duration_s = scene::Duration(scene, animations);
  const int samples = duration_s > 0.0 ? kBoundsSamples : 1;
  std::vector<scene::DrawItem> items;
  scene::ItemTessellator tessellator(scene, tessellation);
  scene::SphereMorph to_sphere(morph);
  const float factor = CountPatches(scene) > kManyPatches ? kManyPatchesFactor : kBoundsFactor;
  for (int i = 0; i < samples; ++i) {
    const scene::Pose pose = scene::EvaluatePose(scene, animations, duration_s * i / samples);
    scene::UpdateDrawItems(scene, pose, pose, items, tessellator.is_active());
    to_sphere.MoveVertices(scene, items);
    if (tessellator.is_active()) (void)tessellator.TessellateEvenly(factor, items);  // too many: the cage's bounds
    to_sphere.MoveSurfaces(scene, items);
    see(items);
  }
}

/// `fits_angle`: the automatic camera comes as near as this one orbit angle allows.
scene::CameraChoice FrameWhole(const scene::Scene& scene, const scene::AnimationSelection& animations,
                               const scene::TessellationOptions& tessellation, std::pair<int, int> size,
                               double orbit_deg, bool fits_angle, float morph) {
  scene::CameraChoice choice;
  if (fits_angle) choice.reach.emplace();
  const std::array<glm::mat4, 2> maps = scene::AutoReach(size.first, size.second, orbit_deg);
  OverTime(scene, animations, tessellation, morph, [&](const std::vector<scene::DrawItem>& items) {
    choice.bounds.Extend(scene::ComputeBounds(scene, items));
    for (std::size_t i = 0; i < maps.size() && fits_angle; ++i) {
      (*choice.reach)[i].Extend(scene::ComputeBounds(scene, items, maps[i]));
    }
  });
  return choice;
}

class SceneSource final : public Source {
 public:
  SceneSource(scene::Scene scene, scene::AnimationSelection animations, int camera_node, const Job& job)
      : scene_(std::move(scene)),
        animations_(std::move(animations)),
        tessellator_(scene_, TessellationOf(job)),
        turntable_(job.turntable_frames),
        orbit_deg_(job.orbit_deg.value_or(0.0)),
        to_sphere_(job.morph_to_sphere),
        size_(job.size.value_or(kDefaultSize)),
        rate_(job.fps.value_or(kDefaultRate)) {
    const double duration_s = scene::Duration(scene_, animations_);
    const bool turns = job.orbit_deg.has_value() || turntable_ > 0;
    camera_ = FrameWhole(scene_, animations_, TessellationOf(job), size_, orbit_deg_,
                         camera_node == scene::kNone && !turns, job.morph_to_sphere);
    camera_.camera_node = camera_node;
    const std::optional<float>& factor = job.tessellation.factor;
    if (factor && *factor != *TessellationOf(job).factor) {
      scene_.warnings.push_back(fmt::format("--tessellation-factor {:g} is not between 1 and {:g}; {:g} is taken",
                                            *factor, tessellation::kMaxFactor, *TessellationOf(job).factor));
    }
    info_.kind = SourceKind::kScene;
    info_.rate = job.fps;
    // A loop's last frame is the one before the first comes again.
    const double frames =
        turntable_ > 0 ? static_cast<double>(turntable_) : std::ceil(duration_s * rate_.value() - 1e-4);
    info_.frames.resize(static_cast<std::size_t>(std::clamp(frames, 1.0, 1e6)));
    for (std::size_t i = 0; i < info_.frames.size(); ++i) info_.frames[i] = static_cast<long>(i) + 1;
  }

  [[nodiscard]] const SourceInfo& info() const override { return info_; }
  [[nodiscard]] const scene::Scene* scene() const override { return &scene_; }
  [[nodiscard]] std::vector<std::string> warnings() const override {
    std::vector<std::string> warnings;
    for (const std::string& warning : scene_.warnings) {
      warnings.push_back(warning.starts_with(scene_.path) ? warning : fmt::format("{}: {}", scene_.path, warning));
    }
    return warnings;
  }

  [[nodiscard]] Result<bool> Read(long number, SourceFrame& frame) override {
    frame.number = number;
    auto now = std::make_unique<SceneFrame>();
    now->pose = scene::EvaluatePose(scene_, animations_, Time(number));
    const scene::Pose previous = scene::EvaluatePose(scene_, animations_, Time(number - 1));
    scene::UpdateDrawItems(scene_, now->pose, previous, now->items, tessellator_.is_active());
    to_sphere_.MoveVertices(scene_, now->items);
    now->view = View(now->pose, number);
    now->previous_view = View(previous, number - 1);
    FillContext(*now);
    if (tessellator_.is_active()) {
      if (Result<void> done = Tessellate(*now, frame); !done) return std::unexpected(done.error());
      to_sphere_.MoveSurfaces(scene_, now->items);
    }
    frame.scene = std::move(now);
    return true;
  }

  [[nodiscard]] std::vector<std::string> Summary(double elapsed_s) const override {
    if (tessellated_frames_ == 0) return {};
    return {fmt::format("tessellation: up to {} triangles a frame, {:.1f} ms a frame, {:.1f} % of the time",
                        most_triangles_, 1e3 * tessellation_s_ / static_cast<double>(tessellated_frames_),
                        elapsed_s > 0.0 ? 100.0 * tessellation_s_ / elapsed_s : 0.0)};
  }

 private:
  /// The crease angle is one for edges and for meshes that are curved.
  static scene::TessellationOptions TessellationOf(const Job& job) {
    scene::TessellationOptions options = job.tessellation;
    options.crease_angle_deg = job.edges.crease_angle_deg;
    if (options.factor) options.factor = std::clamp(*options.factor, 1.0f, tessellation::kMaxFactor);
    return options;
  }

  Result<void> Tessellate(SceneFrame& now, SourceFrame& frame) {
    const auto begin = std::chrono::steady_clock::now();
    const auto counts = tessellator_.Tessellate(now.view, size_.first, size_.second, now.items);
    if (!counts) return Fail(counts.error().kind, fmt::format("{}: {}", scene_.path, counts.error().message));
    tessellation_s_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    if (tessellated_frames_++ == 0) {
      frame.notes.push_back(fmt::format("tessellation: {} patches, {} triangles in frame {}", counts->patches,
                                        counts->triangles, frame.number));
    }
    most_triangles_ = std::max(most_triangles_, counts->triangles);
    if (counts->clamped > 0 && !told_clamped_) {
      told_clamped_ = true;
      frame.warnings.push_back(
          fmt::format("{}: frame {}: {} sides of patches are longer than {:g} pieces of "
                      "--edge-length; they are cut in {:g}",
                      scene_.path, frame.number, counts->clamped, tessellation::kMaxFactor, tessellation::kMaxFactor));
    }
    return {};
  }

  /// Seconds at a frame: frame 1 is 0.
  [[nodiscard]] double Time(long number) const { return static_cast<double>(number - 1) / rate_.value(); }

  [[nodiscard]] scene::View View(const scene::Pose& pose, long number) const {
    double angle_deg = orbit_deg_;
    if (turntable_ > 0) {
      const long step = ((number - 1) % turntable_ + turntable_) % turntable_;
      angle_deg += 360.0 * static_cast<double>(step) / static_cast<double>(turntable_);
    }
    return scene::MakeView(scene_, camera_, pose, size_.first, size_.second, angle_deg);
  }

  void FillContext(SceneFrame& frame) const {
    effect::FrameContext& context = frame.context;
    context.view_from_world = frame.view.view_from_world;
    context.clip_from_view = frame.view.clip_from_view;
    context.previous_view_from_world = frame.previous_view.view_from_world;
    context.previous_clip_from_view = frame.previous_view.clip_from_view;
    context.eye_world = glm::vec3(glm::inverse(frame.view.view_from_world)[3]);
    const gbuffer::KeyLight light = gbuffer::FindKeyLight(scene_, frame.pose);
    context.light_direction_world = light.direction;
    context.light_color = glm::vec4(light.color, 1.0f);
    if (light.type != scene::LightType::kDirectional) context.light_position_world = light.position;
    if (!camera_.bounds.empty()) {
      context.scene_center_world = 0.5f * (camera_.bounds.min + camera_.bounds.max);
      context.scene_radius = 0.5f * glm::length(camera_.bounds.max - camera_.bounds.min);
    }
    const std::vector<int> nodes = gbuffer::LightNodes(scene_);
    for (const int node : nodes) context.lights.push_back(LightAt(frame.pose, node, nodes.front()));
  }

  [[nodiscard]] effect::LightContext LightAt(const scene::Pose& pose, int node, int key_node) const {
    const auto index = static_cast<std::size_t>(node);
    const scene::Light& light = scene_.lights[static_cast<std::size_t>(scene_.nodes[index].light)];
    const glm::mat4& world = pose.world_from_node.at(index);
    const glm::vec3 axis = -glm::vec3(world[2]);
    effect::LightContext context;
    if (light.type != scene::LightType::kDirectional) context.position = glm::vec3(world[3]);
    if (glm::dot(axis, axis) > 0.0f) context.direction = glm::normalize(axis);
    // Effects know no intensities: the key light's is 1, and no other is brighter.
    const scene::Light& key =
        scene_.lights[static_cast<std::size_t>(scene_.nodes[static_cast<std::size_t>(key_node)].light)];
    const bool compares = key.type == light.type && key.intensity > 0.0f;
    const float share = node == key_node ? 1.0f : compares ? std::min(light.intensity / key.intensity, 1.0f) : 0.5f;
    context.color = glm::vec4(light.color * share, 1.0f);
    context.range = light.range.value_or(0.0f);
    return context;
  }

  scene::Scene scene_;
  scene::AnimationSelection animations_;
  scene::ItemTessellator tessellator_;
  double tessellation_s_ = 0.0;
  long tessellated_frames_ = 0;
  std::size_t most_triangles_ = 0;
  bool told_clamped_ = false;
  scene::CameraChoice camera_;
  SourceInfo info_;
  long turntable_;
  double orbit_deg_;
  scene::SphereMorph to_sphere_;
  std::pair<int, int> size_;
  video::FrameRate rate_;
};

}  // namespace

Result<std::unique_ptr<Source>> OpenSceneSource(const Job& job, bool wants_tangents) {
  scene::ReadOptions options;
  options.subdivides = job.tessellation.mode != scene::TessellationMode::kOff;
  options.decode_image = [](std::span<const std::byte> bytes, const std::string& name) -> Result<image::Image> {
    auto module = image::LoadImageModule();
    if (!module) return std::unexpected(module.error());
    return (*module)->ReadMemory(bytes, name);
  };
  auto scene = scene::ReadScene(job.source, options);
  if (!scene) return std::unexpected(scene.error());
  scene::TurnUpwards(job.up, *scene);
  if (wants_tangents) scene::AddTangents(*scene);
  auto animations = scene::SelectAnimations(*scene, job.animation);
  if (!animations) return std::unexpected(animations.error());
  auto camera = scene::SelectCamera(*scene, job.camera);
  if (!camera) return std::unexpected(camera.error());
  return std::make_unique<SceneSource>(*std::move(scene), *std::move(animations), *camera, job);
}

}  // namespace burin::render
