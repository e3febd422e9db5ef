// SPDX-License-Identifier: Apache-2.0
#include "core/translucency/translucency_renderer.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "core/gbuffer/environment.h"
#include "core/gbuffer/geometry_shader.h"
#include "core/gl/buffer.h"
#include "core/translucency/body_passes.h"
#include "core/translucency/dipole_table.h"
#include "core/translucency/irradiance_glsl.h"
#include "core/translucency/pass_target.h"
#include "core/translucency/receiver_glsl.h"

namespace burin::translucency {
namespace {

using gbuffer::TranslucencyInput;

/// One body from frame to frame.
struct Body {
  BodyMaps maps;
  ShadowMaps shadows;
  BodyBlock block{};
  ShadowBlock shadow_block{};
  gl::BufferHandle block_buffer = gl::CreateBuffer("translucent body");
  gl::BufferHandle shadow_buffer = gl::CreateBuffer("translucent body's shadows");
  std::uint64_t shape_key = 0;
  std::uint64_t lighting_key = 0;
  std::size_t map_bytes = 0;
  bool has_parts = false;
  bool is_known = false;  ///< the above is of some frame
};

ShRadiance RadianceOf(const image::Image* environment) {
  std::optional<gbuffer::EnvironmentMap> map;
  if (environment != nullptr) {
    if (auto read = gbuffer::EnvironmentFromImage(*environment)) map = *std::move(read);
  }
  if (!map) map = gbuffer::StudioEnvironment();
  return ProjectLatLong(map->pixels, map->width, map->height);
}

Quality QualityFor(const TranslucencyOptions& options) {
  Quality quality = QualityOf(options.scattering);
  if (quality.is_paper()) quality.kernel = options.paper_kernel;
  return quality;
}

class Renderer final : public TranslucencyRenderer {
 public:
  Renderer(const scene::Scene& scene, const TranslucencyOptions& options, SceneMedia media, const ShRadiance& radiance)
      : scene_(&scene),
        options_(options),
        quality_(QualityFor(options)),
        passes_(quality_),
        warnings_(std::move(media.warnings)) {
    of_material_.resize(media.of_material.size());
    for (std::size_t i = 0; i < media.of_material.size(); ++i) {
      if (!media.of_material[i]) continue;
      const auto same = std::ranges::find(media_, *media.of_material[i]);
      of_material_[i] = static_cast<std::size_t>(same - media_.begin());
      if (same == media_.end()) media_.push_back(*media.of_material[i]);
    }
    for (const Medium& medium : media_) {
      const std::array<Dipole, 3> dipoles = MakeDipoles(medium);
      tables_.push_back(
          MakeDipoleTable(dipoles, std::min({dipoles[0].real_mm, dipoles[1].real_mm, dipoles[2].real_mm})));
      environments_.push_back(FoldIrradiance(radiance, static_cast<double>(medium.ior), false));
    }
    shader_text_ = BodyDeclarations() + IrradianceFunctions(quality_) + LookUpFunctions();
  }

  [[nodiscard]] bool IsTranslucent(int material) const override {
    return material != scene::kNone && of_material_[static_cast<std::size_t>(material)].has_value();
  }
  [[nodiscard]] const std::string& ShaderText() const override { return shader_text_; }
  std::vector<std::string> TakeNotes() override { return std::exchange(notes_, {}); }
  std::vector<std::string> TakeWarnings() override { return std::exchange(warnings_, {}); }

  Result<void> Update(const TranslucencyInput& input) override;
  void Bind(std::size_t item) const override;

 private:
  [[nodiscard]] std::vector<BodyItems> FindBodies(const TranslucencyInput& input) const;
  [[nodiscard]] Result<void> UpdateBody(const TranslucencyInput& input, const BodyItems& items,
                                        std::uint64_t lighting_key, Body& body);
  [[nodiscard]] std::unexpected<Error> RefuseMaps(std::size_t bytes_each) const;
  [[nodiscard]] Result<void> Reserve(Body& body, std::size_t bytes);
  [[nodiscard]] Result<void> BindTable(std::size_t medium);
  void Describe(const TranslucencyInput& input, const BodyItems& items, const Body& body);

