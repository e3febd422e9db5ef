// SPDX-License-Identifier: Apache-2.0
#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "fx_parser/source/file_system.h"

namespace burin::fx {

namespace {

constexpr std::size_t kMaxFileSize = std::size_t{16} << 20;
// Each level may branch where names differ only in case.
constexpr std::size_t kMaxComponents = 64;
constexpr int kMaxLookUps = 1000;

std::string SystemMessage(int code) { return std::strerror(code); }

class Descriptor {
 public:
  // O_NONBLOCK: opening a FIFO that nobody writes must not hang.
  explicit Descriptor(const std::string& path) : fd_(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {}
  ~Descriptor() {
    if (fd_ >= 0) close(fd_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] int get() const { return fd_; }

 private:
  int fd_;
};

bool IsFile(const std::string& path) {
  struct stat status{};
  return stat(path.c_str(), &status) == 0 && !S_ISDIR(status.st_mode);
}

bool Exists(const std::string& path) {
  struct stat status{};
  return stat(path.c_str(), &status) == 0;
}

bool SameIgnoringCase(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  return std::ranges::equal(a, b, {}, lower, lower);
}

std::vector<std::string> Split(const std::string& path) {
  std::vector<std::string> components;
  std::string component;
  for (const char c : path + "/") {
    if (c != '/') {
      component += c;
    } else if (!component.empty()) {
      components.push_back(std::exchange(component, {}));
    }
  }
  return components;
}

// The entries of `folder` that equal `name` but for case, in a fixed order.
std::vector<std::string> Matches(const std::string& folder, const std::string& name) {
  std::vector<std::string> matches;
  const std::unique_ptr<DIR, int (*)(DIR*)> entries(opendir(folder.empty() ? "." : folder.c_str()), closedir);
  if (!entries) return matches;
  while (const dirent* entry = readdir(entries.get())) {
    if (SameIgnoringCase(entry->d_name, name)) matches.emplace_back(entry->d_name);
  }
  std::ranges::sort(matches);
  return matches;
}

class CaseInsensitiveSearch {
 public:
  explicit CaseInsensitiveSearch(std::vector<std::string> components) : components_(std::move(components)) {}

  std::string Find(const std::string& folder, std::size_t next) {
    if (next == components_.size()) return IsFile(folder) ? folder : std::string();
    if (++look_ups_ > kMaxLookUps) return {};
    const std::string prefix = folder.empty() || folder == "/" ? folder : folder + "/";
    const std::string& name = components_[next];
    if (Exists(prefix + name)) {
      if (std::string found = Find(prefix + name, next + 1); !found.empty()) return found;
    }
    for (const std::string& match : Matches(folder, name)) {
      if (match == name) continue;
      if (std::string found = Find(prefix + match, next + 1); !found.empty()) return found;
    }
    return {};
  }

 private:
  std::vector<std::string> components_;
  int look_ups_ = 0;
};

}  // namespace

std::expected<std::string, std::string> DiskFileSystem::Read(const std::string& path) const {
  if (path.contains('\0')) return std::unexpected("the path has a zero byte");
  const Descriptor file(path);
  if (file.get() < 0) return std::unexpected(SystemMessage(errno));
  struct stat status{};
  if (fstat(file.get(), &status) != 0) return std::unexpected(SystemMessage(errno));
  if (S_ISDIR(status.st_mode)) return std::unexpected("it is a directory");
  if (!S_ISREG(status.st_mode)) return std::unexpected("it is not a regular file");
  std::string text;
  std::string buffer(std::size_t{1} << 16, '\0');
  for (;;) {
    const ssize_t count = read(file.get(), buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return std::unexpected(SystemMessage(errno));
    if (count == 0) return text;
    text.append(buffer, 0, static_cast<std::size_t>(count));
    if (text.size() > kMaxFileSize) return std::unexpected("it is larger than 16 MiB");
  }
}

std::string DiskFileSystem::Find(const std::string& path) const {
  if (path.empty() || path.contains('\0')) return {};
  if (IsFile(path)) return path;
  std::string slashed = path;
  std::ranges::replace(slashed, '\\', '/');
  if (IsFile(slashed)) return slashed;
  std::vector<std::string> components = Split(slashed);
  if (components.empty() || components.size() > kMaxComponents) return {};
  return CaseInsensitiveSearch(std::move(components)).Find(slashed.starts_with('/') ? "/" : "", 0);
}

}  // namespace burin::fx
