// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/base/error.h"
#include "core/gbuffer/attribute_table.h"
#include "core/render/job.h"
#include "core/render/output_file.h"
#include "core/render/source.h"

namespace burin::render {

/// A job after its source and output were looked at: every decision that holds for all frames.
struct Plan {
  Output output;
  int width = 0;
  int height = 0;
  video::FrameRate rate;
  /// Ascending; empty: all that a video has, to its end.
  std::vector<long> frames;
  bool frames_were_asked_for = false;      ///< then one that is not there is an error
  std::vector<gbuffer::Attribute> layers;  ///< --attributes
  bool has_frame = true;                   ///< false: only the layers are written
};

/// Errors: kUsage for what does not fit together, each before anything is rendered; those of output_file.h.
[[nodiscard]] Result<Plan> MakePlan(const Job& job, Output output, const SourceInfo& source);

/// The attributes of --attributes. Errors: kUsage for an unknown name, with the nearest, and for a second use of one.
[[nodiscard]] Result<std::vector<gbuffer::Attribute>> FindAttributes(const std::vector<std::string>& names);

}  // namespace burin::render
