// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/base/error.h"
#include "core/video/video_module.h"

namespace burin::video {

enum class MatroskaKind { kMatroska, kWebm };

/// Goes through a finished Matroska file of one video track and takes out what ffmpeg's muxer puts in at random, so
/// that two runs give the same bytes: the segment's identifier becomes padding, the track's identifier its number;
/// checksums are made right again. The frame duration becomes that of `rate`, which OpenCV rounds, and with kWebm the
/// document type becomes "webm". Returns the number of frames in the file. `descriptor`: open for reading and writing.
/// Errors: kFailed when the file is not whole; `name` is for messages.
[[nodiscard]] Result<long> SettleMatroska(int descriptor, const std::string& name, const FrameRate& rate,
                                          MatroskaKind kind);

/// True when the file is Matroska and its segment, by its own account, goes on behind the end of the file: a copy that
/// was cut off. Segments of unknown size (streams) don't tell.
[[nodiscard]] bool MatroskaIsCutOff(int descriptor);

}  // namespace burin::video
