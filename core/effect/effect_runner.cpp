// SPDX-License-Identifier: Apache-2.0
#include "core/effect/effect_runner.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "core/effect/light_view.h"
#include "core/effect/object_technique.h"
#include "core/effect/offscreen.h"
#include "core/effect/parameter_override.h"
#include "core/effect/parameter_range.h"
#include "core/effect/parameter_values.h"
#include "core/effect/pass_program.h"
#include "core/effect/pass_step.h"
#include "core/effect/procedural_texture.h"
#include "core/effect/schedule.h"
#include "core/effect/step_programs.h"
#include "core/effect/target_format.h"
#include "core/effect/target_step.h"
#include "core/effect/technique_choice.h"
#include "core/effect/text.h"
#include "core/effect/texture_store.h"
#include "core/gl/fullscreen_quad.h"
#include "core/gl/state.h"
#include "core/gl/vertex_layout.h"

namespace burin::effect {
namespace {

// The same frame through a light's eye.
FrameContext SeenFromLight(const FrameContext& context, std::size_t light) {
  const LightView view = LightViewOf(context, light);
  FrameContext seen = context;
  seen.view_from_world = view.view_from_world;
  seen.clip_from_view = view.clip_from_view;
  seen.eye_world = view.eye_world;
  return seen;
}

class Runner final : public EffectRunner {
 public:
  [[nodiscard]] static Result<std::unique_ptr<Runner>> Create(std::shared_ptr<const fx::Effect> effect,
                                                              const RunnerOptions& options, TechniqueChoice choice,
                                                              Schedule schedule, std::vector<StepPrograms> programs);

  const std::vector<AttributeTarget>& attributes() const override { return attributes_; }
  const TechniqueChoice& choice() const override { return choice_; }
  image::Encoding frame_encoding() const override { return frame_encoding_; }
  bool needs_scene() const override {
    if (std::any_of(offscreen_.begin(), offscreen_.end(), [](const auto& o) { return o.second->needs_scene(); }))
      return true;
    return std::any_of(schedule_.steps.begin(), schedule_.steps.end(), [](const Step& s) { return s.draws_scene; });
  }
  const std::vector<std::string>& warnings() const override { return warnings_; }
  Result<const gl::Texture*> Run(const FrameContext& context, const SceneDraws& scene) override;

 private:
  Runner(std::shared_ptr<const fx::Effect> effect, TechniqueChoice choice, Schedule schedule)
      : effect_(std::move(effect)), choice_(std::move(choice)), schedule_(std::move(schedule)) {}
  Result<void> CreateTextures(const RunnerOptions& options);
  Result<void> CreateSteps(std::vector<StepPrograms> programs);
  [[nodiscard]] bool LooksAtSource() const;
  void CreateOffscreen(const RunnerOptions& options);
  [[nodiscard]] Result<std::unique_ptr<EffectRunner>> CreateOffscreenRunner(const RunnerOptions& options,
                                                                            std::size_t index,
                                                                            const std::string& file) const;
  void ListAttributes();
  Result<void> RunOffscreen(const FrameContext& context, const SceneDraws& scene);
  void ClearAtStart();
  Result<void> RunStep(std::size_t index, const FrameContext& context);
  Result<void> DrawScene(PassStep& step, const FrameContext& context);
  void DrawQuad(const PassStep& step);
  [[nodiscard]] std::uint32_t MaterialTexture(const PassStep& step, const SceneDraw& draw, TextureMeaning meaning,
                                              bool is_decoded) const;
  [[nodiscard]] bool IsFor(const PassStep& step, const SceneDraw& draw) const;
  [[nodiscard]] std::uint32_t Environment() const { return environment_ ? environment_() : 0u; }

