// SPDX-License-Identifier: Apache-2.0
#include "core/image/file_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <string_view>

#include "core/base/path.h"

namespace burin::image {
namespace {

struct WritableFormat {
  std::string_view extension;
  std::string_view name;
  std::initializer_list<SampleType> types;
  std::string_view alternatives;  ///< for the types that it lacks
};

constexpr std::string_view kIntegersElsewhere = "8- and 16-bit samples go into .png or .tif, exact ids into .exr";
constexpr std::string_view kFloatsElsewhere = "floating-point samples go into .exr, .tif or .hdr, exact ids into .exr";
constexpr std::string_view kWiderElsewhere =
    "16-bit samples go into .png or .tif, floating-point ones into .exr, .tif or .hdr, exact ids into .exr";
constexpr std::string_view kIdsElsewhere = "exact 32-bit ids go into .exr";

constexpr std::array<WritableFormat, 7> kWritable{{
    {"png", "PNG", {SampleType::kU8, SampleType::kU16}, kFloatsElsewhere},
    {"jpg", "JPEG", {SampleType::kU8}, kWiderElsewhere},
    {"jpeg", "JPEG", {SampleType::kU8}, kWiderElsewhere},
    {"tif", "TIFF", {SampleType::kU8, SampleType::kU16, SampleType::kF16, SampleType::kF32}, kIdsElsewhere},
    {"tiff", "TIFF", {SampleType::kU8, SampleType::kU16, SampleType::kF16, SampleType::kF32}, kIdsElsewhere},
    {"exr", "OpenEXR", {SampleType::kF16, SampleType::kF32, SampleType::kU32}, kIntegersElsewhere},
    {"hdr", "Radiance HDR", {SampleType::kF16, SampleType::kF32}, kIntegersElsewhere},
}};

constexpr std::array<std::string_view, 15> kReadableToo{"bmp", "tga", "webp", "ppm", "pgm", "pbm",  "pnm", "pfm",
                                                        "dpx", "gif", "psd",  "jp2", "j2k", "rgbe", "ico"};

constexpr std::string_view TypeName(SampleType type) {
  switch (type) {
    case SampleType::kU8:
      return "8-bit";
    case SampleType::kU16:
      return "16-bit";
    case SampleType::kU32:
      return "32-bit integer";
    case SampleType::kF16:
      return "half-float";
    case SampleType::kF32:
      return "float";
  }
  return "";
}

const WritableFormat* FindFormat(const std::string& path) {
  const std::string extension = base::LowerExtension(path);
  const auto* found = std::ranges::find(kWritable, std::string_view(extension), &WritableFormat::extension);
  return found == kWritable.end() ? nullptr : found;
}

}  // namespace

bool IsImagePath(const std::string& path) {
  const std::string extension = base::LowerExtension(path);
  return FindFormat(path) != nullptr ||
         std::ranges::find(kReadableToo, std::string_view(extension)) != kReadableToo.end();
}

Result<void> CheckWritable(const std::string& path, SampleType type, int channels) {
  const WritableFormat* format = FindFormat(path);
  if (format == nullptr) {
    const std::string extension = base::LowerExtension(path);
    return Fail(ErrorKind::kUsage,
                fmt::format("cannot write '{}': {}; images are written as .png, .jpg, .tif, .exr or .hdr", path,
                            extension.empty() ? "it has no extension to choose a format by"
                                              : fmt::format("'.{}' is no image format that burin writes", extension)));
  }
  if (channels < 1 || channels > 4) {
    return Fail(ErrorKind::kUsage, fmt::format("cannot write '{}': it would have {} channels, an image has 1 to 4; "
                                               "more go into .exr as layers",
                                               path, channels));
  }
  if (std::ranges::find(format->types, type) == format->types.end()) {
    return Fail(ErrorKind::kUsage, fmt::format("cannot write '{}': {} has no {} samples; {}", path, format->name,
                                               TypeName(type), format->alternatives));
  }
  return {};
}

}  // namespace burin::image
