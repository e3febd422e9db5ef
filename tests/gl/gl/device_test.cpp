// SPDX-License-Identifier: Apache-2.0
#include <epoxy/gl.h>
#include <gmock/gmock.h>

#include <cstdlib>

#include "core/gl/context.h"

namespace burin::gl {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

Error FailureOf(const std::string& device) {
  ContextOptions options;
  options.device = device;
  const Result<std::unique_ptr<Context>> context = Context::Create(options);
  EXPECT_FALSE(context.has_value()) << device;
  return context ? Error{} : context.error();
}

TEST(Device, SoftwareRendersByGl45Core) {
  ContextOptions options;
  options.device = "software";
  const Result<std::unique_ptr<Context>> context = Context::Create(options);
  ASSERT_TRUE(context.has_value()) << context.error().message;
  EXPECT_TRUE((*context)->info().is_software);
  EXPECT_GE((*context)->info().max_draw_buffers, 8);
  EXPECT_GE((*context)->info().max_texture_size, 16384);
  GLint mask = 0;
  glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &mask);
  EXPECT_EQ(mask, GL_CONTEXT_CORE_PROFILE_BIT);
  GLint origin = 0;
  glGetIntegerv(GL_CLIP_ORIGIN, &origin);
  EXPECT_EQ(origin, GL_UPPER_LEFT);
}

TEST(Device, ARendererIsFoundByAPartOfItsName) {
  ContextOptions options;
  options.device = "LLVMpipe";
  const Result<std::unique_ptr<Context>> context = Context::Create(options);
  if (!context) GTEST_SKIP() << "no llvmpipe here: " << context.error().message;
  EXPECT_THAT((*context)->info().renderer, StartsWith("llvmpipe"));
}

TEST(Device, ASecondContextIsRefused) {
  const Result<std::unique_ptr<Context>> first = Context::Create({});
  ASSERT_TRUE(first.has_value()) << first.error().message;
  const Result<std::unique_ptr<Context>> second = Context::Create({});
  ASSERT_FALSE(second.has_value());
  EXPECT_EQ(second.error().message, "a GL context is open already; there is one a process");
}

TEST(Device, AContextCanFollowAnother) {
  for (int i = 0; i < 3; ++i) {
    const Result<std::unique_ptr<Context>> context = Context::Create({});
    ASSERT_TRUE(context.has_value()) << context.error().message;
  }
}

TEST(Device, AMissingNumberNamesWhatThereIs) {
  const Error error = FailureOf("63");
  EXPECT_EQ(error.kind, ErrorKind::kDevice);
  EXPECT_THAT(error.message, AllOf(StartsWith("--device 63: no such device"), HasSubstr("device 0")));
}

TEST(Device, AnUnknownNameSaysWhatWasTried) {
  const Error error = FailureOf("Voodoo Banshee");
  EXPECT_EQ(error.kind, ErrorKind::kDevice);
  EXPECT_THAT(error.message, AllOf(StartsWith("--device Voodoo Banshee: no usable GL device; tried:\n  device 0"),
                                   HasSubstr(": its renderer is '")));
}

TEST(Device, AMissingNodeIsNotTriedByRenderer) {
  const Error error = FailureOf("/dev/dri/renderD255");
  EXPECT_EQ(error.kind, ErrorKind::kDevice);
  EXPECT_THAT(error.message, StartsWith("--device /dev/dri/renderD255: no such device"));
}

TEST(Device, MalformedChoicesAreUsageErrors) {
  for (const char* device : {"", "-1", "1-2", "cuda:", "cuda:x", "cuda:-1", "99999999999"}) {
    EXPECT_EQ(FailureOf(device).kind, ErrorKind::kUsage) << device;
  }
}

TEST(Device, ListsEveryDevice) { EXPECT_THAT(ListDevices(), testing::Contains(StartsWith("device 0"))); }

}  // namespace
}  // namespace burin::gl
