// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/edge_quality/stand.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <glm/gtc/matrix_transform.hpp>

#include "core/gl/readback.h"
#include "core/gl/state.h"

namespace burin::bench {
namespace {

constexpr std::string_view kVertex = R"(#version 450 core
layout(location = 0) in vec4 position;
void main() { gl_Position = position; }
)";
constexpr std::string_view kFragment = R"(#version 450 core
layout(binding = 0) uniform sampler2D picture;
layout(location = 0) out vec4 color;
void main() { color = texelFetch(picture, ivec2(gl_FragCoord.xy), 0); }
)";

constexpr glm::dvec2 kRollPivot(-0.5, -0.4);  // x and y of clip space

[[noreturn]] void Die(const std::string& message) {
  fmt::print(stderr, "edge_quality: {}\n", message);
  std::exit(1);
}

void Check(const Result<void>& result) {
  if (!result) Die(result.error().message);
}

template <class T>
T Take(Result<T> result) {
  if (!result) Die(result.error().message);
  return std::move(*result);
}

gl::Format FloatRgba() { return gl::PlainFormat(gl::Numeric::kFloat, 32, 4); }

std::vector<float> ReadRgb(const gl::Texture& texture) {
  const image::Image image = gl::Read(texture, image::SampleType::kF32, 3, image::Encoding::kData);
  const auto samples = image.As<float>();
  return {samples.begin(), samples.end()};
}

Place Shifted(Place place, const glm::dvec2& by) {
  place.shift += by;
  return place;
}

}  // namespace

Mean::Mean(int width, int height)
    : sum_(Take(gl::Texture::Create(FloatRgba(), width, height, 1, "sum"))),
      program_(Take(gl::Program::Create(kVertex, kFragment, "add"))),
      quad_(Take(gl::FullscreenQuad::Create())) {
  const std::array<const gl::Texture*, 1> targets = {&sum_};
  framebuffer_ = Take(gl::Framebuffer::Create(targets, nullptr, "sum"));
  Clear();
}

void Mean::Clear() {
  constexpr std::array<float, 4> kZero{};
  glClearTexImage(sum_.id(), 0, GL_RGBA, GL_FLOAT, kZero.data());
  count_ = 0;
}

void Mean::Add(const gl::Texture& picture) {
  gl::ResetState();
  framebuffer_.Bind();
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  glUseProgram(program_.id());
  glBindTextureUnit(0, picture.id());
  glBindSampler(0, 0);
  quad_.Draw();
  gl::ResetState();
  ++count_;
}

std::vector<float> Mean::Rgb() const {
  std::vector<float> rgb = ReadRgb(sum_);
  const float scale = 1.0f / static_cast<float>(std::max(count_, 1));
  for (float& x : rgb) x *= scale;
  return rgb;
}

Stand::Stand(scene::Scene scene, int size)
    : scene_(std::move(scene)),
      size_(size),
      pictures_(Take(render::PictureStage::Create(image::SrgbTransform()))),
      target_(Take(gl::Texture::Create(FloatRgba(), size, size, 1, "frame"))) {
  frame_.pose = scene::EvaluatePose(scene_, {}, 0.0);
  frame_.items = scene::BuildDrawItems(scene_, frame_.pose, frame_.pose);
  camera_.bounds = scene::ComputeBounds(scene_, frame_.items);
}

Stand::Stand(scene::Scene scene, int size, const scene::View& view) : Stand(std::move(scene), size) {
  fixed_view_ = view;
}

void Stand::LookFrom(const Place& place) {
  scene::View view =
      fixed_view_ ? *fixed_view_ : scene::MakeView(scene_, camera_, frame_.pose, size_, size_, place.orbit_deg);
  const double c = std::cos(place.roll_rad);
  const double s = std::sin(place.roll_rad);
  view.view_from_world =
      glm::rotate(glm::mat4(1.0f), static_cast<float>(place.roll_rad), glm::vec3(0, 0, 1)) * view.view_from_world;
  // The roll is about the middle: what it would do to the pivot is taken back.
  const glm::dvec2 pivot_shift =
      kRollPivot - glm::dvec2(c * kRollPivot.x - s * kRollPivot.y, s * kRollPivot.x + c * kRollPivot.y);
  const glm::dvec2 clip_shift = pivot_shift + glm::dvec2(-2.0 * place.shift.x / size_, 2.0 * place.shift.y / size_);
  glm::mat4& clip = view.clip_from_view;
  for (int column = 0; column < 4; ++column) {
    clip[column][0] += static_cast<float>(clip_shift.x * clip[column][3]);
    clip[column][1] += static_cast<float>(clip_shift.y * clip[column][3]);
  }
  frame_.view = frame_.previous_view = view;
}

render::SceneStage& Stand::StageOf(const std::string& name, const render::SceneOptions& options) {
  std::unique_ptr<render::SceneStage>& stage = stages_[name];
  if (!stage) stage = Take(render::SceneStage::Create(scene_, options, *pictures_));
  return *stage;
}

void Stand::Draw(const Method& method, const Place& place, const gl::Texture& target) {
  LookFrom(place);
  const gbuffer::Request request{gbuffer::Attribute::kColor, &target, image::Encoding::kDisplay};
  Check(StageOf(method.name + ", timed", *method.timed).Fill(frame_, {&request, 1}));
  glFinish();
}

void Stand::FillAttributes(const Method& plain, const Place& place, std::span<const gbuffer::Request> requests) {
  LookFrom(place);
  Check(StageOf(plain.name, plain.options).Fill(frame_, requests));
}

void Stand::AddSample(const Method& plain, const Place& place, Mean& mean) {
  const gbuffer::Request request{gbuffer::Attribute::kColor, &target_, image::Encoding::kSceneLinear};
  FillAttributes(plain, place, {&request, 1});
  mean.Add(target_);
}

Picture Stand::Render(const Method& method, const Place& place) {
  if (method.offsets.size() == 1) {
    const gbuffer::Request request{gbuffer::Attribute::kColor, &target_, image::Encoding::kSceneLinear};
    FillAttributes(method, Shifted(place, method.offsets.front()), {&request, 1});
    return ToPicture(ReadRgb(target_), size_);
  }
  if (!mean_) mean_ = std::make_unique<Mean>(size_, size_);
  mean_->Clear();
  for (const glm::dvec2& offset : method.offsets) AddSample(method, Shifted(place, offset), *mean_);
  return ToPicture(mean_->Rgb(), size_);
}

glm::dvec2 R2(int n) {
  constexpr double kX = 0.7548776662466927;  // 1 / g and 1 / g^2 of the plastic number g
  constexpr double kY = 0.5698402909980532;
  const double x = 0.5 + kX * n;
  const double y = 0.5 + kY * n;
  return {x - std::floor(x) - 0.5, y - std::floor(y) - 0.5};
}

Picture Reference(Stand& stand, const Method& plain, const Place& place, int samples) {
  Mean mean(stand.size(), stand.size());
  for (int i = 0; i < samples; ++i) stand.AddSample(plain, Shifted(place, R2(i)), mean);
  return ToPicture(mean.Rgb(), stand.size());
}

Picture ToPicture(std::vector<float> rgb, int size) {
  for (float& x : rgb) x = std::clamp(x, 0.0f, 1.0f);
  return {.width = size, .height = size, .rgb = std::move(rgb)};
}

}  // namespace burin::bench
