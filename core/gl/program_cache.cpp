// SPDX-License-Identifier: Apache-2.0
#include "core/gl/program_cache.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace burin::gl {
namespace {

namespace fs = std::filesystem;

static_assert(std::endian::native == std::endian::little, "the cache's numbers are little-endian");

struct Header {
  std::array<char, 8> magic{'b', 'u', 'r', 'i', 'n', 'P', 'B', '1'};
  std::uint32_t format = 0;
  std::uint32_t key_bytes = 0;
  std::uint64_t binary_bytes = 0;
  std::uint64_t hash = 0;
};
static_assert(sizeof(Header) == 32);

// FNV-1a, 64 bits (Fowler, Noll, Vo; draft-eastlake-fnv).
constexpr std::uint64_t kFnvBasis = 0xcbf29ce484222325u;
constexpr std::uint64_t kFnvPrime = 0x100000001b3u;

std::uint64_t Fnv(const void* data, std::size_t size, std::uint64_t hash = kFnvBasis) {
  const auto* bytes = static_cast<const unsigned char*>(data);
  for (std::size_t i = 0; i < size; ++i) hash = (hash ^ bytes[i]) * kFnvPrime;
  return hash;
}

std::uint64_t ContentHash(std::string_view key, const std::vector<std::byte>& binary) {
  return Fnv(binary.data(), binary.size(), Fnv(key.data(), key.size()));
}

std::optional<std::vector<char>> ReadFile(const std::string& path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file) return std::nullopt;
  const std::streamoff size = file.tellg();
  if (size < 0) return std::nullopt;
  std::vector<char> data(static_cast<std::size_t>(size));
  file.seekg(0);
  if (!file.read(data.data(), size)) return std::nullopt;
  return data;
}

std::string Variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? std::string() : std::string(value);
}

}  // namespace

ProgramCache ProgramCache::Default() {
  const std::string off = Variable("BURIN_NO_CACHE");
  if (!off.empty() && off != "0") return ProgramCache("");
  // The XDG base directory specification: a relative path counts as unset.
  if (const std::string base = Variable("XDG_CACHE_HOME"); base.starts_with('/'))
    return ProgramCache(base + "/burin/programs");
  if (const std::string home = Variable("HOME"); home.starts_with('/'))
    return ProgramCache(home + "/.cache/burin/programs");
  return ProgramCache("");
}

std::string ProgramCache::PathOf(std::string_view key) const {
  return fmt::format("{}/{:016x}.bin", folder_, Fnv(key.data(), key.size()));
}

std::optional<ProgramBinary> ProgramCache::Load(std::string_view key) const {
  if (!enabled()) return std::nullopt;
  const std::optional<std::vector<char>> data = ReadFile(PathOf(key));
  if (!data || data->size() < sizeof(Header)) return std::nullopt;
  Header header;
  std::memcpy(&header, data->data(), sizeof(header));
  const std::size_t rest = data->size() - sizeof(header);
  if (header.magic != Header{}.magic || header.key_bytes != key.size() || header.key_bytes > rest ||
      header.binary_bytes != rest - header.key_bytes) {
    return std::nullopt;
  }
  const char* stored_key = data->data() + sizeof(header);
  if (std::string_view(stored_key, header.key_bytes) != key) return std::nullopt;
  ProgramBinary binary{.format = header.format, .bytes = std::vector<std::byte>(header.binary_bytes)};
  if (!binary.bytes.empty()) std::memcpy(binary.bytes.data(), stored_key + header.key_bytes, binary.bytes.size());
  if (ContentHash(key, binary.bytes) != header.hash) return std::nullopt;
  return binary;
}

void ProgramCache::Store(std::string_view key, const ProgramBinary& binary) const {
  if (!enabled() || binary.bytes.empty()) return;
  std::error_code error;
  fs::create_directories(folder_, error);
  if (error) return;
  const std::string path = PathOf(key);
  const std::string temporary = fmt::format("{}.{}.tmp", path, getpid());
  const Header header{.format = binary.format,
                      .key_bytes = static_cast<std::uint32_t>(key.size()),
                      .binary_bytes = binary.bytes.size(),
                      .hash = ContentHash(key, binary.bytes)};
  {
    std::ofstream file(temporary, std::ios::binary | std::ios::trunc);
    file.write(reinterpret_cast<const char*>(&header), sizeof(header));
    file.write(key.data(), static_cast<std::streamsize>(key.size()));
    file.write(reinterpret_cast<const char*>(binary.bytes.data()), static_cast<std::streamsize>(binary.bytes.size()));
    file.flush();
    if (!file) {
      file.close();
      fs::remove(temporary, error);
      return;
    }
  }
  fs::rename(temporary, path, error);
  if (error) fs::remove(temporary, error);
  Prune();
}

void ProgramCache::Prune() const {
  struct Entry {
    fs::file_time_type time;
    fs::path path;
  };
  std::vector<Entry> entries;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_, error)) {
    std::error_code ignored;
    entries.push_back({entry.last_write_time(ignored), entry.path()});
  }
  if (entries.size() <= kMaxEntries) return;
  // Half at once, so that a full cache isn't sorted for every program.
  std::ranges::sort(entries, {}, &Entry::time);
  for (std::size_t i = 0; i < entries.size() / 2; ++i) fs::remove(entries[i].path, error);
}

}  // namespace burin::gl
