// SPDX-License-Identifier: Apache-2.0
#pragma once
// Linked programs on disk. Plain bytes: no GL here.
//
// One file an entry, named by a hash of its key; the file holds the whole key, so two keys of one hash never mix:
//   8 bytes  "burinPB1"
//   u32      GL's binary format
//   u32      bytes of the key
//   u64      bytes of the binary
//   u64      FNV-1a hash of the key and the binary
//   key, binary
// All numbers little-endian. Written to a temporary beside it and renamed, so readers see whole entries or none.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace burin::gl {

struct ProgramBinary {
  std::uint32_t format = 0;
  std::vector<std::byte> bytes;
};

class ProgramCache {
 public:
  /// An empty folder turns the cache off.
  explicit ProgramCache(std::string folder) : folder_(std::move(folder)) {}
  /// $XDG_CACHE_HOME/burin/programs, else ~/.cache/burin/programs; off with BURIN_NO_CACHE=1 or without a home.
  [[nodiscard]] static ProgramCache Default();

  /// Nothing when there is no entry, or one that is damaged or of another key.
  [[nodiscard]] std::optional<ProgramBinary> Load(std::string_view key) const;
  /// Failing to write is no error: the next run compiles again. Old entries go when there are more than kMaxEntries.
  void Store(std::string_view key, const ProgramBinary& binary) const;

  [[nodiscard]] bool enabled() const { return !folder_.empty(); }
  [[nodiscard]] std::string PathOf(std::string_view key) const;

  static constexpr std::size_t kMaxEntries = 1024;

 private:
  void Prune() const;
  std::string folder_;
};

}  // namespace burin::gl
