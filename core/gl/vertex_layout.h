// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace burin::gl {

/// Generic vertex attribute locations that every mesh and every effect's vertex shader agree on.
/// fx_parser/glsl/interface.h names the same numbers for the shaders it writes (core/effect asserts it).
enum VertexLocation : int {
  kLocationPosition = 0,
  kLocationNormal = 1,
  kLocationTangent = 2,
  kLocationBinormal = 3,
  kLocationColor0 = 4,
  kLocationColor1 = 5,
  kLocationBlendWeight = 6,
  kLocationBlendIndices = 7,
  kLocationTexCoord0 = 8,  // to 15: TEXCOORD7
};

}  // namespace burin::gl
