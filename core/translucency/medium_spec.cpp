// SPDX-License-Identifier: Apache-2.0
#include "core/translucency/medium_spec.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/translucency/dipole.h"

namespace burin::translucency {
namespace {

constexpr std::string_view kForms =
    "a measured material, none, \"scattering:R,G,B;absorption:R,G,B[;ior:N]\" or \"albedo:R,G,B;path:R,G,B[;ior:N]\"";

std::string MeasuredNames() {
  std::string names;
  for (const Medium& medium : MeasuredMedia()) names += fmt::format("{}{}", names.empty() ? "" : ", ", medium.name);
  return names;
}

std::vector<std::string> Split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(separator, at), text.size());
    parts.emplace_back(text.substr(at, end - at));
    at = end + 1;
  }
  return parts;
}

Result<float> ParseFloat(const std::string& text, std::string_view key) {
  char* end = nullptr;
  const float value = std::strtof(text.c_str(), &end);
  if (text.empty() || end != text.c_str() + text.size() || !std::isfinite(value)) {
    return Fail(ErrorKind::kUsage, fmt::format("{}: \"{}\" is no number", key, text));
  }
  return value;
}

struct Values {
  std::optional<glm::vec3> scattering, absorption, albedo, path;
  std::optional<glm::vec3> ior;
};

std::optional<glm::vec3>* FieldOf(Values& values, std::string_view key) {
  if (key == "scattering") return &values.scattering;
  if (key == "absorption") return &values.absorption;
  if (key == "albedo") return &values.albedo;
  if (key == "path") return &values.path;
  if (key == "ior") return &values.ior;
  return nullptr;
}

Result<glm::vec3> ParseTriple(const std::string& text, std::string_view key, bool is_single) {
  const std::vector<std::string> parts = Split(text, ',');
  if (parts.size() != 1 && (parts.size() != 3 || is_single)) {
    return Fail(ErrorKind::kUsage,
                fmt::format("{}: {} numbers, expected {}", key, parts.size(), is_single ? "one" : "one or three"));
  }
  glm::vec3 triple;
  for (int c = 0; c < 3; ++c) {
    const Result<float> number = ParseFloat(parts[parts.size() == 1 ? 0 : static_cast<std::size_t>(c)], key);
    if (!number) return std::unexpected(number.error());
    triple[c] = *number;
  }
  return triple;
}

Result<Values> ParseValues(std::string_view text) {
  Values values;
  for (const std::string& part : Split(text, ';')) {
    const std::size_t colon = part.find(':');
    const std::string key = part.substr(0, colon);
    std::optional<glm::vec3>* field = FieldOf(values, key);
    if (colon == std::string::npos || field == nullptr) {
      return Fail(ErrorKind::kUsage,
                  fmt::format("\"{}\" is no medium; expected {}. Measured: {}", text, kForms, MeasuredNames()));
    }
    if (field->has_value()) return Fail(ErrorKind::kUsage, fmt::format("{}: given twice in \"{}\"", key, text));
    Result<glm::vec3> triple = ParseTriple(part.substr(colon + 1), key, key == "ior");
    if (!triple) return std::unexpected(triple.error());
    *field = *triple;
  }
  return values;
}

bool AllWithin(const glm::vec3& v, float low, float high) {
  return v.x >= low && v.y >= low && v.z >= low && v.x <= high && v.y <= high && v.z <= high;
}

