// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "fx_parser/source/file_system.h"

namespace burin::fx {

namespace {

std::string Fold(const std::string& path) {
  std::string folded = path;
  for (char& c : folded) {
    if (c == '\\') c = '/';
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return folded;
}

}  // namespace

std::expected<std::string, std::string> InMemoryFileSystem::Read(const std::string& path) const {
  const auto found = files.find(path);
  if (found == files.end()) return std::unexpected("No such file or directory");
  return found->second;
}

std::string InMemoryFileSystem::Find(const std::string& path) const {
  if (files.contains(path)) return path;
  const auto found =
      std::ranges::find_if(files, [&](const auto& file) { return Fold(file.first) == Fold(path); });
  return found == files.end() ? std::string() : found->first;
}

}  // namespace burin::fx
