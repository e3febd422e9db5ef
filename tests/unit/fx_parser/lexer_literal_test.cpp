// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <limits>

#include "fx_parser/syntax/literal.h"

namespace burin::fx {
namespace {

TEST(LexerLiteral, EvaluatesIntegersInEveryBase) {
  EXPECT_EQ(ParseInteger("42")->value, 42u);
  EXPECT_EQ(ParseInteger("0x900")->value, 0x900u);
  EXPECT_EQ(ParseInteger("0XFFFFFFFF")->value, 4294967295u);
  EXPECT_EQ(ParseInteger("010")->value, 8u);
  EXPECT_EQ(ParseInteger("0")->value, 0u);
  EXPECT_EQ(ParseInteger("18446744073709551615")->value, std::numeric_limits<std::uint64_t>::max());
}

TEST(LexerLiteral, TellsUnsignedIntegers) {
  EXPECT_TRUE(ParseInteger("1u")->is_unsigned);
  EXPECT_TRUE(ParseInteger("1LU")->is_unsigned);
  EXPECT_FALSE(ParseInteger("1L")->is_unsigned);
}

TEST(LexerLiteral, RefusesIntegersBeyond64Bits) {
  EXPECT_FALSE(ParseInteger("18446744073709551616"));
  EXPECT_FALSE(ParseInteger("0x10000000000000000"));
}

TEST(LexerLiteral, EvaluatesFloats) {
  EXPECT_EQ(ParseFloat("1.5f").value, 1.5);
  EXPECT_EQ(ParseFloat(".25").value, 0.25);
  EXPECT_EQ(ParseFloat("2.").value, 2.0);
  EXPECT_EQ(ParseFloat("1.e2").value, 100.0);
  EXPECT_EQ(ParseFloat("1e-3").value, 1e-3);
  EXPECT_TRUE(ParseFloat("1.0h").is_half);
  EXPECT_FALSE(ParseFloat("1.0f").is_half);
}

TEST(LexerLiteral, SaturatesFloatsOutOfRange) {
  EXPECT_EQ(ParseFloat("1e999").value, std::numeric_limits<double>::infinity());
  EXPECT_EQ(ParseFloat("1e-999").value, 0.0);
}

TEST(LexerLiteral, ResolvesEscapes) {
  EXPECT_EQ(ParseString(R"("a\n\t\"\\\x41\101")"), "a\n\t\"\\AA");
  EXPECT_EQ(ParseString(R"("a\0b")"), std::string("a\0b", 3));
}

TEST(LexerLiteral, KeepsTheBackslashOfUnknownEscapes) {
  EXPECT_EQ(ParseString(R"("..\media\Wood.dds")"), R"(..\media\Wood.dds)");
  EXPECT_EQ(ParseString("\"a\\"), "a\\");
}

TEST(LexerLiteral, JoinsAStringContinuedOnTheNextLine) { EXPECT_EQ(ParseString("\"a\\\nb\""), "ab"); }

}  // namespace
}  // namespace burin::fx
