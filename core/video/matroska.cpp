// SPDX-License-Identifier: Apache-2.0
// RFC 8794 (EBML: elements of a self-delimiting identifier, a size and a payload; CRC-32 elements cover the rest of
// their parent; Void elements are padding) and RFC 9559 (Matroska's elements).
#include "core/video/matroska.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <vector>

#include "core/base/crc32.h"

namespace burin::video {
namespace {

constexpr std::uint64_t kEbmlHeader = 0x1A45DFA3;
constexpr std::uint64_t kDocType = 0x4282;
constexpr std::uint64_t kCrc32 = 0xBF;
constexpr std::uint64_t kSegment = 0x18538067;
constexpr std::uint64_t kInfo = 0x1549A966;
constexpr std::uint64_t kSegmentUid = 0x73A4;
constexpr std::uint64_t kTracks = 0x1654AE6B;
constexpr std::uint64_t kTrackEntry = 0xAE;
constexpr std::uint64_t kTrackUid = 0x73C5;
constexpr std::uint64_t kDefaultDuration = 0x23E383;
constexpr std::uint64_t kTags = 0x1254C367;
constexpr std::uint64_t kTag = 0x7373;
constexpr std::uint64_t kTargets = 0x63C0;
constexpr std::uint64_t kTagTrackUid = 0x63C5;
constexpr std::uint64_t kCluster = 0x1F43B675;
constexpr std::uint64_t kSimpleBlock = 0xA3;
constexpr std::uint64_t kBlockGroup = 0xA0;
constexpr std::byte kVoid{0xEC};

constexpr std::size_t kLongestHead = 12;  // identifier of 4 bytes, size of 8
constexpr std::uint64_t kLargestMaster = std::uint64_t{1} << 24;

struct Element {
  std::uint64_t id = 0;
  std::size_t head = 0;    ///< bytes of identifier and size
  std::uint64_t size = 0;  ///< bytes of payload
  [[nodiscard]] std::uint64_t total() const { return head + size; }
};

// A number whose first byte tells by its leading zeros how many bytes follow; the marking bit stays in identifiers.
std::optional<std::uint64_t> VariableInt(std::span<const std::byte> bytes, bool keep_marker, std::size_t& length) {
  if (bytes.empty()) return std::nullopt;
  const unsigned first = std::to_integer<unsigned>(bytes[0]);
  length = 1;
  while (length <= 8 && (first & (0x80U >> (length - 1))) == 0) ++length;
  if (length > 8 || bytes.size() < length) return std::nullopt;
  std::uint64_t value = keep_marker ? first : first & (0x7FU >> (length - 1));
  for (std::size_t i = 1; i < length; ++i) value = value << 8 | std::to_integer<std::uint64_t>(bytes[i]);
  return value;
}

std::optional<Element> ParseHead(std::span<const std::byte> bytes) {
  Element element;
  std::size_t id_length = 0;
  std::size_t size_length = 0;
  const auto id = VariableInt(bytes, true, id_length);
  if (!id || id_length > 4) return std::nullopt;
  const auto size = VariableInt(bytes.subspan(id_length), false, size_length);
  if (!size || *size == (std::uint64_t{1} << (7 * size_length)) - 1) return std::nullopt;  // "unknown": still open
  return Element{*id, id_length + size_length, *size};
}

void StoreBigEndian(std::span<std::byte> to, std::uint64_t value) {
  for (std::size_t i = 0; i < to.size(); ++i) to[to.size() - 1 - i] = static_cast<std::byte>(value >> (8 * i));
}

// The whole element, head included, becomes padding of the same length.
void MakeVoid(std::span<std::byte> element) {
  std::ranges::fill(element, std::byte{0});
  element[0] = kVoid;
  element[1] = static_cast<std::byte>(0x80U | (element.size() - 2));
}

class Settler {
 public:
  Settler(int descriptor, const std::string& name, const FrameRate& rate, MatroskaKind kind)
      : descriptor_(descriptor), name_(name), rate_(rate), kind_(kind) {}

  Result<long> Run() {
    struct stat status {};
    if (fstat(descriptor_, &status) != 0) return Damaged(0);
    end_ = static_cast<std::uint64_t>(status.st_size);
    const auto header = HeadAt(0);
    if (!header || header->id != kEbmlHeader) return Damaged(0);
    if (const Result<void> done = RewriteMaster(0, *header); !done) return std::unexpected(done.error());
    const auto segment = HeadAt(header->total());
    if (!segment || segment->id != kSegment) return Damaged(header->total());
    const std::uint64_t begin = header->total() + segment->head;
    for (std::uint64_t at = begin; at < begin + segment->size;) {
      const auto element = HeadAt(at);
      if (!element) return Damaged(at);
      Result<void> done;
      if (element->id == kInfo || element->id == kTracks || element->id == kTags) done = RewriteMaster(at, *element);
      if (element->id == kCluster) done = CountBlocks(at, *element);
      if (!done) return std::unexpected(done.error());
      at += element->total();
    }
    return frames_;
  }

 private:
  // Also checks that the element ends within the file.
  [[nodiscard]] std::optional<Element> HeadAt(std::uint64_t at) const {
    std::array<std::byte, kLongestHead> bytes{};
    const ssize_t got = pread(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(at));
    if (got <= 0) return std::nullopt;
    const auto element = ParseHead(std::span(bytes).first(static_cast<std::size_t>(got)));
    if (!element || element->size > end_ || at + element->total() > end_) return std::nullopt;
    return element;
  }

