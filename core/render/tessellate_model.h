// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/render/job.h"

namespace burin::render {

/// What there is to say afterwards.
struct TessellatedModel {
  std::vector<std::string> warnings;
  std::vector<std::string> notes;
};

/// `burin tessellate`: poses the job's scene at its one frame (frame 1 without), tessellates it as its options say,
/// meshes too, and writes the triangles to the job's output: .glb, .obj, .ply, or - (GLB on stdout). No GL. Errors:
/// kUsage for outputs and options, kInput for the model, kFailed for what cannot be written.
[[nodiscard]] Result<TessellatedModel> TessellateModel(const Job& job);

}  // namespace burin::render
