// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/edge_quality/method.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <utility>

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

/// The middles of k x k cells of a pixel.
std::vector<glm::dvec2> Grid(int k) {
  std::vector<glm::dvec2> positions;
  for (int i = 0; i < k * k; ++i) {
    positions.emplace_back((i % k + 0.5) / k - 0.5, (i / k + 0.5) / k - 0.5);
  }
  return positions;
}

}  // namespace

std::vector<Method> Methods(const glm::vec4& background) {
  render::SceneOptions plain;
  plain.background = background;
  plain.edges.mode = overdraw::EdgeMode::kOff;
  render::SceneOptions four = plain, sixteen = plain;
  four.samples = 4;
  sixteen.samples = 16;
  std::vector<Method> methods;
  methods.push_back({.name = "none", .options = plain, .timed = plain});
  // For quality the samples of --samples one by one: rendered at twice the size textures would take finer mipmaps than
  // the reference's, which has nothing to do with edges. Without textures the pixels are the same.
  methods.push_back({.name = "2x2", .options = plain, .offsets = Grid(2), .timed = four});
  methods.push_back({.name = "4x4", .options = plain, .offsets = Grid(4), .timed = sixteen});
  // Visibility as four hardware samples see it; shading is taken at each of them too, which real MSAA does once.
  methods.push_back({.name = "4x MSAA", .options = plain, .offsets = FourSamplePositions(), .timed = std::nullopt});
  for (const auto& [name, mode] : {std::pair("unsorted", overdraw::EdgeMode::kUnsorted),
                                   std::pair("sorted", overdraw::EdgeMode::kSorted),
                                   std::pair("resolve", overdraw::EdgeMode::kResolve)}) {
    render::SceneOptions options = plain;
    options.edges.mode = mode;
    methods.push_back({.name = name, .options = options, .timed = options});
  }
  return methods;
}

}  // namespace burin::bench