  Result<void> CountBlocks(std::uint64_t cluster_at, const Element& cluster) {
    const std::uint64_t end = cluster_at + cluster.total();
    for (std::uint64_t at = cluster_at + cluster.head; at < end;) {
      const auto element = HeadAt(at);
      if (!element) return Damaged(at);
      if (element->id == kSimpleBlock || element->id == kBlockGroup) ++frames_;
      at += element->total();
    }
    return {};
  }

  Result<void> RewriteMaster(std::uint64_t at, const Element& element) {
    if (element.size > kLargestMaster) return Damaged(at);
    std::vector<std::byte> payload(element.size);
    const off_t where = static_cast<off_t>(at + element.head);
    if (pread(descriptor_, payload.data(), payload.size(), where) != static_cast<ssize_t>(payload.size()))
      return Damaged(at);
    if (!RewriteChildren(payload)) return Damaged(at);
    if (pwrite(descriptor_, payload.data(), payload.size(), where) != static_cast<ssize_t>(payload.size())) {
      return Fail(ErrorKind::kFailed, fmt::format("cannot write '{}': {}", name_, std::strerror(errno)));
    }
    return {};
  }

  // Depth first, so that a checksum is made over what its siblings became.
  bool RewriteChildren(std::span<std::byte> payload) {
    std::optional<std::span<std::byte>> checksum;
    std::span<std::byte> covered;
    for (std::span<std::byte> rest = payload; !rest.empty();) {
      const auto element = ParseHead(rest);
      if (!element || element->size > rest.size() - element->head) return false;
      const std::span<std::byte> whole = rest.first(element->total());
      const std::span<std::byte> body = whole.subspan(element->head);
      rest = rest.subspan(element->total());
      if (element->id == kCrc32 && body.size() == 4) {
        checksum = body;
        covered = rest;
      } else if (!RewriteElement(element->id, whole, body)) {
        return false;
      }
    }
    if (checksum) {
      const std::uint32_t crc = base::Crc32(covered);
      for (std::size_t i = 0; i < 4; ++i) (*checksum)[i] = static_cast<std::byte>(crc >> (8 * i));  // little-endian
    }
    return true;
  }

  bool RewriteElement(std::uint64_t id, std::span<std::byte> whole, std::span<std::byte> body) {
    constexpr std::uint64_t kOnlyTrack = 1;
    switch (id) {
      case kTrackEntry:
      case kTag:
      case kTargets:
        return RewriteChildren(body);
      case kSegmentUid:
        MakeVoid(whole);
        return true;
      case kTrackUid:
      case kTagTrackUid:
        StoreBigEndian(body, kOnlyTrack);
        return true;
      case kDefaultDuration:
        StoreFrameDuration(body);
        return true;
      case kDocType:
        StoreDocType(whole, body);
        return true;
      default:
        return true;
    }
  }

  void StoreFrameDuration(std::span<std::byte> body) const {
    const std::uint64_t numerator = static_cast<std::uint64_t>(rate_.numerator);
    const std::uint64_t denominator = static_cast<std::uint64_t>(rate_.denominator);
    const std::uint64_t duration_ns = (denominator * 1000000000U + numerator / 2) / numerator;
    if (body.size() >= 8 || duration_ns >> (8 * body.size()) == 0) StoreBigEndian(body, duration_ns);
  }

  // "matroska" has room for "webm" and four bytes of padding.
  void StoreDocType(std::span<std::byte> whole, std::span<std::byte> body) const {
    if (kind_ != MatroskaKind::kWebm || body.size() != 8) return;
    std::memcpy(body.data(), "webm", 4);
    whole[whole.size() - 9] = std::byte{0x84};  // the size's one byte: now 4
    MakeVoid(body.subspan(4));
  }

  [[nodiscard]] std::unexpected<Error> Damaged(std::uint64_t at) const {
    return Fail(ErrorKind::kFailed,
                fmt::format("cannot write '{}': what was written is no whole Matroska file (byte {})", name_, at));
  }

  int descriptor_;
  const std::string& name_;
  const FrameRate& rate_;
  MatroskaKind kind_;
  std::uint64_t end_ = 0;
  long frames_ = 0;
};

}  // namespace

bool MatroskaIsCutOff(int descriptor) {
  struct stat status {};
  std::array<std::byte, 4096> front{};
  const ssize_t got = pread(descriptor, front.data(), front.size(), 0);
  if (got <= 0 || fstat(descriptor, &status) != 0) return false;
  const std::span<const std::byte> bytes = std::span(front).first(static_cast<std::size_t>(got));
  const auto header = ParseHead(bytes);
  if (!header || header->id != kEbmlHeader || header->total() >= bytes.size()) return false;
  const auto segment = ParseHead(bytes.subspan(header->total()));
  if (!segment || segment->id != kSegment) return false;
  return segment->size > static_cast<std::uint64_t>(status.st_size) - header->total() - segment->head;
}

Result<long> SettleMatroska(int descriptor, const std::string& name, const FrameRate& rate, MatroskaKind kind) {
  return Settler(descriptor, name, rate, kind).Run();
}

}  // namespace burin::video
