// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/weld.h"

#include <gmock/gmock.h>

#include <cstdio>
#include <limits>
#include <random>

namespace burin::geometry {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(Weld, GivesTheLowestIndexAtEachPlace) {
  const std::vector<glm::vec3> p = {{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}};
  EXPECT_THAT(WeldPositions(p), ElementsAre(0, 1, 0, 1, 4, 0));
  EXPECT_THAT(WeldPositions({}), IsEmpty());
}

TEST(Weld, TakesBothZerosForOne) {
  const std::vector<glm::vec3> p = {{0.0f, -0.0f, 1}, {-0.0f, 0.0f, 1}, {0, 0, -1}};
  EXPECT_THAT(WeldPositions(p), ElementsAre(0, 0, 2));
}

TEST(Weld, KeepsNeighbouringFloatsApart) {
  const float next = std::nextafter(1.0f, 2.0f);
  const std::vector<glm::vec3> p = {{1, 1, 1}, {next, 1, 1}, {1, next, 1}, {1, 1, next}};
  EXPECT_THAT(WeldPositions(p), ElementsAre(0, 1, 2, 3));
}

TEST(Weld, EndsWithNumbersThatAreNone) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<glm::vec3> p = {{nan, 0, 0}, {nan, 0, 0}, {0, 0, 0}};
  EXPECT_THAT(WeldPositions(p), ElementsAre(0, 0, 2));
}

TEST(Weld, AgreesWithComparingAllPairs) {
  constexpr std::uint32_t kSeed = 4127;
  std::printf("seed %u\n", kSeed);
  std::mt19937 random(kSeed);
  std::vector<glm::vec3> p(700);
  for (glm::vec3& v : p) v = {random() % 8, random() % 8, random() % 8};
  const std::vector<std::uint32_t> welded = WeldPositions(p);
  for (std::size_t i = 0; i < p.size(); ++i) {
    std::size_t first = 0;
    while (p[first] != p[i]) ++first;
    ASSERT_EQ(welded[i], first) << i;
  }
}

}  // namespace
}  // namespace burin::geometry
