// SPDX-License-Identifier: Apache-2.0
// --edges resolve while things turn: nothing pops.
#include <gmock/gmock.h>

#include <algorithm>
#include <cstdio>

#include "tests/gl/overdraw/edge_fixture.h"

namespace burin::overdraw {
namespace {

constexpr float kCornerError = 0.02f;  // where several edges cross a pixel

struct Changes {
  float resolved = 0, reference = 0, plain = 0;
};

/// The largest change of any pixel between two steps of a turn during which faces appear and vanish, edges turn from
/// creases into silhouettes and back.
class Turning : public EdgeTest {
 protected:
  Turning() { background_ = {0, 0, 0, 1}; }

  Changes Turn(TestScene& test, const glm::vec3& axis, int steps) {
    constexpr int kSmall = 48, kSamples = 16;  // 16 x 16 say how fast pixels may change
    Changes most;
    Picture last[3];
    for (int step = 0; step < steps; ++step) {
      const float angle = 0.6f * (static_cast<float>(step) / static_cast<float>(steps) - 0.5f);
      test.scene.nodes[0].matrix = glm::rotate(Translate(0.07f, 0.03f, -6), angle, glm::normalize(axis));
      Picture now[] = {DrawOne(test, view_, EdgeMode::kResolve, kSmall, kSmall),
                       Reference(test, view_, kSamples, kSmall, kSmall),
                       DrawOne(test, view_, EdgeMode::kOff, kSmall, kSmall)};
      float* const changes[] = {&most.resolved, &most.reference, &most.plain};
      for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t i = 0; step > 0 && i < now[k].values.size(); ++i)
          *changes[k] = std::max(*changes[k], std::abs(now[k].values[i] - last[k].values[i]));
        last[k] = std::move(now[k]);
      }
    }
    std::printf("largest change of a pixel: %.3f, of the reference's %.3f, without antialiasing %.3f\n", most.resolved,
                most.reference, most.plain);
    return most;
  }
  scene::View view_ = Perspective(0.6f, 1);
};

TEST_F(Turning, NothingPopsWhileACubeTurnsThroughItsSilhouettes) {
  TestScene test = ColoredCube();
  for (scene::Material& material : test.scene.materials) material = Unlit({1, 1, 1, 1});
  for (const glm::vec3& axis : {glm::vec3(0.3f, 1, 0.1f), glm::vec3(1, -0.4f, 0.8f)}) {
    const Changes most = Turn(test, axis, 60);
    EXPECT_LE(most.resolved, most.reference + kCornerError);
    EXPECT_EQ(most.plain, 1.0f) << "else nothing is tested";
  }
}

TEST_F(Turning, FacesOfOtherColoursAppearMoreSoftlyThanWithoutAntialiasing) {
  // Where no centre sees a face yet, its colour beside an outline is taken from the face next to it.
  TestScene test = ColoredCube();
  const Changes most = Turn(test, {0.3f, 1, 0.1f}, 60);
  EXPECT_LE(most.resolved, 0.75f * most.plain);
}

}  // namespace
}  // namespace burin::overdraw
