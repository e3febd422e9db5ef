// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <vector>

#include "core/gl/context.h"
#include "core/gl/texture.h"

namespace burin::gl {

/// A debug context for a suite: any driver error ends the test program. BURIN_TEST_DEVICE chooses the device.
class ContextTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    ContextOptions options;
    options.debug = true;
    if (const char* device = std::getenv("BURIN_TEST_DEVICE"); device != nullptr) options.device = device;
    Result<std::unique_ptr<Context>> context = Context::Create(options);
    ASSERT_TRUE(context.has_value()) << context.error().message;
    context_ = std::move(*context);
  }
  static void TearDownTestSuite() { context_.reset(); }

  static inline std::unique_ptr<Context> context_;
};

template <class T>
T Must(Result<T> result) {
  if (!result) {
    ADD_FAILURE() << result.error().message;
    std::abort();
  }
  return std::move(*result);
}

/// An image whose sample i is `value(i)`, in the type's own numbers.
template <class T, class Value>
image::Image MakeImage(int width, int height, int channels, image::SampleType type, Value value) {
  image::Image image;
  image.width = width;
  image.height = height;
  image.channels = channels;
  image.type = type;
  image.pixels.resize(image.RowBytes() * static_cast<std::size_t>(height));
  std::size_t i = 0;
  for (T& sample : image.As<T>()) sample = static_cast<T>(value(i++));
  return image;
}

}  // namespace burin::gl
