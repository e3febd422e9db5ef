// SPDX-License-Identifier: Apache-2.0
// Damaged .obj, .mtl and .bpt files: read, or refused with a message that names the file; never a crash.
#include <gtest/gtest.h>

#include <random>

#include "core/scene/item_tessellator.h"
#include "core/scene/read_scene.h"
#include "tests/unit/scene/scene_fixture.h"

namespace burin::scene {
namespace {

constexpr const char* kObj =
    "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0.5\nv 0 1 0\nv 2 0 0\nv 2 1 1\nvt 0 0\nvt 1 1\nvn 0 0 1\n"
    "o a\nusemtl x\nf 1 2 3 4\nf 2 5 6 3\no b\ns 1\nf 1/1/1 2/2/1 3/1/1\nf 1 2 5 6 3\nl 1 2 3\np 4\nt crease 2/1/0 0 1 "
    "3\n";
constexpr const char* kMtl = "newmtl x\nKd 0.5 0.2 0.1\nNs 20\nd 0.5\nmap_Kd -s 1 1 1 none.png\nKe 1 0 0\nillum 2\n";
constexpr const char* kBpt =
    "4\n2 1\n0 0 0\n0 1 0\n0.5 0 1\n0.5 1 1\n1 0 0\n1 1 0\n1 1\n1 0 0\n1 1 0\n2 0 0\n2 1 0\n"
    "rational 2 1\n1 0 0 1 1 0 2 1\n1 1 0 0.7 1 1 2 0.7\n0 1 0 1 0 1 2 1\ntexcoords 1 1\n0 0 0 1 1 0 1 1\n"
    "triangle 1 0 0 0 0 1 0 1 0 0\nnormals 0 0 0 1\ncolors 1 1 0 0 1 0 1 0 1 0 0 1 1\n";

std::string Damage(std::string text, std::mt19937& random) {
  static const char* const kPieces[] = {"-1",   "0",  "99999999999", "nan", "1e39", "/", "//",
                                        "\\\n", "\n", " ",           "f",   "#",    "-"};
  const int changes = 1 + static_cast<int>(random() % 4);
  for (int i = 0; i < changes && !text.empty(); ++i) {
    const std::size_t at = random() % text.size();
    switch (random() % 4) {
      case 0:
        text[at] = static_cast<char>(random());
        break;
      case 1:
        text.erase(at, 1 + random() % 12);
        break;
      case 2:
        text.insert(at, kPieces[random() % std::size(kPieces)]);
        break;
      default:
        text.resize(at);
        break;
    }
  }
  return text;
}

TEST(TextSceneMutation, DamagedFilesAreReadOrRefused) {
  constexpr std::uint32_t kSeed = 20260;
  std::mt19937 random(kSeed);
  const TempFolder folder;
  int read = 0, refused = 0;
  for (int i = 0; i < 900; ++i) {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", case " + std::to_string(i));
    const bool is_bpt = i % 3 == 0;
    folder.Write("m.mtl", i % 4 == 1 ? Damage(kMtl, random) : kMtl);
    const std::string path = folder.Write(is_bpt ? "m.bpt" : "m.obj", Damage(is_bpt ? kBpt : kObj, random));
    const Result<Scene> scene = ReadScene(path, {});
    if (!scene) {
      ++refused;
      EXPECT_EQ(scene.error().kind, ErrorKind::kInput);
      EXPECT_NE(scene.error().message.find("m."), std::string::npos) << scene.error().message;
      continue;
    }
    ++read;
    const Pose pose = EvaluatePose(*scene, {}, 0.0);
    std::vector<DrawItem> items = BuildDrawItems(*scene, pose, pose);
    ItemTessellator tessellator(*scene, {.mode = TessellationMode::kFractional, .edge_length_px = {}, .factor = {}});
    (void)tessellator.TessellateEvenly(2.0f, items);
  }
  EXPECT_GT(read, 50);
  EXPECT_GT(refused, 200);
}

}  // namespace
}  // namespace burin::scene
