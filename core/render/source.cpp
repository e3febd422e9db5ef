// SPDX-License-Identifier: Apache-2.0
#include "core/render/source.h"

#include <fmt/format.h>

#include <filesystem>

#include "core/base/path.h"
#include "core/render/name_pattern.h"
#include "core/scene/read_scene.h"

namespace burin::render {
namespace {

/// Frames without a picture, for effects that need none.
class EmptySource final : public Source {
 public:
  EmptySource() { info_.frames = {1}; }
  [[nodiscard]] const SourceInfo& info() const override { return info_; }
  [[nodiscard]] Result<bool> Read(long number, SourceFrame& frame) override {
    frame.number = number;
    frame.picture.reset();
    return true;
  }

 private:
  SourceInfo info_;
};

}  // namespace

SourceKind ClassifySource(const std::string& source) {
  if (source.empty()) return SourceKind::kNone;
  if (source == "-") return SourceKind::kY4mStream;
  if (scene::IsScenePath(source)) return SourceKind::kScene;
  if (base::LowerExtension(source) == "y4m") return SourceKind::kY4mFile;
  if (video::IsVideoPath(source)) return SourceKind::kVideo;
  std::error_code status;
  if (std::filesystem::exists(source, status)) return SourceKind::kImage;
  const auto pattern = NamePattern::Parse(source);
  return pattern && !pattern->has_token() ? SourceKind::kImage : SourceKind::kSequence;
}

Result<std::unique_ptr<Source>> OpenSource(const Job& job, bool wants_tangents) {
  const SourceKind kind = ClassifySource(job.source);
  if (kind != SourceKind::kNone && kind != SourceKind::kY4mStream && kind != SourceKind::kSequence) {
    std::error_code status;
    if (!std::filesystem::exists(job.source, status)) {
      return Fail(ErrorKind::kInput, fmt::format("{}: no such file", job.source));
    }
    if (std::filesystem::is_directory(job.source, status)) {
      return Fail(ErrorKind::kInput, fmt::format("{}: a folder; expected a scene, an image or a video", job.source));
    }
  }
  switch (kind) {
    case SourceKind::kNone:
      return std::make_unique<EmptySource>();
    case SourceKind::kScene:
      return OpenSceneSource(job, wants_tangents);
    case SourceKind::kImage:
    case SourceKind::kSequence:
      return OpenPictureSource(job, kind);
    case SourceKind::kVideo:
    case SourceKind::kY4mFile:
    case SourceKind::kY4mStream:
      return OpenVideoSource(job, kind);
  }
  return Fail(ErrorKind::kFailed, "unreachable: unknown kind of source");
}

}  // namespace burin::render
