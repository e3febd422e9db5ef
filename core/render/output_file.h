// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/base/error.h"
#include "core/image/image.h"
#include "core/render/job.h"
#include "core/render/name_pattern.h"
#include "core/render/source.h"

namespace burin::render {

enum class OutputKind { kImages, kVideo, kY4mFile, kY4mStream };

/// Where frames go and how their samples are held there.
struct Output {
  OutputKind kind = OutputKind::kImages;
  NamePattern pattern;
  image::SampleType type = image::SampleType::kU8;
  image::Encoding encoding = image::Encoding::kDisplay;
  int channels = 4;     ///< 3: alpha is dropped
  bool is_exr = false;  ///< takes layers

  [[nodiscard]] bool is_video() const { return kind != OutputKind::kImages; }
  /// Whether more than one frame fits.
  [[nodiscard]] bool takes_several() const { return is_video() || pattern.has_token(); }
};

/// What --output is by its name, before anything is opened. Errors: kUsage when it is missing or names no known format.
[[nodiscard]] Result<Output> ClassifyOutput(const Job& job);

/// Chooses samples and channels for this source and size. Errors: kUsage when the format cannot hold what was asked
/// for, with the alternative.
[[nodiscard]] Result<void> ChooseSamples(Output& output, const Job& job, const SourceInfo& source, int width,
                                         int height);

/// That the folder is there (made for --mkdir) and takes new files. Errors: kFailed, naming the folder or file.
[[nodiscard]] Result<void> CheckPlace(const Output& output, bool make_folders);

}  // namespace burin::render
