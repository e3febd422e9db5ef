// SPDX-License-Identifier: Apache-2.0
#include "tests/golden/render/golden_image.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "core/image/image_module.h"

namespace burin::golden {

bool update_golden = false;

namespace {

namespace fs = std::filesystem;

fs::path Folder(const char* variable) {
  const char* const value = std::getenv(variable);
  return value != nullptr ? value : ".";
}

struct Comparison {
  int max_difference = 0;
  double mean_difference = 0.0;
  image::Image difference;
};

Comparison Compare(const image::Image& picture, const image::Image& golden) {
  Comparison comparison;
  comparison.difference = picture;
  const auto a = picture.As<std::uint8_t>();
  const auto b = golden.As<std::uint8_t>();
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const int difference = std::abs(a[i] - b[i]);
    comparison.max_difference = std::max(comparison.max_difference, difference);
    sum += difference;
    const bool is_alpha = picture.channels == 4 && i % 4 == 3;
    comparison.difference.As<std::uint8_t>()[i] =
        static_cast<std::uint8_t>(is_alpha ? 255 : std::min(255, difference * 8));
  }
  comparison.mean_difference = a.empty() ? 0.0 : sum / static_cast<double>(a.size());
  return comparison;
}

}  // namespace

void ExpectGolden(const std::string& path, const std::string& name, const Tolerance& tolerance) {
  const fs::path golden_path = Folder("BURIN_SOURCE_DIR") / "tests" / "golden" / "images" / (name + ".png");
  if (update_golden) {
    fs::create_directories(golden_path.parent_path());
    fs::copy_file(path, golden_path, fs::copy_options::overwrite_existing);
    return;
  }
  auto module = image::LoadImageModule();
  ASSERT_TRUE(module) << module.error().message;
  const auto picture = (*module)->Read(path);
  ASSERT_TRUE(picture) << picture.error().message;
  const auto golden = (*module)->Read(golden_path.string());
  ASSERT_TRUE(golden) << golden.error().message << "; --update-golden makes it";
  ASSERT_EQ(picture->width, golden->width);
  ASSERT_EQ(picture->height, golden->height);
  ASSERT_EQ(picture->channels, golden->channels);
  ASSERT_EQ(picture->type, image::SampleType::kU8);

  const Comparison comparison = Compare(*picture, *golden);
  if (comparison.max_difference <= tolerance.max_difference &&
      comparison.mean_difference <= tolerance.mean_difference) {
    return;
  }
  const fs::path kept = Folder("BURIN_BINARY_DIR") / "golden";
  fs::create_directories(kept);
  fs::copy_file(path, kept / (name + ".png"), fs::copy_options::overwrite_existing);
  const std::string difference = (kept / (name + ".difference.png")).string();
  (void)(*module)->Write(difference, comparison.difference, {});
  ADD_FAILURE() << name << ": max difference " << comparison.max_difference << " (tolerance "
                << tolerance.max_difference << "), mean " << comparison.mean_difference << " (tolerance "
                << tolerance.mean_difference << "); the picture and the difference are in " << kept.string();
}

}  // namespace burin::golden
