// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "core/gbuffer/attribute_renderer.h"

namespace burin::gbuffer {

/// Requests of one size together, as many as this device has draw buffers, in the order given.
[[nodiscard]] std::vector<std::vector<Request>> GroupRequests(std::span<const Request> requests);

/// GL_MAX_DRAW_BUFFERS, or fewer attachments.
[[nodiscard]] std::size_t MaxDrawBuffers();

}  // namespace burin::gbuffer
