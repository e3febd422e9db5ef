// SPDX-License-Identifier: Apache-2.0
#include "core/scene/bpt_reader.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "core/scene/mtl_file.h"
#include "core/scene/patch_primitive.h"
#include "core/scene/text_lines.h"

namespace burin::scene {
namespace {

constexpr int kMostDegree = 7;

std::unexpected<Error> Bad(std::string message) { return Fail(ErrorKind::kInput, std::move(message)); }

/// The words of a file, whatever lines they stand on.
class Words {
 public:
  explicit Words(std::string_view text) : lines_(text) {}

  /// Empty at the end.
  std::string_view Next() {
    while (true) {
      const std::string_view word = TakeWord(line_);
      if (!word.empty()) return word;
      const std::optional<std::string_view> line = lines_.Next();
      if (!line) return {};
      line_ = *line;
    }
  }
  [[nodiscard]] int line() const { return lines_.number(); }

 private:
  TextLines lines_;
  std::string_view line_;
};

Result<glm::vec3> ReadPoint(Words& words, int patch, int point, int points) {
  glm::vec3 p(0.0f);
  for (int axis = 0; axis < 3; ++axis) {
    const std::string_view word = words.Next();
    if (word.empty()) {
      return Bad(fmt::format("ends in patch {}, point {} of {}", patch, point, points));
    }
    const std::optional<float> value = ParseFinite(word);
    if (!value) {
      return Bad(fmt::format("line {}: patch {}, point {}: found {}, expected a finite number", words.line(), patch,
                             point, Found(word)));
    }
    p[axis] = *value + 0.0f;  // no -0: shared boundaries are compared by bits
  }
  return p;
}

Result<int> ReadDegree(Words& words, int patch, const char* direction) {
  const std::string_view word = words.Next();
  const std::optional<int> degree = ParseWhole(word);
  if (word.empty()) return Bad(fmt::format("ends before patch {}", patch));
  if (!degree || *degree < 1 || *degree > kMostDegree) {
    return Bad(fmt::format("line {}: patch {}: found {} as the degree in {}, expected 1 to {}", words.line(), patch,
                           Found(word), direction, kMostDegree));
  }
  return *degree;
}

Result<void> ReadPatch(Words& words, int number, geometry::BezierPatches& patches) {
  const Result<int> u_degree = ReadDegree(words, number, "u");
  if (!u_degree) return std::unexpected(u_degree.error());
  const Result<int> v_degree = ReadDegree(words, number, "v");
  if (!v_degree) return std::unexpected(v_degree.error());
  const std::size_t u_order = static_cast<std::size_t>(*u_degree) + 1,
                    v_order = static_cast<std::size_t>(*v_degree) + 1;
  geometry::BezierPatch patch;
  patch.position = {.first = static_cast<std::uint32_t>(patches.positions.size()),
                    .u_order = static_cast<std::uint8_t>(u_order),
                    .v_order = static_cast<std::uint8_t>(v_order)};
  patch.face = static_cast<std::uint32_t>(number - 1);
  patches.positions.resize(patches.positions.size() + u_order * v_order);
  glm::vec4* const net = &patches.positions[patch.position.first];
  const int points = static_cast<int>(u_order * v_order);
  int point = 0;
  for (std::size_t i = 0; i < u_order; ++i) {
    for (std::size_t j = 0; j < v_order; ++j) {
      const Result<glm::vec3> p = ReadPoint(words, number, ++point, points);
      if (!p) return std::unexpected(p.error());
      net[j * u_order + i] = glm::vec4(*p, 1.0f);
    }
  }
  patches.patches.push_back(patch);
  return {};
}

Result<geometry::BezierPatches> Parse(std::string_view text) {
  Words words(text);
  const std::string_view word = words.Next();
  const std::optional<int> count = ParseWhole(word);
  if (!count || *count < 1) {
    return Bad(fmt::format("line {}: found {}, expected the number of patches", words.line(), Found(word)));
  }
  geometry::BezierPatches patches;
  for (int number = 1; number <= *count; ++number) {
    if (Result<void> read = ReadPatch(words, number, patches); !read) {
      if (read.error().message.starts_with("ends"))
        read.error().message += fmt::format("; expected {} patch{}", *count, *count == 1 ? "" : "es");
      return std::unexpected(read.error());
    }
  }
  if (const std::string_view more = words.Next(); !more.empty()) {
    return Bad(fmt::format("line {}: found {} after the last of {} patches, expected the end", words.line(),
                           Found(more), *count));
  }
  return patches;
}

Result<Scene> Read(const std::string& path, const ReadOptions& options) {
  const Result<std::string> text = ReadText(path);
  if (!text) return std::unexpected(text.error());
  Result<geometry::BezierPatches> patches = Parse(*text);
  if (!patches) return std::unexpected(patches.error());
  Scene scene;
  scene.path = path;
  const std::filesystem::path file(path);
  scene.name = file.stem().string();
  std::filesystem::path sidecar = file;
  sidecar.replace_extension(".mtl");
  if (std::error_code status; std::filesystem::is_regular_file(sidecar, status)) {
    Result<std::vector<Material>> materials = ReadMtl(sidecar.string(), options.decode_image, scene);
    if (!materials) return std::unexpected(materials.error());
    if (!materials->empty()) scene.materials = {std::move(materials->front())};
  }
  if (scene.materials.empty()) scene.materials.push_back(PlainMaterial());
  scene.materials.front().double_sided = true;  // which side is the front is nothing that the format says
  Mesh mesh{.name = scene.name, .primitives = {}, .weights = {}};
  mesh.primitives.push_back(MakePatchPrimitive(*std::move(patches), 0));
  scene.meshes.push_back(std::move(mesh));
  Node node;
  node.name = scene.name;
  node.mesh = 0;
  scene.nodes.push_back(std::move(node));
  scene.roots = {0};
  return scene;
}

}  // namespace

Result<Scene> ReadBpt(const std::string& path, const ReadOptions& options) {
  Result<Scene> scene = Read(path, options);
  if (!scene && !scene.error().message.starts_with(path)) {
    return Fail(scene.error().kind, fmt::format("{}: {}", path, scene.error().message));
  }
  return scene;
}

}  // namespace burin::scene
