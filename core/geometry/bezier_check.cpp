// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/bezier_check.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <span>
#include <string>

namespace burin::geometry {
namespace {

/// What messages call one net of one patch.
struct NetName {
  std::string_view model;
  std::size_t patch;  ///< from 1
  std::string_view attribute;
};

std::unexpected<Error> Fault(const NetName& net, std::string_view what) {
  return Fail(ErrorKind::kInput, fmt::format("{}: patch {}: {}{}", net.model, net.patch, net.attribute, what));
}

Result<void> CheckOrders(const NetName& name, PatchDomain domain, const ControlNet& net, int least, int most) {
  const int u = net.u_order, v = net.v_order;
  if (u < least || u > most || v < least || v > most)
    return Fault(name, fmt::format(" have order {} x {}, expected {} to {}", u, v, least, most));
  if (domain == PatchDomain::kTriangle && u != v)
    return Fault(name, fmt::format(" have order {} x {}, expected one order for a triangle", u, v));
  return {};
}

template <class Value>
std::string Text(const Value& value) {
  std::string text;
  for (int c = 0; c < Value::length(); ++c) text += fmt::format("{}{}", c == 0 ? "" : ", ", value[c]);
  return text;
}

template <class Value>
Result<void> CheckValues(const NetName& name, PatchDomain domain, const ControlNet& net,
                         const std::vector<Value>& values) {
  const std::size_t count = ValueCount(domain, net);
  if (net.first > values.size() || count > values.size() - net.first)
    return Fault(name, fmt::format(" are {} from {} on, of {} there are", count, net.first, values.size()));
  for (std::size_t i = 0; i < count; ++i) {
    const Value& value = values[net.first + i];
    for (int c = 0; c < Value::length(); ++c) {
      if (!std::isfinite(value[c]))
        return Fault(name, fmt::format(": point {} is ({}), expected finite numbers", i + 1, Text(value)));
    }
  }
  return {};
}

template <class Value>
Result<void> CheckNet(const NetName& name, PatchDomain domain, const ControlNet& net,
                      const std::vector<Value>& values) {
  if (!net) return {};
  if (auto orders = CheckOrders(name, domain, net, 1, kMaxBezierOrder); !orders) return orders;
  return CheckValues(name, domain, net, values);
}

Result<void> CheckWeights(const NetName& name, PatchDomain domain, const ControlNet& net,
                          const std::vector<glm::vec4>& positions) {
  for (std::size_t i = 0; i < ValueCount(domain, net); ++i) {
    const float weight = positions[net.first + i].w;
    if (!(weight > 0.0f))
      return Fault(name, fmt::format(": point {} has the weight {}, expected more than 0", i + 1, weight));
  }
  return {};
}

Result<void> CheckPositions(const NetName& name, const BezierPatch& patch, const BezierPatches& patches) {
  const int most = patch.is_rational ? kMaxRationalOrder : kMaxBezierOrder;
  if (auto orders = CheckOrders(name, patch.domain, patch.position, 2, most); !orders) return orders;
  if (auto values = CheckValues(name, patch.domain, patch.position, patches.positions); !values) return values;
  return patch.is_rational ? CheckWeights(name, patch.domain, patch.position, patches.positions) : Result<void>();
}

}  // namespace

Result<void> CheckPatches(const BezierPatches& patches, std::string_view name) {
  constexpr std::string_view kTexcoords[] = {"first texture coordinates", "second texture coordinates"};
  for (std::size_t p = 0; p < patches.patches.size(); ++p) {
    const BezierPatch& patch = patches.patches[p];
    const auto named = [&](std::string_view attribute) { return NetName{name, p + 1, attribute}; };
    const std::string_view positions = patch.is_rational ? "rational positions" : "positions";
    if (auto result = CheckPositions(named(positions), patch, patches); !result) return result;
    if (auto result = CheckNet(named("normals"), patch.domain, patch.normal, patches.normals); !result) return result;
    for (std::size_t t = 0; t < 2; ++t) {
      auto result = CheckNet(named(kTexcoords[t]), patch.domain, patch.texcoord[t], patches.texcoords[t]);
      if (!result) return result;
    }
    if (auto result = CheckNet(named("colours"), patch.domain, patch.color, patches.colors); !result) return result;
  }
  return {};
}

}  // namespace burin::geometry
