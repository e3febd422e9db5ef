// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/edge_quality/bench_scenes.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>
#include <random>
#include <span>

#include "core/image/image_module.h"
#include "core/scene/gltf_reader.h"

namespace burin::bench {
namespace {

using scene::Primitive;
using scene::Scene;

constexpr std::uint32_t kSeed = 20010319;

scene::Material Plain(const glm::vec3& color) {
  scene::Material material;
  material.base_color = glm::vec4(color, 1.0f);
  material.metallic = 0.0f;
  material.roughness = 0.6f;
  return material;
}

/// A scene of one node a primitive.
Scene SceneOf(std::vector<Primitive> primitives, std::vector<scene::Material> materials) {
  Scene scene;
  scene.materials = std::move(materials);
  for (Primitive& primitive : primitives) {
    scene::Node node;
    node.mesh = static_cast<int>(scene.meshes.size());
    scene.roots.push_back(static_cast<int>(scene.nodes.size()));
    scene.nodes.push_back(node);
    scene::Mesh mesh;
    mesh.primitives.push_back(std::move(primitive));
    scene.meshes.push_back(std::move(mesh));
  }
  return scene;
}

/// A flat polygon with vertices of its own, counter-clockwise seen from its front.
void AddPolygon(Primitive& mesh, std::span<const glm::vec3> corners, const glm::vec3& color) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const glm::vec3 normal = glm::normalize(glm::cross(corners[1] - corners[0], corners.back() - corners[0]));
  for (const glm::vec3& corner : corners) {
    mesh.positions.push_back(corner);
    mesh.normals.push_back(normal);
    mesh.colors.emplace_back(color, 1.0f);
  }
  for (std::uint32_t i = 2; i < corners.size(); ++i) {
    mesh.indices.insert(mesh.indices.end(), {first, first + i - 1, first + i});
  }
}

/// The box from -1 to 1 through `place`.
void AddBox(Primitive& mesh, const glm::mat4& place, const glm::vec3& color) {
  constexpr std::array<std::array<int, 4>, 6> kFaces = {
      {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
  for (const auto& face : kFaces) {
    std::array<glm::vec3, 4> corners;
    for (std::size_t i = 0; i < 4; ++i) {
      const int bits = face[i];
      const glm::vec4 corner((bits & 1) != 0 ? 1 : -1, (bits & 2) != 0 ? 1 : -1, (bits & 4) != 0 ? 1 : -1, 1);
      corners[i] = glm::vec3(place * corner);
    }
    AddPolygon(mesh, corners, color);
  }
}

glm::vec3 OnSphere(int stack, int slice, int stacks, int slices) {
  const float polar = glm::radians(180.0f) * static_cast<float>(stack) / static_cast<float>(stacks);
  const float around = glm::radians(360.0f) * static_cast<float>(slice) / static_cast<float>(slices);
  return {std::sin(polar) * std::cos(around), std::cos(polar), -std::sin(polar) * std::sin(around)};
}

/// The unit sphere, smooth.
Scene Sphere() {
  constexpr int kSlices = 128;
  constexpr int kStacks = kSlices / 2;
  Primitive mesh;
  for (int i = 0; i <= kStacks; ++i) {
    for (int j = 0; j <= kSlices; ++j) mesh.positions.push_back(OnSphere(i, j, kStacks, kSlices));
  }
  mesh.normals = mesh.positions;
  for (int i = 0; i < kStacks; ++i) {
    for (int j = 0; j < kSlices; ++j) {
      const auto a = static_cast<std::uint32_t>(i * (kSlices + 1) + j);
      const std::uint32_t b = a + kSlices + 1;
      if (i > 0) mesh.indices.insert(mesh.indices.end(), {a, b, a + 1});
      if (i + 1 < kStacks) mesh.indices.insert(mesh.indices.end(), {a + 1, b, b + 1});
    }
  }
  return SceneOf({std::move(mesh)}, {});
}

Scene Cube() {
  Primitive mesh;
  AddBox(mesh, glm::mat4(1.0f), {1, 1, 1});
  return SceneOf({std::move(mesh)}, {});
}

/// A dented sphere of flat triangles, each of a colour of its own: creases and colour seams everywhere, and open rims
/// at the poles.
Scene ManyColors() {
  constexpr int kSlices = 56;
  constexpr int kStacks = kSlices / 2;
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<float> channel(0.1f, 0.9f);
  std::uniform_real_distribution<float> radius(0.97f, 1.03f);
  std::vector<glm::vec3> points;
  for (int i = 0; i <= kStacks; ++i) {
    for (int j = 0; j < kSlices; ++j) points.push_back(radius(random) * OnSphere(i, j, kStacks, kSlices));
  }
  const auto at = [&](int i, int j) { return points[static_cast<std::size_t>(i * kSlices + j % kSlices)]; };
  Primitive mesh;
  for (int i = 1; i + 1 < kStacks; ++i) {
    for (int j = 0; j < kSlices; ++j) {
      for (const auto& corners : {std::array{at(i, j), at(i + 1, j), at(i, j + 1)},
                                  std::array{at(i, j + 1), at(i + 1, j), at(i + 1, j + 1)}}) {
        AddPolygon(mesh, corners, {channel(random), channel(random), channel(random)});
      }
    }
  }
  scene::Material material = Plain({1, 1, 1});
  material.double_sided = true;
  mesh.material = 0;
  return SceneOf({std::move(mesh)}, {material});
}

/// Hills as an open height field, smooth.
Scene Terrain() {
  constexpr int kCells = 96;
  const auto height = [](float x, float z) {
    return 0.32f * std::sin(5.1f * x + 0.3f) * std::cos(4.3f * z) + 0.09f * std::sin(11.0f * x - 7.0f * z);
  };
  Primitive mesh;
  for (int i = 0; i <= kCells; ++i) {
    for (int j = 0; j <= kCells; ++j) {
      const float x = 2.0f * static_cast<float>(j) / kCells - 1.0f;
      const float z = 2.0f * static_cast<float>(i) / kCells - 1.0f;
      constexpr float kStep = 1e-3f;
      mesh.positions.emplace_back(x, height(x, z), z);
      mesh.normals.push_back(glm::normalize(glm::vec3(height(x - kStep, z) - height(x + kStep, z), 2 * kStep,
                                                      height(x, z - kStep) - height(x, z + kStep))));
    }
  }
  for (int i = 0; i < kCells; ++i) {
    for (int j = 0; j < kCells; ++j) {
      const auto a = static_cast<std::uint32_t>(i * (kCells + 1) + j);
      const std::uint32_t b = a + kCells + 1;
      mesh.indices.insert(mesh.indices.end(), {a, b, a + 1, a + 1, b, b + 1});
    }
  }
  scene::Material material = Plain({0.5f, 0.7f, 0.35f});
  material.double_sided = true;
  mesh.material = 0;
  return SceneOf({std::move(mesh)}, {material});
}

/// Bars about a pixel and a half wide at 512 pixels, in many directions.
Scene ThinBars() {
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
  Primitive mesh;
  for (int i = 0; i < 60; ++i) {
    glm::mat4 place = glm::translate(glm::mat4(1.0f), 0.6f * glm::vec3(unit(random), unit(random), unit(random)));
    place = glm::rotate(place, 3.0f * unit(random), glm::normalize(glm::vec3(unit(random), unit(random), 0.1f)));
    AddBox(mesh, glm::scale(place, glm::vec3(0.8f, 0.005f, 0.005f)),
           0.5f + 0.4f * glm::vec3(unit(random), unit(random), unit(random)));
  }
  return SceneOf({std::move(mesh)}, {});
}

/// Boxes smaller than a pixel, so many that half of the frame is near an edge.
Scene SubpixelBoxes() {
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
  Primitive mesh;
  for (int i = 0; i < 14000; ++i) {
    const glm::mat4 place = glm::translate(glm::mat4(1.0f), glm::vec3(unit(random), unit(random), unit(random)));
    AddBox(mesh, glm::scale(place, glm::vec3(0.0022f)),
           0.5f + 0.4f * glm::vec3(unit(random), unit(random), unit(random)));
  }
  return SceneOf({std::move(mesh)}, {});
}

std::optional<Scene> ReadShared(const std::string& path) {
  std::error_code status;
  if (!std::filesystem::exists(path, status)) return std::nullopt;
  scene::ReadOptions options;
  options.decode_image = [](std::span<const std::byte> bytes, const std::string& name) -> Result<image::Image> {
    auto module = image::LoadImageModule();
    if (!module) return std::unexpected(module.error());
    return (*module)->ReadMemory(bytes, name);
  };
  auto scene = scene::ReadGltf(path, options);
  if (!scene) {
    fmt::print(stderr, "edge_quality: {}\n", scene.error().message);
    return std::nullopt;
  }
  return *std::move(scene);
}

/// The triangles of each primitive, shared out among five materials by where they are: long borders within one mesh.
std::optional<Scene> WithMaterials(std::optional<Scene> scene) {
  if (!scene) return scene;
  constexpr int kMaterials = 5;
  const std::array<glm::vec3, kMaterials> colors = {
      {{0.8f, 0.1f, 0.1f}, {0.1f, 0.5f, 0.8f}, {0.9f, 0.8f, 0.2f}, {0.1f, 0.1f, 0.1f}, {0.9f, 0.9f, 0.9f}}};
  scene->materials.clear();
  for (const glm::vec3& color : colors) scene->materials.push_back(Plain(color));
  for (scene::Mesh& mesh : scene->meshes) {
    std::vector<Primitive> parts;
    for (const Primitive& whole : mesh.primitives) {
      glm::vec3 low(1e30f), high(-1e30f);
      for (const glm::vec3& p : whole.positions) low = glm::min(low, p), high = glm::max(high, p);
      std::array<std::vector<std::uint32_t>, kMaterials> shares;
      for (std::size_t i = 0; i + 2 < whole.indices.size(); i += 3) {
        const glm::vec3 p = (whole.positions[whole.indices[i]] - low) / (high.y - low.y);
        const float bands = 6.0f * p.y + 1.1f * std::sin(9.0f * p.x) + 0.8f * std::sin(7.0f * p.z);
        auto& share = shares[static_cast<std::size_t>(std::floor(bands) + 10 * kMaterials) % kMaterials];
        share.insert(share.end(), whole.indices.begin() + static_cast<std::ptrdiff_t>(i),
                     whole.indices.begin() + static_cast<std::ptrdiff_t>(i) + 3);
      }
      for (int m = 0; m < kMaterials; ++m) {
        Primitive part = whole;
        part.material = m;
        part.indices = std::move(shares[static_cast<std::size_t>(m)]);
        if (!part.indices.empty()) parts.push_back(std::move(part));
      }
    }
    mesh.primitives = std::move(parts);
  }
  return scene;
}

}  // namespace

std::vector<BenchScene> BenchScenes(const std::string& shared_data) {
  const auto file = [&](const std::string& name) {
    return [path = shared_data + "/" + name] { return ReadShared(path); };
  };
  return {
      {"cube", true, [] { return Cube(); }},
      {"spot", true, file("mesh/spot.glb")},
      {"spot 94k", true, file("mesh/spot_loop2.glb")},
      {"spot 375k", true, file("mesh/spot_loop3.glb")},
      {"sphere", true, [] { return Sphere(); }},
      {"many colours", false, [] { return ManyColors(); }},
      {"open terrain", false, [] { return Terrain(); }},
      {"94k + materials", false, [read = file("mesh/spot_loop2.glb")] { return WithMaterials(read()); }},
      {"thin bars", false, [] { return ThinBars(); }},
      {"subpixel boxes", false, [] { return SubpixelBoxes(); }},
      {"Fox", false, file("gltf/Fox.glb")},
      {"CesiumMan", false, file("gltf/CesiumMan.glb")},
      {"BoomBox", false, file("gltf/BoomBox/BoomBox.gltf")},
  };
}

Scene HalfPlane(double angle_rad, double offset) {
  const auto c = static_cast<float>(std::cos(angle_rad));
  const auto s = static_cast<float>(std::sin(angle_rad));
  const glm::vec3 along(c, s, 0), down(s, -c, 0);
  const glm::vec3 on_line = -static_cast<float>(offset) * down;
  constexpr float kFar = 8.0f;
  Primitive mesh;
  const std::array<glm::vec3, 4> corners = {on_line + kFar * (down - along), on_line + kFar * (down + along),
                                            on_line + kFar * along, on_line - kFar * along};
  AddPolygon(mesh, corners, {1, 1, 1});
  mesh.material = 0;
  scene::Material white = Plain({1, 1, 1});
  white.unlit = true;
  return SceneOf({std::move(mesh)}, {white});
}

}  // namespace burin::bench