  std::shared_ptr<const fx::Effect> effect_;
  TechniqueChoice choice_;
  Schedule schedule_;
  image::Encoding frame_encoding_ = image::Encoding::kDisplay;
  std::vector<AttributeTarget> attributes_;
  std::vector<std::string> warnings_;
  gl::FullscreenQuad quad_;
  gl::Texture frame_;
  std::array<float, 4> clear_color_{};
  gl::TextureHandle frame_srgb_;
  std::optional<TextureStore> textures_;
  std::optional<ParameterValues> values_;
  std::vector<std::variant<PassStep, TargetStep>> steps_;  ///< one for each of the schedule's
  gl::Texture source_;                                     ///< what ScriptExternal draws; a caller fills it
  /// Effects that draw into offscreen targets, by the target's index in Effect::textures.
  std::vector<std::pair<std::size_t, std::unique_ptr<EffectRunner>>> offscreen_;
  std::function<std::uint32_t()> environment_;
  gl::FramebufferHandle scratch_framebuffer_;
  std::vector<SceneDraw> draws_;
};

Result<std::unique_ptr<Runner>> Runner::Create(std::shared_ptr<const fx::Effect> effect, const RunnerOptions& options,
                                               TechniqueChoice choice, Schedule schedule,
                                               std::vector<StepPrograms> programs) {
  std::unique_ptr<Runner> runner(new Runner(std::move(effect), std::move(choice), std::move(schedule)));
  if (auto made = runner->CreateTextures(options); !made) return std::unexpected(made.error());
  if (auto made = runner->CreateSteps(std::move(programs)); !made) return std::unexpected(made.error());
  runner->ListAttributes();
  runner->CreateOffscreen(options);
  auto quad = gl::FullscreenQuad::Create();
  if (!quad) return std::unexpected(quad.error());
  runner->quad_ = std::move(*quad);
  return runner;
}

Result<void> Runner::CreateTextures(const RunnerOptions& options) {
  auto overrides = ParseOverrides(*effect_, options.parameters);
  if (!overrides) return std::unexpected(overrides.error());
  warnings_ = RangeWarnings(*effect_, *overrides);
  auto textures = TextureStore::Create(*effect_, schedule_, *overrides, options, warnings_);
  if (!textures) return std::unexpected(textures.error());
  textures_ = std::move(*textures);
  values_.emplace(*effect_, *overrides, schedule_.texture_sizes, warnings_);
  for (const std::size_t index : schedule_.procedural) {
    auto filled = FillProceduralTexture(*effect_, index, *values_);
    if (!filled) return std::unexpected(filled.error());
    textures_->SetProcedural(index, *std::move(filled));
  }

  frame_encoding_ = FrameEncoding(*effect_, choice_.technique);
  const gl::Format& format =
      frame_encoding_ == image::Encoding::kDisplay ? options.display_frame_format : options.linear_frame_format;
  auto frame =
      gl::Texture::Create(format, options.width, options.height, 1, fmt::format("{}: the frame", effect_->path));
  if (!frame) return std::unexpected(frame.error());
  frame_ = std::move(*frame);
  environment_ = options.environment;
  clear_color_ = options.clear_color;
  schedule_.copies_source |= options.has_source && LooksAtSource();
  if (schedule_.copies_source) {
    auto source =
        gl::Texture::Create(format, options.width, options.height, 1, fmt::format("{}: the source", effect_->path));
    if (!source) return std::unexpected(source.error());
    source_ = std::move(*source);
  }
  if (schedule_.replaces_scene) {
    warnings_.push_back(fmt::format(
        "{}: it draws the geometry of a scene; the source is none, so the picture stands in", effect_->path));
  }
  if (schedule_.is_cut) {
    warnings_.push_back(fmt::format("{}: the script of technique '{}' runs more than {} steps: the rest is left out",
                                    effect_->path, effect_->techniques[choice_.technique].name, kMaxSteps));
  }
  if (schedule_.clears_frame_at_start) {
    warnings_.push_back(fmt::format("{}: no pass of technique '{}' draws into the frame, which stays empty",
                                    effect_->path, effect_->techniques[choice_.technique].name));
  }
  GLuint scratch = 0;
  glCreateFramebuffers(1, &scratch);
  scratch_framebuffer_ = gl::FramebufferHandle(scratch);
  return {};
}

Result<void> Runner::CreateSteps(std::vector<StepPrograms> programs) {
  const FrameTexture frame{.texture = &frame_, .srgb = &frame_srgb_, .clear_color = clear_color_};
  const auto lookup = [this](std::size_t parameter) -> const fx::Value& { return values_->value(parameter); };
  for (std::size_t i = 0; i < schedule_.steps.size(); ++i) {
    const Step& step = schedule_.steps[i];
    if (step.kind != Step::Kind::kPass) {
      auto made = TargetStep::Create(*effect_, step, frame, *textures_);
      if (!made) return std::unexpected(made.error());
      steps_.emplace_back(std::move(*made));
      continue;
    }
    auto made = PassStep::Create(*effect_, step, std::move(programs[i]), frame, *textures_, lookup, warnings_);
    if (!made) return std::unexpected(made.error());
    steps_.emplace_back(std::move(*made));
  }
  return {};
}

// Whether a texture without a file, looked up over the quadrilateral, stands for the source's picture.
bool Runner::LooksAtSource() const {
  return std::any_of(schedule_.steps.begin(), schedule_.steps.end(), [&](const Step& step) {
    if (step.kind != Step::Kind::kPass || !step.shows_source) return false;
    const auto samplers = fx::SamplersOf(effect_->techniques[step.technique].passes[step.pass]);
    return std::any_of(samplers.begin(), samplers.end(), [&](std::size_t sampler) {
      return textures_->HostMeaning(effect_->samplers[sampler]) == TextureMeaning::kBaseColor;
    });
  });
}

void Runner::ListAttributes() {
  const auto annotated = AnnotatedEncoding(effect_->techniques[choice_.technique]);
  for (const std::size_t index : schedule_.attributes) {
    const fx::Texture& texture = effect_->textures[index];
    const auto natural = fx::Info(texture.format).is_float ? image::Encoding::kSceneLinear : image::Encoding::kDisplay;
    attributes_.push_back({.attribute = std::get<fx::AttributeRole>(texture.role).attribute,
                           .texture = textures_->texture(index),
                           .encoding = annotated.value_or(natural)});
  }
  if (schedule_.copies_source)
    attributes_.push_back({.attribute = "color", .texture = &source_, .encoding = frame_encoding_});
}

// What is drawn into offscreen targets: nothing, the source as it is, or the scene by an effect of its own.
void Runner::CreateOffscreen(const RunnerOptions& options) {
  for (const std::size_t index : schedule_.offscreen) {
    OffscreenContent content = ContentOf(effect_->textures[index]);
    const bool is_effect = content.kind == OffscreenContent::Kind::kEffect;
    if (is_effect && options.has_scene && options.open_effect) {
      auto runner = CreateOffscreenRunner(options, index, content.file);
      if (runner) {
        for (const AttributeTarget& target : (*runner)->attributes()) attributes_.push_back(target);
        for (const std::string& warning : (*runner)->warnings()) warnings_.push_back(warning);
        offscreen_.emplace_back(index, *std::move(runner));
        continue;
      }
      warnings_.push_back(fmt::format("{}: offscreen target '{}' shows the scene as it is: {}", effect_->path,
                                      effect_->textures[index].name, runner.error().message));
    }
    if (content.kind == OffscreenContent::Kind::kNothing || (is_effect && !options.has_scene)) {
      schedule_.cleared_at_start.push_back(index);
      continue;
    }
    attributes_.push_back(
        {.attribute = "color", .texture = textures_->texture(index), .encoding = image::Encoding::kDisplay});
  }
}

Result<std::unique_ptr<EffectRunner>> Runner::CreateOffscreenRunner(const RunnerOptions& options, std::size_t index,
                                                                    const std::string& file) const {
  auto effect = options.open_effect(file);
  if (!effect) return std::unexpected(effect.error());
  const fx::Texture& target = effect_->textures[index];
  RunnerOptions own = options;
  own.technique.clear();
  own.parameters.clear();
  own.open_effect = nullptr;
  own.width = textures_->texture(index)->width();
  own.height = textures_->texture(index)->height();
  own.display_frame_format = own.linear_frame_format = TargetFormat(target.format);
  own.clear_color = ClearColor(target);
  return EffectRunner::Create(*std::move(effect), own);
}

Result<void> Runner::RunOffscreen(const FrameContext& context, const SceneDraws& scene) {
  for (const auto& [index, runner] : offscreen_) {
    const gl::Texture& target = *textures_->texture(index);
    FrameContext own = context;
    own.width = target.width();
    own.height = target.height();
    const auto frame = runner->Run(own, scene);
    if (!frame) return std::unexpected(frame.error());
    glCopyImageSubData((*frame)->id(), GL_TEXTURE_2D, 0, 0, 0, 0, target.id(), GL_TEXTURE_2D, 0, 0, 0, 0,
                       target.width(), target.height(), 1);
  }
  return {};
}

void Runner::ClearAtStart() {
  const auto clear = [this](const gl::Texture& texture, const std::array<float, 4>& color) {
    glNamedFramebufferTexture(scratch_framebuffer_.id(), GL_COLOR_ATTACHMENT0, texture.id(), 0);
    glClearNamedFramebufferfv(scratch_framebuffer_.id(), GL_COLOR, 0, color.data());
  };
  for (const std::size_t index : schedule_.cleared_at_start) {
    if (const gl::Texture* texture = textures_->texture(index)) {
      clear(*texture, ClearColor(effect_->textures[index]));
    }
  }
  if (schedule_.clears_frame_at_start) clear(frame_, clear_color_);
}

// An object without a texture has one of its colour, unless the effect gets that by a parameter too.
std::uint32_t Runner::MaterialTexture(const PassStep& step, const SceneDraw& draw, TextureMeaning meaning,
                                      bool is_decoded) const {
  const std::uint32_t texture = draw.texture ? draw.texture(meaning, is_decoded) : 0u;
  if (texture != 0 || meaning != TextureMeaning::kBaseColor || values_->has_material_color() || step.lights_material())
    return texture;
  std::array<std::uint8_t, 4> color{};
  for (int i = 0; i < 4; ++i) {
    color[static_cast<std::size_t>(i)] =
        static_cast<std::uint8_t>(std::lround(std::clamp(draw.material.diffuse[i], 0.0f, 1.0f) * 255.0f));
  }
  return textures_->stand_ins().Plain(color);
}

// Whether the object is drawn by the step's technique, where objects choose among several.
bool Runner::IsFor(const PassStep& step, const SceneDraw& draw) const {
  if (choice_.by_object.empty() || !effect_->techniques[step.technique()].custom_attribute.empty()) return true;
  const auto chosen = std::find_if(choice_.by_object.begin(), choice_.by_object.end(), [&](std::size_t technique) {
    return Draws(effect_->techniques[technique], draw.material);
  });
  return chosen != choice_.by_object.end() && *chosen == step.technique();
}

Result<void> Runner::DrawScene(PassStep& step, const FrameContext& context) {
  FrameContext object = context;
  const auto lookup = [this](std::size_t parameter) -> const fx::Value& { return values_->value(parameter); };
  for (const SceneDraw& draw : draws_) {
    if (!IsFor(step, draw)) continue;
    object.world_from_object = draw.world_from_object;
    object.material = draw.material;
    values_->SetObject(object);
    step.UpdateObject(*effect_, *values_, object, lookup);
    // Models wind their front faces counter-clockwise, and a mirroring matrix turns them round; effects of Direct3D
    // expect clockwise ones.
    step.SetFrontFace(glm::determinant(draw.world_from_object) < 0.0f);
    step.BindHostTextures([&](TextureMeaning meaning, bool is_decoded) {
      if (meaning == TextureMeaning::kEnvironment) return Environment();
      return IsOfMaterial(meaning) ? MaterialTexture(step, draw, meaning, is_decoded) : 0u;
    });
    draw.draw();
  }
  values_->SetObject(context);
  return {};
}

void Runner::DrawQuad(const PassStep& step) {
  step.BindHostTextures([&](TextureMeaning meaning, bool) {
    if (meaning == TextureMeaning::kEnvironment) return Environment();
    return meaning == TextureMeaning::kBaseColor && step.shows_source() && source_ ? source_.id() : 0u;
  });
  // A quadrilateral that faces the eye, for shaders that were meant for models.
  glVertexAttrib4f(gl::kLocationNormal, 0.0f, 0.0f, 1.0f, 1.0f);
  glVertexAttrib4f(gl::kLocationTangent, 1.0f, 0.0f, 0.0f, 1.0f);
  for (const GLuint location : {gl::kLocationColor0, gl::kLocationColor1})
    glVertexAttrib4f(location, 1.0f, 1.0f, 1.0f, 1.0f);
  quad_.Draw();
}

Result<const gl::Texture*> Runner::Run(const FrameContext& context, const SceneDraws& scene) {
  if (auto drawn = RunOffscreen(context, scene); !drawn) return std::unexpected(drawn.error());
  gl::ResetState();
  values_->SetFrame(context);
  draws_.clear();
  if (needs_scene() && scene) {
    auto draws = scene();
    if (!draws) return std::unexpected(draws.error());
    draws_ = std::move(*draws);
  }
  ClearAtStart();
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    if (auto run = RunStep(i, context); !run) return std::unexpected(run.error());
  }
  gl::ResetState();
  return &frame_;
}

Result<void> Runner::RunStep(std::size_t index, const FrameContext& context) {
  for (const LoopTurn& turn : schedule_.steps[index].loop_turns) values_->Set(turn.parameter, turn.number);
  if (auto* target = std::get_if<TargetStep>(&steps_[index])) {
    target->Run(*values_, source_);
    return {};
  }
  auto& step = std::get<PassStep>(steps_[index]);
  const auto viewer = LightOf(LowerCase(schedule_.steps[index].viewer));
  const FrameContext seen = viewer ? SeenFromLight(context, *viewer) : context;
  if (viewer) values_->SetFrame(seen);
  const auto lookup = [this](std::size_t parameter) -> const fx::Value& { return values_->value(parameter); };
  if (auto bound = step.Begin(*effect_, *textures_, *values_, lookup, warnings_); !bound) return bound;
  if (step.draws_scene()) {
    if (auto drawn = DrawScene(step, seen); !drawn) return drawn;
  } else {
    step.UpdateObject(*effect_, *values_, seen, lookup);
    DrawQuad(step);
  }
  step.End();
  if (viewer) values_->SetFrame(context);
  return {};
}

// A picture is an object with a texture.
void ChooseForPicture(const fx::Effect& effect, TechniqueChoice& choice) {
  const MaterialContext picture{.has_texture = true};
  for (const std::size_t technique : choice.by_object) {
    if (effect.techniques[technique].passes.empty() || !Draws(effect.techniques[technique], picture)) continue;
    choice.technique = technique;
    return;
  }
}

// Where no scene is there, the picture stands in for its objects: a quadrilateral that shows it. Not for attributes of
// the extension's, which are what a scene is.
void AdaptToSource(const fx::Effect& effect, const RunnerOptions& options, Schedule& schedule) {
  for (Step& step : schedule.steps) {
    const bool is_custom = !effect.techniques[step.technique].custom_attribute.empty();
    if (step.draws_scene && !is_custom && !effect.uses_extension && !options.has_scene && options.has_source) {
      step.draws_scene = false;
      step.shows_source = true;
      schedule.replaces_scene = true;
    }
    step.shows_source &= options.has_source;
  }
}

}  // namespace

