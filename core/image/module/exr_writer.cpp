// SPDX-License-Identifier: Apache-2.0
#include <ImfArray.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <deque>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "core/base/atomic_file.h"
#include "core/base/file_io.h"
#include "core/image/convert.h"
#include "core/image/module/writer.h"

namespace burin::image {
namespace {

std::unexpected<Error> CannotWrite(const std::string& path, const std::string& why) {
  return Fail(ErrorKind::kFailed, fmt::format("cannot write '{}': {}", path, why));
}

// The whole file in memory: OpenEXR goes back to fill in its offset table, and a failed write must not be missed.
class MemoryStream final : public Imf::OStream {
 public:
  MemoryStream() : Imf::OStream("memory") {}
  void write(const char* bytes, int count) override {
    const std::size_t n = static_cast<std::size_t>(count);
    if (at_ + n > buffer_.size()) buffer_.resize(at_ + n);
    std::copy_n(reinterpret_cast<const std::byte*>(bytes), n, buffer_.begin() + static_cast<std::ptrdiff_t>(at_));
    at_ += n;
  }
  std::uint64_t tellp() override { return at_; }
  void seekp(std::uint64_t position) override { at_ = position; }
  [[nodiscard]] const std::vector<std::byte>& buffer() const { return buffer_; }

 private:
  std::vector<std::byte> buffer_;
  std::size_t at_ = 0;
};

Imf::PixelType PixelTypeOf(SampleType type) {
  switch (type) {
    case SampleType::kU32:
      return Imf::UINT;
    case SampleType::kF16:
      return Imf::HALF;
    default:
      return Imf::FLOAT;
  }
}

// 8-bit samples fit halves (11 significant bits), 16-bit ones need floats.
const Image& Fitted(const Image& image, std::deque<Image>& storage) {
  if (image.type == SampleType::kU8) return storage.emplace_back(ToType(image, SampleType::kF16));
  if (image.type == SampleType::kU16) return storage.emplace_back(ToType(image, SampleType::kF32));
  return image;
}

Result<void> CheckLayers(const std::string& path, std::span<const Layer> layers) {
  if (layers.empty()) return CannotWrite(path, "it would have no layers");
  const Image& first = *layers.front().image;
  std::vector<std::string> names;
  for (const Layer& layer : layers) {
    if (layer.image->width != first.width || layer.image->height != first.height) {
      return CannotWrite(path,
                         fmt::format("its layers differ in size: {}x{} and {}x{} ({})", first.width, first.height,
                                     layer.image->width, layer.image->height, fmt::join(layer.channel_names, ", ")));
    }
    if (layer.channel_names.size() != static_cast<std::size_t>(layer.image->channels)) {
      return CannotWrite(path,
                         fmt::format("{} channel names ({}) for an image of {} channels", layer.channel_names.size(),
                                     fmt::join(layer.channel_names, ", "), layer.image->channels));
    }
    names.insert(names.end(), layer.channel_names.begin(), layer.channel_names.end());
  }
  std::ranges::sort(names);
  if (const auto twice = std::ranges::adjacent_find(names); twice != names.end()) {
    return CannotWrite(path, fmt::format("two of its channels are named '{}'", *twice));
  }
  return {};
}

void Encode(std::span<const Layer> layers, const WriteOptions& options, MemoryStream& stream) {
  const int width = layers.front().image->width;
  const int height = layers.front().image->height;
  Imf::Header header(width, height);
  header.compression() = Imf::ZIP_COMPRESSION;
  Imf::FrameBuffer pixels;
  std::deque<Image> storage;  // of converted layers; its elements stay where they are
  for (const Layer& layer : layers) {
    const Image& image = Fitted(*layer.image, storage);
    const std::size_t sample = SampleBytes(image.type);
    const std::size_t pixel = sample * static_cast<std::size_t>(image.channels);
    for (std::size_t c = 0; c < layer.channel_names.size(); ++c) {
      const Imf::PixelType type = PixelTypeOf(image.type);
      header.channels().insert(layer.channel_names[c], Imf::Channel(type));
      // OpenEXR only reads through this pointer when it writes a file.
      char* base = reinterpret_cast<char*>(const_cast<std::byte*>(image.pixels.data())) + c * sample;
      pixels.insert(layer.channel_names[c], Imf::Slice(type, base, pixel, image.RowBytes()));
    }
  }
  for (const TextAttribute& text : options.metadata) header.insert(text.name, Imf::StringAttribute(text.value));
  Imf::OutputFile file(stream, header);
  file.setFrameBuffer(pixels);
  file.writePixels(height);
}

}  // namespace

Result<void> WriteExr(const std::string& path, std::span<const Layer> layers, const WriteOptions& options) {
  if (const Result<void> checked = CheckLayers(path, layers); !checked) return checked;
  Result<base::AtomicFile> file = base::AtomicFile::Create(path);
  if (!file) return std::unexpected(file.error());
  MemoryStream stream;
  try {
    Encode(layers, options, stream);
  } catch (const std::exception& e) {
    return CannotWrite(path, e.what());
  }
  if (const int error = base::WriteAll(file->descriptor(), stream.buffer()); error != 0) {
    return CannotWrite(path, std::generic_category().message(error));
  }
  return file->Commit();
}

}  // namespace burin::image
