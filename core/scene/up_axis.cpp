// SPDX-License-Identifier: Apache-2.0
#include "core/scene/up_axis.h"

#include <utility>

namespace burin::scene {
namespace {

glm::quat TurnOf(UpAxis axis) {
  constexpr float kHalf = 0.70710678118654752f;  // of a quarter turn, sine and cosine
  switch (axis) {
    case UpAxis::kX:
      return {kHalf, 0.0f, 0.0f, kHalf};
    case UpAxis::kMinusX:
      return {kHalf, 0.0f, 0.0f, -kHalf};
    case UpAxis::kZ:
      return {kHalf, -kHalf, 0.0f, 0.0f};
    case UpAxis::kMinusZ:
      return {kHalf, kHalf, 0.0f, 0.0f};
    case UpAxis::kMinusY:
      return {0.0f, 1.0f, 0.0f, 0.0f};
    case UpAxis::kY:
      break;
  }
  return {1.0f, 0.0f, 0.0f, 0.0f};
}

}  // namespace

void TurnUpwards(UpAxis axis, Scene& scene) {
  if (axis == UpAxis::kY) return;
  Node turn;
  turn.transform.rotation = TurnOf(axis);
  turn.children = std::move(scene.roots);
  const auto index = static_cast<int>(scene.nodes.size());
  for (const int root : turn.children) scene.nodes[static_cast<std::size_t>(root)].parent = index;
  scene.roots = {index};
  scene.nodes.push_back(std::move(turn));
}

}  // namespace burin::scene
