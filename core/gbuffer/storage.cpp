// SPDX-License-Identifier: Apache-2.0
// Transfer functions: IEC 61966-2-1 (sRGB). Luma weights: ITU-R BT.709.
#include "core/gbuffer/storage.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace burin::gbuffer {
namespace {

using Vector = std::array<float, 4>;

constexpr std::string_view kFunctions = R"(
float Luma(vec3 c) { return dot(c, vec3(0.2126, 0.7152, 0.0722)); }
vec3 SrgbEncode(vec3 c) {
  c = max(c, vec3(0.0));
  return mix(12.92 * c, 1.055 * pow(max(c, vec3(0.0031308)), vec3(1.0 / 2.4)) - 0.055, greaterThan(c, vec3(0.0031308)));
}
vec3 SrgbDecode(vec3 c) {
  c = max(c, vec3(0.0));
  return mix(c / 12.92, pow((max(c, vec3(0.04045)) + 0.055) / 1.055, vec3(2.4)), greaterThan(c, vec3(0.04045)));
}
vec4 DisplayFromScene(vec4 c) { return vec4(c.a > 0.0 ? SrgbEncode(c.rgb / c.a) : vec3(0.0), c.a); }
vec4 DisplayOnBlack(vec4 c) { return vec4(SrgbEncode(c.rgb), c.a); }
vec4 SceneFromDisplay(vec4 c) { return vec4(SrgbDecode(c.rgb) * c.a, c.a); }
vec4 ClampToHalf(vec4 v) { return clamp(v, vec4(-65504.0), vec4(65504.0)); }
float WrapId(uint id, uint last) { return id == 0u ? 0.0 : float((id - 1u) % last + 1u); }
)";

float SrgbEncode(float c) {
  if (c <= 0.0031308f) return 12.92f * std::max(c, 0.0f);
  return 1.055f * std::pow(c, 1.0f / 2.4f) - 0.055f;
}

Vector DisplayOnBlack(const Vector& c) { return {SrgbEncode(c[0]), SrgbEncode(c[1]), SrgbEncode(c[2]), c[3]}; }

Vector DisplayFromScene(const Vector& c) {
  if (c[3] <= 0.0f) return {0, 0, 0, c[3]};
  return {SrgbEncode(c[0] / c[3]), SrgbEncode(c[1] / c[3]), SrgbEncode(c[2] / c[3]), c[3]};
}

float Luma(const Vector& c) { return 0.2126f * c[0] + 0.7152f * c[1] + 0.0722f * c[2]; }

bool HasOwnAlpha(Attribute attribute) { return Info(attribute).components == 4; }

bool IsDisplay(const Storage& storage) {
  return storage.encoding == image::Encoding::kDisplay && Info(storage.attribute).is_color;
}

bool IsUnorm(const Storage& storage) { return storage.format.numeric == gl::Numeric::kUnorm; }

bool IsHalf(const Storage& storage) {
  return storage.format.numeric == gl::Numeric::kFloat && storage.format.bits == 16;
}

// Which stored component holds the alpha of a luminance format: "a" for A8L8 in four components, "g" in two.
char AlphaSlot(const gl::Format& format) {
  if (format.swizzle[3] == GL_ALPHA) return 'a';
  if (format.swizzle[3] == GL_GREEN) return 'g';
  return 0;
}

// The stored components that carry an id's digits, least significant first, and their bits.
struct Digit {
  char slot;
  int bits;
};

std::vector<Digit> IdDigits(const gl::Format& format) {
  const std::array<int, 4> bits = gl::ComponentBits(format);
  std::vector<Digit> digits;
  const auto add = [&](char slot) {
    const std::size_t index = std::string_view("rgba").find(slot);
    if (bits[index] > 0) digits.push_back({slot, bits[index]});
  };
  if (gl::IsAlphaOnly(format)) {
    add('a');
  } else if (gl::IsLuminance(format)) {
    add('r');
    if (const char slot = AlphaSlot(format); slot != 0) add(slot);
  } else {
    for (const char slot : std::string_view("rgb").substr(0, static_cast<std::size_t>(std::min(format.components, 3))))
      add(slot);
  }
  return digits;
}

