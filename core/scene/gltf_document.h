// SPDX-License-Identifier: Apache-2.0
#pragma once
// A glTF file in memory: its JSON as tinygltf's model, its buffers and images as bytes. Every index of the JSON is in
// range and every buffer view lies in its buffer; accessors are checked when they are read (gltf_accessor.h).

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/scene/gltf_json.h"
#include "core/scene/scene_folder.h"

namespace tinygltf {
class Model;
}

namespace burin::scene {

struct GltfBuffer {
  std::vector<std::byte> owned;  ///< empty when the bytes are the GLB's own
  std::span<const std::byte> bytes;
};

class GltfDocument {
 public:
  /// Messages lack the scene's path: ReadGltf adds it.
  [[nodiscard]] static Result<GltfDocument> Open(const std::string& path);

  GltfDocument(GltfDocument&&) noexcept;
  ~GltfDocument();

  [[nodiscard]] const tinygltf::Model& model() const { return *model_; }
  [[nodiscard]] const std::vector<ImageEntry>& images() const { return json_.images; }
  [[nodiscard]] bool Uses(std::string_view extension) const;
  [[nodiscard]] std::span<const std::byte> ViewBytes(int buffer_view) const;
  /// The encoded bytes of an image, from wherever it is.
  [[nodiscard]] Result<std::vector<std::byte>> ImageBytes(int image) const;

  void Warn(std::string message);
  [[nodiscard]] std::vector<std::string> TakeWarnings() { return std::move(warnings_); }

  /// Counts the memory that decoded arrays take, so that a small file cannot ask for all of it by naming one accessor
  /// many times: the limit grows with the size of the file and its buffers.
  [[nodiscard]] Result<void> Spend(std::uint64_t bytes);
  [[nodiscard]] std::uint64_t spent_bytes() const { return spent_bytes_; }
  /// After arrays were dropped: what is really in use.
  void SetSpent(std::uint64_t bytes) { spent_bytes_ = bytes; }

 private:
  explicit GltfDocument(const std::string& path);
  [[nodiscard]] Result<void> CheckExtensions();
  [[nodiscard]] Result<void> LoadBuffers(std::span<const std::byte> glb_bin, bool has_bin);
  [[nodiscard]] Result<void> ParseModel();
  [[nodiscard]] Result<void> CheckViews() const;

  SceneFolder folder_;
  std::vector<std::byte> file_;
  GltfJson json_;
  std::vector<GltfBuffer> buffers_;
  std::unique_ptr<tinygltf::Model> model_;
  std::vector<std::string> warnings_;
  std::uint64_t spent_bytes_ = 0;
  std::uint64_t max_spent_bytes_ = 0;
};

}  // namespace burin::scene
