// SPDX-License-Identifier: Apache-2.0
// Files that were good until a seeded random change: reading and posing them must end, without a fault that the
// sanitizers see, in a scene or in an error that names the file. (Run under .ci/run's sanitizers; here a crash or a
// hang is the failure.)

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

#include "core/scene/camera.h"
#include "core/scene/describe.h"
#include "core/scene/gltf_reader.h"
#include "core/scene/pose.h"

namespace burin::scene {
namespace {

constexpr std::uint32_t kSeed = 20240607;
constexpr int kRounds = 400;

std::string SourceDir() {
  const char* folder = std::getenv("BURIN_SOURCE_DIR");
  return folder != nullptr ? folder : ".";
}

std::string ReadAll(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file) << path;
  return {std::istreambuf_iterator<char>(file), {}};
}

class Mutation : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (std::filesystem::temp_directory_path() / "burin_mutation_XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
    RecordProperty("seed", static_cast<int>(kSeed));
    std::printf("seed %u\n", kSeed);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::size_t Below(std::size_t limit) { return std::uniform_int_distribution<std::size_t>(0, limit - 1)(random_); }

  /// Reads `bytes` as a file and does with it what a render does before GL. True when it could be read.
  bool Try(const std::string& name, const std::string& bytes) {
    const std::string path = folder_ + "/" + name;
    std::ofstream(path, std::ios::binary) << bytes;
    const auto scene = ReadGltf(path, {});
    if (!scene) {
      EXPECT_EQ(scene.error().kind, ErrorKind::kInput);
      EXPECT_TRUE(scene.error().message.starts_with(path + ": ")) << scene.error().message;
      return false;
    }
    const AnimationSelection selection = SelectAnimations(*scene, "all").value();
    const Pose pose = EvaluatePose(*scene, selection, 0.7);
    const std::vector<DrawItem> items = BuildDrawItems(*scene, pose, EvaluatePose(*scene, selection, 0.6));
    for (const DrawItem& item : items) {
      const Primitive& p =
          scene->meshes[static_cast<std::size_t>(item.mesh)].primitives[static_cast<std::size_t>(item.primitive)];
      for (const std::uint32_t index : p.indices) EXPECT_LT(index, p.positions.size());
      EXPECT_TRUE(p.normals.empty() || p.normals.size() == p.positions.size());
      EXPECT_TRUE(!item.is_deformed || item.deformed.previous_positions.size() == p.positions.size());
    }
    const CameraChoice choice{SelectCamera(*scene, "").value(), ComputeBounds(*scene, items), {}};
    static_cast<void>(MakeView(*scene, choice, pose, 64, 64, 10.0));
    EXPECT_FALSE(DescribeScene(*scene, true).empty());
    return true;
  }

  std::mt19937 random_{kSeed};
  std::string folder_;
};

TEST_F(Mutation, OfBytes) {
  int refused = 0;
  for (const char* name : {"rig.glb", "modes.glb"}) {
    const std::string good = ReadAll(SourceDir() + "/tests/data/scene/" + name);
    for (int round = 0; round < kRounds; ++round) {
      std::string bytes = good;
      for (std::size_t n = 1 + Below(4); n > 0; --n) bytes[Below(bytes.size())] = static_cast<char>(Below(256));
      if (round % 8 == 0) bytes.resize(Below(bytes.size()));
      refused += Try("m.glb", bytes) ? 0 : 1;
    }
  }
  EXPECT_GT(refused, kRounds / 2) << "the changes do reach something";
}

/// Replaces one number of a JSON text by one that is likely to hurt.
std::string WithOtherNumber(const std::string& text, std::size_t pick, std::size_t value) {
  static const std::string kNumbers[] = {"-1",
                                         "0",
                                         "1",
                                         "2",
                                         "3",
                                         "7",
                                         "255",
                                         "65535",
                                         "65536",
                                         "1.5",
                                         "1e30",
                                         "1e-30",
                                         "-0",
                                         "2147483647",
                                         "1e99",
                                         "-1e30",
                                         "2147483648",
                                         "4294967295",
                                         "5121",
                                         "5123",
                                         "5125",
                                         "5126",
                                         "9007199254740991",
                                         "18446744073709551615",
                                         "16777216"};
  std::vector<std::pair<std::size_t, std::size_t>> numbers;
  for (std::size_t i = 1; i < text.size(); ++i) {
    const bool starts =
        (std::isdigit(static_cast<unsigned char>(text[i])) != 0 || text[i] == '-') &&
        (text[i - 1] == ':' || text[i - 1] == ' ' || text[i - 1] == '[' || text[i - 1] == ',' || text[i - 1] == '\n');
    if (!starts) continue;
    const std::size_t end = text.find_first_not_of("0123456789.+-eE", i);
    numbers.emplace_back(i, end - i);
    i = end;
  }
  const auto [at, length] = numbers[pick % numbers.size()];
  return std::string(text).replace(at, length, kNumbers[value % std::size(kNumbers)]);
}

TEST_F(Mutation, OfJsonNumbers) {
  const std::string folder = SourceDir() + "/tests/data/scene/";
  std::filesystem::copy_file(folder + "every thing.bin", folder_ + "/every thing.bin");
  const std::string good = ReadAll(folder + "everything.gltf");
  ASSERT_TRUE(Try("e.gltf", good));
  int refused = 0;
  for (int round = 0; round < kRounds; ++round) {
    std::string text = WithOtherNumber(good, Below(100'000), Below(100'000));
    if (round % 3 == 0) text = WithOtherNumber(text, Below(100'000), Below(100'000));
    refused += Try("e.gltf", text) ? 0 : 1;
  }
  EXPECT_GT(refused, kRounds / 4);
}

TEST_F(Mutation, OfJsonNumbersInTheRig) {
  const std::string glb = ReadAll(SourceDir() + "/tests/data/scene/rig.glb");
  std::uint32_t length = 0;
  std::memcpy(&length, glb.data() + 12, 4);
  const std::string json = glb.substr(20, length);
  const std::string bin = glb.substr(20 + length + 8);
  const std::string good =
      std::string(json).replace(json.find("\"buffers\":[{"), 12, "\"buffers\":[{\"uri\":\"rig.bin\",");
  std::ofstream(folder_ + "/rig.bin", std::ios::binary) << bin;
  ASSERT_TRUE(Try("r.gltf", good));
  for (int round = 0; round < 2 * kRounds; ++round)
    Try("r.gltf", WithOtherNumber(good, Below(100'000), Below(100'000)));
}

TEST_F(Mutation, OfStructure) {
  const std::string good = ReadAll(SourceDir() + "/tests/data/scene/everything.gltf");
  std::filesystem::copy_file(SourceDir() + "/tests/data/scene/every thing.bin", folder_ + "/every thing.bin");
  static const std::string kPieces[] = {"{}", "[]", "null", "true", "\"x\"", ",",    "}",   "]",
                                        "{",  "[",  ":",    "\"",   "\\",    "[[[[", "\xff"};
  for (int round = 0; round < kRounds; ++round) {
    std::string text = good;
    const std::size_t at = Below(text.size());
    text.replace(at, Below(12), kPieces[Below(std::size(kPieces))]);
    Try("s.gltf", text);
  }
}

}  // namespace
}  // namespace burin::scene
