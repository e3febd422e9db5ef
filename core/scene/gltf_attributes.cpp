// SPDX-License-Identifier: Apache-2.0
#include "core/scene/gltf_attributes.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "core/scene/gltf_accessor.h"

namespace burin::scene {
namespace {

using Attributes = std::map<std::string, int>;

std::unexpected<Error> Bad(const std::string& where, const std::string& what) {
  return Fail(ErrorKind::kInput, fmt::format("{}: {}", where, what));
}

/// Reads the attributes of one map (of a primitive or of a morph target), each as long as `count`.
class AttributeMap {
 public:
  AttributeMap(GltfDocument& document, const Attributes& attributes, std::string where, std::size_t count)
      : document_(document), attributes_(attributes), where_(std::move(where)), count_(count) {}

  [[nodiscard]] bool Has(const std::string& name) const { return attributes_.contains(name); }
  [[nodiscard]] int Accessor(const std::string& name) const { return attributes_.at(name); }
  [[nodiscard]] std::string Where(const std::string& name) const { return fmt::format("{}.{}", where_, name); }
  [[nodiscard]] std::unexpected<Error> BadAt(const std::string& name, const std::string& what) const {
    return Bad(Where(name), what);
  }

  /// Leaves `out` empty when the attribute is not there.
  template <class V>
  Result<void> Read(const std::string& name, std::vector<V>& out, Integers integers = Integers::kAsDeclared) const {
    if (!Has(name)) return {};
    if (auto ok = CheckCount(name); !ok) return ok;
    auto values = ReadVectors<V>(document_, Accessor(name), integers);
    if (!values) return BadAt(name, values.error().message);
    out = std::move(*values);
    return {};
  }

  Result<void> CheckCount(const std::string& name) const {
    auto shape = CheckAccessor(document_, Accessor(name));
    if (!shape) return BadAt(name, shape.error().message);
    if (shape->count == count_) return {};
    return BadAt(name,
                 fmt::format("accessor {} has {} elements, POSITION has {}", Accessor(name), shape->count, count_));
  }

