// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <vector>

#include "core/image/image_module.h"
#include "tests/unit/base/temporary_folder.h"

namespace burin::image {
namespace {

using testing::HasSubstr;

class Color : public testing::Test {
 protected:
  void SetUp() override {
    const auto module = LoadImageModule();
    ASSERT_TRUE(module.has_value()) << module.error().message;
    module_ = *module;
    const char* source = std::getenv("BURIN_SOURCE_DIR");
    ASSERT_NE(source, nullptr) << "the tests need BURIN_SOURCE_DIR";
    config_ = std::string(source) + "/tests/data/ocio/gamma22.ocio";
  }

  Error Refusal(const ColorOptions& options) const {
    const auto transform = module_->MakeColorTransform(options);
    return transform ? Error{} : transform.error();
  }

  ImageModule* module_ = nullptr;
  std::string config_;
};

TEST_F(Color, BuiltInIsSrgb) {
  const auto transform = module_->MakeColorTransform({});
  ASSERT_TRUE(transform.has_value());
  EXPECT_TRUE((*transform)->is_srgb());
}

TEST_F(Color, ConfigurationGivesItsDefaultDisplayAndView) {
  const auto transform = module_->MakeColorTransform({config_, "", ""});
  ASSERT_TRUE(transform.has_value()) << transform.error().message;
  EXPECT_FALSE((*transform)->is_srgb());
  std::vector<float> pixel{0.18F, 0.5F, 1.0F, 0.25F};
  (*transform)->SceneToDisplay(pixel);
  EXPECT_NEAR(pixel[0], std::pow(0.18, 1.0 / 2.2), 1e-5);
  EXPECT_NEAR(pixel[1], std::pow(0.5, 1.0 / 2.2), 1e-5);
  EXPECT_NEAR(pixel[2], 1.0, 1e-5);
  EXPECT_EQ(pixel[3], 0.25F);
  (*transform)->DisplayToScene(pixel);
  EXPECT_NEAR(pixel[0], 0.18, 1e-5);
  EXPECT_NEAR(pixel[1], 0.5, 1e-5);
  EXPECT_EQ(pixel[3], 0.25F);
}

TEST_F(Color, AlphaIsKeptFromAMatrixAndOverManyPixels) {
  const auto transform = module_->MakeColorTransform({config_, "monitor", "half gamma"});
  ASSERT_TRUE(transform.has_value()) << transform.error().message;
  std::vector<float> pixels;
  for (int i = 0; i < 3000; ++i) pixels.insert(pixels.end(), {1.0F, 1.0F, 1.0F, static_cast<float>(i)});
  (*transform)->SceneToDisplay(pixels);
  for (int i = 0; i < 3000; ++i) {
    const std::size_t at = static_cast<std::size_t>(i) * 4;
    ASSERT_NEAR(pixels[at], std::pow(0.5, 1.0 / 2.2), 1e-5) << i;
    ASSERT_EQ(pixels[at + 3], static_cast<float>(i));
  }
}

TEST_F(Color, NamesTheDisplaysAndViewsThatThereAre) {
  const std::string where = "the OpenColorIO configuration '" + config_ + "'";
  EXPECT_EQ(Refusal({config_, "TV", ""}).message, where + " has no display 'TV'; it has: Monitor, Projector");
  EXPECT_EQ(Refusal({config_, "", "Film"}).message,
            "display 'Monitor' of " + where + " has no view 'Film'; it has: Gamma, Half Gamma");
  EXPECT_EQ(Refusal({config_, "TV", ""}).kind, ErrorKind::kUsage);
}

TEST_F(Color, DisplayWithoutConfigurationIsRefused) {
  EXPECT_EQ(Refusal({"", "TV", ""}).message, "display 'TV' needs an OpenColorIO configuration (--ocio or $OCIO)");
  EXPECT_EQ(Refusal({"", "", "Film"}).message, "view 'Film' needs an OpenColorIO configuration (--ocio or $OCIO)");
}

TEST_F(Color, MissingAndBrokenConfigurationsAreRefused) {
  EXPECT_THAT(Refusal({"/no/such.ocio", "", ""}).message,
              HasSubstr("cannot read the OpenColorIO configuration '/no/such.ocio': "));
  EXPECT_EQ(Refusal({"/no/such.ocio", "", ""}).kind, ErrorKind::kInput);
  const test::TemporaryFolder folder;
  test::WriteText(folder.File("a.ocio"), "ocio_profile_version: 2\nroles: [");
  EXPECT_THAT(Refusal({folder.File("a.ocio"), "", ""}).message, HasSubstr("cannot read the OpenColorIO configuration"));
  test::WriteText(folder.File("b.ocio"), "garbage");
  EXPECT_EQ(Refusal({folder.File("b.ocio"), "", ""}).kind, ErrorKind::kInput);
}

TEST_F(Color, BuiltInConfigurationsNeedANewerLibrary) {
  if (module_->Versions().find("OpenColorIO 2.1") == std::string::npos) GTEST_SKIP() << module_->Versions();
  EXPECT_THAT(Refusal({"ocio://default", "", ""}).message,
              HasSubstr("configurations built into the library come with OpenColorIO 2.2, this is 2.1"));
}

// Values measured with ociochecklut of OpenColorIO 2.1.2 on the ACES CG configuration.
TEST_F(Color, AcesConfigurationGivesItsGoldenNumbers) {
  const std::string config = test::SharedData("ocio/cg-config-v1.0.0_aces-v1.3_ocio-v2.1.ocio");
  if (config.empty()) GTEST_SKIP() << "no shared data";
  const auto sdr = module_->MakeColorTransform({config, "sRGB - Display", "ACES 1.0 - SDR Video"});
  ASSERT_TRUE(sdr.has_value()) << sdr.error().message;
  constexpr float kSixDigits = 2e-6F;  // the golden numbers have six digits
  std::vector<float> pixel{0.18F, 0.18F, 0.18F, 1.0F};
  (*sdr)->SceneToDisplay(pixel);
  EXPECT_NEAR(pixel[0], 0.355954F, kSixDigits);
  constexpr float kInverseLut = 1e-3F;  // the inverse of the tone curve is interpolated
  (*sdr)->DisplayToScene(pixel);
  EXPECT_NEAR(pixel[0], 0.18F, kInverseLut);
}

TEST_F(Color, SharedMinimalConfigurationIsSrgb) {
  const std::string config = test::SharedData("ocio/minimal_srgb.ocio");
  if (config.empty()) GTEST_SKIP() << "no shared data";
  const auto transform = module_->MakeColorTransform({config, "", ""});
  ASSERT_TRUE(transform.has_value()) << transform.error().message;
  std::vector<float> pixel{0.18F, 0.5F, 0.001F, 1.0F};
  (*transform)->SceneToDisplay(pixel);
  EXPECT_NEAR(pixel[0], 0.461356F, 2e-5F);
  EXPECT_NEAR(pixel[1], 0.735357F, 2e-5F);
}

}  // namespace
}  // namespace burin::image
