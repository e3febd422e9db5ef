// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/effect/frame_context.h"
#include "core/effect/texture_meaning.h"
#include "core/gl/texture.h"
#include "core/image/image.h"
#include "fx_parser/effect/effect.h"

namespace burin::effect {

/// An attribute that the caller fills before each Run(): render into `texture`, whose size is the scaled frame's.
struct AttributeTarget {
  std::string attribute;  ///< "color", "normal" ... (not custom ones: Run() fills those itself)
  const gl::Texture* texture = nullptr;
  image::Encoding encoding = image::Encoding::kDisplay;  ///< for colour attributes
};

/// One draw of the scene for a custom attribute's technique: set the matrices of `world_from_object`, then call `draw`.
struct SceneDraw {
  glm::mat4 world_from_object{1.0f};
  std::function<void()> draw{};  ///< binds the vertex array and draws; the program and states are the effect's
  MaterialContext material{};
  /// The GL name of one of its material's textures, mipmapped; `is_decoded`: display-encoded ones read as scene-linear.
  /// 0: it has none. Null: no material has any.
  std::function<std::uint32_t(TextureMeaning meaning, bool is_decoded)> texture{};
};
using SceneDraws = std::function<Result<std::vector<SceneDraw>>()>;

/// Compiles the effect of an offscreen target, by its name in the file.
using EffectOpener = std::function<Result<std::shared_ptr<const fx::Effect>>(const std::string& path)>;

/// Finds and decodes the file of a texture parameter; nothing when there is no such file.
using TextureLoader = std::function<Result<std::optional<image::Image>>(const std::string& path)>;

struct RunnerOptions {
  std::string technique;                                        ///< empty: the first that validates
  std::vector<std::pair<std::string, std::string>> parameters;  ///< --param NAME=VALUE
  TextureLoader load_texture;
  std::string texture_folders;  ///< where it looks, for messages
  /// The GL name of a cube map of what is all around, display-encoded; null or 0: a grey cube.
  std::function<std::uint32_t()> environment;
  EffectOpener open_effect;            ///< null: offscreen targets show the scene
  std::array<float, 4> clear_color{};  ///< of the frame
  bool has_source = false;             ///< a scene or a picture
  bool has_scene = false;              ///< the source has geometry; otherwise it is a picture
  int width = 0;                       ///< of the frame
  int height = 0;
  /// Of the frame when its colour is display-encoded / scene-linear.
  gl::Format display_frame_format;
  gl::Format linear_frame_format;
};

/// The technique that was chosen and why those before it were not.
struct TechniqueChoice {
  std::size_t technique = 0;
  std::vector<std::pair<std::string, std::string>> rejected;  ///< name, reason
  /// Where objects choose among several (ObjectTechniques()), `technique` being the first that draws; else empty.
  std::vector<std::size_t> by_object;
};

/// Chooses without GL (for `burin info` and `burin check`): kUsage for an unknown --technique, kInput when none is
/// valid.
[[nodiscard]] Result<TechniqueChoice> ChooseTechnique(const fx::Effect& effect, const std::string& wanted);

/// What colour-like values the technique's frame holds (annotation ColorSpace, else fixed-point or floating inputs).
[[nodiscard]] image::Encoding FrameEncoding(const fx::Effect& effect, std::size_t technique);

/// Whether `--param NAME=...` can mean this effect: a parameter, or a texture that takes a file. In a chain the caller
/// hands each effect only the overrides that it accepts.
[[nodiscard]] bool AcceptsParameter(const fx::Effect& effect, const std::string& name);

/// Runs one effect at one frame size: owns its programs, targets and frame.
class EffectRunner {
 public:
  [[nodiscard]] static Result<std::unique_ptr<EffectRunner>> Create(std::shared_ptr<const fx::Effect> effect,
                                                                    const RunnerOptions& options);
  virtual ~EffectRunner() = default;
  [[nodiscard]] virtual const std::vector<AttributeTarget>& attributes() const = 0;
  [[nodiscard]] virtual const TechniqueChoice& choice() const = 0;
  [[nodiscard]] virtual image::Encoding frame_encoding() const = 0;
  /// True when a custom attribute or a pass draws the scene's geometry: Run() then needs `scene`.
  [[nodiscard]] virtual bool needs_scene() const = 0;
  /// Runs custom attributes and all passes; the result is the frame's texture, valid until the next Run().
  [[nodiscard]] virtual Result<const gl::Texture*> Run(const FrameContext& context, const SceneDraws& scene) = 0;
  /// Said once each: ignored states, stand-in textures, unknown semantics.
  [[nodiscard]] virtual const std::vector<std::string>& warnings() const = 0;
};

}  // namespace burin::effect
