// SPDX-License-Identifier: Apache-2.0
// What goes into a texture of each format comes back, and is read as Direct3D 9 reads it.
#include <epoxy/gl.h>
#include <gmock/gmock.h>

#include <array>
#include <cmath>

#include "core/gl/framebuffer.h"
#include "core/gl/fullscreen_quad.h"
#include "core/gl/program.h"
#include "core/gl/readback.h"
#include "core/gl/state.h"
#include "tests/gl/gl/context_fixture.h"

namespace burin::gl {
namespace {

using image::SampleType;

class FormatTest : public ContextTest {};

constexpr const char* kVertex = R"(#version 450 core
layout(location = 0) in vec4 position;
void main() { gl_Position = position; })";

// What a shader reads at texel (0,0).
std::array<float, 4> Sampled(const Texture& texture) {
  const Program program = Must(Program::Create(kVertex, R"(#version 450 core
layout(binding = 0) uniform sampler2D source;
layout(location = 0) out vec4 result;
void main() { result = texelFetch(source, ivec2(0), 0); })",
                                               "test"));
  const Texture target = Must(Texture::Create(PlainFormat(Numeric::kFloat, 32, 4), 1, 1, 1, "test"));
  const Texture* color = &target;
  const Framebuffer framebuffer = Must(Framebuffer::Create(std::span(&color, 1), nullptr, "test"));
  const FullscreenQuad quad = Must(FullscreenQuad::Create());
  ResetState();
  framebuffer.Bind();
  glUseProgram(program.id());
  glBindTextureUnit(0, texture.id());
  quad.Draw();
  const image::Image pixel = Read(target, SampleType::kF32, 4, image::Encoding::kData);
  std::array<float, 4> values{};
  std::ranges::copy(pixel.As<float>(), values.begin());
  return values;
}

auto Near(const std::array<float, 4>& values) { return testing::Pointwise(testing::FloatNear(1e-6f), values); }

TEST_F(FormatTest, EveryPlainFormatComesBackBitForBit) {
  for (const int channels : {1, 2, 3, 4}) {
    const auto round_trip = [&](const image::Image& image) {
      Texture texture = Must(Texture::Create(FormatFor(image), image.width, image.height, 1, "test"));
      texture.Upload(image);
      EXPECT_EQ(Read(texture, image.type, channels, image::Encoding::kData).pixels, image.pixels)
          << channels << " channels of type " << static_cast<int>(image.type);
    };
    round_trip(MakeImage<std::uint8_t>(5, 3, channels, SampleType::kU8, [](std::size_t i) { return i * 37 + 11; }));
    round_trip(MakeImage<std::uint16_t>(5, 3, channels, SampleType::kU16, [](std::size_t i) { return i * 1237 + 11; }));
    // Finite halves only: 0x3C00 is 1.0.
    round_trip(
        MakeImage<std::uint16_t>(5, 3, channels, SampleType::kF16, [](std::size_t i) { return 0x3C00 + i * 17; }));
    round_trip(
        MakeImage<float>(5, 3, channels, SampleType::kF32, [](std::size_t i) { return std::exp(double(i)) - 40; }));
  }
}

