// SPDX-License-Identifier: Apache-2.0
#include "core/image/image_module.h"

#include <gtest/gtest.h>

namespace burin::image {
namespace {

TEST(ImageModule, LoadsOnceAndTellsItsVersions) {
  const auto module = LoadImageModule();
  ASSERT_TRUE(module.has_value()) << module.error().message;
  EXPECT_EQ(*module, *LoadImageModule());
  EXPECT_TRUE((*module)->Versions().starts_with("OpenImageIO 2.")) << (*module)->Versions();
  EXPECT_NE((*module)->Versions().find(", OpenEXR 3."), std::string::npos) << (*module)->Versions();
  EXPECT_NE((*module)->Versions().find(", OpenColorIO 2."), std::string::npos) << (*module)->Versions();
}

}  // namespace
}  // namespace burin::image