std::string StoreFloatId(const Storage& storage, std::string_view id) {
  // binary16 holds integers up to 2048 exactly; binary32 up to 2^24, more than a frame can tell apart.
  const std::string number = IsHalf(storage) ? fmt::format("WrapId({}, 2048u)", id) : fmt::format("float({})", id);
  return fmt::format("vec4(vec3({}), 1.0)", number);
}

std::string StoreUnormId(const Storage& storage, std::string_view id) {
  const std::vector<Digit> digits = IdDigits(storage.format);
  int total = 0;
  for (const Digit& digit : digits) total += digit.bits;
  // Ids over the range start again at 1, so that neighbours stay apart and none looks like the background.
  const std::string wrapped =
      total >= 32 ? std::string(id)
                  : fmt::format("(({0}) == 0u ? 0u : (({0}) - 1u) % {1}u + 1u)", id, (1ull << total) - 1);
  std::array<std::string, 4> slots = {"0.0", "0.0", "0.0", "1.0"};
  int shift = 0;
  for (const Digit& digit : digits) {
    const std::uint64_t most = (1ull << digit.bits) - 1;
    const std::size_t index = std::string_view("rgba").find(digit.slot);
    if (shift < 32) slots[index] = fmt::format("float(({} >> {}u) & {}u) / {}.0", wrapped, shift, most, most);
    shift += digit.bits;
  }
  return fmt::format("vec4({}, {}, {}, {})", slots[0], slots[1], slots[2], slots[3]);
}

// Data components over the whole vector: one is repeated, as L8 reads.
std::string Expand(const Storage& storage, std::string_view value, bool halve) {
  const std::string v = halve ? fmt::format("(({}) * 0.5 + 0.5)", value) : fmt::format("({})", value);
  switch (Info(storage.attribute).components) {
    case 1:
      return fmt::format("vec4({}.xxx, 1.0)", v);
    case 2:
      return fmt::format("vec4({}.xy, 0.0, 1.0)", v);
    case 3:
      return fmt::format("vec4({}.xyz, 1.0)", v);
    default:
      return v;
  }
}

// Into the components that the format's swizzle reads.
std::string Place(const Storage& storage, std::string expanded) {
  const AttributeInfo& info = Info(storage.attribute);
  if (gl::IsAlphaOnly(storage.format)) {
    return fmt::format("vec4(({}).{})", expanded, HasOwnAlpha(storage.attribute) ? 'a' : 'r');
  }
  if (!gl::IsLuminance(storage.format)) return expanded;
  const std::string luminance =
      info.is_color && info.components >= 3 ? fmt::format("Luma(({}).rgb)", expanded) : fmt::format("({}).r", expanded);
  const std::string second = fmt::format("({}).{}", expanded, info.components == 2 ? 'g' : 'a');
  // Green and alpha both: whichever of them the format keeps.
  return fmt::format("vec4({}, {}, 0.0, {})", luminance, second, second);
}

std::string Limit(const Storage& storage, std::string expression) {
  return IsHalf(storage) ? fmt::format("ClampToHalf({})", expression) : expression;
}

Vector ExpandBackground(const Storage& storage, const Vector& value) {
  const AttributeInfo& info = Info(storage.attribute);
  const bool halve = info.is_signed && IsUnorm(storage);
  const auto store = [&](float x) { return halve ? 0.5f * x + 0.5f : x; };
  switch (info.components) {
    case 1:
      return {store(value[0]), store(value[0]), store(value[0]), 0.0f};
    case 2:
      return {store(value[0]), store(value[1]), 0.0f, 0.0f};
    case 3:
      return {store(value[0]), store(value[1]), store(value[2]), 0.0f};
    default:
      return value;
  }
}