  const scene::Scene* scene_;
  TranslucencyOptions options_;
  Quality quality_;
  BodyPasses passes_;
  ShadowPass shadows_;
  std::vector<Medium> media_;
  std::vector<std::array<glm::vec3, kShTerms>> environments_;  ///< one a medium
  std::vector<DipoleTable> tables_;                            ///< one a medium
  std::vector<gl::Texture> table_textures_;                    ///< made when first used
  std::vector<std::optional<std::size_t>> of_material_;
  std::map<std::pair<int, std::size_t>, Body> bodies_;  ///< by node and medium
  std::vector<const Body*> of_item_;
  std::size_t body_count_ = 0;  ///< of the frame
  std::size_t map_bytes_ = 0;   ///< of all bodies
  std::string shader_text_;
  std::vector<std::string> notes_;
  std::vector<std::string> warnings_;
};

std::vector<BodyItems> Renderer::FindBodies(const TranslucencyInput& input) const {
  std::vector<BodyItems> bodies;
  std::map<std::pair<int, std::size_t>, std::size_t> places;
  for (const gbuffer::PreparedDraw& draw : input.draws->opaque) {
    if ((draw.features & gbuffer::kIsTranslucent) == 0) continue;
    const int node = input.frame->items[draw.block].node;
    const std::size_t medium = *of_material_[static_cast<std::size_t>(draw.material)];
    const auto [place, is_new] = places.try_emplace({node, medium}, bodies.size());
    if (is_new) bodies.push_back({node, medium, {}});
    bodies[place->second].draws.push_back(&draw);
  }
  return bodies;
}

Result<void> Renderer::Update(const TranslucencyInput& input) {
  of_item_.assign(input.frame->items.size(), nullptr);
  const std::vector<BodyItems> found = FindBodies(input);
  if (found.empty()) return {};
  const std::uint64_t lighting_key = LightingKey(input);
  body_count_ = found.size();
  // Lights beside an object take more.
  const int shadow_maps = std::clamp(static_cast<int>(input.lights.size()), 1, kMaxShadowedLights);
  const std::size_t least = BytesOfMaps(quality_, input.wants_parts, shadow_maps);
  if (least > options_.most_map_bytes / body_count_) return RefuseMaps(least);
  for (const BodyItems& items : found) {
    Body& body = bodies_[{items.node, items.medium}];
    if (auto updated = UpdateBody(input, items, lighting_key, body); !updated) return updated;
    for (const gbuffer::PreparedDraw* draw : items.draws) of_item_[draw->block] = &body;
  }
  return {};
}

std::unexpected<Error> Renderer::RefuseMaps(std::size_t bytes_each) const {
  const auto mib = [](std::size_t count) { return static_cast<double>(count) / (1 << 20); };
  std::string message = fmt::format(
      "translucency: the maps of {} translucent objects, {:.0f} MiB each, need more than the limit of {:.0f} MiB",
      body_count_, mib(bytes_each), mib(options_.most_map_bytes));
  const std::size_t least = BytesOfMaps(QualityOf(Scattering::kFast), false, 1);
  if (bytes_each > least) message += fmt::format("; with --scattering fast they are {:.0f} MiB or more", mib(least));
  return Fail(ErrorKind::kFailed, message + "; surfaces of one node and medium are one object");
}

// Each object has maps of its own, and all of them are needed to shade one frame.
Result<void> Renderer::Reserve(Body& body, std::size_t bytes) {
  const std::size_t total = map_bytes_ - body.map_bytes + bytes;
  if (total > options_.most_map_bytes) return RefuseMaps(bytes);
  map_bytes_ = total;
  body.map_bytes = bytes;
  return {};
}

Result<void> Renderer::UpdateBody(const TranslucencyInput& input, const BodyItems& items, std::uint64_t lighting_key,
                                  Body& body) {
  const BodyShape shape = ShapeOf(*scene_, input.frame->items, items);
  const bool is_same_shape = body.is_known && body.shape_key == shape.key;
  const bool is_same_light = is_same_shape && body.lighting_key == lighting_key;
  if (is_same_light && (body.has_parts || !input.wants_parts)) return {};

  const bool is_new = !body.is_known;
  body.is_known = false;
  const bool has_parts = body.has_parts || input.wants_parts;
  const scene::Bounds bounds = shape.bounds.empty() ? scene::Bounds{glm::vec3(-0.5f), glm::vec3(0.5f)} : shape.bounds;
  const int shadow_maps = std::max(CountShadowMaps(input.lights, SphereOf(bounds)), body.shadows.count);
  if (auto fits = Reserve(body, BytesOfMaps(quality_, has_parts, shadow_maps)); !fits) return fits;
  if (auto ready = body.maps.Ensure(quality_, has_parts); !ready) return ready;
  std::array<glm::vec3, kShTerms> environment = environments_[items.medium];
  for (glm::vec3& term : environment) term *= input.environment_strength;
  body.block =
      MakeBodyBlock(bounds, media_[items.medium], quality_, options_.unit_mm,
                    BrightestIrradiance(input.lights, bounds, environment), static_cast<int>(input.lights.size()));
  for (std::size_t i = 0; i < kShTerms; ++i) body.block.environment[i] = glm::vec4(environment[i], 0.0f);
  gl::StreamInto(body.block_buffer, &body.block, sizeof(body.block));
  glBindBufferBase(GL_UNIFORM_BUFFER, kBodyBinding, body.block_buffer.id());

  const std::uint32_t draw_blocks = input.draws->block_buffer;
  if (!is_same_light) {
    const Casters casters{*input.draws, *input.materials};
    auto drawn =
        shadows_.Draw(input.lights, casters, SphereOf(bounds), quality_.shadow_texels, body.shadows, body.shadow_block);
    if (!drawn) return drawn;
    gl::StreamInto(body.shadow_buffer, &body.shadow_block, sizeof(body.shadow_block));
    glBindBufferBase(GL_UNIFORM_BUFFER, kShadowBinding, body.shadow_buffer.id());
    shadows_.Bind(body.shadows);
    if (!is_same_shape) {
      if (auto done = passes_.DrawDepth(items, body.block, draw_blocks, body.maps); !done) return done;
    }
    auto done = passes_.DrawSources(items, body.block, draw_blocks, body.shadow_block, *input.materials, body.maps);
    if (!done) return done;
    if (auto built = passes_.BuildPyramid(body.block, body.maps); !built) return built;
  }
  if (auto bound = BindTable(items.medium); !bound) return bound;
  if (auto gathered = passes_.Gather(body.maps, has_parts); !gathered) return gathered;
  body.shape_key = shape.key;
  body.lighting_key = lighting_key;
  body.has_parts = has_parts;
  body.is_known = true;
  if (is_new) Describe(input, items, body);
  return {};
}

Result<void> Renderer::BindTable(std::size_t medium) {
  table_textures_.resize(tables_.size());
  gl::Texture& texture = table_textures_[medium];
  if (!texture) {
    Result<gl::Texture> made = CreateBitsTexture(DipoleTable::kWidth, DipoleTable::kHeight, "translucency: dipole");
    if (!made) return std::unexpected(made.error());
    texture = *std::move(made);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    glTextureSubImage2D(texture.id(), 0, 0, 0, texture.width(), texture.height(), GL_RGBA_INTEGER, GL_UNSIGNED_INT,
                        tables_[medium].texels.data());
  }
  BindForFetch(kDipoleUnit, texture);
  return {};
}

void Renderer::Describe(const TranslucencyInput& input, const BodyItems& items, const Body& body) {
  const Medium& medium = media_[items.medium];
  const double object_mm =
      static_cast<double>(std::max({body.block.box_mm.x, body.block.box_mm.y, body.block.box_mm.z}));
  std::string warning = CheckScale(medium, object_mm, TexelSize(body.block), options_.unit_mm);
  if (!warning.empty() && std::ranges::find(warnings_, warning) == warnings_.end()) {
    warnings_.push_back(std::move(warning));
  }
  const scene::View& view = input.frame->view;
  const glm::vec3 center(body.block.box_min +
                         glm::vec4(glm::vec3(body.block.box_mm) * (0.5f / body.block.box_min.w), 0.0f));
  const float distance = view.orthographic ? 1.0f : -(view.view_from_world * glm::vec4(center, 1.0f)).z;
  const float pixels_per_mm = 0.5f * static_cast<float>(input.height) * view.clip_from_view[1][1] /
                              (std::max(distance, 1e-6f) * body.block.box_min.w);
  const glm::vec3 path = 1.0f / glm::max(medium.ReducedExtinction(), glm::vec3(1e-9f));
  const glm::vec3 reach = 1.0f / glm::max(medium.EffectiveTransport(), glm::vec3(1e-9f));
  const auto triple = [](const glm::vec3& v) { return fmt::format("{:.3g} {:.3g} {:.3g}", v.x, v.y, v.z); };
  const std::string& node = scene_->nodes[static_cast<std::size_t>(items.node)].name;
  notes_.push_back(fmt::format(
      "translucency: node \"{}\", {:.3g} mm of {}: mean free path {} mm ({} pixels), 1/sigma_tr {} mm ({} pixels)",
      node.empty() ? std::to_string(items.node) : node, object_mm, medium.name, triple(path),
      triple(path * pixels_per_mm), triple(reach), triple(reach * pixels_per_mm)));
}

void Renderer::Bind(std::size_t item) const {
  const Body& body = *of_item_[item];
  glBindBufferBase(GL_UNIFORM_BUFFER, kBodyBinding, body.block_buffer.id());
  glBindBufferBase(GL_UNIFORM_BUFFER, kShadowBinding, body.shadow_buffer.id());
  shadows_.Bind(body.shadows);
  BindForFetch(kReceiverUnit, body.maps.receivers);
  BindForFetch(kSourceUnit, body.maps.sources);
  if (body.maps.near_receivers) BindForFetch(kLocalUnit, body.maps.near_receivers);
}

}  // namespace

Result<std::unique_ptr<TranslucencyRenderer>> TranslucencyRenderer::Create(const scene::Scene& scene,
                                                                           const image::Image* environment,
                                                                           const TranslucencyOptions& options) {
  Result<SceneMedia> media = ResolveMedia(scene, options.assignments, options.unit_mm);
  if (!media) return std::unexpected(media.error());
  const bool is_needed = std::ranges::any_of(media->of_material, [](const auto& medium) { return medium.has_value(); });
  if (!is_needed && media->warnings.empty()) return std::unique_ptr<TranslucencyRenderer>();
  const ShRadiance radiance = is_needed ? RadianceOf(environment) : ShRadiance{};
  return std::make_unique<Renderer>(scene, options, *std::move(media), radiance);
}

}  // namespace burin::translucency
