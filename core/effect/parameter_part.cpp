// SPDX-License-Identifier: Apache-2.0
#include "core/effect/parameter_part.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>

#include "fx_parser/semantics/conversion.h"
#include "fx_parser/source/diagnostic.h"

namespace burin::effect {
namespace {

std::size_t Size(const fx::Type& type) { return static_cast<std::size_t>(std::max(0L, fx::FlatComponents(type))); }

// "[3]" off the front of the path.
std::expected<void, std::string> TakeElement(std::string_view& path, ParameterPart& part) {
  const std::size_t end = path.find(']');
  std::size_t index = 0;
  const char* const last = end == std::string_view::npos ? nullptr : path.data() + end;
  const auto [stop, error] = std::from_chars(path.data() + 1, last == nullptr ? path.data() + 1 : last, index);
  if (last == nullptr || error != std::errc() || stop != last)
    return std::unexpected(fmt::format("'{}' is no index", path));
  if (!part.type.is_array()) return std::unexpected(fmt::format("a {} has no elements", fx::ToString(part.type)));
  const std::size_t count = part.type.array.front();
  if (index >= count) return std::unexpected(fmt::format("there is no element {}: it has {}", index, count));
  part.type.array.erase(part.type.array.begin());
  part.offset += index * Size(part.type);
  path.remove_prefix(end + 1);
  return {};
}

// ".Color" off the front of the path.
std::expected<void, std::string> TakeMember(std::string_view& path, ParameterPart& part) {
  path.remove_prefix(1);
  const std::string name(path.substr(0, path.find_first_of(".[")));
  if (part.type.kind != fx::TypeKind::kStruct || part.type.is_array() || part.type.structure == nullptr)
    return std::unexpected(fmt::format("a {} has no members", fx::ToString(part.type)));
  std::size_t offset = part.offset;
  std::vector<std::string> names;
  for (const auto& member : part.type.structure->members) {
    if (member->name == name) {
      const fx::Type type = member->type;
      part = {offset, type};
      path.remove_prefix(name.size());
      return {};
    }
    offset += Size(member->type);
    names.push_back(member->name);
  }
  const std::string near = fx::NearestName(name, names);
  return std::unexpected(near.empty() ? fmt::format("there is no member '{}'; it has {}", name, fmt::join(names, ", "))
                                      : fmt::format("there is no member '{}'; did you mean '{}'?", name, near));
}

}  // namespace

std::string_view ParameterName(std::string_view path) { return path.substr(0, path.find_first_of(".[")); }

std::expected<ParameterPart, std::string> FindPart(const fx::Parameter& parameter, std::string_view path) {
  ParameterPart part{.offset = 0, .type = parameter.type};
  path.remove_prefix(ParameterName(path).size());
  while (!path.empty()) {
    const auto taken = path.front() == '[' ? TakeElement(path, part) : TakeMember(path, part);
    if (!taken) return std::unexpected(taken.error());
    if (!path.empty() && path.front() != '[' && path.front() != '.')
      return std::unexpected(fmt::format("'{}' is neither an index nor a member", path));
  }
  return part;
}

}  // namespace burin::effect
