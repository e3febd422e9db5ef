// SPDX-License-Identifier: Apache-2.0
#include "core/image/image_module.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

#include "core/image/convert.h"
#include "tests/unit/base/temporary_folder.h"
#include "tests/unit/image/tiny_tiff.h"

namespace burin::image {
namespace {

using test::TemporaryFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr unsigned kSeed = 7;

// Random samples; of floats, finite ones of either sign.
Image Random(int width, int height, int channels, SampleType type) {
  std::mt19937 random(kSeed);
  const Encoding encoding = type == SampleType::kU8 || type == SampleType::kU16 ? Encoding::kDisplay
                            : type == SampleType::kU32                          ? Encoding::kData
                                                                                : Encoding::kSceneLinear;
  Image image = MakeImage(width, height, channels, type, encoding);
  if (type == SampleType::kF16 || type == SampleType::kF32) {
    Image floats = MakeImage(width, height, channels, SampleType::kF32, encoding);
    for (float& v : floats.As<float>()) v = static_cast<float>(static_cast<int>(random() % 20001) - 10000) / 256.0F;
    return ToType(floats, type);
  }
  for (std::byte& byte : image.pixels) byte = static_cast<std::byte>(random());
  return image;
}

class ImageFiles : public testing::Test {
 protected:
  void SetUp() override {
    const auto module = LoadImageModule();
    ASSERT_TRUE(module.has_value()) << module.error().message;
    module_ = *module;
  }

  Image RoundTrip(const std::string& name, const Image& image) {
    const Result<void> written = module_->Write(folder_.File(name), image, {});
    EXPECT_TRUE(written.has_value()) << written.error().message;
    const Result<Image> read = module_->Read(folder_.File(name));
    EXPECT_TRUE(read.has_value()) << read.error().message;
    return read.value_or(Image{});
  }

  std::string ReadError(const std::string& path) {
    const Result<Image> read = module_->Read(path);
    if (read) return "it was read";
    EXPECT_EQ(read.error().kind, ErrorKind::kInput);
    return read.error().message;
  }

  void ExpectSame(const Image& a, const Image& b, const std::string& what) {
    EXPECT_EQ(a.width, b.width) << what;
    EXPECT_EQ(a.height, b.height) << what;
    EXPECT_EQ(a.channels, b.channels) << what;
    EXPECT_EQ(a.type, b.type) << what;
    EXPECT_EQ(a.encoding, b.encoding) << what;
    EXPECT_TRUE(a.pixels == b.pixels) << what;
  }

  ImageModule* module_ = nullptr;
  TemporaryFolder folder_;
};

TEST(ImageModule, LoadsOnceAndTellsItsVersions) {
  const auto module = LoadImageModule();
  ASSERT_TRUE(module.has_value()) << module.error().message;
  EXPECT_EQ(*module, *LoadImageModule());
  EXPECT_TRUE((*module)->Versions().starts_with("OpenImageIO 2.")) << (*module)->Versions();
  EXPECT_NE((*module)->Versions().find(", OpenEXR 3."), std::string::npos) << (*module)->Versions();
  EXPECT_NE((*module)->Versions().find(", OpenColorIO 2."), std::string::npos) << (*module)->Versions();
}

TEST_F(ImageFiles, LosslessFormatsComeBackBitForBit) {
  struct Case {
    const char* extension;
    SampleType type;
  };
  for (const Case& c : {Case{"png", SampleType::kU8}, Case{"png", SampleType::kU16}, Case{"tif", SampleType::kU8},
                        Case{"tif", SampleType::kU16}, Case{"tif", SampleType::kF32}, Case{"exr", SampleType::kF16},
                        Case{"exr", SampleType::kF32}, Case{"exr", SampleType::kU32}}) {
    for (const int channels : {1, 2, 3, 4}) {
      const Image image = Random(37, 21, channels, c.type);
      const std::string name = std::string("a.") + c.extension;
      ExpectSame(
          RoundTrip(name, image), image,
          name + " of type " + std::to_string(static_cast<int>(c.type)) + " and channels " + std::to_string(channels));
    }
  }
}

TEST_F(ImageFiles, OnePixelAndOddSizes) {
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 7}, {7, 1}, {255, 3}}) {
    const Image image = Random(width, height, 4, SampleType::kU8);
    ExpectSame(RoundTrip("a.png", image), image, "png");
    const Image half = Random(width, height, 4, SampleType::kF16);
    ExpectSame(RoundTrip("a.exr", half), half, "exr");
  }
}

