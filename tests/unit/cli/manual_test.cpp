// SPDX-License-Identifier: Apache-2.0
// The manual pages agree with the option table: every option is there with its value's name, and no other.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include "cli/command_table.h"

namespace burin::cli {
namespace {

/// A page as text: \- is a dash, fonts are gone, macro names are gone.
std::string Page(const std::string& name) {
  const char* const folder = std::getenv("BURIN_SOURCE_DIR");
  std::ifstream file(std::string(folder != nullptr ? folder : ".") + "/man/" + name);
  std::stringstream stream;
  stream << file.rdbuf();
  std::string text = std::regex_replace(stream.str(), std::regex(R"(\\-)"), "-");
  text = std::regex_replace(text, std::regex(R"(\\f[BIRP])"), "");
  text = std::regex_replace(text, std::regex(R"(\\&)"), "");
  text = std::regex_replace(text, std::regex("\""), "");
  text = std::regex_replace(text, std::regex(" +"), " ");
  return std::regex_replace(text, std::regex(R"(^\.(BR|B|I|BI|IR|RI|TP|SH|SS|PP|RS|RE)\b ?)", std::regex::multiline),
                            "");
}

class Manual : public testing::TestWithParam<const char*> {};

TEST_P(Manual, HasEveryOptionOfItsCommand) {
  const CommandSpec& command = *FindCommand(GetParam());
  const std::string page = Page("burin-" + std::string(command.name) + ".1");
  ASSERT_FALSE(page.empty()) << "no page";
  for (const OptionSpec& spec : OptionTable()) {
    if ((spec.commands & command.bit) == 0) continue;
    std::string heading = "--" + std::string(spec.name);
    if (!spec.value.empty()) heading += " " + std::string(spec.value);
    if (spec.letter != 0) heading = std::string("-") + spec.letter + ", " + heading;
    EXPECT_NE(page.find("\n" + heading + "\n"), std::string::npos) << heading;
  }
}

TEST_P(Manual, HasNoOptionThatTheCommandLacks) {
  const CommandSpec& command = *FindCommand(GetParam());
  const std::string page = Page("burin-" + std::string(command.name) + ".1");
  std::set<std::string> known;
  for (const OptionSpec& spec : OptionTable()) {
    if ((spec.commands & command.bit) != 0) known.insert("--" + std::string(spec.name));
  }
  const std::regex heading(R"((?:^|\n)(?:-[A-Za-z], )?(--[a-z][a-z-]*)(?: \S+)?(?=\n))");
  for (std::sregex_iterator at(page.begin(), page.end(), heading), end; at != end; ++at) {
    EXPECT_TRUE(known.contains((*at)[1])) << (*at)[1];
  }
}

INSTANTIATE_TEST_SUITE_P(Pages, Manual, testing::Values("render", "check", "info", "effects", "tessellate"),
                         [](const auto& parameter) { return std::string(parameter.param); });

TEST(ManualOverview, NamesEveryCommand) {
  const std::string page = Page("burin.1");
  ASSERT_FALSE(page.empty());
  for (const CommandSpec& command : CommandTable()) {
    EXPECT_NE(page.find("burin " + std::string(command.name)), std::string::npos) << command.name;
  }
}

}  // namespace
}  // namespace burin::cli
