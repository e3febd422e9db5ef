// SPDX-License-Identifier: Apache-2.0
// The front end and the meshes must agree on where vertex attributes are.
#include <string>

#include <gtest/gtest.h>

#include "core/gl/vertex_layout.h"
#include "fx_parser/glsl/interface.h"

namespace burin::effect {
namespace {

TEST(VertexInputs, AreWhereMeshesPutThem) {
  EXPECT_EQ(fx::VertexInputLocation("POSITION0"), gl::kLocationPosition);
  EXPECT_EQ(fx::VertexInputLocation("NORMAL0"), gl::kLocationNormal);
  EXPECT_EQ(fx::VertexInputLocation("TANGENT0"), gl::kLocationTangent);
  EXPECT_EQ(fx::VertexInputLocation("BINORMAL0"), gl::kLocationBinormal);
  EXPECT_EQ(fx::VertexInputLocation("COLOR0"), gl::kLocationColor0);
  EXPECT_EQ(fx::VertexInputLocation("COLOR1"), gl::kLocationColor1);
  EXPECT_EQ(fx::VertexInputLocation("BLENDWEIGHT0"), gl::kLocationBlendWeight);
  EXPECT_EQ(fx::VertexInputLocation("BLENDINDICES0"), gl::kLocationBlendIndices);
  for (int i = 0; i < 8; ++i) {
    EXPECT_EQ(fx::VertexInputLocation("TEXCOORD" + std::to_string(i)), gl::kLocationTexCoord0 + i);
  }
}

}  // namespace
}  // namespace burin::effect
