// SPDX-License-Identifier: Apache-2.0
#include "core/image/module/reader.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/file_io.h"
#include "core/image/convert.h"
#include "core/image/jpeg_end.h"
#include "core/image/module/channel_choice.h"
#include "core/image/orientation.h"
#include "core/image/png_stream.h"
#include "core/image/tiff_stream.h"

namespace burin::image {
namespace {

constexpr std::int64_t kMostPixels = std::int64_t{1} << 28;  // 16384 x 16384, the largest texture of llvmpipe
// A header that claims far more than its file could hold is a lie or a bomb: no codec here packs a real picture so
// tightly (deflate ends at 1032:1). Only checked where it would cost memory.
constexpr std::uint64_t kHarmlessBytes = std::uint64_t{256} << 20;
constexpr std::uint64_t kMostRatio = 10000;

std::unexpected<Error> CannotRead(const std::string& name, const std::string& why) {
  return Fail(ErrorKind::kInput, fmt::format("cannot read '{}': {}", name, why));
}

// OpenImageIO ends some messages with a newline, repeats some, and puts the path in front of a few.
std::string Tidy(std::string text, const std::string& name) {
  if (text.find("could not find a format reader") != std::string::npos) return "it is in no image format that is known";
  if (const std::string front = fmt::format("\"{}\": ", name); text.starts_with(front)) text.erase(0, front.size());
  text = text.substr(0, text.find('\n'));
  return text.empty() ? "the file is damaged" : text;
}

std::optional<SampleType> TypeOf(OIIO::TypeDesc type) {
  switch (type.basetype) {
    case OIIO::TypeDesc::UINT8:
      return SampleType::kU8;
    case OIIO::TypeDesc::UINT16:
      return SampleType::kU16;
    case OIIO::TypeDesc::UINT32:
      return SampleType::kU32;
    case OIIO::TypeDesc::HALF:
      return SampleType::kF16;
    case OIIO::TypeDesc::FLOAT:
    case OIIO::TypeDesc::DOUBLE:
      return SampleType::kF32;
    default:
      return std::nullopt;
  }
}

OIIO::TypeDesc TypeDescOf(SampleType type) {
  switch (type) {
    case SampleType::kU8:
      return OIIO::TypeDesc::UINT8;
    case SampleType::kU16:
      return OIIO::TypeDesc::UINT16;
    case SampleType::kU32:
      return OIIO::TypeDesc::UINT32;
    case SampleType::kF16:
      return OIIO::TypeDesc::HALF;
    case SampleType::kF32:
      return OIIO::TypeDesc::FLOAT;
  }
  return OIIO::TypeDesc::UNKNOWN;
}

Encoding EncodingOf(SampleType type) {
  switch (type) {
    case SampleType::kU8:
    case SampleType::kU16:
      return Encoding::kDisplay;
    case SampleType::kU32:
      return Encoding::kData;
    case SampleType::kF16:
    case SampleType::kF32:
      return Encoding::kSceneLinear;
  }
  return Encoding::kData;
}

// The type that holds every chosen channel.
std::optional<SampleType> CommonType(const OIIO::ImageSpec& spec, const std::vector<int>& channels) {
  std::optional<SampleType> common;
  for (const int channel : channels) {
    const auto type = TypeOf(spec.channelformat(channel));
    if (!type) return std::nullopt;
    if (!common || common == type) {
      common = type;
    } else {
      common = SampleType::kF32;
    }
  }
  return common;
}

// Colour models that OpenImageIO would turn into RGB by a rough formula, or hand over as if they were RGB.
std::optional<std::string> RefusedColorModel(const OIIO::ImageSpec& spec) {
  constexpr int kPhotometricSeparated = 5;
  constexpr int kPhotometricCieLab = 8;
  const int photometric = spec.get_int_attribute("tiff:PhotometricInterpretation", -1);
  if (photometric == kPhotometricSeparated) return "CMYK";
  if (photometric == kPhotometricCieLab) return "CIE L*a*b*";
  for (const char* name : {"jpeg:ColorSpace", "tiff:ColorSpace", "psd:ColorMode", "oiio:ColorSpace"}) {
    const std::string model = spec.get_string_attribute(name);
    if (model == "CMYK" || model == "YCbCrK" || model == "YCCK" || model == "Lab" || model == "multichannel") {
      return model;
    }
  }
  return std::nullopt;
}

struct Plan {
  std::vector<int> channels;
  SampleType type = SampleType::kU8;
};

Result<Plan> Check(const OIIO::ImageSpec& spec, const std::string& name, std::uint64_t file_bytes) {
  if (spec.deep) return CannotRead(name, "it is a deep image; flatten it first");
  if (spec.depth > 1) return CannotRead(name, "it is a volume");
  if (spec.width <= 0 || spec.height <= 0 || std::int64_t{spec.width} * spec.height > kMostPixels) {
    return CannotRead(name,
                      fmt::format("its size {}x{} is outside 1x1 to {} pixels", spec.width, spec.height, kMostPixels));
  }
  if (const auto model = RefusedColorModel(spec)) {
    return CannotRead(name, fmt::format("its colours are {}; convert it to RGB or grey first", *model));
  }
  const auto channels = ChoosePictureChannels(spec.channelnames);
  if (!channels) {
    return CannotRead(name, fmt::format("none of its {} channels ({}) are R, G, B or Y", spec.nchannels,
                                        fmt::join(spec.channelnames, ", ")));
  }
  const auto type = CommonType(spec, *channels);
  if (!type) {
    return CannotRead(
        name, fmt::format("its samples are {}; 8- and 16-bit unsigned, half and float are read", spec.format.c_str()));
  }
  const std::uint64_t bytes = static_cast<std::uint64_t>(spec.width) * static_cast<std::uint64_t>(spec.height) *
                              channels->size() * SampleBytes(*type);
  if (bytes > kHarmlessBytes && bytes / kMostRatio > file_bytes) {
    return CannotRead(name,
                      fmt::format("it claims {}x{} pixels in a file of {} bytes", spec.width, spec.height, file_bytes));
  }
  return Plan{*channels, *type};
}

// Cut and padded with zeros from the pixels stored (the data window) to the picture meant (the display window).
Result<Image> ToDisplayWindow(Image data, const OIIO::ImageSpec& spec, const std::string& name) {
  const int x = spec.x - spec.full_x;
  const int y = spec.y - spec.full_y;
  if (x == 0 && y == 0 && spec.full_width == data.width && spec.full_height == data.height) return data;
  if (spec.full_width <= 0 || spec.full_height <= 0 || std::int64_t{spec.full_width} * spec.full_height > kMostPixels) {
    return CannotRead(name, fmt::format("its display window of {}x{} is outside 1x1 to {} pixels", spec.full_width,
                                        spec.full_height, kMostPixels));
  }
  Image full = MakeImage(spec.full_width, spec.full_height, data.channels, data.type, data.encoding);
  const int left = std::max(x, 0);
  const int right = std::min(x + data.width, full.width);
  if (left >= right) return full;
  const std::size_t pixel = static_cast<std::size_t>(data.channels) * SampleBytes(data.type);
  for (int row = std::max(y, 0); row < std::min(y + data.height, full.height); ++row) {
    std::memcpy(
        full.pixels.data() + static_cast<std::size_t>(row) * full.RowBytes() + static_cast<std::size_t>(left) * pixel,
        data.pixels.data() + static_cast<std::size_t>(row - y) * data.RowBytes() +
            static_cast<std::size_t>(left - x) * pixel,
        static_cast<std::size_t>(right - left) * pixel);
  }
  return full;
}

// Row by row: for whole images OpenImageIO 2.4 unpacks TIFF strips itself and doesn't look whether that worked.
Result<Image> ReadTiffRows(OIIO::ImageInput& input, const Plan& plan, Image image, const std::string& name) {
  const OIIO::TypeDesc type = TypeDescOf(plan.type);
  const std::size_t sample = SampleBytes(plan.type);
  const std::size_t stored_channels = static_cast<std::size_t>(input.spec().nchannels);
  std::vector<std::byte> row(static_cast<std::size_t>(image.width) * stored_channels * sample);
  std::byte* target = image.pixels.data();
  for (int y = 0; y < image.height; ++y) {
    if (!input.read_scanline(y + input.spec().y, 0, type, row.data()))
      return CannotRead(name, Tidy(input.geterror(), name));
    for (std::size_t x = 0; x < static_cast<std::size_t>(image.width); ++x) {
      for (const int channel : plan.channels) {
        std::memcpy(target, row.data() + (x * stored_channels + static_cast<std::size_t>(channel)) * sample, sample);
        target += sample;
      }
    }
  }
  return image;
}

Result<Image> ReadPixels(OIIO::ImageInput& input, const Plan& plan, const std::string& name) {
  const OIIO::ImageSpec& spec = input.spec();
  Image image =
      MakeImage(spec.width, spec.height, static_cast<int>(plan.channels.size()), plan.type, EncodingOf(plan.type));
  if (std::string_view(input.format_name()) == "tiff" && spec.tile_width == 0) {
    return ReadTiffRows(input, plan, std::move(image), name);
  }
  const OIIO::TypeDesc type = TypeDescOf(plan.type);
  const bool in_order =
      std::ranges::adjacent_find(plan.channels, [](int a, int b) { return b != a + 1; }) == plan.channels.end();
  if (in_order) {
    if (input.read_image(0, 0, plan.channels.front(), plan.channels.back() + 1, type, image.pixels.data()))
      return image;
    return CannotRead(name, Tidy(input.geterror(), name));
  }
  const OIIO::stride_t pixel = static_cast<OIIO::stride_t>(image.RowBytes()) / image.width;
  for (std::size_t i = 0; i < plan.channels.size(); ++i) {
    if (!input.read_image(0, 0, plan.channels[i], plan.channels[i] + 1, type,
                          image.pixels.data() + i * SampleBytes(plan.type), pixel)) {
      return CannotRead(name, Tidy(input.geterror(), name));
    }
  }
  return image;
}

template <class Change>
void ChangeAlpha(Image& image, Change change) {
  Image rgba = ToType(ToChannels(image, 4), SampleType::kF32);
  change(rgba.As<float>());
  image = ToType(ToChannels(rgba, image.channels), image.type);
}

// Integer files end up unassociated and floating ones associated, whatever the file holds. The input was opened so
// that OpenImageIO leaves unassociated alpha alone and says so; TIFF alone also knows associated integers.
void SettleAlpha(Image& image, const OIIO::ImageSpec& spec, std::string_view format) {
  if (image.channels != 2 && image.channels != 4) return;
  const bool unassociated = spec.get_int_attribute("oiio:UnassociatedAlpha") != 0;
  if (image.encoding == Encoding::kSceneLinear && unassociated) ChangeAlpha(image, Premultiply);
  if (image.encoding == Encoding::kDisplay && !unassociated && format == "tiff" && spec.alpha_channel >= 0) {
    ChangeAlpha(image, Unpremultiply);
  }
}

Result<Image> ReadOpen(OIIO::ImageInput& input, const std::string& name, std::uint64_t file_bytes) {
  const OIIO::ImageSpec& spec = input.spec();
  const Result<Plan> plan = Check(spec, name, file_bytes);
  if (!plan) return std::unexpected(plan.error());
  Result<Image> image = ReadPixels(input, *plan, name);
  if (!image) return image;
  const std::string_view format = input.format_name();
  SettleAlpha(*image, spec, format);
  if (format == "openexr") return ToDisplayWindow(std::move(*image), spec, name);
  return Upright(std::move(*image), spec.get_int_attribute("Orientation", 1));
}

Result<Image> ReadWith(const std::string& open_as, const std::string& name, std::uint64_t file_bytes,
                       OIIO::Filesystem::IOProxy* proxy) {
  try {
    OIIO::ImageSpec config;
    config["oiio:UnassociatedAlpha"] = 1;
    // As an attribute: the parameter of ImageInput::open doesn't reach the format readers in 2.4.
    void* pointer = proxy;
    if (proxy != nullptr) config.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &pointer);
    const auto input = OIIO::ImageInput::open(open_as, &config);
    if (!input) return CannotRead(name, Tidy(OIIO::geterror(), open_as));
    return ReadOpen(*input, name, file_bytes);
  } catch (const std::exception& e) {
    return CannotRead(name, Tidy(e.what(), name));
  }
}

bool StartsWith(std::span<const std::byte> bytes, std::string_view magic) {
  return bytes.size() >= magic.size() && std::memcmp(bytes.data(), magic.data(), magic.size()) == 0;
}

// Formats that may be embedded, by their first bytes: OpenImageIO wants a file name to choose by.
std::optional<std::string_view> SniffExtension(std::span<const std::byte> bytes) {
  using namespace std::string_view_literals;
  constexpr std::array<std::pair<std::string_view, std::string_view>, 9> kMagics{{
      {"\x89PNG\r\n\x1A\n"sv, "png"},
      {"\xFF\xD8\xFF"sv, "jpg"},
      {"\x76\x2F\x31\x01"sv, "exr"},
      {"II*\0"sv, "tif"},
      {"MM\0*"sv, "tif"},
      {"II+\0"sv, "tif"},
      {"MM\0+"sv, "tif"},
      {"#?RADIANCE"sv, "hdr"},
      {"RIFF"sv, "webp"},
  }};
  for (const auto& [magic, extension] : kMagics) {
    if (StartsWith(bytes, magic)) return extension;
  }
  return std::nullopt;
}

Result<std::vector<std::byte>> Slurp(int descriptor, std::uint64_t size, const std::string& path) {
  std::vector<std::byte> bytes(size);
  const base::ReadCount count = base::ReadAll(descriptor, bytes);
  if (count.error != 0) return CannotRead(path, std::strerror(count.error));
  bytes.resize(count.bytes);
  return bytes;
}

class Descriptor {
 public:
  explicit Descriptor(int value) : value_(value) {}
  ~Descriptor() {
    if (value_ >= 0) close(value_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] int value() const { return value_; }

 private:
  int value_;
};

}  // namespace

Result<Image> ReadBytes(std::span<const std::byte> bytes, const std::string& name) {
  const auto extension = SniffExtension(bytes);
  if (!extension) return CannotRead(name, "it is no PNG, JPEG, TIFF, EXR, HDR or WebP data");
  if (*extension == "jpg" && !ReachesJpegEnd(bytes)) return CannotRead(name, "the JPEG data ends too early");
  if (*extension == "tif" && !TiffIsWhole(bytes)) return CannotRead(name, "the TIFF data ends too early");
  std::vector<std::byte> storage;
  if (*extension == "png") {
    auto picture = PngPicture(bytes);
    if (!picture) return CannotRead(name, picture.error());
    storage = std::move(*picture);
    bytes = storage;
  }
  OIIO::Filesystem::IOMemReader proxy(bytes.data(), bytes.size());
  return ReadWith(fmt::format("memory.{}", *extension), name, bytes.size(), &proxy);
}

Result<Image> ReadFile(const std::string& path) {
  const Descriptor file(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (file.value() < 0) return CannotRead(path, std::strerror(errno));
  struct stat status {};
  if (fstat(file.value(), &status) != 0) return CannotRead(path, std::strerror(errno));
  if (S_ISDIR(status.st_mode)) return CannotRead(path, "it is a folder");
  if (!S_ISREG(status.st_mode)) return CannotRead(path, "it is not a regular file");
  if (status.st_size == 0) return CannotRead(path, "it is empty");
  const std::uint64_t size = static_cast<std::uint64_t>(status.st_size);

  std::array<std::byte, 12> magic{};
  if (pread(file.value(), magic.data(), magic.size(), 0) > 0 && SniffExtension(magic)) {
    const auto bytes = Slurp(file.value(), size, path);
    return bytes ? ReadBytes(*bytes, path) : std::unexpected(bytes.error());
  }
  return ReadWith(path, path, size, nullptr);
}

}  // namespace burin::image
