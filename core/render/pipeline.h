// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>

#include "core/base/error.h"
#include "core/render/frame_renderer.h"
#include "core/render/plan.h"
#include "core/render/progress.h"
#include "core/render/sink.h"
#include "core/render/source.h"

namespace burin::render {

/// Runs all frames: a thread decodes, the caller's draws (it owns the GL context), and the sink's workers encode, over
/// bounded queues, so that memory does not depend on the number of frames. The first error stops everything and is the
/// result; with `keep_going` a failed frame is left out and the result is an error in the end all the same.
/// `frames_done` counts the frames written, whatever the result.
[[nodiscard]] Result<void> RunPipeline(const Plan& plan, Source& source, FrameRenderer& renderer, Sink& sink,
                                       bool keep_going, Progress& progress, const std::atomic<bool>& stop,
                                       long& frames_done);

}  // namespace burin::render
