// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <numbers>

#include "core/scene/animation_sampler.h"
#include "core/scene/pose.h"
#include "scene_fixture.h"

namespace burin::scene {
namespace {

constexpr float kTolerance = 2e-6f;  // float arithmetic on values near 1

AnimationChannel Channel(AnimationPath path, Interpolation interpolation, std::vector<float> times,
                         std::vector<float> values, int components) {
  AnimationChannel channel;
  channel.node = 0;
  channel.path = path;
  channel.interpolation = interpolation;
  channel.components = components;
  channel.times = std::move(times);
  channel.values = std::move(values);
  return channel;
}

std::vector<float> Sample(const AnimationChannel& channel, float time_s) {
  std::vector<float> out(static_cast<std::size_t>(channel.components));
  SampleChannel(channel, time_s, out);
  return out;
}

TEST(SampleChannel, HoldsTheEndsAndStepsBetween) {
  const AnimationChannel step =
      Channel(AnimationPath::kTranslation, Interpolation::kStep, {1, 2, 4}, {1, 0, 0, 2, 0, 0, 3, 0, 0}, 3);
  EXPECT_EQ(Sample(step, 0.0f)[0], 1.0f);
  EXPECT_EQ(Sample(step, 1.999f)[0], 1.0f);
  EXPECT_EQ(Sample(step, 2.0f)[0], 2.0f);
  EXPECT_EQ(Sample(step, 3.999f)[0], 2.0f);
  EXPECT_EQ(Sample(step, 4.0f)[0], 3.0f);
  EXPECT_EQ(Sample(step, 9.0f)[0], 3.0f);
}

TEST(SampleChannel, IsLinearBetweenKeys) {
  const AnimationChannel linear =
      Channel(AnimationPath::kScale, Interpolation::kLinear, {1, 3}, {0, 10, 4, 2, 20, 4}, 3);
  EXPECT_EQ(Sample(linear, 0.5f), (std::vector<float>{0, 10, 4}));
  EXPECT_EQ(Sample(linear, 1.5f), (std::vector<float>{0.5f, 12.5f, 4}));
  EXPECT_EQ(Sample(linear, 3.0f), (std::vector<float>{2, 20, 4}));
}

TEST(SampleChannel, FollowsTheCubicSplineOfAppendixC) {
  // One component a key: in-tangent, value, out-tangent. Between keys 2 s apart, at t = 0.25:
  // h00 = 0.84375, h10 = 0.140625, h01 = 0.15625, h11 = -0.046875
  // 0.84375 * 1 + 2 * 0.140625 * 3 + 0.15625 * 5 + 2 * -0.046875 * -1 = 2.5625
  const AnimationChannel cubic =
      Channel(AnimationPath::kWeights, Interpolation::kCubicSpline, {1, 3}, {7, 1, 3, -1, 5, 9}, 1);
  EXPECT_NEAR(Sample(cubic, 1.5f)[0], 2.5625f, kTolerance);
  EXPECT_EQ(Sample(cubic, 0.0f)[0], 1.0f);
  EXPECT_EQ(Sample(cubic, 3.0f)[0], 5.0f);
}

TEST(SampleChannel, TurnsAlongTheShorterArc) {
  // About z from 0 to 90 degrees, the second key negated: the same rotation, named the long way round.
  const float h = std::sqrt(0.5f);
  const AnimationChannel turn =
      Channel(AnimationPath::kRotation, Interpolation::kLinear, {0, 1}, {0, 0, 0, 1, 0, 0, -h, -h}, 4);
  for (const float t : {0.1f, 0.25f, 0.5f, 0.9f}) {
    const std::vector<float> q = Sample(turn, t);
    const float half_angle = t * std::numbers::pi_v<float> / 4.0f;
    EXPECT_NEAR(q[2], std::sin(half_angle), kTolerance) << t;
    EXPECT_NEAR(q[3], std::cos(half_angle), kTolerance) << t;
  }
}

TEST(SampleChannel, NormalisesRotations) {
  const AnimationChannel cubic = Channel(AnimationPath::kRotation, Interpolation::kCubicSpline, {0, 1},
                                         {0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0}, 4);
  const std::vector<float> q = Sample(cubic, 0.5f);
  EXPECT_NEAR(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3], 1.0f, kTolerance);
  EXPECT_NEAR(q[2], q[3], kTolerance) << "half way between two keys with mirrored tangents";
  const AnimationChannel step = Channel(AnimationPath::kRotation, Interpolation::kStep, {0}, {0, 0, 3, 4}, 4);
  EXPECT_NEAR(Sample(step, 0.0f)[2], 0.6f, kTolerance);
}

TEST(Slerp, AgreesWithTheFormula) {
  const glm::quat a = glm::normalize(glm::quat(0.9f, 0.1f, -0.3f, 0.2f));
  const glm::quat b = glm::normalize(glm::quat(0.2f, -0.7f, 0.4f, 0.5f));
  const double dot = static_cast<double>(a.w) * b.w + static_cast<double>(a.x) * b.x + static_cast<double>(a.y) * b.y +
                     static_cast<double>(a.z) * b.z;
  const double angle = std::acos(std::abs(dot));
  const double sign = dot < 0 ? -1.0 : 1.0;
  for (const double t : {0.0, 0.2, 0.5, 0.75, 1.0}) {
    const glm::quat q = Slerp(a, b, static_cast<float>(t));
    const double wa = std::sin((1 - t) * angle) / std::sin(angle);
    const double wb = sign * std::sin(t * angle) / std::sin(angle);
    EXPECT_NEAR(q.w, wa * a.w + wb * b.w, kTolerance);
    EXPECT_NEAR(q.x, wa * a.x + wb * b.x, kTolerance);
  }
}

TEST(SelectAnimations, AutoLeavesOutWhatClashes) {
  const Scene scene = ReadOrDie(DataPath("rig.glb"));
  // "bend again" turns the joint that "bend" turns; "jump" moves another.
  EXPECT_EQ(SelectAnimations(scene, "auto").value(), (AnimationSelection{0, 1}));
  EXPECT_EQ(SelectAnimations(scene, "").value(), (AnimationSelection{0, 1}));
  EXPECT_EQ(SelectAnimations(scene, "all").value(), (AnimationSelection{0, 1, 2}));
  EXPECT_EQ(SelectAnimations(scene, "none").value(), AnimationSelection{});
  EXPECT_EQ(SelectAnimations(scene, "bend again").value(), AnimationSelection{2});
  EXPECT_EQ(SelectAnimations(scene, "1").value(), AnimationSelection{1});
  EXPECT_EQ(Duration(scene, {0, 1}), 2.0f);
  EXPECT_EQ(Duration(scene, {}), 0.0f);
}

TEST(SelectAnimations, NamesWhatThereIs) {
  const Scene scene = ReadOrDie(DataPath("rig.glb"));
  const auto bad = SelectAnimations(scene, "run");
  ASSERT_FALSE(bad);
  EXPECT_EQ(bad.error().kind, ErrorKind::kUsage);
  EXPECT_EQ(bad.error().message, R"(no animation "run": the scene has 0 "bend", 1 "jump", 2 "bend again")");
  EXPECT_FALSE(SelectAnimations(scene, "3"));
  EXPECT_FALSE(SelectAnimations(scene, "-1"));
  EXPECT_FALSE(SelectAnimations(scene, "1x"));
  EXPECT_EQ(SelectAnimations(Scene(), "run").error().message, R"(no animation "run": the scene has none)");
}

TEST(EvaluatePose, LoopsAndClampsTime) {
  const Scene scene = ReadOrDie(DataPath("rig.glb"));
  const AnimationSelection jump{1};
  // Joint 1 steps from x = 0 to x = 1 at 1 s; the loop is 2 s.
  const auto x_at = [&](double t) { return EvaluatePose(scene, jump, t).world_from_node[1][3].x; };
  EXPECT_EQ(x_at(0.2), 0.0f) << "before the first key";
  EXPECT_EQ(x_at(1.5), 1.0f);
  EXPECT_EQ(x_at(2.5), 0.0f);
  EXPECT_EQ(x_at(3.5), 1.0f);
  EXPECT_EQ(x_at(-0.5), 0.0f);
  EXPECT_EQ(EvaluatePose(scene, jump, 2.0).world_from_node, EvaluatePose(scene, jump, 0.0).world_from_node);
}

TEST(EvaluatePose, ChainsMatricesAndWeights) {
  const Scene scene = ReadOrDie(DataPath("rig.glb"));
  const Pose pose = EvaluatePose(scene, {0}, 1.0);
  // Joint 2 is turned by 90 degrees: joint 3, one up its axis, lies at x = -1.
  EXPECT_NEAR(pose.world_from_node[3][3].x, -1.0f, kTolerance);
  EXPECT_NEAR(pose.world_from_node[3][3].y, 2.0f, kTolerance);
  EXPECT_EQ(pose.weights[5], (std::vector<float>{0.5f, 1.0f})) << "the animation's key";
  EXPECT_EQ(pose.weights[6], (std::vector<float>{0.0f, 1.0f})) << "the node's own";
  EXPECT_TRUE(pose.weights[0].empty());
}

TEST(EvaluatePose, UsesMatricesAndScalesInOrder) {
  const Scene scene = ReadOrDie(DataPath("everything.gltf"));
  const Pose pose = EvaluatePose(scene, {}, 0.0);
  // The parent's matrix sends (x, y, z) to (2z + 10, 2y + 20, -2x + 30); the child mirrors x and moves up by 2.
  const glm::vec4 p = pose.world_from_node[0] * glm::vec4(1, 1, 1, 1);
  EXPECT_EQ(p, glm::vec4(12, 26, 32, 1));
}

}  // namespace
}  // namespace burin::scene
