// SPDX-License-Identifier: Apache-2.0
#include "core/scene/scene_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>

namespace burin::scene {
namespace {

namespace fs = std::filesystem;

class FileDescriptor {
 public:
  explicit FileDescriptor(int fd) : fd_(fd) {}
  ~FileDescriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;
  [[nodiscard]] int get() const { return fd_; }

 private:
  int fd_;
};

std::unexpected<Error> Bad(std::string message) { return Fail(ErrorKind::kInput, std::move(message)); }

/// RFC 3986, 3.1: letters, digits, '+', '-', '.' before the first ':'.
bool HasScheme(std::string_view uri) {
  const std::size_t colon = uri.find(':');
  if (colon == std::string_view::npos || colon == 0) return false;
  return std::all_of(uri.begin(), uri.begin() + static_cast<std::ptrdiff_t>(colon),
                     [](unsigned char c) { return std::isalnum(c) != 0 || c == '+' || c == '-' || c == '.'; });
}

int HexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

bool IsInside(const fs::path& file, const fs::path& folder) {
  const auto [end, rest] = std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
  return end == folder.end() && rest != file.end();
}

}  // namespace

Result<std::vector<std::byte>> ReadRegularFile(const std::string& path, std::uint64_t max_bytes) {
  // O_NONBLOCK: opening a pipe must not wait for its writer.
  const FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (file.get() < 0) return Bad(fmt::format("cannot be opened: {}", std::strerror(errno)));
  struct stat status {};
  if (::fstat(file.get(), &status) != 0) return Bad(fmt::format("cannot be read: {}", std::strerror(errno)));
  if (!S_ISREG(status.st_mode)) return Bad("is not a regular file");
  const auto size = static_cast<std::uint64_t>(status.st_size);
  if (size > max_bytes) return Bad(fmt::format("has {} bytes, over the limit of {}", size, max_bytes));

  std::vector<std::byte> bytes(size);
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t count = ::read(file.get(), bytes.data() + done, bytes.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return Bad(fmt::format("cannot be read: {}", std::strerror(errno)));
    if (count == 0) return Bad("shrank while it was read");
    done += static_cast<std::size_t>(count);
  }
  return bytes;
}

Result<std::string> PercentDecode(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      out += text[i];
      continue;
    }
    const int high = i + 2 < text.size() ? HexDigit(text[i + 1]) : -1;
    const int low = high >= 0 ? HexDigit(text[i + 2]) : -1;
    if (low < 0) return Bad(fmt::format("bad percent escape at \"{}\"", text.substr(i, 3)));
    out += static_cast<char>(high * 16 + low);
    i += 2;
  }
  if (out.find('\0') != std::string::npos) return Bad("holds a NUL character");
  return out;
}

SceneFolder::SceneFolder(const std::string& scene_path) {
  const fs::path parent = fs::path(scene_path).parent_path();
  std::error_code error;
  folder_ = fs::canonical(parent.empty() ? fs::path(".") : parent, error).string();
}

Result<std::string> SceneFolder::Resolve(std::string_view uri) const {
  if (HasScheme(uri)) return Bad("is a URL; only files in the scene's folder are read");
  auto decoded = PercentDecode(uri);
  if (!decoded) return std::unexpected(decoded.error());
  std::replace(decoded->begin(), decoded->end(), '\\', '/');  // some Windows exporters leave them in
  if (decoded->empty()) return Bad("is empty");
  if (decoded->front() == '/') return Bad("is an absolute path; only files in the scene's folder are read");
  // "..": judged on the text first, so that a refusal does not tell what exists outside.
  const fs::path relative = fs::path(*decoded).lexically_normal();
  if (relative.begin() != relative.end() && *relative.begin() == "..") return Bad("leaves the scene's folder");

  std::error_code error;
  const fs::path resolved = fs::canonical(fs::path(folder_) / relative, error);
  if (error) return Bad(fmt::format("cannot be opened: {}", error.message()));
  if (!IsInside(resolved, folder_)) return Bad("leaves the scene's folder");
  return resolved.string();
}

}  // namespace burin::scene
