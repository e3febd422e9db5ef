// SPDX-License-Identifier: Apache-2.0
#include "core/video/y4m_header.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cstdint>
#include <optional>

namespace burin::video {
namespace {

constexpr std::string_view kMagic = "YUV4MPEG2";
constexpr std::int64_t kMostPixels = std::int64_t{1} << 28;

std::unexpected<Error> Malformed(const std::string& name, const std::string& why) {
  return Fail(ErrorKind::kInput, fmt::format("cannot read '{}': {}", name, why));
}

// What a stream holds may be anything: printable, and not too much of it.
std::string Quoted(std::string_view text) {
  constexpr std::size_t kMost = 40;
  std::string quoted = "'";
  for (const char c : text.substr(0, kMost)) quoted += c >= ' ' && c < 127 ? c : '?';
  return quoted + (text.size() > kMost ? "...'" : "'");
}

std::optional<int> ParseInt(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<FrameRate> ParseRatio(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) return std::nullopt;
  const auto numerator = ParseInt(text.substr(0, colon));
  const auto denominator = ParseInt(text.substr(colon + 1));
  if (!numerator || !denominator || *numerator < 0 || *denominator < 0) return std::nullopt;
  return FrameRate{*numerator, *denominator};
}

struct ColorSpace {
  std::string_view tag;
  int shift_x;
  int shift_y;
  bool has_chroma;
  bool has_alpha;
  Chroma chroma;
};

// The 4:2:0 kinds differ in where chroma is sited, by half a pixel at most; chroma is replicated, so they read alike.
constexpr std::array<ColorSpace, 10> kColorSpaces{{
    {"420", 1, 1, true, false, Chroma::k420},
    {"420jpeg", 1, 1, true, false, Chroma::k420},
    {"420mpeg2", 1, 1, true, false, Chroma::k420},
    {"420paldv", 1, 1, true, false, Chroma::k420},
    {"422", 1, 0, true, false, Chroma::k422},
    {"444", 0, 0, true, false, Chroma::k444},
    {"444alpha", 0, 0, true, true, Chroma::k444},
    {"411", 2, 0, true, false, Chroma::k422},
    {"410", 2, 2, true, false, Chroma::k420},
    {"mono", 0, 0, false, false, Chroma::k420},
}};

Result<void> ReadColorSpace(std::string_view tag, Y4mHeader& header, const std::string& name) {
  for (const ColorSpace& space : kColorSpaces) {
    if (space.tag != tag) continue;
    header.layout.chroma_shift_x = space.shift_x;
    header.layout.chroma_shift_y = space.shift_y;
    header.layout.has_chroma = space.has_chroma;
    header.layout.has_alpha = space.has_alpha;
    header.info.chroma = space.chroma;
    return {};
  }
  return Malformed(name, fmt::format("its colour space {} is not read; 8-bit C420, C422, C444 and Cmono are "
                                     "(ffmpeg's -pix_fmt yuv420p, yuv422p, yuv444p, gray)",
                                     Quoted(fmt::format("C{}", tag))));
}

Result<void> ReadInterlacing(std::string_view value, Y4mHeader& header, const std::string& name) {
  if (value == "t" || value == "b") {
    header.interlaced = true;
  } else if (value != "p" && value != "?" && value != "m") {
    return Malformed(name,
                     fmt::format("its interlacing {} is none of Ip, It, Ib, Im", Quoted(fmt::format("I{}", value))));
  }
  return {};
}

Result<void> ReadRate(std::string_view value, Y4mHeader& header, const std::string& name) {
  const auto rate = ParseRatio(value);
  if (!rate || (rate->numerator == 0) != (rate->denominator == 0)) {
    return Malformed(name,
                     fmt::format("its frame rate {} is no ratio like F30000:1001", Quoted(fmt::format("F{}", value))));
  }
  if (rate->numerator > 0) header.info.rate = *rate;
  return {};
}

Result<void> ReadToken(std::string_view token, Y4mHeader& header, const std::string& name) {
  const std::string_view value = token.substr(1);
  switch (token.front()) {
    case 'W':
    case 'H': {
      const auto size = ParseInt(value);
      if (!size || *size <= 0) return Malformed(name, fmt::format("its header has the size {}", Quoted(token)));
      (token.front() == 'W' ? header.layout.width : header.layout.height) = *size;
      return {};
    }
    case 'F':
      return ReadRate(value, header, name);
    case 'I':
      return ReadInterlacing(value, header, name);
    case 'C':
      return ReadColorSpace(value, header, name);
    case 'X':
      if (value == "COLORRANGE=FULL") header.layout.full_range = true;
      return {};
    default:
      return {};  // the pixel aspect, and whatever comes in later versions
  }
}

}  // namespace

Result<Y4mHeader> ParseY4mHeader(std::string_view line, const std::string& name) {
  if (line != kMagic && !line.starts_with(fmt::format("{} ", kMagic))) {
    return Malformed(name, fmt::format("it is no YUV4MPEG2 stream: it begins with {}", Quoted(line)));
  }
  Y4mHeader header;
  header.layout.chroma_shift_x = 1;  // without a C tag it is 4:2:0
  header.layout.chroma_shift_y = 1;
  header.info.rate = {25, 1};  // of streams that don't tell, as ffmpeg takes them
  line.remove_prefix(kMagic.size());
  while (!line.empty()) {
    const std::size_t space = line.find(' ');
    const std::string_view token = line.substr(0, space);
    line = space == std::string_view::npos ? std::string_view{} : line.substr(space + 1);
    if (token.empty()) continue;
    if (const Result<void> read = ReadToken(token, header, name); !read) return std::unexpected(read.error());
  }
  const std::int64_t width = header.layout.width;
  const std::int64_t height = header.layout.height;
  if (width == 0 || height == 0)
    return Malformed(name, fmt::format("its header has no {}", width == 0 ? "width" : "height"));
  if (width * height > kMostPixels) {
    return Malformed(name, fmt::format("its size {}x{} is over {} pixels", width, height, kMostPixels));
  }
  header.info.width = header.layout.width;
  header.info.height = header.layout.height;
  return header;
}

// "FRAME Ixyz": z tells how the chroma was sampled, 'p' progressive, 'i' interlaced, '?' unknown.
bool FrameIsInterlaced(std::string_view frame_line, bool fallback) {
  const std::size_t at = frame_line.find(" I");
  if (at == std::string_view::npos || at + 4 >= frame_line.size()) return fallback;
  const char sampling = frame_line[at + 4];
  return sampling == 'i' || (sampling != 'p' && fallback);
}

YcbcrLayout LayoutOf(int width, int height, Chroma chroma) {
  YcbcrLayout layout;
  layout.width = width;
  layout.height = height;
  layout.chroma_shift_x = chroma == Chroma::k444 ? 0 : 1;
  layout.chroma_shift_y = chroma == Chroma::k420 ? 1 : 0;
  return layout;
}

std::string FormatY4mHeader(const VideoWriteOptions& options) {
  // Box-averaged 4:2:0 chroma lies in the middle of its four pixels, which is what JPEG's siting says.
  const std::string_view space = options.chroma == Chroma::k420   ? "420jpeg"
                                 : options.chroma == Chroma::k422 ? "422"
                                                                  : "444";
  return fmt::format("{} W{} H{} F{}:{} Ip A1:1 C{} XCOLORRANGE=LIMITED\n", kMagic, options.width, options.height,
                     options.rate.numerator, options.rate.denominator, space);
}

}  // namespace burin::video
