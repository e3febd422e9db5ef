// SPDX-License-Identifier: Apache-2.0
#pragma once
// Direct3D 9's fixed pipeline as shader text: transform, lights and texture stages.

#include <array>
#include <string>
#include <vector>

#include "fx_parser/glsl/semantic.h"
#include "fx_parser/semantics/type.h"

namespace burin::fx {

/// One texture stage, in Direct3D's numbers (D3DTEXTUREOP, D3DTA_...).
struct FixedStage {
  int color_op = 1;
  int alpha_op = 1;
  std::array<int, 3> color_args{1, 2, 1};  ///< ColorArg0 to 2
  std::array<int, 3> alpha_args{1, 2, 1};
  int result = 1;       ///< D3DTA_CURRENT or D3DTA_TEMP
  std::string sampler;  ///< the uniform of its texture; empty: it has none
  Dimension dimension = Dimension::k2D;
  int texcoord = 0;           ///< which of the vertex's, or D3DTSS_TCI_... above the low 16 bits
  int transform_count = 0;    ///< D3DTTFF_COUNT1 to 4: its texture transform is used; 0: it is not
  bool is_projected = false;  ///< D3DTTFF_PROJECTED
};

struct FixedPipeline {
  bool is_vertex = false;  ///< no vertex shader
  bool is_pixel = false;   ///< no pixel shader
  bool lighting = true;
  bool specular = false;
  bool local_viewer = true;
  /// D3DMATERIALCOLORSOURCE of diffuse, specular, ambient, emissive: 0 the material, 1 and 2 the vertex's colours. A
  /// vertex without colours is white.
  std::array<int, 4> sources{0, 0, 0, 0};
  std::vector<FixedStage> stages;  ///< up to the first that is disabled
};

/// Statements of main, for `varyings`; adds what it reads to `inputs`. Its functions go in front: FixedVertexFunctions.
[[nodiscard]] std::string FixedVertexText(const FixedPipeline& pipeline, const std::vector<Semantic>& varyings,
                                          std::vector<Semantic>& inputs);
[[nodiscard]] std::string FixedVertexFunctions(const FixedPipeline& pipeline);

/// Statements of main that write burin_out0; adds what it reads to `varyings`.
[[nodiscard]] std::string FixedPixelText(const FixedPipeline& pipeline, std::vector<Semantic>& varyings);
/// Declarations in front of them.
[[nodiscard]] std::string FixedPixelDeclarations(const FixedPipeline& pipeline);

}  // namespace burin::fx