TEST_F(ImageFiles, HalvesInTiffBecomeFloatsWithoutLoss) {
  const Image image = Random(9, 5, 3, SampleType::kF16);
  ExpectSame(RoundTrip("a.tif", image), ToType(image, SampleType::kF32), "tif");
}

TEST_F(ImageFiles, JpegDropsAlphaAndStaysNear) {
  Image image = MakeImage(64, 48, 4, SampleType::kU8, Encoding::kDisplay);
  for (int y = 0; y < 48; ++y) {
    for (int x = 0; x < 64; ++x) {
      std::uint8_t* pixel = &image.As<std::uint8_t>()[static_cast<std::size_t>(4 * (y * 64 + x))];
      pixel[0] = static_cast<std::uint8_t>(x * 4);
      pixel[1] = static_cast<std::uint8_t>(y * 5);
      pixel[2] = 90;
      pixel[3] = 128;
    }
  }
  const Image read = RoundTrip("a.jpg", image);
  ASSERT_EQ(read.channels, 3);
  const Image expected = ToChannels(image, 3);
  constexpr int kJpegError = 6;  // of smooth pictures at quality 95
  for (std::size_t i = 0; i < expected.pixels.size(); ++i) {
    ASSERT_NEAR(read.As<std::uint8_t>()[i], expected.As<std::uint8_t>()[i], kJpegError) << i;
  }
}

TEST_F(ImageFiles, JpegQualityIsUsed) {
  const Image image = Random(64, 64, 3, SampleType::kU8);
  ASSERT_TRUE(module_->Write(folder_.File("good.jpg"), image, {.jpeg_quality = 95, .metadata = {}}).has_value());
  ASSERT_TRUE(module_->Write(folder_.File("bad.jpg"), image, {.jpeg_quality = 20, .metadata = {}}).has_value());
  EXPECT_GT(test::ReadAllBytes(folder_.File("good.jpg")).size(),
            2 * test::ReadAllBytes(folder_.File("bad.jpg")).size());
}

TEST_F(ImageFiles, RadianceStaysWithinItsPrecision) {
  Image image = Random(40, 30, 4, SampleType::kF32);
  for (float& v : image.As<float>()) v = std::abs(v) + 0.25F;
  const Image read = RoundTrip("a.hdr", image);
  ASSERT_EQ(read.channels, 3);
  EXPECT_EQ(read.encoding, Encoding::kSceneLinear);
  const Image expected = ToChannels(image, 3);
  for (std::size_t i = 0; i < expected.pixels.size() / 4; i += 3) {
    const auto rgb = expected.As<float>().subspan(i, 3);
    const float largest = std::max({rgb[0], rgb[1], rgb[2]});
    for (std::size_t c = 0; c < 3; ++c) {
      ASSERT_NEAR(read.As<float>()[i + c], rgb[c], largest / 100.0F) << i;  // an 8-bit mantissa shared by three
    }
  }
}

TEST_F(ImageFiles, NanAndInfinityPassThrough) {
  Image image = MakeImage(2, 1, 1, SampleType::kF32, Encoding::kSceneLinear);
  image.As<float>()[0] = std::numeric_limits<float>::quiet_NaN();
  image.As<float>()[1] = std::numeric_limits<float>::infinity();
  for (const char* name : {"a.exr", "a.tif"}) {
    const Image read = RoundTrip(name, image);
    ASSERT_EQ(read.pixels.size(), image.pixels.size());
    EXPECT_TRUE(std::isnan(read.As<float>()[0])) << name;
    EXPECT_TRUE(std::isinf(read.As<float>()[1])) << name;
  }
}

TEST_F(ImageFiles, TransparentColoursAreKept) {
  Image image = MakeImage(2, 1, 4, SampleType::kU8, Encoding::kDisplay);
  const std::vector<std::uint8_t> samples{200, 100, 50, 0, 10, 20, 30, 1};
  std::memcpy(image.pixels.data(), samples.data(), samples.size());
  ExpectSame(RoundTrip("a.png", image), image, "png");
  ExpectSame(RoundTrip("a.tif", image), image, "tif");
}

