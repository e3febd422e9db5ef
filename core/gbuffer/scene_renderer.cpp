// SPDX-License-Identifier: Apache-2.0
#include <epoxy/gl.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <list>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "core/gbuffer/attribute_renderer.h"
#include "core/gbuffer/environment_light.h"
#include "core/gbuffer/face_color_table.h"
#include "core/gbuffer/frame_blocks.h"
#include "core/gbuffer/geometry_pass.h"
#include "core/gbuffer/light_setup.h"
#include "core/gbuffer/request_groups.h"
#include "core/gbuffer/translucency_stage.h"
#include "core/gl/buffer.h"
#include "core/gl/framebuffer.h"
#include "core/gl/state.h"

namespace burin::gbuffer {
namespace {

// Lights that a file brings leave the built-in studio only to fill their shadows.
constexpr float kStudioFill = 0.25f;

using Size = std::pair<int, int>;

Size SizeOf(const Request& request) { return {request.target->width(), request.target->height()}; }

void ClearToBackground(const Request& request) {
  const std::array<float, 4> empty =
      StoredBackground({request.attribute, request.target->format(), request.encoding}, {});
  glClearTexImage(request.target->id(), 0, GL_RGBA, GL_FLOAT, empty.data());
}

// True when some colour can't be smoothed where it is kept: intensity, alpha, and formats that lose the colour.
bool SmoothsIndirectly(const FrameInput& frame, std::span<const Request> requests) {
  if (frame.edges == nullptr || !frame.edges->antialiases()) return false;
  return std::ranges::any_of(requests, [](const Request& request) {
    return IsColorClass(request.attribute) &&
           !CanLoadColor({request.attribute, request.target->format(), request.encoding});
  });
}

// Lit triangles of a translucent material, but not what is blended: its alpha lets light through already.
bool Scatters(const FrameInput& frame, const PreparedDraw& draw) {
  return frame.translucency != nullptr && draw.primitive->mode == GL_TRIANGLES && !draw.is_blend &&
         (draw.features & kIsUnlit) == 0 && frame.translucency->IsTranslucent(draw.material);
}

class Renderer final : public SceneRenderer {
 public:
  Renderer(const scene::Scene& scene, std::optional<EnvironmentMap> environment,
           std::unique_ptr<PictureRenderer> resolver)
      : scene_(&scene),
        environment_(std::move(environment)),
        resolver_(std::move(resolver)),
        materials_(scene),
        meshes_(scene),
        frame_block_(gl::CreateBuffer("frame")),
        draw_blocks_(gl::CreateBuffer("draws")),
        lights_(gl::CreateBuffer("lights")),
        exposure_(LightExposure(scene)),
        face_colors_(scene) {}

  Result<void> Render(const FrameInput& frame, std::span<const Request> requests) override;
  Result<std::vector<GeometryDraw>> Draws(const FrameInput& frame) override;
  Result<const gl::Texture*> TextureOf(int material, MaterialTextureKind kind, bool is_decoded) override {
    return materials_.TextureOf(material, kind, is_decoded);
  }

 private:
  struct Buffers {
    gl::Texture depth;
    gl::Texture color;  ///< scene-linear, for blending; only made where it is needed
  };

  Result<FrameDraws> Prepare(const FrameInput& frame);
  Result<std::vector<Request>> TakeOverColor(std::span<const Request> requests,
                                             std::map<Size, std::vector<Request>>& resolves);
  Result<void> RenderGroup(const FrameInput& frame, const FrameDraws& draws, Size size,
                           const std::vector<Request>& group, bool takes_over);
  Result<void> RenderEdges(const FrameInput& frame, const FrameDraws& draws, std::span<const Request> requests,
                           std::set<Size> drawn);
  void BindFrame(const FrameInput& frame, Size size, bool wants_color);
  [[nodiscard]] float EnvironmentStrength() const {
    return environment_.is_builtin() && light_count_ > 0 ? kStudioFill : 1.0f;
  }
  Result<void> UpdateTranslucency(const FrameInput& frame, const FrameDraws& draws, std::span<const LightRecord> lights,
                                  std::span<const Request> requests);
  Result<Buffers*> BuffersOf(Size size, bool wants_color);
  GeometryPass& PassOf(std::vector<Output> outputs);

