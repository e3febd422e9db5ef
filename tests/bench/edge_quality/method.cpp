// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/edge_quality/method.h"

#include <epoxy/gl.h>

#include <algorithm>

namespace burin::bench {
namespace {

/// Where this device takes the samples of a 4-sample target.
std::vector<glm::dvec2> FourSamplePositions() {
  GLuint target = 0;
  GLuint framebuffer = 0;
  glCreateRenderbuffers(1, &target);
  glNamedRenderbufferStorageMultisample(target, 4, GL_RGBA8, 4, 4);
  glCreateFramebuffers(1, &framebuffer);
  glNamedFramebufferRenderbuffer(framebuffer, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, target);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  std::vector<glm::dvec2> positions;
  for (GLuint i = 0; i < 4; ++i) {
    float position[2] = {0.5f, 0.5f};
    glGetMultisamplefv(GL_SAMPLE_POSITION, i, position);
    positions.emplace_back(position[0] - 0.5, position[1] - 0.5);
  }
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glDeleteFramebuffers(1, &framebuffer);
  glDeleteRenderbuffers(1, &target);
  return positions;
}

}  // namespace

std::vector<Method> Methods(const glm::vec4& background) {
  const auto options = [&](int samples, overdraw::EdgeMode edges = overdraw::EdgeMode::kOff) {
    render::SceneOptions scene_options;
    scene_options.background = background;
    scene_options.samples = samples;
    scene_options.edges.mode = edges;
    return scene_options;
  };
  std::vector<Method> methods;
  methods.push_back({.name = "none", .options = options(1)});
  methods.push_back({.name = "2x2", .options = options(4)});
  methods.push_back({.name = "4x4", .options = options(16)});
  // Visibility as four hardware samples see it; shading is taken at each of them too, which real MSAA does once.
  methods.push_back({.name = "4x MSAA", .options = options(1), .offsets = FourSamplePositions(), .is_timed = false});
  methods.push_back({.name = "unsorted", .options = options(1, overdraw::EdgeMode::kUnsorted)});
  methods.push_back({.name = "sorted", .options = options(1, overdraw::EdgeMode::kSorted)});
  methods.push_back({.name = "resolve", .options = options(1, overdraw::EdgeMode::kResolve)});
  return methods;
}

}  // namespace burin::bench