TEST_F(ImageFiles, WritingTwiceGivesTheSameBytesAndNoClockTime) {
  const std::string year = "20";
  for (const char* name : {"a.png", "a.jpg", "a.tif", "b.exr", "b.hdr"}) {
    const bool floats = name[0] == 'b';
    const Image image = Random(50, 40, 3, floats ? SampleType::kF32 : SampleType::kU8);
    const WriteOptions options{.jpeg_quality = 95, .metadata = {{"burin:inputs", "0123abcd"}}};
    ASSERT_TRUE(module_->Write(folder_.File(name), image, options).has_value()) << name;
    const auto first = test::ReadAllBytes(folder_.File(name));
    // Over a second later, so that a clock time would differ.
    usleep(1'100'000);
    ASSERT_TRUE(module_->Write(folder_.File(name), image, options).has_value()) << name;
    EXPECT_TRUE(test::ReadAllBytes(folder_.File(name)) == first) << name;
    const std::string_view text(reinterpret_cast<const char*>(first.data()), first.size());
    for (const char* word : {"DateTime", "capDate", "Software", "OpenImageIO", "ImageHistory"}) {
      EXPECT_EQ(text.find(word), std::string_view::npos) << name << ": " << word;
    }
    const bool has_place = std::string_view(name) != "b.hdr";
    EXPECT_EQ(text.find("0123abcd") != std::string_view::npos, has_place) << name;
  }
}

TEST_F(ImageFiles, UnwritableFolderIsAnErrorAndLeavesNothing) {
  const Image image = Random(4, 4, 3, SampleType::kU8);
  const Result<void> written = module_->Write("/no/such/a.png", image, {});
  ASSERT_FALSE(written.has_value());
  EXPECT_EQ(written.error().kind, ErrorKind::kFailed);
  EXPECT_EQ(written.error().message, "cannot write '/no/such/a.png': the folder '/no/such' does not exist");
}

// A limit on file sizes stands for a full disk. In a child process: limits can't be raised again.
TEST_F(ImageFiles, FullDiskIsAnErrorAndLeavesNothing) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");  // OpenImageIO's threads don't live through a fork
  for (const char* name : {"a.png", "a.tif", "a.jpg", "b.exr", "b.hdr"}) {
    const Image image = Random(256, 256, 3, name[0] == 'b' ? SampleType::kF32 : SampleType::kU8);
    const std::string path = folder_.File(name);
    const auto write_with_limit = [&] {
      signal(SIGXFSZ, SIG_IGN);
      const rlimit limit{4096, 4096};
      setrlimit(RLIMIT_FSIZE, &limit);
      const Result<void> written = module_->Write(path, image, {});
      const bool refused = !written && written.error().message == "cannot write '" + path + "': File too large";
      const bool nothing_left = folder_.Names().empty();
      std::filesystem::remove_all(folder_.path());  // the child's own
      _exit(refused && nothing_left ? 0 : 1);
    };
    EXPECT_EXIT(write_with_limit(), testing::ExitedWithCode(0), "") << name;
  }
}

TEST_F(ImageFiles, RefusesWhatTheFormatLacks) {
  EXPECT_EQ(module_->Write(folder_.File("a.png"), Random(2, 2, 3, SampleType::kF32), {}).error().kind,
            ErrorKind::kUsage);
  EXPECT_EQ(module_->CanWrite("a.exr", SampleType::kU8, 3).error().kind, ErrorKind::kUsage);
  EXPECT_THAT(folder_.Names(), IsEmpty());
}

TEST_F(ImageFiles, RefusesPixelsThatDoNotMakeThePicture) {
  Image image = Random(4, 4, 3, SampleType::kU8);
  image.pixels.pop_back();
  EXPECT_EQ(module_->Write(folder_.File("a.png"), image, {}).error().message,
            "cannot write '" + folder_.File("a.png") + "': 47 bytes of pixels do not make a 4x4 picture");
}

