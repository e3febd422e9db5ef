// SPDX-License-Identifier: Apache-2.0
#include "core/scene/shown_nodes.h"

namespace burin::scene {

std::vector<bool> ShownNodes(const Scene& scene) {
  std::vector<bool> shown(scene.nodes.size(), false);
  std::vector<int> stack(scene.roots);
  while (!stack.empty()) {
    const auto node = static_cast<std::size_t>(stack.back());
    stack.pop_back();
    if (shown[node]) continue;
    shown[node] = true;
    stack.insert(stack.end(), scene.nodes[node].children.begin(), scene.nodes[node].children.end());
  }
  return shown;
}

}  // namespace burin::scene
