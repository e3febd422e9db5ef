// SPDX-License-Identifier: Apache-2.0
#include "core/translucency/body_maps.h"

#include "core/translucency/pass_target.h"

namespace burin::translucency {
namespace {

Result<void> Take(gl::Texture& texture, Result<gl::Texture> made) {
  if (!made) return std::unexpected(made.error());
  texture = *std::move(made);
  return {};
}

}  // namespace

Result<void> BodyMaps::Ensure(const Quality& quality, bool has_parts) {
  const int s = quality.face_texels;
  const int r = s >> quality.receiver_shift;
  if (face_depth.height() != s) {
    if (auto good = Take(face_depth, CreateDepthTexture(6 * s, s, "translucency: depth of faces")); !good) return good;
    if (auto good = Take(sources, CreateBitsTexture(6 * s, 4 * s, "translucency: sources")); !good) return good;
    depth_target = CreateTarget({}, &face_depth, "translucency: depth of faces");
    if (!quality.is_paper()) {
      auto good = Take(face_deepest, CreateDepthTexture(6 * s, s, "translucency: greatest depth of faces"));
      if (!good) return good;
      deepest_target = CreateTarget({}, &face_deepest, "translucency: greatest depth of faces");
    }
    pyramid_target = CreateTarget({&sources}, nullptr, "translucency: sources");
    receivers = {};
  }
  const bool lacks_parts = has_parts && !near_receivers;
  if (receivers.height() == 2 * r && !lacks_parts) return {};
  if (auto good = Take(receivers, CreateFloatTexture(6 * r, 2 * r, "translucency: radiosity")); !good) return good;
  if (!has_parts && !near_receivers) return {};
  return Take(near_receivers, CreateFloatTexture(6 * r, 2 * r, "translucency: radiosity from nearby"));
}

std::size_t BytesOfMaps(const Quality& quality, bool has_parts, int shadow_maps) {
  const auto s = static_cast<std::size_t>(quality.face_texels);
  const std::size_t r = s >> quality.receiver_shift;
  const auto shadow = static_cast<std::size_t>(quality.shadow_texels);
  const std::size_t depth = 2 * 6 * s * s * 4;
  const std::size_t sources = 6 * s * 4 * s * 16;
  const std::size_t receivers = 6 * r * 2 * r * 16 * (has_parts ? 2 : 1);
  return depth + sources + receivers + static_cast<std::size_t>(shadow_maps) * shadow * shadow * 4;
}

Result<void> SourceSums::Ensure(int face_texels) {
  if (light.width() >= 6 * face_texels) return {};
  const int s = face_texels;
  if (auto good = Take(light, CreateFloatTexture(6 * s, 2 * s, "translucency: sums of light")); !good) return good;
  if (auto good = Take(place, CreateFloatTexture(6 * s, 2 * s, "translucency: sums of places")); !good) return good;
  target = CreateTarget({&light, &place}, nullptr, "translucency: sums");
  return {};
}

}  // namespace burin::translucency
