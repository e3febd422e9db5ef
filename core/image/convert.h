// SPDX-License-Identifier: Apache-2.0
#pragma once
// Conversions of pixels that change no colours: sample types, channel counts, alpha association.

#include <cstddef>
#include <span>

#include "core/image/image.h"

namespace burin::image {

/// `count` samples of one type into another; the spans hold count * SampleBytes each and may not overlap.
/// kU8 and kU16 are 0..1: to them floats are clamped and rounded to nearest, NaN gives 0. kU32 is a plain number
/// (an id): to and from floats by value, to narrower integers clamped, from them by value.
void ConvertSamples(std::span<const std::byte> from, SampleType from_type, std::span<std::byte> to, SampleType to_type,
                    std::size_t count);

/// The same picture in another sample type.
[[nodiscard]] Image ToType(const Image& image, SampleType type);

/// The same picture with another number of channels (1 to 4). Grey spreads to RGB, missing alpha is opaque; RGB to
/// grey takes the luminance of BT.709 for colour, the first channel for kData; dropped alpha is just dropped.
[[nodiscard]] Image ToChannels(const Image& image, int channels);

/// RGB *= A and RGB /= A, for pixels of 4 floats. Where A is 0 the colour is kept: glows stay.
void Premultiply(std::span<float> rgba);
void Unpremultiply(std::span<float> rgba);

/// Rows bottom first to rows top first and back, in place.
void FlipRows(Image& image);

/// An image of these sizes with zeroed pixels.
[[nodiscard]] Image MakeImage(int width, int height, int channels, SampleType type, Encoding encoding);

}  // namespace burin::image
