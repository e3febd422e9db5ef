// SPDX-License-Identifier: Apache-2.0
#include "core/image/file_format.h"

#include <gtest/gtest.h>

namespace burin::image {
namespace {

std::string Refusal(const std::string& path, SampleType type, int channels) {
  const Result<void> checked = CheckWritable(path, type, channels);
  if (checked) return "";
  EXPECT_EQ(checked.error().kind, ErrorKind::kUsage);
  return checked.error().message;
}

TEST(FileFormat, TakesWhatEachFormatHolds) {
  for (const int channels : {1, 2, 3, 4}) {
    EXPECT_EQ(Refusal("a.png", SampleType::kU8, channels), "");
    EXPECT_EQ(Refusal("a.PNG", SampleType::kU16, channels), "");
    EXPECT_EQ(Refusal("a.jpg", SampleType::kU8, channels), "");
    EXPECT_EQ(Refusal("a.tif", SampleType::kF32, channels), "");
    EXPECT_EQ(Refusal("a.tiff", SampleType::kU16, channels), "");
    EXPECT_EQ(Refusal("a.exr", SampleType::kF16, channels), "");
    EXPECT_EQ(Refusal("a.exr", SampleType::kU32, channels), "");
    EXPECT_EQ(Refusal("a.hdr", SampleType::kF32, channels), "");
  }
}

TEST(FileFormat, NamesTheAlternatives) {
  EXPECT_EQ(
      Refusal("a.png", SampleType::kF16, 4),
      "cannot write 'a.png': PNG has no half-float samples; floating-point samples go into .exr, .tif or .hdr, exact "
      "ids into .exr");
  EXPECT_EQ(
      Refusal("a.jpg", SampleType::kU16, 3),
      "cannot write 'a.jpg': JPEG has no 16-bit samples; 16-bit samples go into .png or .tif, floating-point ones into "
      ".exr, .tif or .hdr, exact ids into .exr");
  EXPECT_EQ(
      Refusal("a.exr", SampleType::kU8, 3),
      "cannot write 'a.exr': OpenEXR has no 8-bit samples; 8- and 16-bit samples go into .png or .tif, exact ids into "
      ".exr");
  EXPECT_EQ(Refusal("a.tif", SampleType::kU32, 1),
            "cannot write 'a.tif': TIFF has no 32-bit integer samples; exact 32-bit ids go into .exr");
}

TEST(FileFormat, RefusesUnknownExtensions) {
  EXPECT_EQ(
      Refusal("a.gif", SampleType::kU8, 3),
      "cannot write 'a.gif': '.gif' is no image format that burin writes; images are written as .png, .jpg, .tif, .exr "
      "or .hdr");
  EXPECT_EQ(Refusal("frame", SampleType::kU8, 3),
            "cannot write 'frame': it has no extension to choose a format by; images are written as .png, .jpg, .tif, "
            ".exr or "
            ".hdr");
  EXPECT_EQ(Refusal("a.png", SampleType::kU8, 5),
            "cannot write 'a.png': it would have 5 channels, an image has 1 to 4; more go into .exr as layers");
}

TEST(FileFormat, KnowsImagePaths) {
  EXPECT_TRUE(IsImagePath("x/a.0001.EXR"));
  EXPECT_TRUE(IsImagePath("a.webp"));
  EXPECT_FALSE(IsImagePath("a.mkv"));
  EXPECT_FALSE(IsImagePath("a.glb"));
  EXPECT_FALSE(IsImagePath("png"));
}

}  // namespace
}  // namespace burin::image
