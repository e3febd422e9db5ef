// SPDX-License-Identifier: Apache-2.0
#include "core/scene/gltf_material.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>

namespace burin::scene {
namespace {

Wrap WrapOf(int code) {
  switch (code) {
    case TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE:
      return Wrap::kClampToEdge;
    case TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT:
      return Wrap::kMirroredRepeat;
    default:
      return Wrap::kRepeat;
  }
}

/// Unstated filters (-1) are linear with linear mipmaps: the specification leaves them to the reader.
TextureSampler SamplerOf(const tinygltf::Sampler& source) {
  TextureSampler sampler;
  sampler.wrap_s = WrapOf(source.wrapS);
  sampler.wrap_t = WrapOf(source.wrapT);
  sampler.mag = source.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST ? Filter::kNearest : Filter::kLinear;
  const int min = source.minFilter;
  sampler.mipmaps = min != TINYGLTF_TEXTURE_FILTER_NEAREST && min != TINYGLTF_TEXTURE_FILTER_LINEAR;
  if (min == TINYGLTF_TEXTURE_FILTER_NEAREST || min == TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST ||
      min == TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_LINEAR) {
    sampler.min = Filter::kNearest;
  }
  if (min == TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST || min == TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_NEAREST) {
    sampler.mip = Filter::kNearest;
  }
  return sampler;
}

float Number(const tinygltf::Value& object, const char* name, float otherwise) {
  const tinygltf::Value& value = object.Get(std::string(name));
  return value.IsNumber() ? static_cast<float>(value.GetNumberAsDouble()) : otherwise;
}

glm::vec2 Pair(const tinygltf::Value& object, const char* name, glm::vec2 otherwise) {
  const tinygltf::Value& value = object.Get(std::string(name));
  if (!value.IsArray() || value.ArrayLen() != 2) return otherwise;
  return {static_cast<float>(value.Get(0).GetNumberAsDouble()), static_cast<float>(value.Get(1).GetNumberAsDouble())};
}

/// White where it is missing or malformed, 0..1.
glm::vec3 Color(const tinygltf::Value& object, const char* name) {
  const tinygltf::Value& value = object.Get(std::string(name));
  glm::vec3 color(1.0f);
  if (!value.IsArray() || value.ArrayLen() != 3) return color;
  for (int c = 0; c < 3; ++c) {
    color[c] = std::clamp(static_cast<float>(value.Get(c).GetNumberAsDouble()), 0.0f, 1.0f);
  }
  return color;
}

/// A string as it is; an object's members as "key:values" with semicolons between.
std::string MediumText(const tinygltf::Value& value) {
  if (value.IsString()) return value.Get<std::string>();
  if (!value.IsObject()) return "(neither a string nor an object)";
  std::string text;
  for (const std::string& key : value.Keys()) {
    const tinygltf::Value& member = value.Get(key);
    std::string numbers = member.IsNumber() ? fmt::format("{}", member.GetNumberAsDouble()) : "";
    for (int i = 0; member.IsArray() && i < static_cast<int>(member.ArrayLen()); ++i) {
      numbers += fmt::format("{}{}", i == 0 ? "" : ",", member.Get(i).GetNumberAsDouble());
    }
    text += fmt::format("{}{}:{}", text.empty() ? "" : ";", key, numbers);
  }
  return text;
}

/// KHR_texture_transform: translation * rotation * scale. The rotation is counter-clockwise as the image is seen, v
/// down.
glm::mat3 UvTransform(const tinygltf::Value& extension) {
  const glm::vec2 offset = Pair(extension, "offset", glm::vec2(0.0f));
  const glm::vec2 scale = Pair(extension, "scale", glm::vec2(1.0f));
  const float rotation_rad = Number(extension, "rotation", 0.0f);
  const float c = std::cos(rotation_rad);
  const float s = std::sin(rotation_rad);
  return {glm::vec3(c * scale.x, -s * scale.x, 0.0f), glm::vec3(s * scale.y, c * scale.y, 0.0f),
          glm::vec3(offset, 1.0f)};
}

class MaterialReader {
 public:
  explicit MaterialReader(GltfDocument& document) : document_(document) {}

  Material Read(const tinygltf::Material& source, std::string where) {
    where_ = std::move(where);
    const tinygltf::PbrMetallicRoughness& pbr = source.pbrMetallicRoughness;
    Material material;
    material.name = source.name;
    for (int c = 0; c < 4; ++c) {
      material.base_color[c] = static_cast<float>(pbr.baseColorFactor[static_cast<std::size_t>(c)]);
    }
    material.base_color_texture = Use(pbr.baseColorTexture, "pbrMetallicRoughness.baseColorTexture");
    material.metallic = std::clamp(static_cast<float>(pbr.metallicFactor), 0.0f, 1.0f);
    material.roughness = std::clamp(static_cast<float>(pbr.roughnessFactor), 0.0f, 1.0f);
    material.metallic_roughness_texture =
        Use(pbr.metallicRoughnessTexture, "pbrMetallicRoughness.metallicRoughnessTexture");
    material.normal_texture = Use(source.normalTexture, "normalTexture");
    material.normal_scale = static_cast<float>(source.normalTexture.scale);
    material.occlusion_texture = Use(source.occlusionTexture, "occlusionTexture");
    material.occlusion_strength = std::clamp(static_cast<float>(source.occlusionTexture.strength), 0.0f, 1.0f);
    material.emissive_texture = Use(source.emissiveTexture, "emissiveTexture");
    for (int c = 0; c < 3; ++c) {
      material.emissive[c] = static_cast<float>(source.emissiveFactor[static_cast<std::size_t>(c)]);
    }
    if (source.alphaMode == "MASK") material.alpha_mode = AlphaMode::kMask;
    if (source.alphaMode == "BLEND") material.alpha_mode = AlphaMode::kBlend;
    material.alpha_cutoff = static_cast<float>(source.alphaCutoff);
    material.double_sided = source.doubleSided;
    ReadExtensions(source, material);
    return material;
  }

