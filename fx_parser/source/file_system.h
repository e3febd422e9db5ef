// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <expected>
#include <map>
#include <string>

namespace burin::fx {

/// Where includes come from. Tests and fuzzers use InMemoryFileSystem.
class FileSystem {
 public:
  virtual ~FileSystem() = default;
  /// The text of a regular file of at most 16 MiB, or the reason in words ("No such file or directory").
  [[nodiscard]] virtual std::expected<std::string, std::string> Read(const std::string& path) const = 0;
  /// The path as it exists, found without regard to case and with '\\' as a separator; empty if there is none.
  [[nodiscard]] virtual std::string Find(const std::string& path) const = 0;
};

class DiskFileSystem final : public FileSystem {
 public:
  [[nodiscard]] std::expected<std::string, std::string> Read(const std::string& path) const override;
  [[nodiscard]] std::string Find(const std::string& path) const override;
};

class InMemoryFileSystem final : public FileSystem {
 public:
  std::map<std::string, std::string> files;
  [[nodiscard]] std::expected<std::string, std::string> Read(const std::string& path) const override;
  [[nodiscard]] std::string Find(const std::string& path) const override;
};

}  // namespace burin::fx
