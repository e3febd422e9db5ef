// SPDX-License-Identifier: Apache-2.0
// Effects of our own that are dense with what people's files do: each checks without an error, and every pass that can
// run has GLSL that glslang takes.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "tests/unit/fx_parser/compile_effect.h"

namespace burin::fx {
namespace {

/// Of these, the techniques that cannot run; of all others, every one runs.
const std::map<std::string, std::vector<std::string>> kUnsupported = {
    {"asm_in_functions.fx", {"a"}},
    {"interfaces.cgfx", {"a"}},
    {"control_objects.fx", {"E"}},
};

TEST(Corners, FilesCheckAndGiveValidGlsl) {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(test::DataFile("corners"))) {
    if (entry.path().extension() != ".fxh") paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  EXPECT_GE(paths.size(), 19u);
  for (const std::filesystem::path& path : paths) {
    const CompileResult result = CompileEffect(path.string(), DiskFileSystem(), {});
    ASSERT_TRUE(result.effect) << path << "\n" << test::Messages(result);
    std::vector<std::string> unsupported;
    std::vector<const ShaderProgram*> programs;
    for (const Technique& technique : result.effect->techniques) {
      if (!technique.unsupported.empty()) {
        unsupported.push_back(technique.name);
        continue;
      }
      for (const Pass& pass : technique.passes) programs.push_back(&pass.program);
    }
    if (test::HasGlslang()) EXPECT_EQ(test::GlslLogOfAll(programs), "") << path;
    const auto known = kUnsupported.find(path.filename().string());
    EXPECT_EQ(unsupported, known == kUnsupported.end() ? std::vector<std::string>() : known->second) << path;
  }
}

}  // namespace
}  // namespace burin::fx
