// SPDX-License-Identifier: Apache-2.0
#include "core/base/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

namespace burin::base {
namespace fs = std::filesystem;

namespace {

std::string Reason(int code) { return std::generic_category().message(code); }

std::unexpected<Error> CannotWrite(const std::string& path, const std::string& why) {
  return Fail(ErrorKind::kFailed, fmt::format("cannot write '{}': {}", path, why));
}

// Where a chain of links ends, even when nothing is there yet.
Result<fs::path> FollowLinks(const std::string& path) {
  std::error_code error;
  fs::path target = fs::absolute(path, error);
  if (error) return CannotWrite(path, error.message());
  constexpr int kMostLinks = 40;  // as the kernel
  for (int i = 0; i < kMostLinks; ++i) {
    if (!fs::is_symlink(target, error)) return target;
    const fs::path next = fs::read_symlink(target, error);
    if (error) return CannotWrite(path, error.message());
    target = next.is_absolute() ? next : target.parent_path() / next;
  }
  return CannotWrite(path, Reason(ELOOP));
}

// ".walk.0001.4711-3.png" for "walk.0001.png": hidden, unique in this process and among processes, same extension.
fs::path TemporaryFor(const fs::path& target, const std::string& other_extension) {
  static std::atomic<unsigned> counter{0};
  const std::string extension = other_extension.empty() ? target.extension().string() : other_extension;
  const std::string suffix = fmt::format(".{}-{}{}", getpid(), counter.fetch_add(1), extension);
  const std::string stem = target.stem().string().substr(0, NAME_MAX - suffix.size() - 1);
  return target.parent_path() / ("." + stem + suffix);
}

// Errors when `target` is something that must not be replaced; else its permissions, or 0 when it isn't there.
Result<mode_t> CheckReplaceable(const std::string& path, const fs::path& target) {
  if (target.filename().empty()) return CannotWrite(path, "it names a folder");
  struct stat status {};
  if (stat(target.c_str(), &status) != 0) {
    if (errno == ENOENT && !fs::exists(target.parent_path())) {
      return CannotWrite(path, fmt::format("the folder '{}' does not exist", target.parent_path().string()));
    }
    if (errno != ENOENT) return CannotWrite(path, Reason(errno));
    return mode_t{0};
  }
  if (S_ISDIR(status.st_mode)) return CannotWrite(path, "it is a folder");
  if (!S_ISREG(status.st_mode)) return CannotWrite(path, "it is not a regular file");
  if (access(target.c_str(), W_OK) != 0) return CannotWrite(path, Reason(errno));
  return status.st_mode & mode_t{07777};
}

}  // namespace

Result<AtomicFile> AtomicFile::Create(const std::string& path, const std::string& temporary_extension) {
  const Result<fs::path> target = FollowLinks(path);
  if (!target) return std::unexpected(target.error());
  const Result<mode_t> mode = CheckReplaceable(path, *target);
  if (!mode) return std::unexpected(mode.error());

  AtomicFile file;
  file.name_ = path;
  file.target_ = target->string();
  for (;;) {
    file.temporary_ = TemporaryFor(*target, temporary_extension).string();
    // Registered first: a signal between the two calls then still finds it.
    file.id_ = RegisterTemporary(file.temporary_);
    file.descriptor_ = open(file.temporary_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file.descriptor_ >= 0) break;
    const int failure = errno;
    UnregisterTemporary(std::exchange(file.id_, kNotRegistered));
    file.temporary_.clear();
    if (failure != EEXIST) return CannotWrite(path, Reason(failure));
  }
  // Best effort: another user's file in a shared folder keeps what our umask gives.
  if (*mode != 0) static_cast<void>(fchmod(file.descriptor_, *mode));
  return file;
}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : name_(std::move(other.name_)),
      target_(std::move(other.target_)),
      temporary_(std::exchange(other.temporary_, {})),
      descriptor_(std::exchange(other.descriptor_, -1)),
      id_(std::exchange(other.id_, kNotRegistered)) {}

AtomicFile& AtomicFile::operator=(AtomicFile&& other) noexcept {
  if (this != &other) {
    Discard();
    name_ = std::move(other.name_);
    target_ = std::move(other.target_);
    temporary_ = std::exchange(other.temporary_, {});
    descriptor_ = std::exchange(other.descriptor_, -1);
    id_ = std::exchange(other.id_, kNotRegistered);
  }
  return *this;
}

AtomicFile::~AtomicFile() { Discard(); }

void AtomicFile::Discard() noexcept {
  if (descriptor_ >= 0) close(std::exchange(descriptor_, -1));
  if (!temporary_.empty()) unlink(temporary_.c_str());
  temporary_.clear();
  UnregisterTemporary(std::exchange(id_, kNotRegistered));
}

Result<void> AtomicFile::Commit() {
  if (temporary_.empty()) return CannotWrite(name_, "it was already finished");
  // Some file systems refuse to sync (EINVAL, ENOTSUP); a full disk or a failed one shows here.
  if (fdatasync(descriptor_) != 0 && errno != EINVAL && errno != ENOTSUP && errno != ENOSYS) {
    return CannotWrite(name_, Reason(errno));
  }
  if (close(std::exchange(descriptor_, -1)) != 0) return CannotWrite(name_, Reason(errno));
  if (rename(temporary_.c_str(), target_.c_str()) != 0) return CannotWrite(name_, Reason(errno));
  temporary_.clear();
  UnregisterTemporary(std::exchange(id_, kNotRegistered));
  return {};
}

}  // namespace burin::base
