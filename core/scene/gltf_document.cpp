// SPDX-License-Identifier: Apache-2.0
#include "core/scene/gltf_document.h"

// tinygltf 2.7 turns the JSON into its model and does nothing else: it gets a text without buffers and images, and file
// callbacks that find nothing. (Its own loading reads paths outside the scene's folder, decodes every image, and copies
// from buffer views without a range check.)

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <exception>

#include "core/scene/data_uri.h"
#include "core/scene/glb_container.h"

namespace burin::scene {
namespace {

constexpr std::uint64_t kMaxFileBytes = 0xffff'ffffu;  // what a GLB header can say
constexpr std::uint64_t kMaxJsonBytes = 0x7fff'ffffu;
// Decoded arrays are at most some 16 times as large as their bytes (flat normals of byte-sized attributes); sharing of
// accessors by primitives comes on top.
constexpr std::uint64_t kDecodedBytesBase = std::uint64_t{512} << 20;
constexpr std::uint64_t kDecodedBytesFactor = 64;

constexpr std::size_t kMaxWarnings = 30;

// What the readers here know. Others are ignored with a warning, or refused when required.
constexpr std::string_view kKnownExtensions[] = {
    "KHR_lights_punctual",
    "KHR_materials_diffuse_transmission",
    "KHR_materials_emissive_strength",
    "KHR_materials_ior",
    "KHR_materials_unlit",
    "KHR_materials_volume",
    "KHR_mesh_quantization",
    "KHR_texture_transform",
};

bool IsKnown(std::string_view extension) {
  return std::find(std::begin(kKnownExtensions), std::end(kKnownExtensions), extension) != std::end(kKnownExtensions);
}

std::unexpected<Error> Bad(std::string message) { return Fail(ErrorKind::kInput, std::move(message)); }

bool NoSuchFile(const std::string&, void*) { return false; }
std::string SamePath(const std::string& path, void*) { return path; }
bool RefuseRead(std::vector<unsigned char>*, std::string* error, const std::string&, void*) {
  *error = "files are not read here";
  return false;
}
bool RefuseWrite(std::string* error, const std::string&, const std::vector<unsigned char>&, void*) {
  *error = "files are not written here";
  return false;
}
bool NoImage(tinygltf::Image*, int, std::string*, std::string*, int, int, const unsigned char*, int, void*) {
  return false;
}

/// The bytes that a URI names, a data URI or a file in the scene's folder.
Result<std::vector<std::byte>> ReadUri(const SceneFolder& folder, const std::string& uri) {
  if (IsDataUri(uri)) return DecodeDataUri(uri);
  auto path = folder.Resolve(uri);
  Result<std::vector<std::byte>> bytes =
      path ? ReadRegularFile(*path, kMaxFileBytes) : Result<std::vector<std::byte>>(std::unexpected(path.error()));
  if (!bytes) return Bad(fmt::format("\"{}\" {}", uri.substr(0, 200), bytes.error().message));
  return bytes;
}

}  // namespace

GltfDocument::GltfDocument(const std::string& path) : folder_(path) {}
GltfDocument::GltfDocument(GltfDocument&&) noexcept = default;
GltfDocument::~GltfDocument() = default;

Result<GltfDocument> GltfDocument::Open(const std::string& path) {
  GltfDocument document(path);
  auto file = ReadRegularFile(path, kMaxFileBytes);
  if (!file) return std::unexpected(file.error());
  document.file_ = std::move(*file);
  const std::span<const std::byte> bytes = document.file_;
  GlbChunks chunks;
  if (IsGlb(bytes)) {
    auto read = ReadGlbChunks(bytes);
    if (!read) return std::unexpected(read.error());
    chunks = *read;
  } else {
    chunks.json = {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }
  if (chunks.json.size() > kMaxJsonBytes) return Bad("more than 2 GiB of JSON");
  auto json = ParseGltfJson(chunks.json);
  if (!json) return std::unexpected(json.error());
  document.json_ = std::move(*json);
  if (auto ok = document.CheckExtensions(); !ok) return std::unexpected(ok.error());
  if (auto ok = document.LoadBuffers(chunks.bin.value_or(std::span<const std::byte>()), chunks.bin.has_value()); !ok) {
    return std::unexpected(ok.error());
  }
  if (auto ok = document.ParseModel(); !ok) return std::unexpected(ok.error());
  if (auto ok = document.CheckViews(); !ok) return std::unexpected(ok.error());
  return document;
}

Result<void> GltfDocument::CheckExtensions() {
  for (const std::string& extension : json_.extensions_required) {
    if (!IsKnown(extension)) {
      return Bad(fmt::format("needs the extension {}, which is not supported", extension));
    }
  }
  for (const std::string& extension : json_.extensions_used) {
    if (!IsKnown(extension)) Warn(fmt::format("the extension {} is ignored", extension));
  }
  return {};
}

Result<void> GltfDocument::LoadBuffers(std::span<const std::byte> glb_bin, bool has_bin) {
  buffers_.resize(json_.buffers.size());
  std::uint64_t input_bytes = file_.size();
  for (std::size_t i = 0; i < buffers_.size(); ++i) {
    const BufferEntry& entry = json_.buffers[i];
    GltfBuffer& buffer = buffers_[i];
    if (entry.uri) {
      auto bytes = ReadUri(folder_, *entry.uri);
      if (!bytes) return Bad(fmt::format("buffers[{}]: {}", i, bytes.error().message));
      buffer.owned = std::move(*bytes);
      buffer.bytes = buffer.owned;
    } else if (i == 0 && has_bin) {
      buffer.bytes = glb_bin;
    } else {
      return Bad(fmt::format("buffers[{}]: has no \"uri\", and the file holds no data for it", i));
    }
    if (buffer.bytes.size() < entry.byte_length) {
      return Bad(fmt::format("buffers[{}]: byteLength is {}, but its data has {} bytes", i, entry.byte_length,
                             buffer.bytes.size()));
    }
    buffer.bytes = buffer.bytes.first(entry.byte_length);
    input_bytes += buffer.owned.size();
  }
  max_spent_bytes_ = kDecodedBytesBase + kDecodedBytesFactor * input_bytes;
  json_.buffers.clear();  // data URIs are long
  return {};
}

Result<void> GltfDocument::ParseModel() {
  model_ = std::make_unique<tinygltf::Model>();
  tinygltf::TinyGLTF loader;
  loader.SetFsCallbacks({&NoSuchFile, &SamePath, &RefuseRead, &RefuseWrite, nullptr});
  loader.SetImageLoader(&NoImage, nullptr);
  std::string error;
  std::string warning;
  try {
    if (!loader.LoadASCIIFromString(model_.get(), &error, &warning, json_.rest.data(),
                                    static_cast<unsigned int>(json_.rest.size()), "")) {
      while (!error.empty() && error.back() == '\n') error.pop_back();
      return Bad(error.empty() ? "cannot be parsed" : error);
    }
  } catch (const std::exception& exception) {
    return Bad(fmt::format("cannot be parsed: {}", exception.what()));
  }
  json_.rest = std::string();
  return {};
}

Result<void> GltfDocument::CheckViews() const {
  for (std::size_t i = 0; i < model_->bufferViews.size(); ++i) {
    const tinygltf::BufferView& view = model_->bufferViews[i];
    const std::size_t size = buffers_[static_cast<std::size_t>(view.buffer)].bytes.size();
    if (view.byteOffset > size || view.byteLength > size - view.byteOffset) {
      return Bad(fmt::format("bufferViews[{}]: {} bytes from {} do not fit in buffer {} of {} bytes", i,
                             view.byteLength, view.byteOffset, view.buffer, size));
    }
  }
  return {};
}

bool GltfDocument::Uses(std::string_view extension) const {
  return std::find(json_.extensions_used.begin(), json_.extensions_used.end(), extension) !=
         json_.extensions_used.end();
}

std::span<const std::byte> GltfDocument::ViewBytes(int buffer_view) const {
  const tinygltf::BufferView& view = model_->bufferViews[static_cast<std::size_t>(buffer_view)];
  return buffers_[static_cast<std::size_t>(view.buffer)].bytes.subspan(view.byteOffset, view.byteLength);
}

Result<std::vector<std::byte>> GltfDocument::ImageBytes(int image) const {
  const ImageEntry& entry = json_.images[static_cast<std::size_t>(image)];
  if (entry.buffer_view >= 0) {
    const std::span<const std::byte> bytes = ViewBytes(entry.buffer_view);
    return std::vector<std::byte>(bytes.begin(), bytes.end());
  }
  if (!entry.uri) return Bad("has neither \"uri\" nor \"bufferView\"");
  return ReadUri(folder_, *entry.uri);
}

void GltfDocument::Warn(std::string message) {
  if (warnings_.size() > kMaxWarnings) return;
  if (std::find(warnings_.begin(), warnings_.end(), message) != warnings_.end()) return;
  warnings_.push_back(warnings_.size() == kMaxWarnings ? "more warnings like these are left out" : std::move(message));
}

Result<void> GltfDocument::Spend(std::uint64_t bytes) {
  if (bytes > max_spent_bytes_ - std::min(spent_bytes_, max_spent_bytes_)) {
    return Bad(fmt::format("the arrays of a scene of this size may not take more than {} MiB", max_spent_bytes_ >> 20));
  }
  spent_bytes_ += bytes;
  return {};
}

}  // namespace burin::scene
