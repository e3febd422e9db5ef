// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <string_view>
#include <vector>

#include "core/image/convert.h"
#include "core/image/image_module.h"
#include "tests/unit/base/temporary_folder.h"

namespace burin::image {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

struct StoredChannel {
  std::string name;
  int type;  ///< 0 unsigned, 1 half, 2 float
  bool operator==(const StoredChannel&) const = default;
};
void PrintTo(const StoredChannel& channel, std::ostream* out) { *out << channel.name << ":" << channel.type; }

// The "channels" attribute of the header, by the OpenEXR file layout document: name, NUL, pixel type, four bytes of
// linearity and padding, two sampling rates; ended by a NUL.
std::vector<StoredChannel> ChannelsOf(const std::string& path) {
  const auto bytes = test::ReadAllBytes(path);
  const std::string_view file(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  constexpr std::string_view kAttribute("channels\0chlist\0", 16);
  std::size_t at = file.find(kAttribute);
  EXPECT_NE(at, std::string_view::npos);
  at += kAttribute.size() + 4;
  std::vector<StoredChannel> channels;
  while (file[at] != '\0') {
    const std::string name(file.substr(at, file.find('\0', at) - at));
    at += name.size() + 1;
    channels.push_back({name, file[at]});
    at += 16;
  }
  return channels;
}

class ExrLayers : public testing::Test {
 protected:
  void SetUp() override {
    const auto module = LoadImageModule();
    ASSERT_TRUE(module.has_value()) << module.error().message;
    module_ = *module;
  }

  static Image Filled(int channels, SampleType type, float value) {
    Image image = MakeImage(5, 3, channels, SampleType::kF32, Encoding::kData);
    for (std::size_t i = 0; i < image.pixels.size() / 4; ++i) image.As<float>()[i] = value + static_cast<float>(i);
    return ToType(image, type);
  }

  std::string Refusal(std::span<const Layer> layers) {
    const auto written = module_->WriteLayers(folder_.File("a.exr"), layers, {});
    return written ? "" : written.error().message;
  }

  ImageModule* module_ = nullptr;
  test::TemporaryFolder folder_;
};

TEST_F(ExrLayers, ChannelsAreSortedWithTheirOwnTypes) {
  const Image color = Filled(4, SampleType::kF16, 0);
  const Image normal = Filled(3, SampleType::kF16, 100);
  const Image depth = Filled(1, SampleType::kF32, 200);
  const Image id = Filled(1, SampleType::kU32, 300);
  const std::vector<Layer> layers{
      {{"R", "G", "B", "A"}, &color}, {{"N.X", "N.Y", "N.Z"}, &normal}, {{"Z"}, &depth}, {{"objectid.id"}, &id}};
  const auto written = module_->WriteLayers(folder_.File("a.exr"), layers, {});
  ASSERT_TRUE(written.has_value()) << written.error().message;
  EXPECT_THAT(ChannelsOf(folder_.File("a.exr")),
              ElementsAre(StoredChannel{"A", 1}, StoredChannel{"B", 1}, StoredChannel{"G", 1}, StoredChannel{"N.X", 1},
                          StoredChannel{"N.Y", 1}, StoredChannel{"N.Z", 1}, StoredChannel{"R", 1},
                          StoredChannel{"Z", 2}, StoredChannel{"objectid.id", 0}));
  // Read back, the picture is the main layer; its type is one that holds all of it.
  const auto read = module_->Read(folder_.File("a.exr"));
  ASSERT_TRUE(read.has_value()) << read.error().message;
  EXPECT_EQ(read->type, SampleType::kF16);
  EXPECT_EQ(read->pixels, color.pixels);
}

TEST_F(ExrLayers, OneLayerComesBackExactly) {
  const Image normal = Filled(3, SampleType::kF32, -7);
  const Image id = Filled(1, SampleType::kU32, 4000000);
  ASSERT_TRUE(module_->WriteLayers(folder_.File("n.exr"), std::vector<Layer>{{{"N.X", "N.Y", "N.Z"}, &normal}}, {})
                  .has_value());
  EXPECT_EQ(module_->Read(folder_.File("n.exr"))->pixels, normal.pixels);
  ASSERT_TRUE(module_->WriteLayers(folder_.File("i.exr"), std::vector<Layer>{{{"id"}, &id}}, {}).has_value());
  const auto read = module_->Read(folder_.File("i.exr"));
  ASSERT_TRUE(read.has_value()) << read.error().message;
  EXPECT_EQ(read->type, SampleType::kU32);
  EXPECT_EQ(read->encoding, Encoding::kData);
  EXPECT_EQ(read->pixels, id.pixels);
}

TEST_F(ExrLayers, IntegerLayersBecomeFloatingOnes) {
  const Image bytes = ToType(Filled(1, SampleType::kF32, 0), SampleType::kU8);
  const Image words = ToType(Filled(1, SampleType::kF32, 0), SampleType::kU16);
  ASSERT_TRUE(module_->WriteLayers(folder_.File("a.exr"), std::vector<Layer>{{{"a"}, &bytes}, {{"b"}, &words}}, {})
                  .has_value());
  EXPECT_THAT(ChannelsOf(folder_.File("a.exr")), ElementsAre(StoredChannel{"a", 1}, StoredChannel{"b", 2}));
}

TEST_F(ExrLayers, TwoRunsGiveTheSameBytes) {
  const Image image = Filled(3, SampleType::kF16, 1);
  const std::vector<Layer> layers{{{"R", "G", "B"}, &image}};
  const WriteOptions options{.jpeg_quality = 95, .metadata = {{"burin:inputs", "abc"}}};
  ASSERT_TRUE(module_->WriteLayers(folder_.File("a.exr"), layers, options).has_value());
  ASSERT_TRUE(module_->WriteLayers(folder_.File("b.exr"), layers, options).has_value());
  EXPECT_EQ(test::ReadAllBytes(folder_.File("a.exr")), test::ReadAllBytes(folder_.File("b.exr")));
}

TEST_F(ExrLayers, RefusesWhatDoesNotFitTogether) {
  const Image a = Filled(1, SampleType::kF32, 0);
  const Image b = MakeImage(6, 3, 1, SampleType::kF32, Encoding::kData);
  const std::string front = "cannot write '" + folder_.File("a.exr") + "': ";
  EXPECT_EQ(Refusal({}), front + "it would have no layers");
  EXPECT_EQ(Refusal(std::vector<Layer>{{{"Z"}, &a}, {{"Q"}, &b}}),
            front + "its layers differ in size: 5x3 and 6x3 (Q)");
  EXPECT_EQ(Refusal(std::vector<Layer>{{{"Z", "Q"}, &a}}), front + "2 channel names (Z, Q) for an image of 1 channels");
  EXPECT_EQ(Refusal(std::vector<Layer>{{{"Z"}, &a}, {{"Z"}, &a}}), front + "two of its channels are named 'Z'");
  EXPECT_THAT(folder_.Names(), IsEmpty());
  EXPECT_EQ(module_->WriteLayers("a.png", std::vector<Layer>{{{"Z"}, &a}}, {}).error().message,
            "cannot write 'a.png': only .exr holds layers");
}

}  // namespace
}  // namespace burin::image
