// SPDX-License-Identifier: Apache-2.0
#include "core/scene/describe.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/scene/item_tessellator.h"
#include "core/scene/pose.h"

namespace burin::scene {
namespace {

using Json = nlohmann::ordered_json;

/// Pieces of a patch's side: a quarter of a circle is then exact to a 200th of its radius.
constexpr float kBoundsFactor = 8.0f;

const char* Name(PrimitiveMode mode) {
  switch (mode) {
    case PrimitiveMode::kPoints:
      return "points";
    case PrimitiveMode::kLines:
      return "lines";
    case PrimitiveMode::kTriangles:
      return "triangles";
  }
  return "";
}

const char* Name(LightType type) {
  switch (type) {
    case LightType::kDirectional:
      return "directional";
    case LightType::kPoint:
      return "point";
    case LightType::kSpot:
      return "spot";
  }
  return "";
}

const char* Name(AlphaMode mode) {
  switch (mode) {
    case AlphaMode::kOpaque:
      return "opaque";
    case AlphaMode::kMask:
      return "mask";
    case AlphaMode::kBlend:
      return "blend";
  }
  return "";
}

std::size_t CornersOf(PrimitiveMode mode) {
  return mode == PrimitiveMode::kTriangles ? 3 : mode == PrimitiveMode::kLines ? 2 : 1;
}

struct MeshCounts {
  std::size_t patches = 0;
  std::size_t vertices = 0, points = 0, lines = 0, triangles = 0;
};

MeshCounts Count(const Mesh& mesh) {
  MeshCounts counts;
  for (const Primitive& primitive : mesh.primitives) {
    counts.vertices += primitive.positions.size();
    if (primitive.patches) counts.patches += primitive.patches->patches.size();
    const std::size_t n = primitive.indices.size() / CornersOf(primitive.mode);
    if (primitive.mode == PrimitiveMode::kPoints) counts.points += n;
    if (primitive.mode == PrimitiveMode::kLines) counts.lines += n;
    if (primitive.mode == PrimitiveMode::kTriangles) counts.triangles += n;
  }
  return counts;
}

Bounds RestBounds(const Scene& scene) {
  const Pose pose = EvaluatePose(scene, {}, 0.0);
  std::vector<DrawItem> items = BuildDrawItems(scene, pose, pose);
  ItemTessellator tessellator(scene, {});
  if (tessellator.is_active()) (void)tessellator.TessellateEvenly(kBoundsFactor, items);  // too many: the cage's
  return ComputeBounds(scene, items);
}

Json MeshesJson(const Scene& scene) {
  Json meshes = Json::array();
  for (const Mesh& mesh : scene.meshes) {
    Json primitives = Json::array();
    for (const Primitive& p : mesh.primitives) {
      primitives.push_back({{"mode", Name(p.mode)},
                            {"vertices", p.positions.size()},
                            {"count", p.indices.size() / CornersOf(p.mode)},
                            {"material", p.material == kNone ? Json() : Json(p.material)},
                            {"texcoords", p.texcoords[0].empty()   ? 0
                                          : p.texcoords[1].empty() ? 1
                                                                   : 2},
                            {"colors", !p.colors.empty()},
                            {"joints", p.joints[0].empty()   ? 0
                                       : p.joints[1].empty() ? 4
                                                             : 8},
                            {"morph_targets", p.targets.size()}});
    }
    const MeshCounts counts = Count(mesh);
    meshes.push_back({{"name", mesh.name},
                      {"vertices", counts.vertices},
                      {"triangles", counts.triangles},
                      {"lines", counts.lines},
                      {"points", counts.points},
                      {"patches", counts.patches},
                      {"primitives", std::move(primitives)}});
  }
  return meshes;
}

Json MaterialsJson(const Scene& scene) {
  Json materials = Json::array();
  const auto image = [](const TextureUse& use) { return use ? Json(use.image) : Json(); };
  for (const Material& m : scene.materials) {
    materials.push_back({{"name", m.name},
                         {"base_color", {m.base_color.x, m.base_color.y, m.base_color.z, m.base_color.w}},
                         {"metallic", m.metallic},
                         {"roughness", m.roughness},
                         {"emissive", {m.emissive.x, m.emissive.y, m.emissive.z}},
                         {"alpha_mode", Name(m.alpha_mode)},
                         {"double_sided", m.double_sided},
                         {"unlit", m.unlit},
                         {"images",
                          {{"base_color", image(m.base_color_texture)},
                           {"metallic_roughness", image(m.metallic_roughness_texture)},
                           {"normal", image(m.normal_texture)},
                           {"occlusion", image(m.occlusion_texture)},
                           {"emissive", image(m.emissive_texture)}}}});
  }
  return materials;
}

Json CamerasJson(const Scene& scene) {
  Json cameras = Json::array();
  for (const Camera& c : scene.cameras) {
    Json camera = {{"name", c.name}, {"type", c.orthographic ? "orthographic" : "perspective"}, {"znear", c.znear}};
    camera["zfar"] = c.zfar ? Json(*c.zfar) : Json();
    if (c.orthographic) {
      camera["ymag"] = c.ymag;
    } else {
      camera["yfov_rad"] = c.yfov_rad;
    }
    cameras.push_back(std::move(camera));
  }
  return cameras;
}

Json LightsJson(const Scene& scene) {
  Json lights = Json::array();
  for (const Light& l : scene.lights) {
    lights.push_back({{"name", l.name},
                      {"type", Name(l.type)},
                      {"color", {l.color.x, l.color.y, l.color.z}},
                      {"intensity", l.intensity}});
  }
  return lights;
}

Json AnimationsJson(const Scene& scene) {
  Json animations = Json::array();
  for (const Animation& a : scene.animations) {
    animations.push_back({{"name", a.name}, {"duration_s", a.duration_s}, {"channels", a.channels.size()}});
  }
  return animations;
}

Json ImagesJson(const Scene& scene) {
  Json images = Json::array();
  for (const image::Image& i : scene.images) {
    images.push_back(i.width > 0 ? Json({{"width", i.width}, {"height", i.height}, {"channels", i.channels}}) : Json());
  }
  return images;
}

std::string ToJson(const Scene& scene, const Bounds& bounds) {
  Json json;
  json["scene"] = scene.path;
  json["name"] = scene.name;
  json["nodes"] = scene.nodes.size();
  json["meshes"] = MeshesJson(scene);
  json["materials"] = MaterialsJson(scene);
  json["images"] = ImagesJson(scene);
  json["skins"] = scene.skins.size();
  json["cameras"] = CamerasJson(scene);
  json["lights"] = LightsJson(scene);
  json["animations"] = AnimationsJson(scene);
  json["bounds"] = bounds.empty() ? Json()
                                  : Json({{"min", {bounds.min.x, bounds.min.y, bounds.min.z}},
                                          {"max", {bounds.max.x, bounds.max.y, bounds.max.z}}});
  json["warnings"] = scene.warnings;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string Quoted(const std::string& name) { return name.empty() ? "(unnamed)" : fmt::format("\"{}\"", name); }

std::string Plural(std::size_t count, const char* noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

void Heading(std::string& out, std::size_t count, const char* title) {
  out += fmt::format("  {} ({}):\n", title, count);
}

void MeshesText(const Scene& scene, std::string& out) {
  Heading(out, scene.meshes.size(), "meshes");
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    const MeshCounts counts = Count(scene.meshes[i]);
    out += fmt::format("    {} {}: {}", i, Quoted(scene.meshes[i].name), Plural(counts.vertices, "vertex"));
    if (counts.vertices != 1) out.replace(out.rfind("vertexs"), 7, "vertices");
    if (counts.triangles > 0) out += ", " + Plural(counts.triangles, "triangle");
    if (counts.lines > 0) out += ", " + Plural(counts.lines, "line");
    if (counts.points > 0) out += ", " + Plural(counts.points, "point");
    if (counts.patches > 0) out += fmt::format(", {} {}", counts.patches, counts.patches == 1 ? "patch" : "patches");
    if (!scene.meshes[i].weights.empty()) out += ", " + Plural(scene.meshes[i].weights.size(), "morph target");
    out += '\n';
  }
}

void MaterialsText(const Scene& scene, std::string& out) {
  Heading(out, scene.materials.size(), "materials");
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    const Material& m = scene.materials[i];
    out += fmt::format("    {} {}: {}", i, Quoted(m.name), Name(m.alpha_mode));
    if (m.unlit) {
      out += ", unlit";
    } else {
      out += fmt::format(", metallic {:g}, roughness {:g}", m.metallic, m.roughness);
    }
    if (m.double_sided) out += ", double sided";
    const TextureUse* uses[] = {&m.base_color_texture, &m.metallic_roughness_texture, &m.normal_texture,
                                &m.occlusion_texture, &m.emissive_texture};
    std::size_t textures = 0;
    for (const TextureUse* use : uses) textures += *use ? 1 : 0;
    if (textures > 0) out += ", " + Plural(textures, "texture");
    out += '\n';
  }
}

void CamerasText(const Scene& scene, std::string& out) {
  Heading(out, scene.cameras.size(), "cameras");
  for (std::size_t i = 0; i < scene.cameras.size(); ++i) {
    const Camera& c = scene.cameras[i];
    out += fmt::format("    {} {}: ", i, Quoted(c.name));
    out += c.orthographic ? fmt::format("orthographic, {:g} high", 2.0f * c.ymag)
                          : fmt::format("perspective, {:.1f} degrees high", c.yfov_rad * 57.29578f);
    out += fmt::format(", from {:g} to {}\n", c.znear, c.zfar ? fmt::format("{:g}", *c.zfar) : std::string("infinity"));
  }
}

void LightsText(const Scene& scene, std::string& out) {
  Heading(out, scene.lights.size(), "lights");
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const Light& l = scene.lights[i];
    out += fmt::format("    {} {}: {}, {:g} {}\n", i, Quoted(l.name), Name(l.type), l.intensity,
                       l.type == LightType::kDirectional ? "lux" : "candela");
  }
}

void AnimationsText(const Scene& scene, std::string& out) {
  Heading(out, scene.animations.size(), "animations");
  for (std::size_t i = 0; i < scene.animations.size(); ++i) {
    const Animation& a = scene.animations[i];
    out +=
        fmt::format("    {} {}: {:.3f} s, {}\n", i, Quoted(a.name), a.duration_s, Plural(a.channels.size(), "channel"));
  }
}

std::string ToText(const Scene& scene, const Bounds& bounds) {
  std::string out = fmt::format("{}: scene {}\n", scene.path, Quoted(scene.name));
  out +=
      fmt::format("  nodes: {}, skins: {}, images: {}\n", scene.nodes.size(), scene.skins.size(), scene.images.size());
  if (bounds.empty()) {
    out += "  bounds: nothing is drawn\n";
  } else {
    out += fmt::format("  bounds: {:g} {:g} {:g} to {:g} {:g} {:g}\n", bounds.min.x, bounds.min.y, bounds.min.z,
                       bounds.max.x, bounds.max.y, bounds.max.z);
  }
  if (!scene.meshes.empty()) MeshesText(scene, out);
  if (!scene.materials.empty()) MaterialsText(scene, out);
  if (!scene.cameras.empty()) CamerasText(scene, out);
  if (!scene.lights.empty()) LightsText(scene, out);
  if (!scene.animations.empty()) AnimationsText(scene, out);
  return out;
}

}  // namespace

std::string DescribeScene(const Scene& scene, bool as_json) {
  const Bounds bounds = RestBounds(scene);
  return as_json ? ToJson(scene, bounds) : ToText(scene, bounds);
}

}  // namespace burin::scene
