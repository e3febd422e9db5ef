// SPDX-License-Identifier: Apache-2.0
#pragma once
// A frame's triangles as files for other programs. Positions keep their bits in every format.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/scene/pose.h"
#include "core/scene/scene.h"

namespace burin::scene {

/// Takes the file's bytes in order.
using ByteSink = std::function<Result<void>(std::span<const std::byte>)>;

enum class MeshFormat : std::uint8_t { kGlb, kObj, kPly };

/// Writes the triangles of `items` with normals, texture coordinates and colours. glTF binary: a node an item, with its
/// world matrix, vertices in the item's own space, materials without their pictures. OBJ and binary PLY, which have no
/// nodes: vertices in world space, computed in double precision and rounded once; OBJ names materials only, and has v
/// upwards. Items without triangles are left out. Errors: the sink's, and kFailed for a GLB over 4 GiB.
[[nodiscard]] Result<void> WriteMesh(MeshFormat format, const Scene& scene, std::span<const DrawItem> items,
                                     const ByteSink& sink);

// One file each; without items of no triangles.
[[nodiscard]] Result<void> WriteGlb(const Scene& scene, std::span<const DrawItem* const> items, const ByteSink& sink);
[[nodiscard]] Result<void> WriteObj(const Scene& scene, std::span<const DrawItem* const> items, const ByteSink& sink);
[[nodiscard]] Result<void> WritePly(const Scene& scene, std::span<const DrawItem* const> items, const ByteSink& sink);

/// What an item is called: its node, its mesh, or "item N" where neither has a name.
[[nodiscard]] std::string NameOf(const Scene& scene, const DrawItem& item);

/// Points and directions of an item in world space: unit normals, of mirrored items too.
struct WorldVertices {
  std::vector<glm::vec3> positions, normals;
  bool is_mirrored = false;  ///< triangles turn the other way
};
[[nodiscard]] WorldVertices InWorld(const Scene& scene, const DrawItem& item);

/// Collects small pieces for a sink.
class SinkBuffer {
 public:
  explicit SinkBuffer(const ByteSink& sink) : sink_(sink) {}
  void Add(std::string_view text) { AddBytes(std::as_bytes(std::span(text))); }
  template <class T>
  void AddValues(std::span<const T> values) {
    AddBytes(std::as_bytes(values));
  }
  void AddBytes(std::span<const std::byte> bytes);
  /// What is left; the first error of any piece.
  [[nodiscard]] Result<void> Finish();

 private:
  void Flush();
  const ByteSink& sink_;
  std::vector<std::byte> bytes_;
  Result<void> result_;
};

}  // namespace burin::scene
