// SPDX-License-Identifier: Apache-2.0
#include "core/scene/gltf_json.h"

#include <fmt/format.h>

#include <cfloat>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/scene/gltf_schema.h"

namespace burin::scene {
namespace {

using Json = nlohmann::json;

// tinygltf walks `extras` and `extensions` recursively; real files nest fewer than 20 deep.
constexpr int kMaxDepth = 128;
// A DOM needs some 50 bytes a value: this bounds it to about a gigabyte.
constexpr std::size_t kMaxValues = 20'000'000;
constexpr double kMaxInteger = 9007199254740992.0;  // 2^53, exact in a double

Result<void> ScanNesting(std::string_view text) {
  int depth = 0;
  std::size_t values = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      if (c == '\\')
        ++i;
      else if (c == '"')
        in_string = false;
    } else if (c == '"') {
      in_string = true;
    } else if (c == '{' || c == '[') {
      if (++depth > kMaxDepth)
        return Fail(ErrorKind::kInput, fmt::format("JSON nests deeper than {} levels", kMaxDepth));
      ++values;
    } else if (c == '}' || c == ']') {
      --depth;
    } else if (c == ',' && ++values > kMaxValues) {
      return Fail(ErrorKind::kInput, fmt::format("JSON holds more than {} values", kMaxValues));
    }
  }
  return {};
}

std::string Show(const Json& value) {
  if (value.is_object()) return "an object";
  if (value.is_array()) return "an array";
  std::string text = value.dump(-1, ' ', true);
  if (text.size() > 60) text = text.substr(0, 57) + "...";
  return text;
}

bool IsOneOf(std::string_view word, std::string_view words) {
  while (!words.empty()) {
    const std::size_t end = words.find('|');
    if (words.substr(0, end) == word) return true;
    words = end == std::string_view::npos ? std::string_view() : words.substr(end + 1);
  }
  return false;
}

std::string Alternatives(std::string_view words) {
  std::string text;
  for (const char c : words) text += c == '|' ? std::string(", ") : std::string(1, c);
  return text;
}

/// Walks the document along the tables. `path_` names the value in hand; the first fault stops the walk.
class SchemaCheck {
 public:
  explicit SchemaCheck(Json& root) : root_(root) {}

  Result<void> Run() {
    if (!root_.is_object())
      return Fail(ErrorKind::kInput, fmt::format("expected a JSON object, found {}", Show(root_)));
    return CheckObject(root_, "root");
  }

 private:
  std::unexpected<Error> Bad(std::string_view expected, const Json& found) const {
    return Fail(ErrorKind::kInput, fmt::format("{}: expected {}, found {}", path_, expected, Show(found)));
  }

  template <class Body>
  Result<void> At(const std::string& step, Body body) {
    const std::size_t length = path_.size();
    if (!path_.empty() && step[0] != '[') path_ += '.';
    path_ += step;
    Result<void> result = body();
    path_.resize(length);
    return result;
  }

  Result<void> CheckObject(Json& object, std::string_view type) {
    for (const Rule& rule : RulesOf(type)) {
      const auto property = object.find(rule.name);
      if (property == object.end()) {
        if (!rule.required) continue;
        const std::string where = path_.empty() ? std::string() : path_ + ": ";
        return Fail(ErrorKind::kInput, fmt::format("{}\"{}\" is missing", where, rule.name));
      }
      if (auto ok = At(std::string(rule.name), [&] { return CheckValue(*property, rule); }); !ok) return ok;
    }
    const auto extensions = object.find("extensions");
    if (extensions == object.end()) return {};
    return At("extensions", [&]() -> Result<void> {
      if (!extensions->is_object()) return Bad("an object", *extensions);
      for (auto it = extensions->begin(); it != extensions->end(); ++it) {
        auto ok = At(it.key(), [&]() -> Result<void> {
          if (!it->is_object()) return Bad("an object", *it);
          return CheckObject(*it, it.key());
        });
        if (!ok) return ok;
      }
      return {};
    });
  }

  Result<void> CheckValue(Json& value, const Rule& rule) {
    switch (rule.shape) {
      case Shape::kString:
        return value.is_string() ? Result<void>() : Bad("a string", value);
      case Shape::kBoolean:
        return value.is_boolean() ? Result<void>() : Bad("true or false", value);
      case Shape::kNumber:
        return CheckNumber(value, rule);
      case Shape::kInteger:
        return CheckInteger(value, rule);
      case Shape::kIndex:
        return CheckIndex(value, rule.of);
      case Shape::kWord:
        if (value.is_string() && IsOneOf(value.get_ref<const std::string&>(), rule.of)) return {};
        return Bad("one of " + Alternatives(rule.of), value);
      case Shape::kCode:
        NormaliseInteger(value);
        if (value.is_number_unsigned() && IsOneOf(std::to_string(value.get<std::uint64_t>()), rule.of)) return {};
        return Bad("one of " + Alternatives(rule.of), value);
      case Shape::kObject:
        return value.is_object() ? CheckObject(value, rule.of) : Bad("an object", value);
      case Shape::kAccessorMap:
        return CheckAccessorMap(value);
      default:
        return CheckArray(value, rule);
    }
  }

