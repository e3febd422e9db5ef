// SPDX-License-Identifier: Apache-2.0
// One surface, whatever the processor, the threads, the swatches, and what was tessellated before.
#include <gtest/gtest.h>

#include <cstring>
#include <random>

#include "core/base/cpu.h"
#include "core/tessellation/tessellate.h"
#include "tests/support/bezier_networks.h"

namespace burin::tessellation {
namespace {

constexpr std::uint32_t kSeed = 33'107;

template <class Value>
void ExpectSameBits(const std::vector<Value>& a, const std::vector<Value>& b, const char* what) {
  ASSERT_EQ(a.size(), b.size()) << what;
  EXPECT_TRUE(a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Value)) == 0) << what;
}

void ExpectSameSurface(const Surface& a, const Surface& b) {
  ExpectSameBits(a.positions, b.positions, "positions");
  ExpectSameBits(a.normals, b.normals, "normals");
  ExpectSameBits(a.tangents, b.tangents, "tangents");
  for (std::size_t t = 0; t < 2; ++t) ExpectSameBits(a.texcoords[t], b.texcoords[t], "texcoords");
  ExpectSameBits(a.colors, b.colors, "colors");
  ExpectSameBits(a.patch_uv, b.patch_uv, "patch_uv");
  ExpectSameBits(a.patch_ids, b.patch_ids, "patch_ids");
  ExpectSameBits(a.indices, b.indices, "indices");
}

/// Gives every patch nets of random orders of all other attributes.
void AddAttributes(test::BezierPatches& patches, std::mt19937& random) {
  std::uniform_real_distribution<float> value(-1.0f, 1.0f);
  const auto net = [&](test::BezierPatch& patch, auto& values, const auto& make) {
    const auto order = [&] { return static_cast<std::uint8_t>(1 + random() % 8); };
    test::ControlNet added{static_cast<std::uint32_t>(values.size()), order(), order()};
    if (patch.domain == test::PatchDomain::kTriangle) added.v_order = added.u_order;
    for (std::uint32_t k = 0; k < ValueCount(patch.domain, added); ++k) values.push_back(make());
    return added;
  };
  const auto two = [&] { return glm::vec2(value(random), value(random)); };
  for (test::BezierPatch& patch : patches.patches) {
    if (random() % 2 == 0)
      patch.normal =
          net(patch, patches.normals, [&] { return glm::vec3(value(random), value(random), value(random)); });
    if (random() % 4 != 0) patch.texcoord[0] = net(patch, patches.texcoords[0], two);
    if (random() % 4 == 0) patch.texcoord[1] = net(patch, patches.texcoords[1], two);
    if (random() % 2 == 0) patch.color = net(patch, patches.colors, [&] { return glm::vec4(two(), two()); });
  }
}

TEST(Surface, IsTheSameBitsEverywhere) {
  std::mt19937 random(kSeed);
  Tessellator reused;
  for (int n = 0; n < 60; ++n) {
    SCOPED_TRACE(testing::Message() << "seed " << kSeed << " case " << n);
    test::NetworkShape shape{.columns = 2 + n % 2, .rows = 2, .has_pole = n % 3 == 0, .order = 3 + n % 6};
    shape.is_rational = shape.order <= 4 && n % 4 == 0;
    std::uniform_real_distribution<float> factor(1.0f, n % 20 == 0 ? 200.0f : 16.0f);
    test::NetworkBuilder builder(shape, random, [&] { return factor(random); });
    test::Network network = builder.Build();
    if (n % 2 == 0) AddAttributes(network.patches, random);
    const std::vector<Factors> factors(network.factors.begin(), network.factors.end());
    const Options options{.pattern = n % 4 < 2 ? Pattern::kFractional : Pattern::kInteger,
                          .wants_tangents = n % 3 == 0,
                          .is_parallel = false,
                          .uses_avx2 = false};
    Surface first, other;
    Tessellate(network.patches, factors, options, first);
    for (const std::uint32_t swatch : {0u, 1u, 7u, 64u}) {
      for (const bool is_parallel : {false, true}) {
        Options changed = options;
        changed.swatch_vertices = swatch;
        changed.is_parallel = is_parallel;
        changed.uses_avx2 = base::HasAvx2();
        reused.Tessellate(network.patches, factors, changed, other);
        ExpectSameSurface(first, other);
      }
    }
  }
}

}  // namespace
}  // namespace burin::tessellation