Vector PlaceBackground(const Storage& storage, const Vector& v) {
  const AttributeInfo& info = Info(storage.attribute);
  if (gl::IsAlphaOnly(storage.format)) {
    const float x = HasOwnAlpha(storage.attribute) ? v[3] : v[0];
    return {x, x, x, x};
  }
  if (!gl::IsLuminance(storage.format)) return v;
  const float luminance = info.is_color && info.components >= 3 ? Luma(v) : v[0];
  const float second = info.components == 2 ? v[1] : v[3];
  return {luminance, second, 0.0f, second};
}

std::string StoreConverted(const Storage& storage, const std::string& color) {
  switch (storage.attribute) {
    case Attribute::kIntensity:
      return Limit(storage, Place(storage, Expand(storage, fmt::format("vec4(Luma(({}).rgb))", color), false)));
    case Attribute::kAlpha:
      return Limit(storage, Place(storage, Expand(storage, fmt::format("vec4(({}).a)", color), false)));
    default:
      return Limit(storage, Place(storage, Expand(storage, color, false)));
  }
}

}  // namespace

bool IsColorClass(Attribute attribute) {
  return attribute == Attribute::kColor || attribute == Attribute::kIntensity || attribute == Attribute::kAlpha;
}

std::string_view StorageFunctions() { return kFunctions; }

std::string StoreExpression(const Storage& storage, std::string_view value) {
  const AttributeInfo& info = Info(storage.attribute);
  if (info.is_id) return IsUnorm(storage) ? StoreUnormId(storage, value) : StoreFloatId(storage, value);
  const bool is_picture = IsColorClass(storage.attribute) || storage.attribute == Attribute::kVideo;
  if (is_picture) {
    return StoreConverted(storage, !IsDisplay(storage)   ? std::string(value)
                                   : KeepsAlpha(storage) ? fmt::format("DisplayFromScene({})", value)
                                                         : fmt::format("DisplayOnBlack({})", value));
  }
  const std::string converted =
      IsDisplay(storage) ? fmt::format("vec4(SrgbEncode(({0}).rgb), ({0}).a)", value) : std::string(value);
  return Limit(storage, Place(storage, Expand(storage, converted, info.is_signed && IsUnorm(storage))));
}

bool KeepsAlpha(const Storage& storage) {
  if (storage.attribute == Attribute::kIntensity) return false;
  if (gl::IsLuminance(storage.format)) return AlphaSlot(storage.format) != 0;
  return storage.format.components == 4 || gl::IsAlphaOnly(storage.format);
}

bool CanLoadColor(const Storage& storage) {
  const bool has_rgb =
      storage.format.components >= 3 && !gl::IsLuminance(storage.format) && !gl::IsAlphaOnly(storage.format);
  return has_rgb && (storage.attribute == Attribute::kColor || storage.attribute == Attribute::kVideo);
}

std::string LoadColorExpression(const Storage& storage, std::string_view texel) {
  return IsDisplay(storage) ? fmt::format("SceneFromDisplay({})", texel) : std::string(texel);
}

std::string StorePictureExpression(const Storage& storage, std::string_view value) {
  return StoreConverted(storage, std::string(value));
}

std::array<float, 4> StoredBackground(const Storage& storage, const std::array<float, 4>& color) {
  Vector value = Info(storage.attribute).background;
  if (IsColorClass(storage.attribute)) {
    if (IsDisplay(storage)) value = KeepsAlpha(storage) ? DisplayFromScene(color) : DisplayOnBlack(color);
    if (!IsDisplay(storage)) value = color;
    if (storage.attribute == Attribute::kIntensity) value = {Luma(value), 0, 0, 0};
    if (storage.attribute == Attribute::kAlpha) value = {value[3], 0, 0, 0};
  }
  value = PlaceBackground(storage, ExpandBackground(storage, value));
  if (IsHalf(storage)) {
    for (float& x : value) x = std::clamp(x, -kMaxHalf, kMaxHalf);
  }
  return value;
}

}  // namespace burin::gbuffer
