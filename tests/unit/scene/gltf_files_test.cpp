// SPDX-License-Identifier: Apache-2.0
// Where a scene's bytes come from: .glb chunks, data URIs, files of its folder and nothing outside it.

#include <sys/stat.h>

#include "scene_fixture.h"

namespace burin::scene {
namespace {

namespace fs = std::filesystem;

std::string WithUri(const std::string& uri) {
  const TempFolder outside;
  outside.Write("triangle.bin", TriangleBin());
  return Refusal({{"triangle.bin", uri}});
}

TEST(SceneFolder, ReadsOnlyInsideTheFolder) {
  EXPECT_EQ(WithUri("../secret.bin"), R"(buffers[0]: "../secret.bin" leaves the scene's folder)");
  EXPECT_EQ(WithUri("a/../../secret.bin"), R"(buffers[0]: "a/../../secret.bin" leaves the scene's folder)");
  EXPECT_EQ(WithUri("%2e%2e%2fsecret.bin"), R"(buffers[0]: "%2e%2e%2fsecret.bin" leaves the scene's folder)");
  EXPECT_EQ(WithUri("..\\\\secret.bin"), R"(buffers[0]: "..\secret.bin" leaves the scene's folder)");
  EXPECT_EQ(WithUri("/etc/passwd"),
            R"(buffers[0]: "/etc/passwd" is an absolute path; only files in the scene's folder are read)");
  EXPECT_EQ(WithUri("%2Fetc/passwd"),
            R"(buffers[0]: "%2Fetc/passwd" is an absolute path; only files in the scene's folder are read)");
  EXPECT_EQ(WithUri("file:///etc/passwd"),
            R"(buffers[0]: "file:///etc/passwd" is a URL; only files in the scene's folder are read)");
  EXPECT_EQ(WithUri("https://example.org/a.bin"),
            R"(buffers[0]: "https://example.org/a.bin" is a URL; only files in the scene's folder are read)");
  EXPECT_EQ(WithUri("missing.bin"), R"(buffers[0]: "missing.bin" cannot be opened: No such file or directory)");
  EXPECT_EQ(WithUri("a%00b"), R"(buffers[0]: "a%00b" holds a NUL character)");
  EXPECT_EQ(WithUri("a%zz"), R"(buffers[0]: "a%zz" bad percent escape at "%zz")");
  EXPECT_EQ(WithUri("."), R"(buffers[0]: "." leaves the scene's folder)");
  EXPECT_EQ(WithUri("sub/../triangle.bin"), "read");
}

TEST(SceneFolder, FollowsNoLinkThatLeadsOut) {
  const TempFolder outside;
  outside.Write("triangle.bin", TriangleBin());
  const TempFolder folder;
  const std::string path = folder.Write("t.gltf", TriangleText());
  fs::create_symlink(outside / "triangle.bin", folder / "triangle.bin");
  auto scene = ReadGltf(path, {});
  ASSERT_FALSE(scene);
  EXPECT_EQ(scene.error().message, path + R"(: buffers[0]: "triangle.bin" leaves the scene's folder)");

  folder.Write("real.bin", TriangleBin());
  fs::remove(folder / "triangle.bin");
  fs::create_symlink("real.bin", folder / "triangle.bin");
  EXPECT_TRUE(ReadGltf(path, {}));
}

TEST(SceneFolder, ReadsRegularFilesOnly) {
  const TempFolder folder;
  const std::string path = folder.Write("t.gltf", TriangleText());
  fs::create_directory(folder / "triangle.bin");
  EXPECT_EQ(ReadGltf(path, {}).error().message, path + R"(: buffers[0]: "triangle.bin" is not a regular file)");
  fs::remove(folder / "triangle.bin");
  ASSERT_EQ(::mkfifo((folder / "triangle.bin").c_str(), 0600), 0);
  EXPECT_EQ(ReadGltf(path, {}).error().message, path + R"(: buffers[0]: "triangle.bin" is not a regular file)");
  EXPECT_EQ(ReadGltf(folder / "", {}).error().message, (folder / "") + ": is not a regular file");
  EXPECT_EQ(ReadGltf(folder / "none.glb", {}).error().message,
            (folder / "none.glb") + ": cannot be opened: No such file or directory");
}

TEST(DataUri, DecodesBase64OfAnyType) {
  // "AAAA" is three zero bytes: 80 zero bytes make a triangle without extent.
  const std::string zeros = std::string(107, 'A') + "=";
  EXPECT_EQ(WithUri("data:application/octet-stream;base64," + zeros), "read");
  EXPECT_EQ(WithUri("data:;base64," + std::string(107, 'A')), "read");
  EXPECT_EQ(WithUri("data:text/plain,hello"), R"(buffers[0]: data URI that is not base64)");
  EXPECT_EQ(WithUri("data:text/plain;base64"), R"(buffers[0]: data URI without a comma)");
  EXPECT_EQ(WithUri("data:;base64,AA*A"), R"(buffers[0]: bad base64 character at 2)");
  EXPECT_EQ(WithUri("data:;base64,AAAAA"), R"(buffers[0]: base64 of impossible length 5)");
  EXPECT_EQ(WithUri("data:;base64,AAAA"), R"(buffers[0]: byteLength is 80, but its data has 3 bytes)");
}

std::string U32(std::uint32_t value) { return BytesOf<std::uint32_t>({value}); }

std::string Glb(const std::string& json, const std::string& bin) {
  const std::string padded = json + std::string((4 - json.size() % 4) % 4, ' ');
  const std::string body = U32(static_cast<std::uint32_t>(padded.size())) + "JSON" + padded +
                           U32(static_cast<std::uint32_t>(bin.size())) + std::string("BIN\0", 4) + bin;
  return "glTF" + U32(2) + U32(static_cast<std::uint32_t>(12 + body.size())) + body;
}

std::string GlbMessage(const std::string& bytes) {
  const TempFolder folder;
  const std::string path = folder.Write("t.glb", bytes);
  const auto scene = ReadGltf(path, {});
  return scene ? "read" : scene.error().message.substr(path.size() + 2);
}

TEST(Glb, ReadsChunksAndRefusesTruncatedOnes) {
  const std::string json = Edited(TriangleText(), {{R"(,"uri":"triangle.bin")", ""}});
  const std::string whole = Glb(json, TriangleBin());
  EXPECT_EQ(GlbMessage(whole), "read");
  EXPECT_EQ(GlbMessage(whole + "trailing bytes"), "read");
  EXPECT_EQ(GlbMessage(whole.substr(0, 8)), "truncated: 8 bytes, a GLB header has 12");
  EXPECT_EQ(GlbMessage(whole.substr(0, whole.size() - 1)), "truncated: the GLB header says " +
                                                               std::to_string(whole.size()) + " bytes, the file has " +
                                                               std::to_string(whole.size() - 1));
  std::string other = whole;
  other[4] = 1;
  EXPECT_EQ(GlbMessage(other), "GLB version 1 is not supported, expected 2");
  other = whole;
  other.replace(12, 4, U32(0xfffffff0u));
  EXPECT_EQ(GlbMessage(other),
            "GLB chunk 0: 4294967280 bytes, but only " + std::to_string(whole.size() - 20) + " are left in the file");
  other = whole;
  other.replace(16, 4, "XXXX");
  EXPECT_EQ(GlbMessage(other), "GLB chunk 0: expected JSON");
  const std::string without_bin = "glTF" + U32(2) + U32(static_cast<std::uint32_t>(20 + json.size())) +
                                  U32(static_cast<std::uint32_t>(json.size())) + "JSON" + json;
  EXPECT_EQ(GlbMessage(without_bin), R"(buffers[0]: has no "uri", and the file holds no data for it)");
}

TEST(Glb, EveryTruncationIsRefused) {
  const std::string whole = Glb(Edited(TriangleText(), {{R"(,"uri":"triangle.bin")", ""}}), TriangleBin());
  for (std::size_t size = 0; size < whole.size(); size += 7)
    EXPECT_NE(GlbMessage(whole.substr(0, size)), "read") << size;
}

TEST(Images, AreDecodedOnceAndOnlyWhenAMaterialUsesThem) {
  std::vector<std::string> names;
  ReadOptions options;
  options.decode_image = [&](std::span<const std::byte> bytes, const std::string& name) -> Result<image::Image> {
    names.push_back(name);
    EXPECT_EQ(std::to_integer<int>(bytes[0]), 0x89);  // "used" and "bumps" are PNG; "unused" is not
    image::Image picture;
    picture.width = picture.height = 1;
    picture.channels = 3;
    picture.pixels.resize(3);
    return picture;
  };
  const Scene scene = ReadOrDie(DataPath("everything.gltf"), options);
  EXPECT_EQ(names, (std::vector<std::string>{R"(images[0] "used")", R"(images[1] "bumps")"}));
  ASSERT_EQ(scene.images.size(), 3u);
  EXPECT_EQ(scene.images[0].encoding, image::Encoding::kDisplay);
  EXPECT_EQ(scene.images[1].encoding, image::Encoding::kData);
  EXPECT_EQ(scene.images[2].width, 0);
}

TEST(Images, FaultsNameTheImage) {
  ReadOptions options;
  options.decode_image = [](std::span<const std::byte>, const std::string& name) -> Result<image::Image> {
    return Fail(ErrorKind::kInput, name + ": is no picture");
  };
  const std::string path = DataPath("everything.gltf");
  EXPECT_EQ(ReadGltf(path, options).error().message, path + R"(: images[0] "used": is no picture)");
}

TEST(Images, StayEmptyWithoutADecoder) {
  const Scene scene = ReadOrDie(DataPath("everything.gltf"));
  for (const image::Image& picture : scene.images) EXPECT_TRUE(picture.pixels.empty());
}

}  // namespace
}  // namespace burin::scene