TEST_F(FormatTest, MissingComponentsReadAsDirect3DReadsThem) {
  struct Case {
    const char* name;
    GLenum internal;
    std::array<std::int32_t, 4> swizzle;
    std::array<float, 4> expected;
  };
  // Stored: r 0.25, g 0.5, b 0.75, a 0.125, as far as the format goes.
  const Case cases[] = {
      {"R32F", GL_R32F, {GL_RED, GL_ONE, GL_ONE, GL_ONE}, {0.25f, 1, 1, 1}},
      {"G32R32F", GL_RG32F, {GL_RED, GL_GREEN, GL_ONE, GL_ONE}, {0.25f, 0.5f, 1, 1}},
      {"L as R32F", GL_R32F, {GL_RED, GL_RED, GL_RED, GL_ONE}, {0.25f, 0.25f, 0.25f, 1}},
      {"AL as RG32F", GL_RG32F, {GL_RED, GL_RED, GL_RED, GL_GREEN}, {0.25f, 0.25f, 0.25f, 0.5f}},
      {"A in four", GL_RGBA32F, {GL_ZERO, GL_ZERO, GL_ZERO, GL_ALPHA}, {0, 0, 0, 0.125f}},
      {"X in four", GL_RGBA32F, {GL_RED, GL_GREEN, GL_BLUE, GL_ONE}, {0.25f, 0.5f, 0.75f, 1}},
  };
  for (const Case& test : cases) {
    const Format format{
        .internal = test.internal, .swizzle = test.swizzle, .numeric = Numeric::kFloat, .bits = 32, .components = 4};
    Texture texture = Must(Texture::Create(format, 1, 1, 1, test.name));
    constexpr std::array kStored = {0.25f, 0.5f, 0.75f, 0.125f};
    texture.Upload(MakeImage<float>(1, 1, 4, SampleType::kF32, [&](std::size_t i) { return kStored[i]; }));
    EXPECT_EQ(Sampled(texture), test.expected) << test.name;
  }
}

TEST_F(FormatTest, GreyImagesReadAsGrey) {
  const image::Image grey = MakeImage<std::uint8_t>(1, 1, 1, SampleType::kU8, [](std::size_t) { return 51; });
  const image::Image grey_alpha =
      MakeImage<std::uint8_t>(1, 1, 2, SampleType::kU8, [](std::size_t i) { return 51 + 51 * i; });
  for (const Format& format : {FormatFor(grey), PlainFormat(Numeric::kUnorm, 8, 4)}) {
    Texture texture = Must(Texture::Create(format, 1, 1, 1, "grey"));
    texture.Upload(grey);
    EXPECT_THAT(Sampled(texture), Near({0.2f, 0.2f, 0.2f, 1.0f}));
  }
  for (const Format& format : {FormatFor(grey_alpha), PlainFormat(Numeric::kUnorm, 8, 4)}) {
    Texture texture = Must(Texture::Create(format, 1, 1, 1, "grey"));
    texture.Upload(grey_alpha);
    EXPECT_THAT(Sampled(texture), Near({0.2f, 0.2f, 0.2f, 0.4f}));
  }
}

TEST_F(FormatTest, ComponentBitsAreTheStoredOnes) {
  const auto bits = [](GLenum internal) {
    Format format;
    format.internal = internal;
    return ComponentBits(format);
  };
  EXPECT_EQ(bits(GL_RGB565), (std::array{5, 6, 5, 0}));
  EXPECT_EQ(bits(GL_RGB10_A2), (std::array{10, 10, 10, 2}));
  EXPECT_EQ(bits(GL_R16F), (std::array{16, 0, 0, 0}));
  EXPECT_EQ(bits(GL_RGBA8), (std::array{8, 8, 8, 8}));
}

TEST_F(FormatTest, OversizedTexturesAreRefusedWithTheLimit) {
  const int limit = context_->info().max_texture_size;
  const Result<Texture> texture = Texture::Create(PlainFormat(Numeric::kUnorm, 8, 4), limit + 1, 4, 1, "frame");
  ASSERT_FALSE(texture.has_value());
  EXPECT_EQ(texture.error().message, "frame: a texture of " + std::to_string(limit + 1) +
                                         "x4 pixels; this device takes 1x1 to " + std::to_string(limit) + "x" +
                                         std::to_string(limit));
}

TEST_F(FormatTest, MipmapsGoDownToOneTexel) {
  Texture texture = Must(Texture::Create(PlainFormat(Numeric::kUnorm, 8, 4), 7, 3, 0, "mips"));
  EXPECT_EQ(texture.levels(), 3);
  texture.Upload(MakeImage<std::uint8_t>(7, 3, 4, SampleType::kU8, [](std::size_t) { return 200; }));
  texture.GenerateMipmaps();
  std::array<std::uint8_t, 4> top{};
  glGetTextureImage(texture.id(), 2, GL_RGBA, GL_UNSIGNED_BYTE, sizeof(top), top.data());
  EXPECT_EQ(top, (std::array<std::uint8_t, 4>{200, 200, 200, 200}));
}

}  // namespace
}  // namespace burin::gl
