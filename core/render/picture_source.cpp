// SPDX-License-Identifier: Apache-2.0
// Single images and image sequences.
#include <fmt/format.h>

#include <algorithm>

#include "core/render/frame_list.h"
#include "core/render/name_pattern.h"
#include "core/render/source.h"

namespace burin::render {
namespace {

SourceInfo InfoOf(const image::Image& picture, SourceKind kind) {
  SourceInfo info;
  info.kind = kind;
  info.width = picture.width;
  info.height = picture.height;
  info.type = picture.type;
  info.has_alpha = picture.channels == 2 || picture.channels == 4;
  return info;
}

/// One picture for every frame number that is asked for.
class ImageSource final : public Source {
 public:
  explicit ImageSource(image::Image picture)
      : picture_(std::move(picture)), info_(InfoOf(picture_, SourceKind::kImage)) {
    info_.frames = {1};
  }
  [[nodiscard]] const SourceInfo& info() const override { return info_; }
  [[nodiscard]] Result<bool> Read(long number, SourceFrame& frame) override {
    frame.number = number;
    frame.picture = picture_;
    return true;
  }

 private:
  image::Image picture_;
  SourceInfo info_;
};

class SequenceSource final : public Source {
 public:
  SequenceSource(image::ImageModule& module, NamePattern pattern, std::vector<long> frames, long first,
                 image::Image picture, bool any_size)
      : module_(module),
        pattern_(std::move(pattern)),
        info_(InfoOf(picture, SourceKind::kSequence)),
        first_(first),
        first_picture_(std::move(picture)),
        any_size_(any_size) {
    info_.frames = std::move(frames);
  }
  [[nodiscard]] const SourceInfo& info() const override { return info_; }

  [[nodiscard]] Result<bool> Read(long number, SourceFrame& frame) override {
    frame.number = number;
    if (number == first_ && first_picture_) {
      frame.picture = std::move(first_picture_);
      first_picture_.reset();
      return true;
    }
    const std::string path = pattern_.Format(number);
    if (!std::ranges::binary_search(info_.frames, number)) {
      return Fail(ErrorKind::kInput,
                  fmt::format("{}: no such file; the sequence has the frames {}", path, FormatFrameList(info_.frames)));
    }
    auto picture = module_.Read(path);
    if (!picture) return std::unexpected(picture.error());
    if (!any_size_ && (picture->width != info_.width || picture->height != info_.height)) {
      return Fail(ErrorKind::kInput,
                  fmt::format("{}: {}x{}, but the sequence began with {}x{}; --size WxH makes them one size", path,
                              picture->width, picture->height, info_.width, info_.height));
    }
    frame.picture = *std::move(picture);
    return true;
  }

 private:
  image::ImageModule& module_;
  NamePattern pattern_;
  SourceInfo info_;
  long first_;
  std::optional<image::Image> first_picture_;
  bool any_size_;  ///< --size is given: pictures are resized
};

}  // namespace

Result<std::unique_ptr<Source>> OpenPictureSource(const Job& job, SourceKind kind) {
  auto module = image::LoadImageModule();
  if (!module) return std::unexpected(module.error());
  if (kind == SourceKind::kImage) {
    auto picture = (*module)->Read(job.source);
    if (!picture) return std::unexpected(picture.error());
    return std::make_unique<ImageSource>(*std::move(picture));
  }
  auto pattern = NamePattern::Parse(job.source);
  if (!pattern) return std::unexpected(pattern.error());
  auto frames = pattern->FindFrames();
  if (!frames) return std::unexpected(frames.error());
  if (frames->empty()) return Fail(ErrorKind::kInput, fmt::format("{}: no file has such a name", job.source));
  // The first frame that will be done sets the size; a missing one is reported when it is read.
  long first = frames->front();
  const auto there = std::ranges::find_if(job.frames, [&](long n) { return std::ranges::binary_search(*frames, n); });
  if (there != job.frames.end()) first = *there;
  auto picture = (*module)->Read(pattern->Format(first));
  if (!picture) return std::unexpected(picture.error());
  return std::make_unique<SequenceSource>(**module, *std::move(pattern), *std::move(frames), first, *std::move(picture),
                                          job.size.has_value());
}

}  // namespace burin::render