  Result<void> CheckArray(Json& value, const Rule& rule) {
    if (!value.is_array()) return Bad("an array", value);
    if (rule.items > 0 && value.size() != static_cast<std::size_t>(rule.items)) {
      return Fail(ErrorKind::kInput, fmt::format("{}: expected {} numbers, found {}", path_, rule.items, value.size()));
    }
    for (std::size_t i = 0; i < value.size(); ++i) {
      Json& item = value[i];
      auto ok = At(fmt::format("[{}]", i), [&]() -> Result<void> {
        switch (rule.shape) {
          case Shape::kStrings:
            return item.is_string() ? Result<void>() : Bad("a string", item);
          case Shape::kNumbers:
            return CheckNumber(item, rule);
          case Shape::kIndices:
            return CheckIndex(item, rule.of);
          case Shape::kAccessorMaps:
            return CheckAccessorMap(item);
          default:
            return item.is_object() ? CheckObject(item, rule.of) : Bad("an object", item);
        }
      });
      if (!ok) return ok;
    }
    return {};
  }

  Result<void> CheckNumber(const Json& value, const Rule& rule) {
    if (!value.is_number()) return Bad("a number", value);
    const double number = value.get<double>();
    if (!(std::abs(number) <= FLT_MAX)) return Bad("a number in the range of a 32-bit float", value);
    return CheckRange(number, value, rule);
  }

  Result<void> CheckInteger(Json& value, const Rule& rule) {
    NormaliseInteger(value);
    if (!value.is_number_unsigned()) return Bad("an integer that is not negative", value);
    if (value.get<double>() > kMaxInteger) return Bad("an integer below 2^53", value);
    return CheckRange(value.get<double>(), value, rule);
  }

  Result<void> CheckRange(double number, const Json& value, const Rule& rule) const {
    if (number < rule.min) {
      return rule.min == kPositive ? Bad("a number greater than 0", value)
                                   : Bad(fmt::format("at least {}", rule.min), value);
    }
    if (number > rule.max) return Bad(fmt::format("at most {}", rule.max), value);
    return {};
  }

  Result<void> CheckIndex(Json& value, std::string_view collection) {
    NormaliseInteger(value);
    if (!value.is_number_unsigned()) return Bad(fmt::format("an index in \"{}\"", collection), value);
    const std::size_t size = CollectionSize(collection);
    if (value.get<std::uint64_t>() < size) return {};
    return Fail(ErrorKind::kInput,
                fmt::format("{}: index {} is out of range, \"{}\" has {}", path_, Show(value), collection, size));
  }

  Result<void> CheckAccessorMap(Json& value) {
    if (!value.is_object()) return Bad("an object", value);
    for (auto it = value.begin(); it != value.end(); ++it) {
      if (auto ok = At(it.key(), [&] { return CheckIndex(*it, "accessors"); }); !ok) return ok;
    }
    return {};
  }

  // JSON Schema counts 24.0 as an integer; tinygltf does not.
  static void NormaliseInteger(Json& value) {
    if (!value.is_number_float()) return;
    const double number = value.get<double>();
    if (number >= 0 && number <= kMaxInteger && number == std::floor(number))
      value = static_cast<std::uint64_t>(number);
  }

  std::size_t CollectionSize(std::string_view name) const {
    const Json* holder = &root_;
    if (name == "lights") {
      for (const char* step : {"extensions", "KHR_lights_punctual"}) {
        const auto it = holder->find(step);
        if (it == holder->end() || !it->is_object()) return 0;
        holder = &*it;
      }
    }
    const auto it = holder->find(name);
    return it != holder->end() && it->is_array() ? it->size() : 0;
  }

  Json& root_;
  std::string path_;
};

Result<void> CheckVersion(const Json& asset) {
  const std::string& version = asset["version"].get_ref<const std::string&>();
  if (!version.starts_with("2.")) {
    return Fail(ErrorKind::kInput, fmt::format("asset.version: glTF {} is not supported, expected 2.0", version));
  }
  const std::string minimum = asset.value("minVersion", std::string("2.0"));
  if (minimum != "2.0") {
    return Fail(ErrorKind::kInput, fmt::format("asset.minVersion: needs glTF {}, this program reads 2.0", minimum));
  }
  return {};
}

Result<void> CheckStrides(const Json& root) {
  if (!root.contains("bufferViews")) return {};
  const Json& views = root["bufferViews"];
  for (std::size_t i = 0; i < views.size(); ++i) {
    const auto stride = views[i].value("byteStride", std::uint64_t{4});
    if (stride % 4 != 0) {
      return Fail(ErrorKind::kInput,
                  fmt::format("bufferViews[{}].byteStride: expected a multiple of 4, found {}", i, stride));
    }
  }
  return {};
}

