// SPDX-License-Identifier: Apache-2.0
// Files are encoded in memory and written by us: OpenImageIO's writers don't all notice a full disk, and TIFF's puts
// the date in.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <string_view>
#include <system_error>
#include <vector>

#include "core/base/atomic_file.h"
#include "core/base/file_io.h"
#include "core/base/path.h"
#include "core/image/convert.h"
#include "core/image/module/writer.h"
#include "core/image/tiff_stream.h"

namespace burin::image {
namespace {

std::unexpected<Error> CannotWrite(const std::string& path, const std::string& why) {
  return Fail(ErrorKind::kFailed, fmt::format("cannot write '{}': {}", path, why));
}

bool DropsAlpha(std::string_view extension) { return extension == "jpg" || extension == "jpeg" || extension == "hdr"; }

// What the format can hold of it: alpha dropped, halves widened. `storage` keeps a changed copy alive.
const Image& Fitted(const Image& image, std::string_view extension, Image& storage) {
  const Image* fitted = &image;
  if (DropsAlpha(extension) && (image.channels == 2 || image.channels == 4)) {
    storage = ToChannels(image, image.channels - 1);
    fitted = &storage;
  }
  if (extension == "hdr" && fitted->channels == 1) {
    storage = ToChannels(*fitted, 3);
    fitted = &storage;
  }
  if (fitted->type == SampleType::kF16) {
    storage = ToType(*fitted, SampleType::kF32);
    fitted = &storage;
  }
  return *fitted;
}

OIIO::TypeDesc TypeDescOf(SampleType type) {
  switch (type) {
    case SampleType::kU8:
      return OIIO::TypeDesc::UINT8;
    case SampleType::kU16:
      return OIIO::TypeDesc::UINT16;
    default:
      return OIIO::TypeDesc::FLOAT;
  }
}

OIIO::ImageSpec SpecOf(const Image& image, std::string_view extension, const WriteOptions& options) {
  OIIO::ImageSpec spec(image.width, image.height, image.channels, TypeDescOf(image.type));
  if (image.channels == 2) {
    spec.channelnames = {"Y", "A"};
    spec.alpha_channel = 1;
  }
  // Integers come unassociated; without this OpenImageIO would divide by alpha once more.
  if (image.type == SampleType::kU8 || image.type == SampleType::kU16) spec.attribute("oiio:UnassociatedAlpha", 1);
  if (extension == "jpg" || extension == "jpeg") {
    spec.attribute("CompressionQuality", options.jpeg_quality);
    // Halved chroma smears one-pixel lines; at high quality the user wants them.
    spec.attribute("jpeg:subsampling", options.jpeg_quality >= 90 ? "4:4:4" : "4:2:0");
  } else if (extension == "tif" || extension == "tiff") {
    spec.attribute("compression", "zip");
  } else if (extension == "png") {
    // Measured on a 1080p photograph: level 6 takes three times as long for a file 8 % smaller.
    spec.attribute("png:compressionLevel", 3);
  }
  std::string description;
  for (const TextAttribute& text : options.metadata) {
    if (extension == "png") spec.attribute(text.name, text.value);
    description += fmt::format("{}{}={}", description.empty() ? "" : "\n", text.name, text.value);
  }
  // JPEG and TIFF have no free names.
  if (extension != "png" && !description.empty()) spec.attribute("ImageDescription", description);
  return spec;
}

Result<std::vector<unsigned char>> Encode(const std::string& path, const Image& image, std::string_view extension,
                                          const WriteOptions& options) {
  OIIO::Filesystem::IOVecOutput proxy;
  const std::string name = fmt::format("memory.{}", extension);
  const auto output = OIIO::ImageOutput::create(name, &proxy);
  if (!output) return CannotWrite(path, OIIO::geterror());
  if (!output->open(name, SpecOf(image, extension, options)) ||
      !output->write_image(TypeDescOf(image.type), image.pixels.data()) || !output->close()) {
    return CannotWrite(path, output->geterror());
  }
  return proxy.buffer();
}

}  // namespace

Result<void> WriteWithOiio(const std::string& path, const Image& image, const WriteOptions& options) {
  try {
    const std::string extension = base::LowerExtension(path);
    // Opened first: an unwritable folder is known before the work of encoding.
    Result<base::AtomicFile> file = base::AtomicFile::Create(path);
    if (!file) return std::unexpected(file.error());
    Image storage;
    Result<std::vector<unsigned char>> bytes = Encode(path, Fitted(image, extension, storage), extension, options);
    if (!bytes) return std::unexpected(bytes.error());
    const auto content = std::as_writable_bytes(std::span(*bytes));
    RemoveTiffDate(content);
    if (const int error = base::WriteAll(file->descriptor(), content); error != 0) {
      return CannotWrite(path, std::generic_category().message(error));
    }
    return file->Commit();
  } catch (const std::exception& e) {
    return CannotWrite(path, e.what());
  }
}

}  // namespace burin::image
