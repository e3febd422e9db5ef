// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <memory>
#include <span>
#include <vector>

#include "core/base/error.h"
#include "core/gbuffer/attribute_table.h"
#include "core/gl/texture.h"
#include "core/image/image.h"
#include "core/scene/camera.h"
#include "core/scene/pose.h"
#include "core/scene/scene.h"

namespace burin::gbuffer {

/// One attribute to fill. Colour in a kSceneLinear target has associated (premultiplied) alpha, as EXR; in a kDisplay
/// target it is encoded by the sRGB transfer function with unassociated alpha, as PNG. Other display transforms are the
/// caller's: it asks for kSceneLinear in a float target and converts. Signed attributes are stored as 0.5x + 0.5 in
/// kUnorm targets. Ids in kUnorm targets: n / (2^bits - 1) in one component; in several, n's digits to that base, least
/// significant first in r.
struct Request {
  Attribute attribute = Attribute::kColor;
  const gl::Texture* target = nullptr;  ///< its size is the size that is rendered (supersampling: larger)
  image::Encoding encoding = image::Encoding::kSceneLinear;  ///< of colour attributes
};

struct FrameInput;

/// Points along an edge of a face that are to be shaded as the face is, evenly spaced in the picture.
struct FaceEdge {
  std::uint32_t item = 0;                   ///< index in FrameInput::items
  std::array<std::uint32_t, 3> vertices{};  ///< of its primitive: the edge's ends, and the face's third corner
  bool is_back = false;                     ///< the face's back is seen
  std::uint32_t points = 1;                 ///< from the first end to the last of the range; one: its middle
  /// What of the edge they lie on: 0 is its first end, 1 its second, in between as clip space has it; and clip space's
  /// w there, above 0.
  glm::vec2 range{0.0f, 1.0f};
  glm::vec2 w{1.0f};
};

/// The scene-linear colours, with associated alpha, of every edge's points: a texture for FaceColorFunctions
/// (face_color_table.h), valid until the next call, and the place of each edge's first point in `first`.
using FaceShader =
    std::function<Result<const gl::Texture*>(std::span<const FaceEdge> edges, std::vector<std::uint32_t>& first)>;

/// What is done about edges when a size's geometry is drawn: core/overdraw. Context's thread only.
class EdgeStage {
 public:
  virtual ~EdgeStage() = default;
  /// True when Antialias does anything.
  [[nodiscard]] virtual bool antialiases() const = 0;
  /// True when Antialias works on opaque surfaces alone, before blended ones are drawn over them.
  [[nodiscard]] virtual bool precedes_blended() const = 0;
  /// Works on a colour in place. `color`: one for which CanLoadColor (storage.h) holds; `depth`: what it was drawn with
  /// (GL_DEPTH32F_STENCIL8, reversed: 1 at the near plane). Leaves another framebuffer bound and other states set.
  [[nodiscard]] virtual Result<void> Antialias(const FrameInput& frame, const Request& color, const gl::Texture& depth,
                                               const FaceShader& shade) = 0;
  /// Fills targets of one size with attributes of edges.
  [[nodiscard]] virtual Result<void> Fill(const FrameInput& frame, std::span<const Request> requests,
                                          const gl::Texture& depth) = 0;
};

class TranslucencyStage;  // translucency_stage.h

/// Everything about one frame that the renderer does not keep.
struct FrameInput {
  scene::View view;
  scene::View previous_view;
  const scene::Pose* pose = nullptr;  ///< for lights
  std::span<const scene::DrawItem> items;
  glm::vec4 background{0.0f};                 ///< of `color`, scene-linear with associated alpha (--background)
  EdgeStage* edges = nullptr;                 ///< null: edges stay as they are, and attributes of edges empty
  TranslucencyStage* translucency = nullptr;  ///< null: nothing is translucent
};

/// A material's textures, in glTF's words and the order of MaterialTexture (gpu_blocks.h).
enum class MaterialTextureKind { kBaseColor, kMetallicRoughness, kNormal, kOcclusion, kEmissive };

/// Draws one item's geometry with the caller's program bound; attributes at gl::VertexLocation.
struct GeometryDraw {
  glm::mat4 world_from_object{1.0f};
  int material = scene::kNone;
  std::uint32_t vertex_array = 0;
  std::uint32_t mode = 0;  ///< GLenum
  int index_count = 0;     ///< GL_UNSIGNED_INT indices from 0
};

/// Renders G-buffer attributes of one scene. Static geometry is uploaded once; deformed vertices every frame.
class SceneRenderer {
 public:
  /// `environment`: equirectangular scene-linear RGB float image for --environment, or null for the built-in neutral
  /// one.
  [[nodiscard]] static Result<std::unique_ptr<SceneRenderer>> Create(const scene::Scene& scene,
                                                                     const image::Image* environment);
  virtual ~SceneRenderer() = default;
  /// Fills every request's target, grouped by size into as few geometry passes as draw buffers allow.
  [[nodiscard]] virtual Result<void> Render(const FrameInput& frame, std::span<const Request> requests) = 0;
  /// The frame's draws for a custom attribute's own shaders; valid until the next Render or Draws.
  [[nodiscard]] virtual Result<std::vector<GeometryDraw>> Draws(const FrameInput& frame) = 0;
  /// A material's texture with mipmaps, uploaded when it is first asked for; null: it has none. `is_decoded`: where it
  /// is display-encoded, look-ups give scene-linear light.
  [[nodiscard]] virtual Result<const gl::Texture*> TextureOf(int material, MaterialTextureKind kind,
                                                             bool is_decoded) = 0;
};

/// Fills attributes from a picture (an image, a video's frame, an earlier effect's result): `color` and `video` are the
/// picture, `intensity` and `alpha` follow from it, the others hold their background values. Sizes may differ
/// (bilinear); at one size and one format the copy is bit-exact. `picture_encoding` says what `picture` holds.
class PictureRenderer {
 public:
  [[nodiscard]] static Result<std::unique_ptr<PictureRenderer>> Create();
  virtual ~PictureRenderer() = default;
  /// True when the filled target would read exactly as `picture` does, so that the caller may use the picture instead.
  [[nodiscard]] static bool CanAlias(const gl::Texture& picture, image::Encoding picture_encoding,
                                     const Request& request);
  [[nodiscard]] virtual Result<void> Render(const gl::Texture& picture, image::Encoding picture_encoding,
                                            std::span<const Request> requests) = 0;
};

}  // namespace burin::gbuffer
