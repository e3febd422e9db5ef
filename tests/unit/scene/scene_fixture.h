// SPDX-License-Identifier: Apache-2.0
#pragma once
// Small glTF files written by tests, and where the files of tests/data and of the shared collection are.

#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "core/scene/gltf_reader.h"

namespace burin::scene {

inline std::string Environment(const char* name, const std::string& otherwise) {
  const char* value = std::getenv(name);
  return value != nullptr ? value : otherwise;
}

inline std::string DataPath(const std::string& name) {
  return Environment("BURIN_SOURCE_DIR", ".") + "/tests/data/scene/" + name;
}

/// The shared collection of real files; empty where it is not there.
inline std::string SharedData() {
  const std::string path = Environment("BURIN_SHARED_DATA", Environment("BURIN_SOURCE_DIR", ".") + "/../shared/data");
  return std::filesystem::is_directory(path) ? path : std::string();
}

inline Scene ReadOrDie(const std::string& path, const ReadOptions& options = {}) {
  auto scene = ReadGltf(path, options);
  EXPECT_TRUE(scene.has_value()) << (scene ? "" : scene.error().message);
  return scene ? std::move(*scene) : Scene();
}

/// A folder of its own, removed at the end.
class TempFolder {
 public:
  TempFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "burin_scene_XXXXXX").string();
    path_ = ::mkdtemp(pattern.data());
  }
  ~TempFolder() { std::filesystem::remove_all(path_); }
  TempFolder(const TempFolder&) = delete;
  TempFolder& operator=(const TempFolder&) = delete;

  [[nodiscard]] std::string operator/(const std::string& name) const { return path_ + "/" + name; }

  std::string Write(const std::string& name, const std::string& bytes) const {
    const std::string path = path_ + "/" + name;
    std::filesystem::create_directories(std::filesystem::path(path).parent_path());
    std::ofstream(path, std::ios::binary) << bytes;
    return path;
  }

 private:
  std::string path_;
};

template <class T>
std::string BytesOf(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

/// A triangle with normals and indices, in 80 bytes of triangle.bin.
inline std::string TriangleBin() {
  return BytesOf<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}) + BytesOf<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}) +
         BytesOf<std::uint16_t>({0, 1, 2, 0});
}

inline std::string TriangleText() {
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0,"NORMAL":1},"indices":2}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},
{"bufferView":1,"componentType":5126,"count":3,"type":"VEC3"},
{"bufferView":2,"componentType":5123,"count":3,"type":"SCALAR"}],
"bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":36},
{"buffer":0,"byteOffset":72,"byteLength":6}],
"buffers":[{"byteLength":80,"uri":"triangle.bin"}]})";
}

using Edits = std::vector<std::pair<std::string, std::string>>;

/// Replaces the first place of each text; a text that is not there fails the test.
inline std::string Edited(std::string text, const Edits& edits) {
  for (const auto& [from, to] : edits) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << "no " << from;
    if (at != std::string::npos) text.replace(at, from.size(), to);
  }
  return text;
}

/// What ReadGltf says of the triangle after the edits, without the path; "read" when it says nothing.
inline std::string Refusal(const Edits& edits, const std::string& bin = TriangleBin()) {
  const TempFolder folder;
  folder.Write("triangle.bin", bin);
  const std::string path = folder.Write("t.gltf", Edited(TriangleText(), edits));
  const auto scene = ReadGltf(path, {});
  if (scene) return "read";
  EXPECT_EQ(scene.error().kind, ErrorKind::kInput);
  EXPECT_TRUE(scene.error().message.starts_with(path + ": ")) << scene.error().message;
  return scene.error().message.substr(path.size() + 2);
}

}  // namespace burin::scene