/// An object whose "type" is `type` needs the property of that name.
Result<void> CheckKinds(const Json& objects, const std::string& where, std::initializer_list<const char*> types) {
  for (std::size_t i = 0; i < objects.size(); ++i) {
    for (const char* type : types) {
      if (objects[i]["type"] != type || objects[i].contains(type)) continue;
      return Fail(ErrorKind::kInput, fmt::format("{}[{}]: \"{}\" is missing", where, i, type));
    }
  }
  return {};
}

Result<void> CheckCamerasAndLights(const Json& root) {
  if (root.contains("cameras")) {
    if (auto ok = CheckKinds(root["cameras"], "cameras", {"perspective", "orthographic"}); !ok) return ok;
  }
  const Json::json_pointer lights("/extensions/KHR_lights_punctual/lights");
  if (!root.contains(lights)) return {};
  return CheckKinds(root[lights], "extensions.KHR_lights_punctual.lights", {"spot"});
}

/// Compressed vertices stand in an extension, and the accessors have no bytes. (An uncompressed copy may stand beside
/// them.)
Result<void> CheckCompression(const Json& root) {
  if (!root.contains("meshes")) return {};
  for (std::size_t m = 0; m < root["meshes"].size(); ++m) {
    const Json& primitives = root["meshes"][m]["primitives"];
    for (std::size_t p = 0; p < primitives.size(); ++p) {
      const Json& attributes = primitives[p]["attributes"];
      if (!primitives[p].contains("extensions") || !attributes.contains("POSITION")) continue;
      if (!primitives[p]["extensions"].contains("KHR_draco_mesh_compression")) continue;
      if (root["accessors"][attributes["POSITION"].get<std::size_t>()].contains("bufferView")) continue;
      return Fail(
          ErrorKind::kInput,
          fmt::format(
              "meshes[{}].primitives[{}]: needs the extension KHR_draco_mesh_compression, which is not supported", m,
              p));
    }
  }
  return {};
}

std::optional<std::string> OptionalString(const Json& object, const char* name) {
  const auto it = object.find(name);
  if (it == object.end()) return std::nullopt;
  return it->get<std::string>();
}

Result<std::vector<ImageEntry>> TakeImages(Json& root) {
  std::vector<ImageEntry> images;
  if (!root.contains("images")) return images;
  for (const Json& image : root["images"]) {
    ImageEntry entry;
    entry.name = image.value("name", std::string());
    entry.mime_type = image.value("mimeType", std::string());
    entry.uri = OptionalString(image, "uri");
    if (image.contains("bufferView")) entry.buffer_view = image["bufferView"].get<int>();
    if (entry.uri && entry.buffer_view >= 0) {
      return Fail(ErrorKind::kInput, fmt::format("images[{}]: has both \"uri\" and \"bufferView\"", images.size()));
    }
    images.push_back(std::move(entry));
  }
  root.erase("images");
  return images;
}

std::vector<BufferEntry> TakeBuffers(Json& root) {
  std::vector<BufferEntry> buffers;
  if (!root.contains("buffers")) return buffers;
  for (const Json& buffer : root["buffers"]) {
    buffers.push_back({OptionalString(buffer, "uri"), buffer["byteLength"].get<std::uint64_t>()});
  }
  root.erase("buffers");
  return buffers;
}

std::vector<std::string> Strings(const Json& root, const char* name) {
  return root.contains(name) ? root[name].get<std::vector<std::string>>() : std::vector<std::string>();
}

Result<GltfJson> Split(std::string_view text) {
  Json document = Json::parse(text);
  if (auto ok = SchemaCheck(document).Run(); !ok) return std::unexpected(ok.error());
  const Json& root = document;  // const: [] of a missing key must not make one
  if (auto ok = CheckVersion(root["asset"]); !ok) return std::unexpected(ok.error());
  if (auto ok = CheckStrides(root); !ok) return std::unexpected(ok.error());
  if (auto ok = CheckCamerasAndLights(root); !ok) return std::unexpected(ok.error());
  if (auto ok = CheckCompression(root); !ok) return std::unexpected(ok.error());
  GltfJson result;
  auto images = TakeImages(document);
  if (!images) return std::unexpected(images.error());
  result.images = std::move(*images);
  result.buffers = TakeBuffers(document);
  result.extensions_used = Strings(root, "extensionsUsed");
  result.extensions_required = Strings(root, "extensionsRequired");
  result.rest = document.dump();
  return result;
}

}  // namespace

Result<GltfJson> ParseGltfJson(std::string_view text) {
  if (auto ok = ScanNesting(text); !ok) return std::unexpected(ok.error());
  try {
    return Split(text);
  } catch (const Json::exception& exception) {
    std::string_view what =
        exception.what();  // "[json.exception.parse_error.101] parse error at line 1, column 2: ..."
    if (const std::size_t end = what.find("] "); end != std::string_view::npos) what.remove_prefix(end + 2);
    return Fail(ErrorKind::kInput, fmt::format("not valid JSON: {}", what));
  }
}

}  // namespace burin::scene
