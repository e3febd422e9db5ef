// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/effect/naming.h"

#include <algorithm>

#include "fx_parser/effect/case.h"
#include "fx_parser/glsl/interface.h"
#include "fx_parser/source/diagnostic.h"

namespace burin::fx {
namespace {

bool IsDigit(char c) { return c >= '0' && c <= '9'; }
bool IsNumber(std::string_view text) { return !text.empty() && text.size() <= 6 && std::ranges::all_of(text, IsDigit); }
int ToNumber(std::string_view text) {
  int number = 0;
  for (const char c : text) number = number * 10 + (c - '0');
  return number;
}

std::vector<std::string> Split(std::string_view name) {
  std::vector<std::string> tokens(1);
  for (const char c : name) {
    if (c == '_')
      tokens.emplace_back();
    else
      tokens.back() += c;
  }
  return tokens;
}

std::string Suggestion(const std::string& name, const std::vector<std::string>& candidates) {
  const std::string near = NearestName(name, candidates);
  return near.empty() ? "" : "; did you mean '" + near + "'?";
}

NamingError UnknownFormat(std::string_view name, const std::string& token) {
  std::vector<std::string> names;
  for (const FormatInfo& info : AllFormats()) names.emplace_back(info.name);
  return {"B1002", "texture '" + std::string(name) + "': unknown format '" + token + "'" + Suggestion(token, names)};
}

/// Parses the tokens after the format; empty text when they are fine.
std::string ParseModifiers(const std::vector<std::string>& tokens, std::size_t first, ExtensionName& result) {
  bool has_scale = false;
  bool has_target = false;
  for (std::size_t i = first; i < tokens.size(); ++i) {
    const std::string token = LowerCase(tokens[i]);
    if (token.starts_with("rt") && IsNumber(token.substr(2)) && !has_target) {
      auto* pass = std::get_if<PassResultRole>(&result.role);
      if (pass == nullptr) return "only pass results have render targets, so '_" + tokens[i] + "' has no place here";
      pass->target = ToNumber(std::string_view(token).substr(2));
      if (pass->target >= kMaxTargets)
        return "render target " + token.substr(2) + " is too high: the last is " + std::to_string(kMaxTargets - 1);
      has_target = true;
    } else if (token.starts_with("s") && IsNumber(token.substr(1)) && !has_scale) {
      result.scale = ToNumber(std::string_view(token).substr(1));
      if (i + 1 < tokens.size() && IsNumber(tokens[i + 1])) {
        double digit = 0.1;
        for (const char c : tokens[++i]) {
          result.scale += (c - '0') * digit;
          digit /= 10;
        }
      }
      if (!(result.scale > 0) || result.scale > kMaxScale) return "the scale must be above 0 and at most 16";
      has_scale = true;
    } else if (token.starts_with("s") && !has_scale) {
      return "malformed scale '_" + tokens[i] + "': expected _S3 or _S0_5";
    } else {
      return "unexpected '_" + tokens[i] + "': expected _S<scale>" +
             (result.role.index() == 1 ? " or _RT<target>" : "") + " once";
    }
  }
  return {};
}

}  // namespace

bool IsExtensionName(std::string_view name) {
  if (name.starts_with("GBA")) return name.size() > 3 && name[3] != '_' && !IsDigit(name[3]);
  return name.starts_with("PASS") && name.size() > 4 && IsDigit(name[4]);
}

std::variant<ExtensionName, NamingError> ParseExtensionName(std::string_view name,
                                                            const std::vector<std::string>& attributes) {
  const std::vector<std::string> tokens = Split(name);
  const bool is_attribute = name.starts_with("GBA");
  const std::string quoted = "texture '" + std::string(name) + "'";
  if (tokens.size() < 2) {
    return NamingError{"B1003", quoted + " names no format: expected " +
                                    (is_attribute ? "GBA<attribute>_<FORMAT>" : "PASS<k>_<FORMAT>")};
  }
  // An attribute of a technique may hold underscores itself, so the format is the first token that is one.
  std::size_t at = 1;
  while (is_attribute && at < tokens.size() && !FindFormat(tokens[at])) ++at;
  if (at == tokens.size()) at = 1;
  ExtensionName result;
  if (is_attribute) {
    std::string attribute = LowerCase(tokens[0].substr(3));
    for (std::size_t i = 1; i < at; ++i) attribute += "_" + LowerCase(tokens[i]);
    if (std::ranges::find(attributes, attribute) == attributes.end()) {
      return NamingError{"B1001",
                         quoted + ": unknown attribute '" + attribute + "'" + Suggestion(attribute, attributes)};
    }
    result.role = AttributeRole{attribute, false};
  } else {
    const std::string number = tokens[0].substr(4);
    if (!IsNumber(number) || ToNumber(number) > kMaxPass) {
      return NamingError{"B1003", quoted + ": '" + number +
                                      "' is no pass number: expected PASS<k>_<FORMAT> with k from 0 to " +
                                      std::to_string(kMaxPass)};
    }
    result.role = PassResultRole{ToNumber(number), 0};
  }
  const auto format = FindFormat(tokens[at]);
  if (!format) return UnknownFormat(name, tokens[at]);
  result.format = *format;
  const std::string fault = ParseModifiers(tokens, at + 1, result);
  if (!fault.empty()) return NamingError{"B1003", quoted + ": " + fault};
  return result;
}

}  // namespace burin::fx
