// SPDX-License-Identifier: Apache-2.0
#include "core/scene/glb_container.h"

#include <fmt/format.h>

#include <cstdint>
#include <cstring>

namespace burin::scene {
namespace {

constexpr std::size_t kHeaderBytes = 12;
constexpr std::size_t kChunkHeaderBytes = 8;
constexpr std::uint32_t kMagic = 0x46546c67;  // "glTF"
constexpr std::uint32_t kJson = 0x4e4f534a;
constexpr std::uint32_t kBin = 0x004e4942;

std::uint32_t ReadU32(std::span<const std::byte> bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value |= std::to_integer<std::uint32_t>(bytes[at + i]) << (8 * i);
  return value;
}

std::unexpected<Error> Bad(std::string message) { return Fail(ErrorKind::kInput, std::move(message)); }

}  // namespace

bool IsGlb(std::span<const std::byte> file) { return file.size() >= 4 && ReadU32(file, 0) == kMagic; }

Result<GlbChunks> ReadGlbChunks(std::span<const std::byte> file) {
  if (file.size() < kHeaderBytes) return Bad(fmt::format("truncated: {} bytes, a GLB header has 12", file.size()));
  const std::uint32_t version = ReadU32(file, 4);
  if (version != 2) return Bad(fmt::format("GLB version {} is not supported, expected 2", version));
  const std::uint32_t length = ReadU32(file, 8);
  if (length > file.size()) {
    return Bad(fmt::format("truncated: the GLB header says {} bytes, the file has {}", length, file.size()));
  }
  file = file.first(length);

  GlbChunks chunks;
  std::size_t at = kHeaderBytes;
  for (int index = 0; at < file.size(); ++index) {
    if (file.size() - at < kChunkHeaderBytes) return Bad(fmt::format("GLB chunk {}: its header is truncated", index));
    const std::uint32_t size = ReadU32(file, at);
    const std::uint32_t type = ReadU32(file, at + 4);
    at += kChunkHeaderBytes;
    if (size > file.size() - at) {
      return Bad(
          fmt::format("GLB chunk {}: {} bytes, but only {} are left in the file", index, size, file.size() - at));
    }
    const std::span<const std::byte> data = file.subspan(at, size);
    if (index == 0) {
      if (type != kJson) return Bad("GLB chunk 0: expected JSON");
      chunks.json = {reinterpret_cast<const char*>(data.data()), data.size()};
    } else if (index == 1 && type == kBin) {
      chunks.bin = data;
    }
    at += size;
  }
  if (chunks.json.empty()) return Bad("GLB without a JSON chunk");
  return chunks;
}

}  // namespace burin::scene