 private:
  static void ReadExtensions(const tinygltf::Material& source, Material& material) {
    material.unlit = source.extensions.contains("KHR_materials_unlit");
    if (const auto it = source.extensions.find("KHR_materials_emissive_strength"); it != source.extensions.end()) {
      material.emissive *= Number(it->second, "emissiveStrength", 1.0f);
    }
    if (const auto it = source.extensions.find("KHR_materials_ior"); it != source.extensions.end()) {
      material.ior = Number(it->second, "ior", 1.5f);
    }
    ReadDiffusion(source, material);
    if (source.extras.IsObject() && source.extras.Has("translucency")) {
      material.translucency = MediumText(source.extras.Get("translucency"));
    }
  }

  static void ReadDiffusion(const tinygltf::Material& source, Material& material) {
    if (const auto it = source.extensions.find("KHR_materials_diffuse_transmission"); it != source.extensions.end()) {
      material.diffuse_transmission = std::clamp(Number(it->second, "diffuseTransmissionFactor", 0.0f), 0.0f, 1.0f);
      material.diffuse_transmission_color = Color(it->second, "diffuseTransmissionColorFactor");
    }
    if (const auto it = source.extensions.find("KHR_materials_volume"); it != source.extensions.end()) {
      material.attenuation_color = Color(it->second, "attenuationColor");
      const float distance = Number(it->second, "attenuationDistance", material.attenuation_distance);
      if (distance > 0.0f) material.attenuation_distance = distance;
    }
  }

  /// Info is one of tinygltf's three texture infos.
  template <class Info>
  TextureUse Use(const Info& info, const char* slot) {
    TextureUse use;
    if (info.index < 0) return use;
    const tinygltf::Texture& texture = document_.model().textures[static_cast<std::size_t>(info.index)];
    if (texture.source < 0) {
      document_.Warn(
          fmt::format("{}.{}: texture {} has no image that can be read; it is ignored", where_, slot, info.index));
      return use;
    }
    use.image = texture.source;
    if (texture.sampler >= 0) {
      use.sampler = SamplerOf(document_.model().samplers[static_cast<std::size_t>(texture.sampler)]);
    }
    use.texcoord = info.texCoord;
    if (const auto it = info.extensions.find("KHR_texture_transform"); it != info.extensions.end()) {
      use.uv_transform = UvTransform(it->second);
      use.texcoord = static_cast<int>(Number(it->second, "texCoord", static_cast<float>(info.texCoord)));
    }
    if (use.texcoord < 0 || use.texcoord > 1) {
      document_.Warn(fmt::format("{}.{}: uses TEXCOORD_{}; only sets 0 and 1 are read, set 0 is taken", where_, slot,
                                 use.texcoord));
      use.texcoord = 0;
    }
    return use;
  }

  GltfDocument& document_;
  std::string where_;
};

}  // namespace

Result<std::vector<Material>> ReadMaterials(GltfDocument& document) {
  std::vector<Material> materials;
  MaterialReader reader(document);
  for (std::size_t i = 0; i < document.model().materials.size(); ++i) {
    materials.push_back(reader.Read(document.model().materials[i], fmt::format("materials[{}]", i)));
  }
  return materials;
}

Result<std::vector<image::Image>> ReadImages(const GltfDocument& document, const std::vector<Material>& materials,
                                             const ImageDecoder& decode) {
  std::vector<image::Image> images(document.images().size());
  if (!decode) return images;
  std::vector<bool> is_used(images.size(), false);
  std::vector<bool> is_color(images.size(), false);
  const auto mark = [&](const TextureUse& use, bool color) {
    if (!use) return;
    is_used[static_cast<std::size_t>(use.image)] = true;
    if (color) is_color[static_cast<std::size_t>(use.image)] = true;
  };
  for (const Material& material : materials) {
    mark(material.base_color_texture, true);
    mark(material.emissive_texture, true);
    mark(material.metallic_roughness_texture, false);
    mark(material.normal_texture, false);
    mark(material.occlusion_texture, false);
  }
  for (std::size_t i = 0; i < images.size(); ++i) {
    if (!is_used[i]) continue;
    const ImageEntry& entry = document.images()[i];
    std::string label = fmt::format("images[{}]", i);
    if (!entry.name.empty()) label += fmt::format(" \"{}\"", entry.name);
    auto bytes = document.ImageBytes(static_cast<int>(i));
    if (!bytes) return Fail(ErrorKind::kInput, fmt::format("{}: {}", label, bytes.error().message));
    auto decoded = decode(*bytes, label);
    if (!decoded) {
      const std::string& message = decoded.error().message;
      return Fail(ErrorKind::kInput, message.starts_with(label) ? message : fmt::format("{}: {}", label, message));
    }
    if (!is_color[i]) decoded->encoding = image::Encoding::kData;
    images[i] = std::move(*decoded);
  }
  return images;
}

}  // namespace burin::scene