  const scene::Scene* scene_;
  EnvironmentLight environment_;
  std::unique_ptr<PictureRenderer> resolver_;
  MaterialStore materials_;
  MeshStore meshes_;
  gl::BufferHandle frame_block_;
  gl::BufferHandle draw_blocks_;
  gl::BufferHandle lights_;
  float exposure_;
  std::size_t light_count_ = 0;
  std::map<Size, Buffers> buffers_;
  std::list<GeometryPass> passes_;
  FaceColorTable face_colors_;
};

// The frame's items on the device, with their blocks.
Result<FrameDraws> Renderer::Prepare(const FrameInput& frame) {
  FrameDraws draws;
  const std::uint32_t scene_features = light_count_ > 0 ? kHasLights : 0u;
  const std::size_t stride = AlignBlock(sizeof(DrawBlock));
  std::vector<std::byte> blocks(std::max<std::size_t>(frame.items.size(), 1) * stride);
  for (std::size_t i = 0; i < frame.items.size(); ++i) {
    const scene::DrawItem& item = frame.items[i];
    PreparedDraw draw;
    draw.material = static_cast<int>(item.material_id) - 1;
    const scene::Material& material = materials_.Get(draw.material);
    draw.is_blend = material.alpha_mode == scene::AlphaMode::kBlend;
    draw.is_double_sided = material.double_sided;
    draw.is_mirrored = IsMirrored(item.world_from_object);
    draw.block = i;
    const Result<const GpuPrimitive*> primitive = meshes_.Prepare(item, draw.is_blend);
    if (!primitive) return std::unexpected(primitive.error());
    draw.primitive = *primitive;
    if (draw.primitive->index_count == 0) continue;
    draw.features = materials_.Features(draw.material) | scene_features;
    // Lines and points without normals are not lit.
    draw.features |= draw.primitive->has_normals ? kHasNormals : kIsUnlit;
    if (draw.primitive->has_tangents) draw.features |= kHasTangents;
    if (draw.primitive->has_texcoords) draw.features |= kHasTexcoords;
    if (draw.primitive->has_patches) draw.features |= kHasPatches;
    if (Scatters(frame, draw)) draw.features |= kIsTranslucent;
    draw.view_depth =
        -(frame.view.view_from_world * item.world_from_object * glm::vec4(draw.primitive->center, 1.0f)).z;

    const DrawBlock block = MakeDrawBlock(item);
    std::memcpy(blocks.data() + i * stride, &block, sizeof(block));
    (draw.is_blend ? draws.blended : draws.opaque).push_back(draw);
  }
  std::ranges::stable_sort(draws.blended, std::greater<>(), &PreparedDraw::view_depth);
  gl::StreamInto(draw_blocks_, blocks.data(), blocks.size());
  draws.block_buffer = draw_blocks_.id();
  draws.translucency = frame.translucency;
  return draws;
}

Result<Renderer::Buffers*> Renderer::BuffersOf(Size size, bool wants_color) {
  Buffers& buffers = buffers_[size];
  if (!buffers.depth) {
    Result<gl::Texture> depth = gl::CreateDepthStencil(size.first, size.second, "geometry pass: depth");
    if (!depth) return std::unexpected(depth.error());
    buffers.depth = std::move(*depth);
  }
  if (wants_color && !buffers.color) {
    Result<gl::Texture> color = gl::Texture::Create(gl::PlainFormat(gl::Numeric::kFloat, 32, 4), size.first,
                                                    size.second, 1, "geometry pass: blended colour");
    if (!color) return std::unexpected(color.error());
    buffers.color = std::move(*color);
  }
  return &buffers;
}

GeometryPass& Renderer::PassOf(std::vector<Output> outputs) {
  const auto same = [&](const GeometryPass& pass) {
    return std::ranges::equal(pass.outputs(), outputs, [](const Output& a, const Output& b) {
      return a.location == b.location && a.storage == b.storage && a.is_blended == b.is_blended;
    });
  };
  const auto found = std::ranges::find_if(passes_, same);
  return found != passes_.end() ? *found : passes_.emplace_back(std::move(outputs));
}

// Blending, and edges of what is no colour, need scene-linear colour with associated alpha: colour, intensity and alpha
// of one size become one request for such a target, and are resolved from it afterwards.
Result<std::vector<Request>> Renderer::TakeOverColor(std::span<const Request> requests,
                                                     std::map<Size, std::vector<Request>>& resolves) {
  std::vector<Request> taken;
  for (const Request& request : requests) {
    if (!IsColorClass(request.attribute)) {
      taken.push_back(request);
      continue;
    }
    std::vector<Request>& resolve = resolves[SizeOf(request)];
    if (resolve.empty()) {
      const Result<Buffers*> buffers = BuffersOf(SizeOf(request), true);
      if (!buffers) return std::unexpected(buffers.error());
      taken.push_back({Attribute::kColor, &(*buffers)->color, image::Encoding::kSceneLinear});
    }
    resolve.push_back(request);
  }
  return taken;
}

void Renderer::BindFrame(const FrameInput& frame, Size size, bool wants_color) {
  FrameBlock block = MakeFrameBlock(frame, FindKeyLight(*scene_, *frame.pose), size.first, size.second);
  if (wants_color) {
    environment_.Prepare();
    environment_.Bind(kEnvironmentUnit);
    block.irradiance = environment_.irradiance();
    block.environment = glm::vec4(EnvironmentStrength(), static_cast<float>(environment_.last_level()),
                                  static_cast<float>(light_count_), 0.0f);
  }
  gl::StreamInto(frame_block_, &block, sizeof(block));
  glBindBufferBase(GL_UNIFORM_BUFFER, kFrameBinding, frame_block_.id());
  if (light_count_ > 0) glBindBufferBase(GL_SHADER_STORAGE_BUFFER, kLightBinding, lights_.id());
}

Result<void> Renderer::UpdateTranslucency(const FrameInput& frame, const FrameDraws& draws,
                                          std::span<const LightRecord> lights, std::span<const Request> requests) {
  const bool is_wanted = std::ranges::any_of(requests, IsScattering, &Request::attribute);
  if (frame.translucency == nullptr || !is_wanted) return {};
  if (light_count_ > 0) glBindBufferBase(GL_SHADER_STORAGE_BUFFER, kLightBinding, lights_.id());
  TranslucencyInput input;
  input.frame = &frame;
  input.draws = &draws;
  input.materials = &materials_;
  input.lights = lights;
  input.environment_strength = EnvironmentStrength();
  for (const Request& request : requests) input.height = std::max(input.height, request.target->height());
  input.wants_parts = std::ranges::any_of(requests, IsScatteringPart, &Request::attribute);
  Result<void> updated = frame.translucency->Update(input);
  gl::ResetState();
  return updated;
}

Result<void> Renderer::RenderGroup(const FrameInput& frame, const FrameDraws& draws, Size size,
                                   const std::vector<Request>& group, bool takes_over) {
  const Result<Buffers*> buffers = BuffersOf(size, false);
  if (!buffers) return std::unexpected(buffers.error());
  std::vector<const gl::Texture*> targets;
  std::vector<Output> outputs;
  int color_location = -1;
  for (const Request& request : group) {
    const bool is_color = IsColorClass(request.attribute);
    if (is_color) color_location = static_cast<int>(outputs.size());
    outputs.push_back({.location = static_cast<int>(outputs.size()),
                       .storage = {request.attribute, request.target->format(), request.encoding},
                       .is_blended = is_color && takes_over});
    targets.push_back(request.target);
  }
  const Result<gl::Framebuffer> framebuffer = gl::Framebuffer::Create(targets, &(*buffers)->depth, "geometry pass");
  if (!framebuffer) return std::unexpected(framebuffer.error());
  const std::array<float, 4> background = {frame.background.r, frame.background.g, frame.background.b,
                                           frame.background.a};
  for (const Output& output : outputs) {
    const std::array<float, 4> value = StoredBackground(output.storage, background);
    glClearNamedFramebufferfv(framebuffer->id(), GL_COLOR, output.location, value.data());
  }
  glClearNamedFramebufferfi(framebuffer->id(), GL_DEPTH_STENCIL, 0, 0.0f, 0);
  framebuffer->Bind();
  BindFrame(frame, size, color_location >= 0);
  const FaceShader shade = [&](std::span<const FaceEdge> edges, std::vector<std::uint32_t>& first) {
    BindFrame(frame, size, true);
    const SampleView view{ClipFromWorld(frame.view), size.first, size.second};
    return face_colors_.Shade(edges, frame, draws, view, materials_, first);
  };
  const auto smooth = [&]() -> Result<void> {
    for (const Request& request : group) {
      if (!IsColorClass(request.attribute)) continue;
      if (auto done = frame.edges->Antialias(frame, request, (*buffers)->depth, shade); !done) return done;
    }
    return {};
  };
  const bool smooths = color_location >= 0 && frame.edges != nullptr && frame.edges->antialiases();
  const bool smooths_early = smooths && frame.edges->precedes_blended() && !draws.blended.empty();
  std::function<Result<void>()> after_opaque;
  if (smooths_early) {
    after_opaque = [&]() -> Result<void> {
      Result<void> done = smooth();
      framebuffer->Bind();
      BindFrame(frame, size, true);
      return done;
    };
  }
  Result<void> result = PassOf(std::move(outputs)).Draw(draws, materials_, after_opaque);
  gl::ResetState();
  if (result && smooths && !smooths_early) result = smooth();
  return result;
}

// Attributes of edges need the depth of their size, whether or not anything else is drawn at it.
Result<void> Renderer::RenderEdges(const FrameInput& frame, const FrameDraws& draws, std::span<const Request> requests,
                                   std::set<Size> drawn) {
  for (const std::vector<Request>& group : GroupRequests(requests)) {
    const Size size = SizeOf(group.front());
    if (frame.edges == nullptr) {
      for (const Request& request : group) ClearToBackground(request);
      continue;
    }
    if (drawn.insert(size).second) {
      if (Result<void> result = RenderGroup(frame, draws, size, {}, false); !result) return result;
    }
    if (Result<void> result = frame.edges->Fill(frame, group, buffers_.at(size).depth); !result) return result;
  }
  return {};
}

Result<void> Renderer::Render(const FrameInput& frame, std::span<const Request> requests) {
  gl::ResetState();
  SetMissingAttributes();
  std::vector<Request> drawn;
  std::vector<Request> of_edges;
  for (const Request& request : requests) {
    if (request.attribute == Attribute::kVideo) {
      ClearToBackground(request);
    } else {
      (IsEdgeAttribute(request.attribute) ? of_edges : drawn).push_back(request);
    }
  }
  if (drawn.empty() && of_edges.empty()) return {};

  const std::vector<LightRecord> lights = BuildLights(*scene_, *frame.pose, exposure_);
  light_count_ = lights.size();
  if (light_count_ > 0) gl::StreamInto(lights_, lights.data(), lights.size() * sizeof(LightRecord));
  const Result<FrameDraws> draws = Prepare(frame);
  if (!draws) return std::unexpected(draws.error());
  if (auto updated = UpdateTranslucency(frame, *draws, lights, drawn); !updated) return updated;

  const bool takes_over = !draws->blended.empty() || SmoothsIndirectly(frame, drawn);
  std::map<Size, std::vector<Request>> resolves;
  if (takes_over) {
    Result<std::vector<Request>> taken = TakeOverColor(drawn, resolves);
    if (!taken) return std::unexpected(taken.error());
    drawn = std::move(*taken);
  }
  std::set<Size> sizes;
  for (const std::vector<Request>& group : GroupRequests(drawn)) {
    const Size size = SizeOf(group.front());
    // What is blended is left out of the depth of colour alone.
    const bool is_whole = draws->blended.empty() || !std::ranges::all_of(group, IsColorClass, &Request::attribute);
    is_whole ? void(sizes.insert(size)) : void(sizes.erase(size));
    if (Result<void> result = RenderGroup(frame, *draws, size, group, takes_over); !result) return result;
  }
  for (const auto& [size, resolve] : resolves) {
    Result<void> result = resolver_->Render(buffers_.at(size).color, image::Encoding::kSceneLinear, resolve);
    if (!result) return result;
  }
  return RenderEdges(frame, *draws, of_edges, std::move(sizes));
}

Result<std::vector<GeometryDraw>> Renderer::Draws(const FrameInput& frame) {
  SetMissingAttributes();
  std::vector<GeometryDraw> draws;
  for (const scene::DrawItem& item : frame.items) {
    const Result<const GpuPrimitive*> primitive = meshes_.Prepare(item, false);
    if (!primitive) return std::unexpected(primitive.error());
    if ((*primitive)->index_count == 0) continue;
    draws.push_back({.world_from_object = item.world_from_object,
                     .material = static_cast<int>(item.material_id) - 1,
                     .vertex_array = (*primitive)->effect_vertex_array.id(),
                     .mode = (*primitive)->mode,
                     .index_count = (*primitive)->index_count});
  }
  return draws;
}

}  // namespace

Result<std::unique_ptr<SceneRenderer>> SceneRenderer::Create(const scene::Scene& scene,
                                                             const image::Image* environment) {
  std::optional<EnvironmentMap> map;
  if (environment != nullptr) {
    Result<EnvironmentMap> read = EnvironmentFromImage(*environment);
    if (!read) return std::unexpected(read.error());
    map = std::move(*read);
  }
  Result<std::unique_ptr<PictureRenderer>> resolver = PictureRenderer::Create();
  if (!resolver) return std::unexpected(resolver.error());
  return std::make_unique<Renderer>(scene, std::move(map), std::move(*resolver));
}

}  // namespace burin::gbuffer
