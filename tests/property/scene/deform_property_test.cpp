// SPDX-License-Identifier: Apache-2.0
// Skinning and morphing of random meshes against a plain computation in double, and with any number of threads.

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>
#include <random>

#include "core/scene/pose.h"

namespace burin::scene {
namespace {

constexpr std::uint32_t kSeed = 7741;
constexpr std::size_t kVertices = 20'000;  // several tasks of the parallel loop
constexpr std::size_t kJoints = 23;
// Eight joints, blended in float: a few roundings of coordinates below 20.
constexpr double kTolerance = 2e-5;

class RandomRig : public ::testing::Test {
 protected:
  void SetUp() override {
    std::printf("seed %u\n", kSeed);
    Primitive p;
    for (std::size_t i = 0; i < kVertices; ++i) {
      p.positions.push_back(Vector());
      p.normals.push_back(glm::normalize(Vector() + glm::vec3(0, 0, 3)));
      p.tangents.emplace_back(glm::normalize(Vector() + glm::vec3(3, 0, 0)), 1.0f);
      p.indices.push_back(static_cast<std::uint32_t>(i));
      for (std::size_t set = 0; set < 2; ++set) {
        p.joints[set].emplace_back(Joint(), Joint(), Joint(), Joint());
        p.weights[set].emplace_back(Positive(), Positive(), Positive(), Positive());
      }
      const float sum = glm::dot(p.weights[0][i], glm::vec4(1)) + glm::dot(p.weights[1][i], glm::vec4(1));
      for (std::size_t set = 0; set < 2; ++set) p.weights[set][i] /= sum;
    }
    for (int t = 0; t < 2; ++t) {
      Primitive::MorphTarget target;
      for (std::size_t i = 0; i < kVertices; ++i) target.positions.push_back(Vector());
      p.targets.push_back(std::move(target));
    }
    scene_.meshes.push_back({"", {std::move(p)}, {0.3f, 0.6f}});
    scene_.nodes.resize(1 + kJoints);
    scene_.nodes[0].mesh = scene_.nodes[0].skin = 0;
    scene_.roots = {0};
    Skin skin;
    for (std::size_t j = 0; j < kJoints; ++j) {
      Node& node = scene_.nodes[1 + j];
      node.transform.translation = Vector();
      node.transform.rotation = glm::normalize(glm::quat(Positive(), Vector()));
      node.transform.scale = glm::vec3(0.8f + 0.4f * Positive());
      if (j > 0) {
        node.parent = static_cast<int>(j);
        scene_.nodes[j].children = {static_cast<int>(1 + j)};
      } else {
        scene_.roots.push_back(1);
      }
      skin.joints.push_back(static_cast<int>(1 + j));
      glm::mat4 inverse = glm::mat4_cast(glm::normalize(glm::quat(Positive(), Vector())));
      inverse[3] = glm::vec4(Vector(), 1.0f);
      skin.inverse_bind_matrices.push_back(inverse);
    }
    scene_.skins.push_back(std::move(skin));
  }

  float Positive() { return std::uniform_real_distribution<float>(0.05f, 1.0f)(random_); }
  glm::vec3 Vector() {
    std::uniform_real_distribution<float> d(-1.0f, 1.0f);
    const float x = d(random_);
    const float y = d(random_);
    return {x, y, d(random_)};
  }
  std::uint16_t Joint() {
    return static_cast<std::uint16_t>(std::uniform_int_distribution<int>(0, kJoints - 1)(random_));
  }

  Scene scene_;
  std::mt19937 random_{kSeed};
};

TEST_F(RandomRig, AgreesWithAPlainComputation) {
  const Pose pose = EvaluatePose(scene_, {}, 0.0);
  const std::vector<DrawItem> items = BuildDrawItems(scene_, pose, pose);
  ASSERT_EQ(items.size(), 1u);
  const Primitive& p = scene_.meshes[0].primitives[0];
  const Skin& skin = scene_.skins[0];
  for (std::size_t i = 0; i < kVertices; i += 37) {
    glm::dmat4 blend(0.0);
    for (std::size_t set = 0; set < 2; ++set) {
      for (int c = 0; c < 4; ++c) {
        const std::size_t j = p.joints[set][i][c];
        blend += static_cast<double>(p.weights[set][i][c]) * glm::dmat4(pose.world_from_node[1 + j]) *
                 glm::dmat4(skin.inverse_bind_matrices[j]);
      }
    }
    const glm::dvec3 morphed = glm::dvec3(p.positions[i]) + 0.3 * glm::dvec3(p.targets[0].positions[i]) +
                               0.6 * glm::dvec3(p.targets[1].positions[i]);
    const glm::dvec3 expected(blend * glm::dvec4(morphed, 1.0));
    const double scale = 1.0 + glm::length(expected);
    EXPECT_LT(glm::length(glm::dvec3(items[0].deformed.positions[i]) - expected) / scale, kTolerance) << i;

    const glm::dmat3 linear(blend);
    const glm::dvec3 normal = glm::normalize(glm::transpose(glm::inverse(linear)) * glm::dvec3(p.normals[i]));
    // A nearly flattened matrix magnifies the roundings: by its condition number, at most some hundreds here.
    EXPECT_GT(glm::dot(normal, glm::dvec3(items[0].deformed.normals[i])), 1.0 - 1e-3) << i;
  }
}

TEST_F(RandomRig, HasTheSameBitsOnAnyNumberOfThreads) {
  const Pose pose = EvaluatePose(scene_, {}, 0.0);
  Pose before = pose;
  before.weights[0] = {0.1f, 0.2f};
  const auto build = [&](std::size_t threads) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    return BuildDrawItems(scene_, pose, before);
  };
  const std::vector<DrawItem> one = build(1);
  for (const std::size_t threads : {2u, 5u}) {
    const std::vector<DrawItem> many = build(threads);
    EXPECT_EQ(one[0].deformed.positions, many[0].deformed.positions);
    EXPECT_EQ(one[0].deformed.previous_positions, many[0].deformed.previous_positions);
    EXPECT_EQ(one[0].deformed.normals, many[0].deformed.normals);
    EXPECT_EQ(one[0].deformed.tangents, many[0].deformed.tangents);
    const Bounds a = ComputeBounds(scene_, one);
    const Bounds b = ComputeBounds(scene_, many);
    EXPECT_EQ(a.min, b.min);
    EXPECT_EQ(a.max, b.max);
  }
}

}  // namespace
}  // namespace burin::scene
