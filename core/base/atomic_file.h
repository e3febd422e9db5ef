// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/base/error.h"
#include "core/base/temporaries.h"

namespace burin::base {

/// An output file that appears whole or not at all. Create() makes an empty temporary in the folder of `path` (its name
/// hidden, with the same extension, because libraries choose the format by it); something fills it, by name or through
/// the descriptor; Commit() flushes it to the disk and renames it. Without Commit the destructor removes it; so does
/// RemoveTemporaries() on a signal.
///
/// A link is followed, so that the link stays. A path that is no regular file (a folder, a device) and an existing file
/// without write permission are refused; an existing file's permissions are kept. Errors: kFailed, naming the path.
class AtomicFile {
 public:
  /// `temporary_extension` (".mkv"): other than that of `path`, for a library that shall write another format.
  [[nodiscard]] static Result<AtomicFile> Create(const std::string& path, const std::string& temporary_extension = {});

  AtomicFile(AtomicFile&& other) noexcept;
  AtomicFile& operator=(AtomicFile&& other) noexcept;
  ~AtomicFile();

  [[nodiscard]] const std::string& temporary_path() const { return temporary_; }
  /// Open for reading and writing at the start of the temporary; owned by this object.
  [[nodiscard]] int descriptor() const { return descriptor_; }

  [[nodiscard]] Result<void> Commit();

 private:
  AtomicFile() = default;
  void Discard() noexcept;

  std::string name_;       ///< as the caller wrote it, for messages
  std::string target_;     ///< links followed, absolute
  std::string temporary_;  ///< empty once committed or moved from
  int descriptor_ = -1;
  TemporaryId id_ = kNotRegistered;
};

}  // namespace burin::base