Result<std::unique_ptr<EffectRunner>> EffectRunner::Create(std::shared_ptr<const fx::Effect> effect,
                                                           const RunnerOptions& options) {
  auto choice = ChooseTechnique(*effect, options.technique);
  if (!choice) return std::unexpected(choice.error());
  auto overrides = ParseOverrides(*effect, options.parameters);
  if (!overrides) return std::unexpected(overrides.error());
  if (!options.has_scene && !choice->by_object.empty()) ChooseForPicture(*effect, *choice);
  ScheduleOptions schedule_options{.has_scene = options.has_scene, .number = {}, .by_object = choice->by_object};
  schedule_options.number = [&](std::size_t parameter) {
    const auto found = overrides->parameters.find(parameter);
    const fx::Value& value =
        found != overrides->parameters.end() ? found->second : effect->parameters[parameter].default_value;
    return value.numbers.empty() ? 0.0 : value.numbers[0];
  };
  while (true) {
    Schedule schedule = MakeSchedule(*effect, choice->technique, {options.width, options.height}, schedule_options);
    AdaptToSource(*effect, options, schedule);
    auto programs = CompilePrograms(*effect, schedule);
    if (programs) {
      auto runner = Runner::Create(effect, options, *choice, std::move(schedule), std::move(*programs));
      if (!runner) return std::unexpected(runner.error());
      return runner;
    }
    if (!options.technique.empty()) return std::unexpected(programs.error());
    choice->rejected.emplace_back(effect->techniques[choice->technique].name, programs.error().message);
    if (!NextTechnique(*effect, *choice)) return std::unexpected(programs.error());
    schedule_options.by_object = choice->by_object;
  }
}

}  // namespace burin::effect
