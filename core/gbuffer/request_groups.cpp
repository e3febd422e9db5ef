// SPDX-License-Identifier: Apache-2.0
#include "core/gbuffer/request_groups.h"

#include <epoxy/gl.h>

#include <algorithm>

namespace burin::gbuffer {

std::size_t MaxDrawBuffers() {
  GLint buffers = 0;
  GLint attachments = 0;
  glGetIntegerv(GL_MAX_DRAW_BUFFERS, &buffers);
  glGetIntegerv(GL_MAX_COLOR_ATTACHMENTS, &attachments);
  return static_cast<std::size_t>(std::min(buffers, attachments));
}

std::vector<std::vector<Request>> GroupRequests(std::span<const Request> requests) {
  const std::size_t most = MaxDrawBuffers();
  std::vector<std::vector<Request>> groups;
  for (const Request& request : requests) {
    const auto fits = [&](const std::vector<Request>& group) {
      const gl::Texture& target = *group.front().target;
      return group.size() < most && target.width() == request.target->width() &&
             target.height() == request.target->height();
    };
    const auto group = std::ranges::find_if(groups, fits);
    if (group == groups.end()) {
      groups.push_back({request});
    } else {
      group->push_back(request);
    }
  }
  return groups;
}

}  // namespace burin::gbuffer
