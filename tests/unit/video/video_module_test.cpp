// SPDX-License-Identifier: Apache-2.0
#include "core/video/video_module.h"

#include <gtest/gtest.h>

namespace burin::video {
namespace {

TEST(VideoModule, LoadsOnceAndTellsItsVersion) {
  const auto module = LoadVideoModule();
  ASSERT_TRUE(module.has_value()) << module.error().message;
  EXPECT_EQ(*module, *LoadVideoModule());
  EXPECT_TRUE((*module)->Versions().starts_with("OpenCV 4.")) << (*module)->Versions();
}

}  // namespace
}  // namespace burin::video
