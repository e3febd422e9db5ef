// SPDX-License-Identifier: Apache-2.0
#include "core/scene/mtl_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/scene/scene_folder.h"
#include "core/scene/text_lines.h"

namespace burin::scene {
namespace {

constexpr std::uint64_t kMostImageBytes = std::uint64_t{1} << 30;
constexpr float kPlainRoughness = 0.5f;
constexpr float kPlainReflectance = 0.6f;

/// A Blinn-Phong exponent as GGX roughness: alpha = sqrt(2 / (Ns + 2)) (Walter et al. 2007), its root is perceptual.
float RoughnessOf(float exponent) { return std::pow(2.0f / (std::max(exponent, 0.0f) + 2.0f), 0.25f); }

class MtlReader {
 public:
  MtlReader(const std::string& path, const ImageDecoder& decode, Scene& scene)
      : path_(path), folder_(path), decode_(decode), scene_(scene) {}

  Result<std::vector<Material>> Read() {
    const Result<std::string> text = ReadText(path_);
    if (!text) return Fail(ErrorKind::kInput, fmt::format("{}: {}", path_, text.error().message));
    TextLines lines(*text);
    while (std::optional<std::string_view> line = lines.Next()) {
      line_ = lines.number();
      const std::string_view keyword = TakeWord(*line);
      if (keyword.empty() || keyword.front() == '#') continue;
      if (Result<void> done = Statement(keyword, *line); !done) return std::unexpected(done.error());
    }
    return std::move(materials_);
  }

 private:
  std::unexpected<Error> Bad(const std::string& message) const {
    return Fail(ErrorKind::kInput, fmt::format("{}: line {}: {}", path_, line_, message));
  }
  void Warn(const std::string& message) {
    scene_.warnings.push_back(fmt::format("{}: line {}: {}", path_, line_, message));
  }

  Result<float> Number(std::string_view keyword, std::string_view& rest) const {
    const std::string_view word = TakeWord(rest);
    const std::optional<float> value = ParseFinite(word);
    if (!value) return Bad(fmt::format("{}: found {}, expected a finite number", keyword, Found(word)));
    return *value;
  }

  Result<glm::vec3> Color(std::string_view keyword, std::string_view& rest) const {
    glm::vec3 color(0.0f);
    for (int i = 0; i < 3; ++i) {
      const std::string_view before = rest;
      if (i > 0 && TakeWord(rest).empty()) return glm::vec3(color.r);  // one number stands for all three
      rest = before;
      const Result<float> value = Number(keyword, rest);
      if (!value) return std::unexpected(value.error());
      color[i] = std::max(*value, 0.0f);
    }
    return color;
  }

  Result<void> Statement(std::string_view keyword, std::string_view rest) {
    if (keyword == "newmtl") {
      const std::string_view name = Trimmed(rest);
      if (name.empty()) return Bad("newmtl: found nothing, expected a name");
      materials_.push_back(PlainMaterial());
      materials_.back().name = name;
      return {};
    }
    if (materials_.empty()) return Bad(fmt::format("{} before any newmtl", keyword));
    if (keyword.starts_with("map_") || keyword == "norm" || keyword == "bump" || keyword == "disp") {
      return Map(keyword, rest);
    }
    return Value(keyword, rest);
  }

  Result<void> Value(std::string_view keyword, std::string_view rest) {
    Material& m = materials_.back();
    if (keyword == "Kd" || keyword == "Ke") {
      const Result<glm::vec3> color = Color(keyword, rest);
      if (!color) return std::unexpected(color.error());
      if (keyword == "Ke") m.emissive = *color;
      if (keyword == "Kd") m.base_color = glm::vec4(*color, m.base_color.a);
      return {};
    }
    static constexpr std::string_view kNumbers[] = {"Ns", "Ni", "d", "Tr", "Pr", "Pm", "illum"};
    if (std::ranges::find(kNumbers, keyword) == std::end(kNumbers)) return {};
    const Result<float> number = Number(keyword, rest);
    if (!number) return std::unexpected(number.error());
    if (keyword == "Ns") m.roughness = RoughnessOf(*number);
    if (keyword == "Pr") m.roughness = std::clamp(*number, 0.0f, 1.0f);
    if (keyword == "Pm") m.metallic = std::clamp(*number, 0.0f, 1.0f);
    if (keyword == "Ni" && *number >= 1.0f) m.ior = *number;
    if (keyword == "illum") m.unlit = *number == 0.0f;
    if (keyword == "d" || keyword == "Tr") {
      m.base_color.a = std::clamp(keyword == "d" ? *number : 1.0f - *number, 0.0f, 1.0f);
      m.alpha_mode = m.base_color.a < 1.0f ? AlphaMode::kBlend : AlphaMode::kOpaque;
    }
    return {};
  }

