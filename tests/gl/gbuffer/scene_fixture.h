// SPDX-License-Identifier: Apache-2.0
#pragma once
// Small scenes made in code, and a renderer on them. Pixel (x, y) counts from the top left.

#include <cmath>
#include <functional>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <initializer_list>
#include <optional>

#include "core/gbuffer/attribute_renderer.h"
#include "core/gl/readback.h"
#include "tests/gl/gl/context_fixture.h"

namespace burin::gbuffer {

using gl::Must;

/// A square of side 2 about the origin at z = 0, its front towards +z, u to the right and v down.
inline scene::Primitive Square(int material = scene::kNone) {
  scene::Primitive square;
  square.positions = {{-1, 1, 0}, {1, 1, 0}, {-1, -1, 0}, {1, -1, 0}};
  square.normals.assign(4, {0, 0, 1});
  square.texcoords[0] = {{0, 0}, {1, 0}, {0, 1}, {1, 1}};
  square.indices = {0, 2, 1, 1, 2, 3};
  square.material = material;
  return square;
}

/// A unit sphere with smooth normals.
inline scene::Primitive Sphere(int material = scene::kNone, int slices = 96) {
  scene::Primitive sphere;
  const int stacks = slices / 2;
  for (int i = 0; i <= stacks; ++i) {
    const float polar = glm::pi<float>() * static_cast<float>(i) / static_cast<float>(stacks);
    for (int j = 0; j <= slices; ++j) {
      const float around = 2.0f * glm::pi<float>() * static_cast<float>(j) / static_cast<float>(slices);
      sphere.positions.emplace_back(std::sin(polar) * std::cos(around), std::cos(polar),
                                    std::sin(polar) * std::sin(around));
    }
  }
  sphere.normals = sphere.positions;
  for (int i = 0; i < stacks; ++i) {
    for (int j = 0; j < slices; ++j) {
      const auto a = static_cast<std::uint32_t>(i * (slices + 1) + j);
      const auto b = a + static_cast<std::uint32_t>(slices) + 1;
      sphere.indices.insert(sphere.indices.end(), {a, a + 1, b, b, a + 1, b + 1});
    }
  }
  sphere.material = material;
  return sphere;
}

struct TestScene {
  scene::Scene scene;

  int AddMesh(scene::Primitive primitive) {
    scene::Mesh mesh;
    mesh.primitives.push_back(std::move(primitive));
    scene.meshes.push_back(std::move(mesh));
    return static_cast<int>(scene.meshes.size()) - 1;
  }
  int AddNode(int mesh, const glm::mat4& world) {
    scene::Node node;
    node.mesh = mesh;
    node.matrix = world;
    scene.nodes.push_back(std::move(node));
    scene.roots.push_back(static_cast<int>(scene.nodes.size()) - 1);
    return scene.roots.back();
  }
  int AddMaterial(const scene::Material& material) {
    scene.materials.push_back(material);
    return static_cast<int>(scene.materials.size()) - 1;
  }
  int AddLight(const scene::Light& light, const glm::mat4& world) {
    scene.lights.push_back(light);
    const int node = AddNode(scene::kNone, world);
    scene.nodes.back().light = static_cast<int>(scene.lights.size()) - 1;
    return node;
  }
};

inline glm::mat4 Translate(float x, float y, float z) { return glm::translate(glm::mat4(1.0f), glm::vec3(x, y, z)); }

inline scene::Material Unlit(const glm::vec4& color) {
  scene::Material material;
  material.base_color = color;
  material.unlit = true;
  return material;
}

/// Looks from the origin along -z.
inline scene::View Perspective(float yfov_rad, float aspect, float znear = 0.5f, float zfar = 50.0f) {
  scene::View view;
  view.clip_from_view = glm::perspectiveRH_ZO(yfov_rad, aspect, znear, zfar);
  view.znear = znear;
  view.zfar = zfar;
  return view;
}

/// Half-size 1: a Square in front of it fills the frame exactly.
inline scene::View Orthographic(float znear = 1.0f, float zfar = 9.0f) {
  scene::View view;
  view.clip_from_view = glm::orthoRH_ZO(-1.0f, 1.0f, -1.0f, 1.0f, znear, zfar);
  view.orthographic = true;
  view.znear = znear;
  view.zfar = zfar;
  return view;
}

inline gl::Format Float(int components = 4, int bits = 32) {
  return gl::PlainFormat(gl::Numeric::kFloat, bits, components);
}
inline gl::Format Unorm(int components = 4, int bits = 8) {
  return gl::PlainFormat(gl::Numeric::kUnorm, bits, components);
}

class GbufferTest : public gl::ContextTest {
 protected:
  struct Picture {
    int width = 0;
    int channels = 4;
    std::vector<float> values;
    [[nodiscard]] std::vector<float> At(int x, int y) const {
      const auto first = values.begin() + (static_cast<std::ptrdiff_t>(y) * width + x) * channels;
      return {first, first + channels};
    }
  };

  static Picture ReadPicture(const gl::Texture& texture) {
    const image::Image image = gl::Read(texture, image::SampleType::kF32, 4, image::Encoding::kData);
    const auto values = image.As<float>();
    return {.width = image.width, .channels = 4, .values = {values.begin(), values.end()}};
  }

  /// One attribute of the scene at rest; the frame is width x height.
  Picture Render(const TestScene& test, const scene::View& view, Attribute attribute, const gl::Format& format,
                 int width, int height, image::Encoding encoding = image::Encoding::kSceneLinear) {
    const gl::Texture target = Must(gl::Texture::Create(format, width, height, 1, "target"));
    const Request request{attribute, &target, encoding};
    RenderInto(test, view, std::span(&request, 1));
    return ReadPicture(target);
  }

  void RenderInto(const TestScene& test, const scene::View& view, std::span<const Request> requests) {
    const std::unique_ptr<SceneRenderer> renderer =
        Must(SceneRenderer::Create(test.scene, environment_ ? &*environment_ : nullptr));
    const scene::Pose pose = scene::EvaluatePose(test.scene, {}, 0.0);
    std::vector<scene::DrawItem> items = scene::BuildDrawItems(test.scene, pose, pose);
    if (change_items_) change_items_(items);
    FrameInput frame;
    frame.view = view;
    frame.previous_view = previous_view_.value_or(view);
    frame.pose = &pose;
    frame.items = items;
    frame.background = background_;
    frame.edges = edges_;
    const Result<void> result = renderer->Render(frame, requests);
    ASSERT_TRUE(result.has_value()) << result.error().message;
  }

  std::optional<image::Image> environment_;
  std::optional<scene::View> previous_view_;
  std::function<void(std::vector<scene::DrawItem>&)> change_items_;
  glm::vec4 background_{0.0f};
  EdgeStage* edges_ = nullptr;
};

/// An equirectangular map of one radiance.
inline image::Image UniformEnvironment(float radiance) {
  image::Image map = gl::MakeImage<float>(64, 32, 3, image::SampleType::kF32, [&](std::size_t) { return radiance; });
  map.encoding = image::Encoding::kSceneLinear;
  return map;
}

}  // namespace burin::gbuffer