 private:
  GltfDocument& document_;
  const Attributes& attributes_;
  std::string where_;
  std::size_t count_;
};

/// Specification 3.7.2.1: sets are numbered from 0 without gaps.
Result<void> CheckNumbering(const AttributeMap& map, const Attributes& attributes) {
  for (const auto& [name, accessor] : attributes) {
    const std::size_t underscore = name.find('_');
    if (underscore == std::string::npos || underscore == 0) continue;
    const std::string base = name.substr(0, underscore);
    const std::string number = name.substr(underscore + 1);
    if (base != "TEXCOORD" && base != "COLOR" && base != "JOINTS" && base != "WEIGHTS") continue;
    if (number.empty() || number.size() > 3 || number.find_first_not_of("0123456789") != std::string::npos) {
      return map.BadAt(name, "is no attribute set of glTF");
    }
    const int set = std::stoi(number);
    if (set > 0 && !map.Has(fmt::format("{}_{}", base, set - 1))) {
      return map.BadAt(name,
                       fmt::format("is there without {}_{}; sets are numbered from 0 without gaps", base, set - 1));
    }
  }
  return {};
}

/// RGB or RGBA; integers are fractions.
Result<void> ReadColors(GltfDocument& document, const AttributeMap& map, Primitive& primitive) {
  if (!map.Has("COLOR_0")) return {};
  auto shape = CheckAccessor(document, map.Accessor("COLOR_0"));
  if (!shape) return map.BadAt("COLOR_0", shape.error().message);
  if (shape->components == 4) return map.Read("COLOR_0", primitive.colors, Integers::kAlwaysNormalised);
  std::vector<glm::vec3> rgb;
  if (auto ok = map.Read("COLOR_0", rgb, Integers::kAlwaysNormalised); !ok) return ok;
  primitive.colors.reserve(rgb.size());
  for (const glm::vec3& color : rgb) primitive.colors.emplace_back(color, 1.0f);
  return {};
}

Result<void> ReadJoints(GltfDocument& document, const AttributeMap& map, int set, std::vector<glm::u16vec4>& out) {
  const std::string name = fmt::format("JOINTS_{}", set);
  if (!map.Has(name)) return {};
  if (auto ok = map.CheckCount(name); !ok) return ok;
  auto values = ReadIntegers(document, map.Accessor(name), 4);
  if (!values) return map.BadAt(name, values.error().message);
  out.reserve(values->size() / 4);
  for (std::size_t i = 0; i + 3 < values->size(); i += 4) {
    glm::u16vec4 joints;
    for (int c = 0; c < 4; ++c) {
      const std::uint32_t joint = (*values)[i + static_cast<std::size_t>(c)];
      if (joint > 0xffffu) return map.BadAt(name, fmt::format("joint {} of vertex {} is over 65535", joint, i / 4));
      joints[c] = static_cast<std::uint16_t>(joint);
    }
    out.push_back(joints);
  }
  return {};
}

/// Weights that add up to 1; joints of weight 0 become joint 0, whatever the file names there.
Result<void> NormaliseWeights(GltfDocument& document, const AttributeMap& map, Primitive& primitive) {
  bool has_unweighted = false;
  for (std::size_t i = 0; i < primitive.positions.size(); ++i) {
    float sum = 0.0f;
    for (std::size_t set = 0; set < 2 && !primitive.weights[set].empty(); ++set) {
      for (int c = 0; c < 4; ++c) {
        const float weight = primitive.weights[set][i][c];
        if (weight < 0.0f) {
          return map.BadAt(fmt::format("WEIGHTS_{}", set),
                           fmt::format("the weight {} of vertex {} is negative", weight, i));
        }
        if (weight == 0.0f) primitive.joints[set][i][c] = 0;
        sum += weight;
      }
    }
    if (!(sum > 0.0f) || !std::isfinite(sum)) {
      has_unweighted = true;
      primitive.weights[0][i] = glm::vec4(1.0f, 0.0f, 0.0f, 0.0f);
      if (!primitive.weights[1].empty()) primitive.weights[1][i] = glm::vec4(0.0f);
    } else if (sum != 1.0f) {
      for (std::size_t set = 0; set < 2 && !primitive.weights[set].empty(); ++set) primitive.weights[set][i] /= sum;
    }
  }
  if (has_unweighted) {
    document.Warn(fmt::format("{}: vertices without weight follow the skin's first joint", map.Where("WEIGHTS_0")));
  }
  return {};
}

Result<void> ReadSkinning(GltfDocument& document, const AttributeMap& map, Primitive& primitive) {
  for (int set = 0; set < 2; ++set) {
    const std::string joints = fmt::format("JOINTS_{}", set);
    const std::string weights = fmt::format("WEIGHTS_{}", set);
    if (map.Has(joints) != map.Has(weights)) {
      return map.BadAt(map.Has(joints) ? joints : weights,
                       fmt::format("is there without {}", map.Has(joints) ? weights : joints));
    }
    const auto at = static_cast<std::size_t>(set);
    if (auto ok = ReadJoints(document, map, set, primitive.joints[at]); !ok) return ok;
    if (auto ok = map.Read(weights, primitive.weights[at], Integers::kAlwaysNormalised); !ok) return ok;
  }
  if (map.Has("JOINTS_2")) {
    document.Warn(fmt::format("{}: only 8 joints a vertex are used", map.Where("JOINTS_2")));
  }
  return primitive.joints[0].empty() ? Result<void>() : NormaliseWeights(document, map, primitive);
}

/// Unit length, w of -1 or 1. For a tangent of no length any direction is as good.
void NormaliseTangents(std::vector<glm::vec4>& tangents) {
  for (glm::vec4& tangent : tangents) {
    const glm::vec3 direction(tangent);
    const float length = glm::length(direction);
    const glm::vec3 unit = length > 0.0f ? direction / length : glm::vec3(1.0f, 0.0f, 0.0f);
    tangent = glm::vec4(unit, tangent.w < 0.0f ? -1.0f : 1.0f);
  }
}

Result<void> ReadTargets(GltfDocument& document, const tinygltf::Primitive& source, const std::string& where,
                         Primitive& primitive) {
  for (std::size_t i = 0; i < source.targets.size(); ++i) {
    const AttributeMap map(document, source.targets[i], fmt::format("{}.targets[{}]", where, i),
                           primitive.positions.size());
    Primitive::MorphTarget target;
    if (auto ok = map.Read("POSITION", target.positions); !ok) return ok;
    if (auto ok = map.Read("NORMAL", target.normals); !ok) return ok;
    if (auto ok = map.Read("TANGENT", target.tangents); !ok) return ok;
    if (primitive.normals.empty()) target.normals.clear();
    if (primitive.tangents.empty()) target.tangents.clear();
    primitive.targets.push_back(std::move(target));
  }
  return {};
}

}  // namespace

Result<Primitive> ReadAttributes(GltfDocument& document, const tinygltf::Primitive& source, const std::string& where) {
  auto shape = CheckAccessor(document, source.attributes.at("POSITION"));
  if (!shape) return Bad(where + ".attributes.POSITION", shape.error().message);
  const AttributeMap map(document, source.attributes, where + ".attributes", shape->count);
  if (auto ok = CheckNumbering(map, source.attributes); !ok) return std::unexpected(ok.error());

  Primitive primitive;
  if (auto ok = map.Read("POSITION", primitive.positions); !ok) return std::unexpected(ok.error());
  if (auto ok = map.Read("NORMAL", primitive.normals); !ok) return std::unexpected(ok.error());
  if (auto ok = map.Read("TANGENT", primitive.tangents); !ok) return std::unexpected(ok.error());
  if (primitive.normals.empty()) primitive.tangents.clear();  // specification 3.7.2.1
  NormaliseTangents(primitive.tangents);
  if (auto ok = map.Read("TEXCOORD_0", primitive.texcoords[0]); !ok) return std::unexpected(ok.error());
  if (auto ok = map.Read("TEXCOORD_1", primitive.texcoords[1]); !ok) return std::unexpected(ok.error());
  if (auto ok = ReadColors(document, map, primitive); !ok) return std::unexpected(ok.error());
  if (auto ok = ReadSkinning(document, map, primitive); !ok) return std::unexpected(ok.error());
  if (auto ok = ReadTargets(document, source, where, primitive); !ok) return std::unexpected(ok.error());
  return primitive;
}

}  // namespace burin::scene