TEST_F(ImageFiles, MemoryGivesWhatTheFileGives) {
  for (const char* name : {"a.png", "a.jpg", "a.tif", "b.exr", "b.hdr"}) {
    const Image image = Random(33, 17, 3, name[0] == 'b' ? SampleType::kF32 : SampleType::kU8);
    const Image from_file = RoundTrip(name, image);
    const auto from_memory = module_->ReadMemory(test::ReadAllBytes(folder_.File(name)), "embedded image 3");
    ASSERT_TRUE(from_memory.has_value()) << from_memory.error().message;
    ExpectSame(*from_memory, from_file, name);
  }
}

TEST_F(ImageFiles, MemoryErrorsCarryTheGivenName) {
  const std::vector<std::byte> garbage(100, std::byte{7});
  EXPECT_EQ(module_->ReadMemory(garbage, "scene.glb: image 3").error().message,
            "cannot read 'scene.glb: image 3': it is no PNG, JPEG, TIFF, EXR, HDR or WebP data");
  EXPECT_FALSE(module_->ReadMemory({}, "nothing").has_value());
}

TEST_F(ImageFiles, TruncatedFilesAreErrorsAtAnyLength) {
  for (const char* name : {"a.png", "a.jpg", "a.tif", "b.exr", "b.hdr"}) {
    const Image image = Random(40, 30, 3, name[0] == 'b' ? SampleType::kF32 : SampleType::kU8);
    ASSERT_TRUE(module_->Write(folder_.File(name), image, {}).has_value());
    const auto whole = test::ReadAllBytes(folder_.File(name));
    // An HDR file's and a JPEG file's last bytes may go unmissed by a few, no picture is lost with them.
    for (const double part : {0.0, 0.01, 0.2, 0.5, 0.9, 0.99}) {
      const std::size_t size = static_cast<std::size_t>(static_cast<double>(whole.size()) * part);
      test::WriteAllBytes(folder_.File(name), std::span(whole).first(size));
      EXPECT_THAT(ReadError(folder_.File(name)), HasSubstr("cannot read '" + folder_.File(name) + "': ")) << part;
    }
  }
}

TEST_F(ImageFiles, NamesWhatIsNoFile) {
  EXPECT_EQ(ReadError(folder_.File("none.png")),
            "cannot read '" + folder_.File("none.png") + "': No such file or directory");
  EXPECT_EQ(ReadError(folder_.path()), "cannot read '" + folder_.path() + "': it is a folder");
  EXPECT_EQ(ReadError("/dev/null"), "cannot read '/dev/null': it is not a regular file");
  test::WriteText(folder_.File("a.txt"), "text");
  EXPECT_EQ(ReadError(folder_.File("a.txt")),
            "cannot read '" + folder_.File("a.txt") + "': it is in no image format that is known");
}

TEST_F(ImageFiles, ContentDecidesNotTheExtension) {
  const Image image = Random(8, 8, 3, SampleType::kU8);
  ASSERT_TRUE(module_->Write(folder_.File("a.png"), image, {}).has_value());
  std::filesystem::rename(folder_.File("a.png"), folder_.File("a.jpg"));
  const auto read = module_->Read(folder_.File("a.jpg"));
  ASSERT_TRUE(read.has_value()) << read.error().message;
  ExpectSame(*read, image, "png named jpg");
}

class TiffFiles : public ImageFiles {
 protected:
  Result<Image> ReadTiff(const test::TinyTiff& tiff, const std::vector<std::byte>& pixels) {
    return module_->ReadMemory(test::MakeTiff(tiff, pixels), "a.tif");
  }
  static std::vector<std::byte> Bytes(std::initializer_list<int> values) {
    std::vector<std::byte> bytes;
    for (const int value : values) bytes.push_back(static_cast<std::byte>(value));
    return bytes;
  }
  static std::vector<int> Samples(const Image& image) {
    std::vector<int> samples;
    for (const std::uint8_t v : image.As<std::uint8_t>()) samples.push_back(v);
    return samples;
  }
};

TEST_F(TiffFiles, OrientationIsHonoured) {
  const auto image =
      ReadTiff({.width = 2, .height = 3, .photometric = 1, .channels = 1, .orientation = 6}, Bytes({3, 6, 2, 5, 1, 4}));
  ASSERT_TRUE(image.has_value()) << image.error().message;
  EXPECT_EQ(image->width, 3);
  EXPECT_EQ(image->height, 2);
  EXPECT_THAT(Samples(*image), ElementsAre(1, 2, 3, 4, 5, 6));
}