Result<Medium> Build(const Values& values, std::string_view text) {
  const bool is_physical = values.scattering && values.absorption && !values.albedo && !values.path;
  const bool is_artistic = values.albedo && values.path && !values.scattering && !values.absorption;
  if (!is_physical && !is_artistic) {
    return Fail(ErrorKind::kUsage, fmt::format("\"{}\": expected scattering and absorption, or albedo and path", text));
  }
  const float ior = values.ior ? values.ior->x : 1.3f;
  if (!(ior >= 1.0f && ior <= 4.0f)) {
    return Fail(ErrorKind::kUsage, fmt::format("ior: {} is out of range; expected 1 to 4", ior));
  }
  constexpr float kMost = 1e6f;
  const auto refuse = [](std::string_view key, const glm::vec3& found, std::string_view expected) {
    return Fail(ErrorKind::kUsage, fmt::format("{}: {:g},{:g},{:g} is out of range; expected {}", key, found.x, found.y,
                                               found.z, expected));
  };
  if (is_artistic) {
    if (!AllWithin(*values.albedo, 0.0f, 1.0f)) return refuse("albedo", *values.albedo, "0 to 1");
    if (!AllWithin(*values.path, 1e-6f, kMost)) return refuse("path", *values.path, "0.000001 to 1000000 millimetres");
    return MediumFromAlbedo(*values.albedo, *values.path, ior);
  }
  if (!AllWithin(*values.scattering, 0.0f, kMost))
    return refuse("scattering", *values.scattering, "0 to 1000000 per millimetre");
  if (!AllWithin(*values.absorption, 0.0f, kMost))
    return refuse("absorption", *values.absorption, "0 to 1000000 per millimetre");
  Medium medium;
  medium.reduced_scattering = *values.scattering;
  medium.absorption = *values.absorption;
  medium.ior = ior;
  return medium;
}

}  // namespace

Result<std::optional<Medium>> ParseMedium(std::string_view text) {
  if (text == "none") return std::optional<Medium>();
  if (std::optional<Medium> measured = FindMeasuredMedium(text)) return measured;
  const Result<Values> values = ParseValues(text);
  if (!values) return std::unexpected(values.error());
  Result<Medium> medium = Build(*values, text);
  if (!medium) return std::unexpected(medium.error());
  medium->name = text;
  return std::optional<Medium>(*std::move(medium));
}

Result<Assignment> ParseAssignment(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) {
    return Fail(ErrorKind::kUsage,
                fmt::format("\"{}\": expected GLOB=MEDIUM, a material's name or pattern and {}", text, kForms));
  }
  Result<std::optional<Medium>> medium = ParseMedium(std::string_view(text).substr(equals + 1));
  if (!medium) return std::unexpected(medium.error());
  return Assignment{text.substr(0, equals), *std::move(medium)};
}

std::vector<std::string> CheckMedium(const Medium& medium) {
  std::vector<std::string> warnings;
  const glm::vec3& s = medium.reduced_scattering;
  const glm::vec3& a = medium.absorption;
  constexpr float kSwapped = 100.0f;  // ketchup's blue, the darkest of the measured ones, has 48
  const bool absorbs_far_more = a.x > kSwapped * s.x && a.y > kSwapped * s.y && a.z > kSwapped * s.z;
  if (absorbs_far_more) {
    warnings.push_back(fmt::format(
        "medium \"{}\": absorption ({:g}, {:g}, {:g}) is far above scattering ({:g}, {:g}, {:g}), so it will be black; "
        "were the two exchanged?",
        medium.name, a.x, a.y, a.z, s.x, s.y, s.z));
  } else if (s == glm::vec3(0.0f)) {
    warnings.push_back(fmt::format("medium \"{}\": nothing scatters, so it will be black", medium.name));
  }
  return warnings;
}

std::string CheckScale(const Medium& medium, double object_mm, double texel_mm, double unit_mm) {
  const glm::vec3 extinction = medium.ReducedExtinction();
  const double most = static_cast<double>(std::max({extinction.x, extinction.y, extinction.z}));
  const double least = static_cast<double>(std::min({extinction.x, extinction.y, extinction.z}));
  if (!(most > 0.0)) return {};
  constexpr double kNothing = 1e-12;  // mm
  if (object_mm < kNothing) {
    return fmt::format("medium \"{}\": an object of it has all its vertices in one place, so nothing scatters",
                       medium.name);
  }
  if (1.0 / least < texel_mm) {
    return fmt::format(
        "medium \"{}\": its longest mean free path is {:.3g} mm, below a texel of {:.3g} mm in an object of {:.3g} mm, "
        "so it looks opaque; is --unit-mm {:g} right?",
        medium.name, 1.0 / least, texel_mm, object_mm, unit_mm);
  }
  if (1.0 / most > object_mm) {
    return fmt::format(
        "medium \"{}\": its shortest mean free path is {:.3g} mm, above the object's {:.3g} mm, where diffusion no "
        "longer holds; is --unit-mm {:g} right?",
        medium.name, 1.0 / most, object_mm, unit_mm);
  }
  return {};
}

}  // namespace burin::translucency
