// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/gl/framebuffer.h"
#include "core/gl/fullscreen_quad.h"
#include "core/gl/program.h"
#include "core/render/scene_stage.h"
#include "tests/bench/edge_quality/method.h"
#include "tests/bench/edge_quality/picture.h"

namespace burin::bench {

/// Where the camera is: turned about the scene's axis, the picture shifted by a part of a pixel.
struct Place {
  double orbit_deg = 0.0;
  glm::dvec2 shift{0.0};  ///< pixels, right and down: pixel p shows what lies at p + shift
  double roll_rad = 0.0;  ///< of the picture about a point off its middle, so that every outline moves
};

/// The mean of many renderings, summed on the device.
class Mean {
 public:
  Mean(int width, int height);
  void Clear();
  void Add(const gl::Texture& picture);
  [[nodiscard]] std::vector<float> Rgb() const;  ///< not clamped

 private:
  gl::Texture sum_;
  gl::Program program_;
  gl::FullscreenQuad quad_;
  gl::Framebuffer framebuffer_;
  int count_ = 0;
};

/// A scene at rest before the automatic camera, drawn by any method. Whatever fails ends the program with a message.
class Stand {
 public:
  Stand(scene::Scene scene, int size);
  /// A given view instead of the automatic camera's.
  Stand(scene::Scene scene, int size, const scene::View& view);

  [[nodiscard]] int size() const { return size_; }
  [[nodiscard]] const scene::Scene& scene() const { return scene_; }
  [[nodiscard]] Picture Render(const Method& method, const Place& place);
  /// A whole frame as `method.timed` draws it, left on the device in display encoding and waited for.
  void Draw(const Method& method, const Place& place, const gl::Texture& target);
  /// Adds one plain rendering to `mean`.
  void AddSample(const Method& plain, const Place& place, Mean& mean);
  /// Attributes of the plain frame, into targets of any size.
  void FillAttributes(const Method& plain, const Place& place, std::span<const gbuffer::Request> requests);

 private:
  render::SceneStage& StageOf(const std::string& name, const render::SceneOptions& options);
  void LookFrom(const Place& place);

  scene::Scene scene_;
  int size_;
  std::optional<scene::View> fixed_view_;
  scene::CameraChoice camera_;
  std::unique_ptr<render::PictureStage> pictures_;
  std::map<std::string, std::unique_ptr<render::SceneStage>> stages_;
  render::SceneFrame frame_;
  gl::Texture target_;
  std::unique_ptr<Mean> mean_;
};

/// The n-th point of the R2 sequence in [-0.5, 0.5)^2 (M. Roberts, "The Unreasonable Effectiveness of Quasirandom
/// Sequences", 2018): low discrepancy and on no grid.
[[nodiscard]] glm::dvec2 R2(int n);

/// The mean of `samples` renderings spread over the pixel: the reference.
[[nodiscard]] Picture Reference(Stand& stand, const Method& plain, const Place& place, int samples);

/// Clamped to 0..1.
[[nodiscard]] Picture ToPicture(std::vector<float> rgb, int size);

}  // namespace burin::bench