  static std::string_view Trimmed(std::string_view text) {
    constexpr std::string_view kBlanks = " \t\r\v\f";
    const std::size_t begin = text.find_first_not_of(kBlanks);
    return begin == std::string_view::npos ? "" : text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
  }

  Result<void> Map(std::string_view keyword, std::string_view rest) {
    Material& m = materials_.back();
    TextureUse* const use = keyword == "map_Kd"                            ? &m.base_color_texture
                            : keyword == "map_Ke"                          ? &m.emissive_texture
                            : keyword == "norm" || keyword == "map_normal" ? &m.normal_texture
                                                                           : nullptr;
    if (use == nullptr) {
      Warn(fmt::format("{} has no place in a glTF material and is left out", keyword));
      return {};
    }
    // Options (-s 1 1 1, -bm 0.5 ...) come first; all that glTF could take of them is left out.
    std::string_view name = Trimmed(rest);
    while (name.starts_with('-')) {
      Warn(fmt::format("{}: options of maps are left out", keyword));
      (void)TakeWord(name);
      for (std::string_view after = name;
           ParseFinite(TakeWord(after)) || Trimmed(name).starts_with("on ") || Trimmed(name).starts_with("off ");
           after = name) {
        (void)TakeWord(name);
      }
      name = Trimmed(name);
    }
    if (name.empty()) return Bad(fmt::format("{}: found nothing, expected a file name", keyword));
    use->image = ImageOf(std::string(name), keyword == "map_Kd" || keyword == "map_Ke");
    // A map alone shines as it is.
    if (use == &m.emissive_texture && *use && m.emissive == glm::vec3(0.0f)) m.emissive = glm::vec3(1.0f);
    return {};
  }

  /// The picture's index in scene.images, or kNone with a warning.
  int ImageOf(const std::string& name, bool is_color) {
    const auto [found, is_new] = images_.try_emplace({name, is_color}, kNone);
    if (!is_new) return found->second;
    if (!decode_) {
      scene_.images.emplace_back();
      return found->second = static_cast<int>(scene_.images.size()) - 1;
    }
    Result<image::Image> picture = Decode(name);
    if (!picture) {
      Warn(fmt::format("{}: {}; the material goes without it", name, picture.error().message));
      return kNone;
    }
    if (!is_color) picture->encoding = image::Encoding::kData;
    scene_.images.push_back(*std::move(picture));
    return found->second = static_cast<int>(scene_.images.size()) - 1;
  }

  [[nodiscard]] Result<image::Image> Decode(const std::string& name) const {
    std::string uri;
    for (const char c : name) uri += c == '%' ? std::string("%25") : std::string(1, c);
    const Result<std::string> file = folder_.Resolve(uri);
    if (!file) return std::unexpected(file.error());
    const Result<std::vector<std::byte>> bytes = ReadRegularFile(*file, kMostImageBytes);
    if (!bytes) return std::unexpected(bytes.error());
    return decode_(*bytes, name);
  }

  std::string path_;
  SceneFolder folder_;
  const ImageDecoder& decode_;
  Scene& scene_;
  std::vector<Material> materials_;
  std::map<std::pair<std::string, bool>, int> images_;
  int line_ = 0;
};

}  // namespace

Material PlainMaterial() {
  Material plain;
  plain.base_color = glm::vec4(glm::vec3(kPlainReflectance), 1.0f);
  plain.metallic = 0.0f;
  plain.roughness = kPlainRoughness;
  return plain;
}

Result<std::vector<Material>> ReadMtl(const std::string& path, const ImageDecoder& decode, Scene& scene) {
  return MtlReader(path, decode, scene).Read();
}

}  // namespace burin::scene
