// SPDX-License-Identifier: Apache-2.0
#include "core/gl/device_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>

namespace burin::gl {
namespace {

constexpr std::string_view kForms = "auto, software, a number, cuda:N, or part of a device's name";

std::optional<int> ParseNumber(std::string_view text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || number < 0) return std::nullopt;
  return number;
}

std::string Lower(std::string_view text) {
  std::string lower(text);
  std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

bool NamesDevice(const EglDevice& device, std::string_view name) {
  return name == device.primary_node || name == device.render_node ||
         (!device.name.empty() && ContainsName(device.name, name));
}

void AppendSurfaceless(std::vector<Candidate>& list, const EglDevices& found, bool must_match) {
  if (found.has_surfaceless) list.push_back({EglDevice{}, must_match});
}

std::vector<Candidate> ByName(std::string_view name, const EglDevices& found) {
  std::vector<Candidate> list;
  for (const EglDevice& device : found.devices) {
    if (NamesDevice(device, name)) list.push_back({device});
  }
  // A path names a node or nothing; anything else may be a part of GL_RENDERER, which only a context tells.
  if (!list.empty() || name.starts_with('/')) return list;
  for (const EglDevice& device : found.devices) list.push_back({device, true});
  AppendSurfaceless(list, found, true);
  return list;
}

}  // namespace

bool ContainsName(std::string_view text, std::string_view name) {
  return Lower(text).find(Lower(name)) != std::string::npos;
}

bool IsSoftwareRenderer(std::string_view renderer) {
  constexpr std::array<std::string_view, 6> kNames = {"llvmpipe", "softpipe",    "swrast",
                                                      "SWR ",     "SwiftShader", "Software Rasterizer"};
  return std::ranges::any_of(kNames, [&](std::string_view name) { return ContainsName(renderer, name); });
}

Result<DeviceChoice> ParseDeviceChoice(std::string_view text) {
  using Kind = DeviceChoice::Kind;
  if (text.empty()) return Fail(ErrorKind::kUsage, fmt::format("--device is empty; expected {}", kForms));
  if (text == "auto") return DeviceChoice{};
  if (text == "software") return DeviceChoice{.kind = Kind::kSoftware};
  if (text.starts_with("cuda:")) {
    const std::optional<int> number = ParseNumber(text.substr(5));
    if (!number) return Fail(ErrorKind::kUsage, fmt::format("--device {}: expected a number after 'cuda:'", text));
    return DeviceChoice{.kind = Kind::kCuda, .number = *number};
  }
  const bool is_numeric = text.find_first_not_of("-0123456789") == std::string_view::npos;
  if (!is_numeric) return DeviceChoice{.kind = Kind::kName, .name = std::string(text)};
  const std::optional<int> number = ParseNumber(text);
  if (!number)
    return Fail(ErrorKind::kUsage, fmt::format("--device {}: not a device's number; expected {}", text, kForms));
  return DeviceChoice{.kind = Kind::kIndex, .number = *number};
}

std::vector<Candidate> Candidates(const DeviceChoice& choice, const EglDevices& found) {
  std::vector<Candidate> list;
  const auto add_if = [&](auto&& keep) {
    for (const EglDevice& device : found.devices) {
      if (keep(device)) list.push_back({device});
    }
  };
  switch (choice.kind) {
    case DeviceChoice::Kind::kAuto:
      add_if([](const EglDevice& device) { return !device.is_software; });
      add_if([](const EglDevice& device) { return device.is_software; });
      AppendSurfaceless(list, found, false);
      break;
    case DeviceChoice::Kind::kSoftware:
      add_if([](const EglDevice& device) { return device.is_software; });
      AppendSurfaceless(list, found, false);
      break;
    case DeviceChoice::Kind::kIndex:
      add_if([&](const EglDevice& device) { return device.index == choice.number; });
      break;
    case DeviceChoice::Kind::kCuda:
      add_if([&](const EglDevice& device) { return device.cuda == choice.number; });
      break;
    case DeviceChoice::Kind::kName:
      list = ByName(choice.name, found);
      break;
  }
  return list;
}

}  // namespace burin::gl
