// SPDX-License-Identifier: Apache-2.0
#include "core/gbuffer/attribute_table.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

namespace burin::gbuffer {
namespace {

std::string ManPage() {
  const char* root = std::getenv("BURIN_SOURCE_DIR");
  std::ifstream file(std::string(root == nullptr ? "." : root) + "/man/burin-attributes.7");
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::string Number(float value) { return value >= 1e9f ? "1e10" : fmt::format("{}", value); }

std::string Join(const AttributeInfo& info) {
  std::string channels;
  for (std::size_t i = 0; i < static_cast<std::size_t>(info.components); ++i) {
    channels += (i == 0 ? "" : " ") + std::string(info.exr_channels[i]);
  }
  return channels;
}

// The paragraph of one attribute, as the page must have it.
std::string Paragraph(const AttributeInfo& info) {
  std::string flags;
  if (info.is_signed) flags += " Signed.";
  if (info.is_color) flags += " Colour.";
  if (info.is_id) flags += " Id.";
  const std::string escaped_range = (info.range.starts_with('-') ? "\\" : "") + std::string(info.range);
  return fmt::format(".TP\n.B {}\n{}{}\n.br\nComponents {}; space {}; range {}; unit {}; background {}; EXR {}.\n",
                     info.name, info.description, flags, info.components, info.space == "-" ? "none" : info.space,
                     escaped_range, info.unit == "-" ? "none" : info.unit, Number(info.background[0]), Join(info));
}

TEST(AttributeTable, NamesAreFoundInAnyCase) {
  EXPECT_EQ(FindAttribute("color"), Attribute::kColor);
  EXPECT_EQ(FindAttribute("OBJECTID"), Attribute::kObjectId);
  EXPECT_EQ(FindAttribute("zBuffer"), Attribute::kZbuffer);
  EXPECT_EQ(FindAttribute("colour"), std::nullopt);
  EXPECT_EQ(FindAttribute(""), std::nullopt);
}

TEST(AttributeTable, EveryAttributeIsThereOnce) {
  EXPECT_EQ(AllAttributes().size(), 33u);
  std::set<std::string_view> names;
  std::set<std::string_view> channels;
  for (const AttributeInfo& info : AllAttributes()) {
    EXPECT_TRUE(names.insert(info.name).second) << info.name;
    EXPECT_EQ(&Info(info.attribute), &info);
    EXPECT_EQ(FindAttribute(info.name), info.attribute);
    for (std::size_t i = 0; i < 4; ++i) {
      const bool has_channel = !info.exr_channels[i].empty();
      EXPECT_EQ(has_channel, i < static_cast<std::size_t>(info.components)) << info.name;
      if (has_channel) {
        EXPECT_TRUE(channels.insert(info.exr_channels[i]).second) << "two attributes write " << info.exr_channels[i];
      }
    }
  }
}

TEST(AttributeTable, IdsHaveABackgroundThatNoObjectHas) {
  for (const AttributeInfo& info : AllAttributes()) {
    if (!info.is_id) continue;
    EXPECT_EQ(info.components, 1);
    EXPECT_EQ(info.background[0], 0.0f);
  }
}

TEST(AttributeTable, TheManPageAgrees) {
  const std::string page = ManPage();
  ASSERT_FALSE(page.empty()) << "man/burin-attributes.7 is missing";
  std::size_t last = 0;
  for (const AttributeInfo& info : AllAttributes()) {
    const std::size_t at = page.find(Paragraph(info));
    ASSERT_NE(at, std::string::npos) << "man/burin-attributes.7 wants this paragraph:\n" << Paragraph(info);
    EXPECT_GT(at, last) << info.name << " is out of the table's order";
    last = at;
  }
}

}  // namespace
}  // namespace burin::gbuffer
