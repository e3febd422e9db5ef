// SPDX-License-Identifier: Apache-2.0
#pragma once
// The JSON text of a glTF file: parsed, checked against the schema tables, and split into what is read by our own code
// (buffers, images, extension lists) and the rest, which tinygltf parses.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"

namespace burin::scene {

struct BufferEntry {
  std::optional<std::string> uri;
  std::uint64_t byte_length = 0;
};

/// Either `uri` or `buffer_view` is there, or none when an extension holds the image.
struct ImageEntry {
  std::string name;
  std::string mime_type;
  std::optional<std::string> uri;
  int buffer_view = -1;
};

struct GltfJson {
  std::vector<BufferEntry> buffers;
  std::vector<ImageEntry> images;
  std::vector<std::string> extensions_used;
  std::vector<std::string> extensions_required;
  std::string rest;  ///< the document without buffers and images, types and indices checked
};

/// Checks types, ranges, required properties and every index of the document. Messages name the object by its JSON
/// path.
[[nodiscard]] Result<GltfJson> ParseGltfJson(std::string_view text);

}  // namespace burin::scene
