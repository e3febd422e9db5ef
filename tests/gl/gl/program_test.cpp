// SPDX-License-Identifier: Apache-2.0
#include "core/gl/program.h"

#include <epoxy/gl.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "core/gl/framebuffer.h"
#include "core/gl/fullscreen_quad.h"
#include "core/gl/readback.h"
#include "core/gl/state.h"
#include "tests/gl/gl/context_fixture.h"

namespace burin::gl {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr const char* kVertex = R"(#version 450 core
layout(location = 0) in vec4 position;
void main() { gl_Position = position; })";
constexpr const char* kFragment = R"(#version 450 core
uniform float value;
layout(location = 0) out vec4 result;
void main() { result = vec4(value); })";

class ProgramTest : public ContextTest {
 protected:
  ProgramTest() {
    folder_ = testing::TempDir() + "burin_programs_" + std::to_string(getpid());
    fs::remove_all(folder_);
    setenv("XDG_CACHE_HOME", folder_.c_str(), 1);
    unsetenv("BURIN_NO_CACHE");
  }
  ~ProgramTest() override {
    setenv("BURIN_NO_CACHE", "1", 1);
    fs::remove_all(folder_);
  }

  static float Run(const Program& program, float value) {
    const Texture target = Must(Texture::Create(PlainFormat(Numeric::kFloat, 32, 1), 1, 1, 1, "target"));
    const Texture* color = &target;
    const Framebuffer framebuffer = Must(Framebuffer::Create(std::span(&color, 1), nullptr, "test"));
    const FullscreenQuad quad = Must(FullscreenQuad::Create());
    ResetState();
    framebuffer.Bind();
    glUseProgram(program.id());
    glUniform1f(program.UniformLocation("value"), value);
    quad.Draw();
    return Read(target, image::SampleType::kF32, 1, image::Encoding::kData).As<float>()[0];
  }

  std::vector<fs::path> Entries() const {
    std::vector<fs::path> paths;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder_ + "/burin/programs", error)) paths.push_back(entry.path());
    return paths;
  }

  static bool CacheWorks() {
    GLint formats = 0;
    glGetIntegerv(GL_NUM_PROGRAM_BINARY_FORMATS, &formats);
    return formats > 0;
  }

  std::string folder_;
};

TEST_F(ProgramTest, UniformsAreFoundByName) {
  const Program program = Must(Program::Create(kVertex, kFragment, "test"));
  EXPECT_GE(program.UniformLocation("value"), 0);
  EXPECT_EQ(program.UniformLocation("nothing"), -1);
  EXPECT_FLOAT_EQ(Run(program, 2.5f), 2.5f);
}

TEST_F(ProgramTest, ASecondRunReadsTheCache) {
  if (!CacheWorks()) GTEST_SKIP() << "this driver has no program binaries";
  EXPECT_FLOAT_EQ(Run(Must(Program::Create(kVertex, kFragment, "test")), 1.0f), 1.0f);
  ASSERT_EQ(Entries().size(), 1u);
  const auto written = fs::last_write_time(Entries()[0]);
  EXPECT_FLOAT_EQ(Run(Must(Program::Create(kVertex, kFragment, "test")), 3.0f), 3.0f);
  EXPECT_EQ(fs::last_write_time(Entries()[0]), written);
  (void)Must(Program::Create(kVertex, std::string(kFragment) + "\n", "test"));
  EXPECT_EQ(Entries().size(), 2u);
}

TEST_F(ProgramTest, ADamagedEntryIsCompiledAnewAndReplaced) {
  if (!CacheWorks()) GTEST_SKIP() << "this driver has no program binaries";
  (void)Must(Program::Create(kVertex, kFragment, "test"));
  ASSERT_EQ(Entries().size(), 1u);
  const auto size = fs::file_size(Entries()[0]);
  fs::resize_file(Entries()[0], size / 2);
  EXPECT_FLOAT_EQ(Run(Must(Program::Create(kVertex, kFragment, "test")), 3.0f), 3.0f);
  EXPECT_EQ(fs::file_size(Entries()[0]), size);
  std::ofstream(Entries()[0], std::ios::trunc) << "rubbish";
  EXPECT_FLOAT_EQ(Run(Must(Program::Create(kVertex, kFragment, "test")), 4.0f), 4.0f);
  EXPECT_EQ(fs::file_size(Entries()[0]), size);
}

TEST_F(ProgramTest, BurinNoCacheTurnsItOff) {
  setenv("BURIN_NO_CACHE", "1", 1);
  (void)Must(Program::Create(kVertex, kFragment, "test"));
  EXPECT_FALSE(fs::exists(folder_));
}

TEST_F(ProgramTest, CompileErrorsShowTheLine) {
  const Result<Program> program =
      Program::Create(kVertex, "#version 450 core\nvoid main() {\n  nonsense = 1;\n}\n", "pass 'P0'");
  ASSERT_FALSE(program.has_value());
  EXPECT_EQ(program.error().kind, ErrorKind::kFailed);
  EXPECT_THAT(program.error().message, testing::StartsWith("pass 'P0': the driver refuses the fragment shader:\n"));
  EXPECT_THAT(program.error().message, HasSubstr("\n    3 |   nonsense = 1;"));
}

TEST_F(ProgramTest, LinkErrorsCarryTheLog) {
  const Result<Program> program = Program::Create(
      kVertex,
      "#version 450 core\nin vec3 missing;\nlayout(location = 0) out vec4 r;\nvoid main() { r = vec4(missing, 1); }",
      "P");
  ASSERT_FALSE(program.has_value());
  EXPECT_THAT(program.error().message, HasSubstr("P: the driver cannot link the program:\n"));
}

TEST_F(ProgramTest, AFragmentShaderMayBeMissing) {
  EXPECT_TRUE(static_cast<bool>(Must(Program::Create(kVertex, "", "depth only"))));
}

}  // namespace
}  // namespace burin::gl
