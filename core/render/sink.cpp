// SPDX-License-Identifier: Apache-2.0
#include "core/render/sink.h"

namespace burin::render {

Result<std::unique_ptr<Sink>> OpenSink(const Plan& plan, const Job& job, const SourceInfo& source,
                                       std::shared_ptr<const image::ColorTransform> transform) {
  return plan.output.is_video() ? OpenVideoSink(plan, job, source, std::move(transform))
                                : OpenImageSink(plan, job, std::move(transform));
}

}  // namespace burin::render
