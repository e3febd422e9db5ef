// SPDX-License-Identifier: Apache-2.0
#pragma once
// A scene as plain data: glTF 2.0's model with accessors resolved to arrays, indices checked. No GL.

#include <array>
#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry/bezier_patches.h"
#include "core/image/image.h"

namespace burin::scene {

inline constexpr int kNone = -1;

enum class PrimitiveMode : std::uint8_t { kPoints, kLines, kTriangles };

/// One drawable piece of a mesh. Strips, fans and loops are turned into lists when read; without indices in the file
/// the indices are 0..n-1. Every array is empty or has one entry a vertex.
struct Primitive {
  PrimitiveMode mode = PrimitiveMode::kTriangles;
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;   ///< triangles: always there (flat ones made when the file has none)
  std::vector<glm::vec4> tangents;  ///< xyz and handedness; made when a normal map needs them and the file has none
  std::array<std::vector<glm::vec2>, 2> texcoords;
  std::vector<glm::vec4> colors;
  /// Up to 8 joints a vertex: set 0 and set 1.
  std::array<std::vector<glm::u16vec4>, 2> joints;
  std::array<std::vector<glm::vec4>, 2> weights;
  std::vector<std::uint32_t> indices;  ///< 2 a line, 3 a triangle, 1 a point; all < positions.size()
  int material = kNone;                ///< kNone: the default material
  /// Normals were made: each triangle has vertices of its own and its plane's normal, also when deformed.
  bool flat_normals = false;
  bool has_made_normals = false;  ///< the file has none; also of flat ones
  struct MorphTarget {
    std::vector<glm::vec3> positions, normals, tangents;  ///< displacements; empty or one a vertex
  };
  std::vector<MorphTarget> targets;
  /// The curved surface that the triangles stand for, if the file holds one: it is drawn in their place unless
  /// tessellation is off. Triangles only, neither skinned nor morphed.
  std::shared_ptr<const geometry::BezierPatches> patches;
};

struct Mesh {
  std::string name;
  std::vector<Primitive> primitives;
  std::vector<float> weights;  ///< default morph weights, one a target
};

struct Transform {
  glm::vec3 translation{0.0f};
  glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f};
  glm::vec3 scale{1.0f};
};

struct Node {
  std::string name;
  int parent = kNone;
  std::vector<int> children;
  Transform transform;
  std::optional<glm::mat4> matrix;  ///< instead of the transform; such a node is not animated
  int mesh = kNone;
  int skin = kNone;
  int camera = kNone;
  int light = kNone;
  std::vector<float> weights;  ///< overrides the mesh's
};

struct Skin {
  std::string name;
  std::vector<int> joints;                       ///< node indices
  std::vector<glm::mat4> inverse_bind_matrices;  ///< one a joint
};

enum class Interpolation : std::uint8_t { kStep, kLinear, kCubicSpline };
enum class AnimationPath : std::uint8_t { kTranslation, kRotation, kScale, kWeights };

struct AnimationChannel {
  int node = kNone;
  AnimationPath path = AnimationPath::kTranslation;
  Interpolation interpolation = Interpolation::kLinear;
  int components = 3;         ///< floats a key: 3, 4 or the number of morph targets
  std::vector<float> times;   ///< seconds, strictly increasing
  std::vector<float> values;  ///< times.size() * components, three times that for cubic splines
};

struct Animation {
  std::string name;
  std::vector<AnimationChannel> channels;
  float duration_s = 0.0f;  ///< the last key of any channel
};

struct Camera {
  std::string name;
  bool orthographic = false;
  float yfov_rad = 0.8f;
  std::optional<float> aspect_ratio;  ///< the frame's when absent
  float xmag = 1.0f, ymag = 1.0f;
  float znear = 0.1f;
  std::optional<float> zfar;  ///< absent: infinite
};

enum class LightType : std::uint8_t { kDirectional, kPoint, kSpot };

struct Light {
  std::string name;
  LightType type = LightType::kDirectional;
  glm::vec3 color{1.0f};       ///< linear
  float intensity = 1.0f;      ///< lux (directional) or candela
  std::optional<float> range;  ///< metres
  float inner_cone_rad = 0.0f;
  float outer_cone_rad = 0.7853982f;
};

enum class Wrap : std::uint8_t { kRepeat, kClampToEdge, kMirroredRepeat };
enum class Filter : std::uint8_t { kNearest, kLinear };

struct TextureSampler {
  Wrap wrap_s = Wrap::kRepeat, wrap_t = Wrap::kRepeat;
  Filter mag = Filter::kLinear, min = Filter::kLinear;
  bool mipmaps = true;
  Filter mip = Filter::kLinear;
};

/// A texture as a material uses it. uv' = uv_transform * (u, v, 1) of KHR_texture_transform.
struct TextureUse {
  int image = kNone;  ///< index in Scene::images; kNone: not textured
  TextureSampler sampler;
  int texcoord = 0;  ///< 0 or 1
  glm::mat3 uv_transform{1.0f};
  explicit operator bool() const { return image != kNone; }
};

enum class AlphaMode : std::uint8_t { kOpaque, kMask, kBlend };

struct Material {
  std::string name;
  glm::vec4 base_color{1.0f};
  TextureUse base_color_texture;
  float metallic = 1.0f;
  float roughness = 1.0f;
  TextureUse metallic_roughness_texture;
  TextureUse normal_texture;
  float normal_scale = 1.0f;
  TextureUse occlusion_texture;
  float occlusion_strength = 1.0f;
  glm::vec3 emissive{0.0f};  ///< with KHR_materials_emissive_strength multiplied in
  TextureUse emissive_texture;
  AlphaMode alpha_mode = AlphaMode::kOpaque;
  float alpha_cutoff = 0.5f;
  bool double_sided = false;
  bool unlit = false;
  float ior = 1.5f;
  /// extras.translucency: a medium, in the words of core/translucency/medium_spec.h; empty: none.
  std::string translucency;
  float diffuse_transmission = 0.0f;  ///< KHR_materials_diffuse_transmission
  glm::vec3 diffuse_transmission_color{1.0f};
  glm::vec3 attenuation_color{1.0f};                                    ///< KHR_materials_volume
  float attenuation_distance = std::numeric_limits<float>::infinity();  ///< scene units
};

struct Scene {
  std::string path;
  std::string name;
  std::vector<Mesh> meshes;
  std::vector<Node> nodes;  ///< a forest: each node has at most one parent, no cycles
  std::vector<int> roots;   ///< of the scene that is shown
  std::vector<Skin> skins;
  std::vector<Animation> animations;
  std::vector<Camera> cameras;
  std::vector<Light> lights;
  std::vector<Material> materials;
  std::vector<image::Image> images;   ///< decoded, only those that a material uses (others have width 0)
  std::vector<std::string> warnings;  ///< said once each: ignored optional extensions and the like
};

}  // namespace burin::scene
