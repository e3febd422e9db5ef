// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/syntax/lexer.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace burin::fx {
namespace {

struct Lexed {
  std::vector<Token> tokens;
  Diagnostics diagnostics;
};

// Holds views into `text`.
Lexed Lex(std::string_view text) {
  Lexed lexed;
  Lexer lexer(text, 0, lexed.diagnostics);
  for (Token token = lexer.Next(); token.kind != TokenKind::kEnd; token = lexer.Next()) lexed.tokens.push_back(token);
  return lexed;
}

std::string Texts(std::string_view text) {
  std::string result;
  for (const Token& token : Lex(text).tokens) result += (result.empty() ? "" : " ") + std::string(token.text);
  return result;
}

TokenKind KindOf(std::string_view text) {
  const Lexed lexed = Lex(text);
  EXPECT_EQ(lexed.tokens.size(), 1u) << text;
  EXPECT_EQ(lexed.tokens.at(0).text, text);
  return lexed.tokens.at(0).kind;
}

TEST(Lexer, TakesTheLongestPunctuator) {
  EXPECT_EQ(Texts("a<<=b>>=c...d"), "a <<= b >>= c ... d");
  EXPECT_EQ(Texts("+++--->>><=="), "++ + -- - >> > <= =");
  EXPECT_EQ(Texts("!=!==&&&|||^^=::::###"), "!= != = && & || | ^ ^= :: :: ## #");
}

TEST(Lexer, GivesEachPunctuatorItsKind) {
  EXPECT_EQ(KindOf("{"), TokenKind::kLeftBrace);
  EXPECT_EQ(KindOf("::"), TokenKind::kScope);
  EXPECT_EQ(KindOf(">>="), TokenKind::kShiftRightAssign);
  EXPECT_EQ(KindOf("^="), TokenKind::kXorAssign);
  EXPECT_EQ(KindOf("##"), TokenKind::kHashHash);
}

TEST(Lexer, ReadsIdentifiers) {
  EXPECT_EQ(KindOf("_foo9"), TokenKind::kIdentifier);
  EXPECT_EQ(KindOf("GBAintensity_A8R8G8B8"), TokenKind::kIdentifier);
  EXPECT_EQ(Texts("a.b"), "a . b");
}

TEST(Lexer, ReadsIntegers) {
  for (const char* text : {"0", "7", "123", "0x1F", "0XabU", "10u", "10UL", "017", "0x0"}) {
    EXPECT_EQ(KindOf(text), TokenKind::kInteger) << text;
  }
}

TEST(Lexer, ReadsFloats) {
  for (const char* text : {"1.0", "1.", ".5", "1e5", "1E-5", "1.5e+3f", "1.f", "2f", "2h", "1.0h", "3.5F", "1.e2",
                           "08.5", "1.0l", "1.0x"}) {
    EXPECT_EQ(KindOf(text), TokenKind::kFloat) << text;
  }
}

TEST(Lexer, KeepsSwizzlesOfNumbersApart) {
  EXPECT_EQ(Texts("1.xxx"), "1 . xxx");
  EXPECT_EQ(Texts("1.0.xxx"), "1.0 . xxx");
  EXPECT_EQ(Texts("1..xx"), "1. . xx");
  EXPECT_EQ(Texts("1.rgb"), "1 . rgb");
  EXPECT_EQ(Texts("1.f.x"), "1.f . x");
}

TEST(Lexer, MarksMalformedNumbers) {
  for (const char* text : {"2D", "0x", "0xg", "09", "1.5q", "1uf", "1e5q", "0x1h", "12ulul"}) {
    EXPECT_EQ(KindOf(text), TokenKind::kBadNumber) << text;
  }
  EXPECT_EQ(Texts("1e+"), "1e +");
}

TEST(Lexer, ReadsStringsWithEscapes) {
  EXPECT_EQ(KindOf(R"("a\"b\\")"), TokenKind::kString);
  EXPECT_EQ(Texts("\"a\"\"b\""), "\"a\" \"b\"");
  EXPECT_EQ(KindOf("\"a\\\nb\""), TokenKind::kString);
}

TEST(Lexer, EndsAnUnterminatedStringAtItsLine) {
  const Lexed lexed = Lex("\"abc\nd");
  ASSERT_EQ(lexed.tokens.size(), 2u);
  EXPECT_EQ(lexed.tokens[0].kind, TokenKind::kUnterminatedString);
  EXPECT_EQ(lexed.tokens[0].text, "\"abc");
  EXPECT_EQ(lexed.tokens[1].text, "d");
  EXPECT_EQ(KindOf("\"abc\\"), TokenKind::kUnterminatedString);
}

TEST(Lexer, TakesCommentsAsSpace) {
  EXPECT_EQ(Texts("a/* b\n c */d // e\nf"), "a d f");
  EXPECT_EQ(Texts("a // b \\\n c\nd"), "a d");
  EXPECT_EQ(Texts("a /*/ b */ c"), "a c");
}

TEST(Lexer, ReportsAnUnterminatedComment) {
  const Lexed lexed = Lex("a\n /* b\n");
  ASSERT_EQ(lexed.diagnostics.all().size(), 1u);
  const Diagnostic& diagnostic = lexed.diagnostics.all()[0];
  EXPECT_EQ(diagnostic.text, "unterminated comment");
  EXPECT_EQ(diagnostic.code, "B1101");
  EXPECT_EQ(diagnostic.range.begin.line, 2u);
  EXPECT_EQ(diagnostic.range.begin.column, 2u);
}

TEST(Lexer, MarksBytesWithoutMeaning) {
  const Lexed lexed = Lex("a @ \x93\xfa ` '");
  ASSERT_EQ(lexed.tokens.size(), 6u);
  for (std::size_t i = 1; i < 6; ++i) EXPECT_EQ(lexed.tokens[i].kind, TokenKind::kUnknown);
}

TEST(Lexer, JoinsLinesAtABackslash) {
  const Lexed lexed = Lex("a \\\n b \\ \t\n c\nd");
  ASSERT_EQ(lexed.tokens.size(), 4u);
  EXPECT_TRUE(lexed.tokens[0].starts_line);
  EXPECT_FALSE(lexed.tokens[1].starts_line);
  EXPECT_FALSE(lexed.tokens[2].starts_line);
  EXPECT_TRUE(lexed.tokens[3].starts_line);
  EXPECT_EQ(lexed.tokens[3].begin.line, 4u);
}

TEST(Lexer, CountsLinesAndColumnsInBytes) {
  const Lexed lexed = Lex("\tab cd\n/* \xc3\xa9 */ e");
  ASSERT_EQ(lexed.tokens.size(), 3u);
  EXPECT_EQ(lexed.tokens[0].begin.column, 2u);
  EXPECT_EQ(lexed.tokens[0].end_column, 4u);
  EXPECT_EQ(lexed.tokens[1].begin.column, 5u);
  EXPECT_EQ(lexed.tokens[2].begin.line, 2u);
  EXPECT_EQ(lexed.tokens[2].begin.column, 10u);
}

TEST(Lexer, TellsWhetherSpaceStoodBefore) {
  const Lexed lexed = Lex("a b(/**/c");
  EXPECT_TRUE(lexed.tokens.at(1).space_before);
  EXPECT_FALSE(lexed.tokens.at(2).space_before);
  EXPECT_TRUE(lexed.tokens.at(3).space_before);
}

TEST(Lexer, GivesTheRestOfALineRaw) {
  Diagnostics diagnostics;
  Lexer lexer("# error  it's \"bad \n next", 0, diagnostics);
  lexer.Next();
  lexer.Next();
  EXPECT_EQ(lexer.Peek().text, "it");
  Location begin;
  EXPECT_EQ(lexer.RestOfLine(&begin), "it's \"bad");
  EXPECT_EQ(begin.column, 10u);
  EXPECT_EQ(lexer.Next().text, "next");
}

TEST(Lexer, GivesAnEmptyRestBeforeTheNextLine) {
  Diagnostics diagnostics;
  Lexer lexer("a\nb", 0, diagnostics);
  lexer.Next();
  EXPECT_EQ(lexer.Peek().text, "b");
  Location begin;
  EXPECT_EQ(lexer.RestOfLine(&begin), "");
  EXPECT_EQ(lexer.Next().text, "b");
}

}  // namespace
}  // namespace burin::fx
