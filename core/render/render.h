// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>

#include "core/base/error.h"
#include "core/render/job.h"
#include "core/render/progress.h"

namespace burin::render {

/// Renders the job: decode, render with asynchronous read-back, and encode overlap in one thread each over bounded
/// queues. Call on the thread that shall own the GL context. When `stop` becomes true the job ends after the frame in
/// hand, its unfinished files removed, and the result is kFailed ("interrupted").
[[nodiscard]] Result<void> Run(const Job& job, Progress& progress, const std::atomic<bool>& stop);

}  // namespace burin::render