TEST_F(TiffFiles, IntegerAlphaIsUnassociated) {
  const auto unassociated = ReadTiff({.channels = 4, .extra_samples = 2}, Bytes({200, 100, 50, 51}));
  ASSERT_TRUE(unassociated.has_value()) << unassociated.error().message;
  EXPECT_THAT(Samples(*unassociated), ElementsAre(200, 100, 50, 51));
  const auto associated = ReadTiff({.channels = 4, .extra_samples = 1}, Bytes({40, 20, 10, 51}));
  ASSERT_TRUE(associated.has_value()) << associated.error().message;
  EXPECT_THAT(Samples(*associated), ElementsAre(200, 100, 50, 51));
}

TEST_F(TiffFiles, FloatAlphaIsAssociated) {
  const std::vector<float> rgba{1.0F, 0.5F, 0.25F, 0.5F};
  const auto bytes = std::as_bytes(std::span(rgba));
  const std::vector<std::byte> pixels(bytes.begin(), bytes.end());
  for (const int extra : {1, 2}) {
    const auto image = ReadTiff({.channels = 4, .bits = 32, .sample_format = 3, .extra_samples = extra}, pixels);
    ASSERT_TRUE(image.has_value()) << image.error().message;
    EXPECT_EQ(image->encoding, Encoding::kSceneLinear);
    const float scale = extra == 2 ? 0.5F : 1.0F;
    EXPECT_THAT(std::vector<float>(image->As<float>().begin(), image->As<float>().end()),
                ElementsAre(1.0F * scale, 0.5F * scale, 0.25F * scale, 0.5F));
  }
}

TEST_F(TiffFiles, OtherColourModelsAreRefused) {
  EXPECT_EQ(ReadTiff({.photometric = 5, .channels = 4}, Bytes({1, 2, 3, 4})).error().message,
            "cannot read 'a.tif': its colours are CMYK; convert it to RGB or grey first");
  EXPECT_EQ(ReadTiff({.photometric = 8, .channels = 3}, Bytes({1, 2, 3})).error().message,
            "cannot read 'a.tif': its colours are CIE L*a*b*; convert it to RGB or grey first");
}

TEST_F(TiffFiles, SignedSamplesAreRefused) {
  EXPECT_EQ(ReadTiff({.photometric = 1, .channels = 1, .sample_format = 2}, Bytes({1})).error().message,
            "cannot read 'a.tif': its samples are int8; 8- and 16-bit unsigned, half and float are read");
}

TEST_F(TiffFiles, ClaimsOfHugeSizesAreRefused) {
  EXPECT_THAT(ReadTiff({.width = 16000, .height = 16000}, Bytes({1, 2, 3})).error().message,
              HasSubstr("it claims 16000x16000 pixels in a file of "));
  EXPECT_THAT(ReadTiff({.width = 100000, .height = 100000}, Bytes({1, 2, 3})).error().message,
              HasSubstr("its size 100000x100000 is outside 1x1 to 268435456 pixels"));
}

TEST_F(ImageFiles, SharedPicturesAreRead) {
  struct Case {
    const char* name;
    int width, height, channels;
    SampleType type;
  };
  for (const Case& c : {Case{"images/astronaut.png", 512, 512, 3, SampleType::kU8},
                        Case{"images/chelsea.png", 451, 300, 3, SampleType::kU8},
                        Case{"images/tahoe-small.tif", 512, 384, 3, SampleType::kU8},
                        Case{"images/grid-small.exr", 256, 256, 4, SampleType::kF16},
                        Case{"images/with_nans.tif", 256, 256, 3, SampleType::kF32},
                        Case{"hdr/spiaggia_di_mondello_1k.hdr", 1024, 512, 3, SampleType::kF32}}) {
    const std::string path = test::SharedData(c.name);
    if (path.empty()) GTEST_SKIP() << "no shared data";
    const auto image = module_->Read(path);
    ASSERT_TRUE(image.has_value()) << image.error().message;
    EXPECT_EQ(image->width, c.width) << c.name;
    EXPECT_EQ(image->height, c.height) << c.name;
    EXPECT_EQ(image->channels, c.channels) << c.name;
    EXPECT_EQ(image->type, c.type) << c.name;
  }
}

}  // namespace
}  // namespace burin::image
