// SPDX-License-Identifier: Apache-2.0
// glTF 2.0, 4.4 (GLB-stored) and 3.7 (geometry).
#include <fmt/format.h>

#include <array>
#include <glm/common.hpp>
#include <nlohmann/json.hpp>

#include "core/scene/item_geometry.h"
#include "core/scene/mesh_writer.h"

namespace burin::scene {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kFloat = 5126, kUnsignedInt = 5125;
constexpr int kVertexBuffer = 34962, kIndexBuffer = 34963;

Json MaterialJson(const Material& m) {
  Json json = {{"pbrMetallicRoughness",
                {{"baseColorFactor", {m.base_color.r, m.base_color.g, m.base_color.b, m.base_color.a}},
                 {"metallicFactor", m.metallic},
                 {"roughnessFactor", m.roughness}}}};
  if (!m.name.empty()) json["name"] = m.name;
  const glm::vec3 e = glm::clamp(m.emissive, 0.0f, 1.0f);
  if (e != glm::vec3(0.0f)) json["emissiveFactor"] = {e.r, e.g, e.b};
  if (m.double_sided) json["doubleSided"] = true;
  if (m.alpha_mode == AlphaMode::kBlend) json["alphaMode"] = "BLEND";
  if (m.alpha_mode == AlphaMode::kMask) {
    json["alphaMode"] = "MASK";
    json["alphaCutoff"] = m.alpha_cutoff;
  }
  return json;
}

class GlbWriter {
 public:
  explicit GlbWriter(const Scene& scene) : scene_(scene) {
    json_ = {{"asset", {{"version", "2.0"}, {"generator", "burin"}}}, {"scene", 0}};
    for (const char* const list : {"scenes", "nodes", "meshes", "accessors", "bufferViews"})
      json_[list] = Json::array();
    json_["scenes"].push_back({{"nodes", Json::array()}});
    for (const Material& material : scene.materials) json_["materials"].push_back(MaterialJson(material));
  }

  void Add(const DrawItem& item) {
    const ItemGeometry geometry = GeometryOf(scene_, item);
    Json attributes = {{"POSITION", Accessor(geometry.positions, "VEC3", kFloat)}};
    AddBounds(geometry.positions);
    if (!geometry.normals.empty()) attributes["NORMAL"] = Accessor(geometry.normals, "VEC3", kFloat);
    if (!geometry.tangents.empty()) attributes["TANGENT"] = Accessor(geometry.tangents, "VEC4", kFloat);
    for (std::size_t set = 0; set < 2; ++set) {
      if (geometry.texcoords[set].empty()) continue;
      attributes[fmt::format("TEXCOORD_{}", set)] = Accessor(geometry.texcoords[set], "VEC2", kFloat);
    }
    if (!geometry.colors.empty()) attributes["COLOR_0"] = Accessor(geometry.colors, "VEC4", kFloat);
    Json primitive = {{"attributes", std::move(attributes)},
                      {"indices", Accessor(geometry.indices, "SCALAR", kUnsignedInt)}};
    if (item.material_id > 0) primitive["material"] = item.material_id - 1;
    const std::string name = NameOf(scene_, item);
    json_["scenes"][0]["nodes"].push_back(json_["nodes"].size());
    Json node = {{"name", name}, {"mesh", json_["meshes"].size()}};
    if (item.world_from_object != glm::mat4(1.0f)) {
      const float* const m = &item.world_from_object[0][0];
      node["matrix"] = std::vector<float>(m, m + 16);
    }
    json_["nodes"].push_back(std::move(node));
    json_["meshes"].push_back({{"name", name}, {"primitives", {std::move(primitive)}}});
  }

  Result<void> Write(const ByteSink& sink) {
    json_["buffers"] = {{{"byteLength", size_}}};
    std::string text = json_.dump(-1, ' ', false, Json::error_handler_t::replace);
    text.resize((text.size() + 3) / 4 * 4, ' ');
    const std::uint64_t total = 12 + 8 + text.size() + 8 + size_;
    if (total > 0xFFFFFFFFu)
      return Fail(ErrorKind::kFailed, fmt::format("a .glb of {} bytes, over its format's 4 GiB", total));
    SinkBuffer out(sink);
    const std::array<std::uint32_t, 5> head = {0x46546C67u, 2, static_cast<std::uint32_t>(total),
                                               static_cast<std::uint32_t>(text.size()), 0x4E4F534Au};
    out.AddValues(std::span<const std::uint32_t>(head));
    out.Add(text);
    const std::array<std::uint32_t, 2> chunk = {static_cast<std::uint32_t>(size_), 0x004E4942u};
    out.AddValues(std::span<const std::uint32_t>(chunk));
    for (const std::span<const std::byte> view : views_) out.AddBytes(view);
    return out.Finish();
  }

 private:
  template <class T>
  std::size_t Accessor(std::span<const T> values, const char* type, int component) {
    const bool is_index = component == kUnsignedInt;
    json_["bufferViews"].push_back({{"buffer", 0},
                                    {"byteOffset", size_},
                                    {"byteLength", values.size_bytes()},
                                    {"target", is_index ? kIndexBuffer : kVertexBuffer}});
    json_["accessors"].push_back({{"bufferView", json_["bufferViews"].size() - 1},
                                  {"componentType", component},
                                  {"count", values.size()},
                                  {"type", type}});
    views_.push_back(std::as_bytes(values));
    size_ += values.size_bytes();
    return json_["accessors"].size() - 1;
  }

  /// glTF wants them of positions.
  void AddBounds(std::span<const glm::vec3> positions) {
    glm::vec3 low = positions.front(), high = low;
    for (const glm::vec3& p : positions) {
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
    json_["accessors"].back()["min"] = {low.x, low.y, low.z};
    json_["accessors"].back()["max"] = {high.x, high.y, high.z};
  }

  const Scene& scene_;
  Json json_;
  std::vector<std::span<const std::byte>> views_;
  std::uint64_t size_ = 0;
};

}  // namespace

Result<void> WriteGlb(const Scene& scene, std::span<const DrawItem* const> items, const ByteSink& sink) {
  GlbWriter writer(scene);
  for (const DrawItem* item : items) writer.Add(*item);
  return writer.Write(sink);
}

}  // namespace burin::scene
