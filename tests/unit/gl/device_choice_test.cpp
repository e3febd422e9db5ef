// SPDX-License-Identifier: Apache-2.0
#include "core/gl/device_choice.h"

#include <gmock/gmock.h>

namespace burin::gl {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

// Pointers are only told apart, never followed.
EglDevice Device(int index, bool software) {
  EglDevice device;
  device.handle = reinterpret_cast<void*>(static_cast<std::uintptr_t>(0x1000 + index));
  device.index = index;
  device.is_software = software;
  return device;
}

EglDevices Machine() {
  EglDevices found;
  found.devices = {Device(0, true), Device(1, false), Device(2, false)};
  found.devices[1].render_node = "/dev/dri/renderD128";
  found.devices[1].primary_node = "/dev/dri/card0";
  found.devices[2].cuda = 0;
  found.devices[2].name = "NVIDIA H200";
  found.has_surfaceless = true;
  return found;
}

std::vector<int> Order(std::string_view text, const EglDevices& found) {
  const Result<DeviceChoice> choice = ParseDeviceChoice(text);
  EXPECT_TRUE(choice.has_value()) << text;
  std::vector<int> order;
  for (const Candidate& candidate : Candidates(*choice, found)) order.push_back(candidate.device.index);
  return order;
}

TEST(DeviceChoice, AutoTriesHardwareThenSoftwareThenSurfaceless) {
  EXPECT_THAT(Order("auto", Machine()), ElementsAre(1, 2, 0, -1));
}

TEST(DeviceChoice, SoftwareSkipsHardware) { EXPECT_THAT(Order("software", Machine()), ElementsAre(0, -1)); }

TEST(DeviceChoice, NumbersAreEglsOrder) {
  EXPECT_THAT(Order("2", Machine()), ElementsAre(2));
  EXPECT_THAT(Order("3", Machine()), IsEmpty());
}

TEST(DeviceChoice, CudaNumbersAreCudas) {
  EXPECT_THAT(Order("cuda:0", Machine()), ElementsAre(2));
  EXPECT_THAT(Order("cuda:1", Machine()), IsEmpty());
}

TEST(DeviceChoice, ANameMatchesANodeOrPartOfTheDevicesName) {
  EXPECT_THAT(Order("/dev/dri/renderD128", Machine()), ElementsAre(1));
  EXPECT_THAT(Order("/dev/dri/card0", Machine()), ElementsAre(1));
  EXPECT_THAT(Order("/dev/dri/renderD12", Machine()), IsEmpty());
  EXPECT_THAT(Order("h200", Machine()), ElementsAre(2));
}

TEST(DeviceChoice, AnUnknownNameAsksEveryRenderer) {
  EXPECT_THAT(Order("radeon", Machine()), ElementsAre(0, 1, 2, -1));
  for (const Candidate& candidate : Candidates(*ParseDeviceChoice("radeon"), Machine())) {
    EXPECT_TRUE(candidate.must_match_renderer);
  }
}

TEST(DeviceChoice, ErrorsSayWhatWasExpected) {
  EXPECT_EQ(ParseDeviceChoice("").error().message,
            "--device is empty; expected auto, software, a number, cuda:N, or part of a device's name");
  EXPECT_EQ(ParseDeviceChoice("cuda:").error().message, "--device cuda:: expected a number after 'cuda:'");
  EXPECT_EQ(
      ParseDeviceChoice("-1").error().message,
      "--device -1: not a device's number; expected auto, software, a number, cuda:N, or part of a device's name");
}

TEST(DeviceChoice, ExtensionsAreComparedByWholeTokens) {
  EXPECT_FALSE(HasToken("EGL_EXT_device_drm_render_node", "EGL_EXT_device_drm"));
  EXPECT_FALSE(HasToken("EGL_MESA_EXT_device_drm", "EXT_device_drm"));
  EXPECT_TRUE(HasToken("A EGL_EXT_device_drm B", "EGL_EXT_device_drm"));
  EXPECT_TRUE(HasToken("A B", "B"));
  EXPECT_FALSE(HasToken("", "B"));
}

TEST(DeviceChoice, SoftwareRenderersAreKnownByName) {
  EXPECT_TRUE(IsSoftwareRenderer("llvmpipe (LLVM 15.0.6, 256 bits)"));
  EXPECT_TRUE(IsSoftwareRenderer("softpipe"));
  EXPECT_FALSE(IsSoftwareRenderer("NVIDIA H200/PCIe/SSE2"));
  EXPECT_FALSE(IsSoftwareRenderer("Mesa Intel(R) UHD Graphics 620 (KBL GT2)"));
}

}  // namespace
}  // namespace burin::gl
