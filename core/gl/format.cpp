// SPDX-License-Identifier: Apache-2.0
#include "core/gl/format.h"

#include <epoxy/gl.h>

#include <algorithm>

#include "core/gl/texture.h"

namespace burin::gl {
namespace {

struct Entry {
  GLenum internal;
  std::array<int, 4> bits;
};

// OpenGL 4.5 core, tables 8.12 and 8.13: those that this program makes textures of.
constexpr std::array kEntries = {
    Entry{GL_R8, {8, 0, 0, 0}},           Entry{GL_RG8, {8, 8, 0, 0}},         Entry{GL_RGB8, {8, 8, 8, 0}},
    Entry{GL_RGBA8, {8, 8, 8, 8}},        Entry{GL_SRGB8, {8, 8, 8, 0}},       Entry{GL_SRGB8_ALPHA8, {8, 8, 8, 8}},
    Entry{GL_RGB565, {5, 6, 5, 0}},       Entry{GL_RGB10_A2, {10, 10, 10, 2}}, Entry{GL_RGB5_A1, {5, 5, 5, 1}},
    Entry{GL_RGBA4, {4, 4, 4, 4}},        Entry{GL_R16, {16, 0, 0, 0}},        Entry{GL_RG16, {16, 16, 0, 0}},
    Entry{GL_RGB16, {16, 16, 16, 0}},     Entry{GL_RGBA16, {16, 16, 16, 16}},  Entry{GL_R16F, {16, 0, 0, 0}},
    Entry{GL_RG16F, {16, 16, 0, 0}},      Entry{GL_RGB16F, {16, 16, 16, 0}},   Entry{GL_RGBA16F, {16, 16, 16, 16}},
    Entry{GL_R32F, {32, 0, 0, 0}},        Entry{GL_RG32F, {32, 32, 0, 0}},     Entry{GL_RGB32F, {32, 32, 32, 0}},
    Entry{GL_RGBA32F, {32, 32, 32, 32}},  Entry{GL_R32UI, {32, 0, 0, 0}},      Entry{GL_RG32UI, {32, 32, 0, 0}},
    Entry{GL_RGBA32UI, {32, 32, 32, 32}},
};

constexpr std::array<std::int32_t, 4> kIdentity = {GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA};

// One and two components as they are; three are kept in four, since no driver has to render to three.
GLenum Internal(Numeric numeric, int bits, int components) {
  const std::size_t column = components == 1 ? 0 : components == 2 ? 1 : 2;
  constexpr std::array<GLenum, 3> kUnorm8 = {GL_R8, GL_RG8, GL_RGBA8};
  constexpr std::array<GLenum, 3> kUnorm16 = {GL_R16, GL_RG16, GL_RGBA16};
  constexpr std::array<GLenum, 3> kFloat16 = {GL_R16F, GL_RG16F, GL_RGBA16F};
  constexpr std::array<GLenum, 3> kFloat32 = {GL_R32F, GL_RG32F, GL_RGBA32F};
  if (numeric == Numeric::kUnorm) return bits <= 8 ? kUnorm8[column] : kUnorm16[column];
  return bits <= 16 ? kFloat16[column] : kFloat32[column];
}

}  // namespace

std::array<int, 4> ComponentBits(const Format& format) {
  const auto* entry = std::ranges::find(kEntries, format.internal, &Entry::internal);
  return entry == kEntries.end() ? std::array<int, 4>{} : entry->bits;
}

bool IsAlphaOnly(const Format& format) { return format.swizzle[0] == GL_ZERO && format.swizzle[3] == GL_ALPHA; }

bool IsLuminance(const Format& format) {
  return format.swizzle[0] == GL_RED && format.swizzle[1] == GL_RED && format.swizzle[2] == GL_RED;
}

Format PlainFormat(Numeric numeric, int bits, int components) {
  Format format{.internal = Internal(numeric, bits, components),
                .swizzle = kIdentity,
                .numeric = numeric,
                .bits = bits,
                .components = components};
  if (components == 3) format.swizzle[3] = GL_ONE;
  return format;
}

Format FormatFor(const image::Image& image) {
  const bool is_float = image.type == image::SampleType::kF16 || image.type == image::SampleType::kF32;
  const int bits = static_cast<int>(image::SampleBytes(image.type)) * 8;
  Format format = PlainFormat(is_float ? Numeric::kFloat : Numeric::kUnorm, bits, image.channels);
  if (image.channels == 1) format.swizzle = {GL_RED, GL_RED, GL_RED, GL_ONE};
  if (image.channels == 2) format.swizzle = {GL_RED, GL_RED, GL_RED, GL_GREEN};
  if (image.channels == 3) format.swizzle = kIdentity;  // Upload stores alpha 1: it can be copied as RGBA
  return format;
}

}  // namespace burin::gl
