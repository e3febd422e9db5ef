// SPDX-License-Identifier: Apache-2.0
// The corpus of the fuzzer through the whole front end, as it is and with seeded random damage.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <vector>

#include "fx_parser/syntax/lexer.h"
#include "tests/fuzz/effect_target.h"

namespace burin::fx {
namespace {

constexpr unsigned kSeed = 51000;
constexpr unsigned kRounds = 500;

const std::vector<std::pair<std::string, std::string>>& Corpus() {
  static const std::vector<std::pair<std::string, std::string>> texts = [] {
    namespace fs = std::filesystem;
    const char* variable = std::getenv("BURIN_SOURCE_DIR");
    const fs::path root = variable != nullptr ? variable : ".";
    std::vector<std::pair<std::string, std::string>> found;
    for (const char* folder : {"tests/fuzz/corpus", "tests/data/fx"}) {
      for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
        if (!entry.is_regular_file()) continue;
        std::stringstream text;
        text << std::ifstream(entry.path(), std::ios::binary).rdbuf();
        found.emplace_back(entry.path().string(), text.str());
      }
    }
    std::sort(found.begin(), found.end());
    return found;
  }();
  return texts;
}

std::string Damaged(const std::string& text, std::mt19937& random) {
  const auto below = [&](std::size_t limit) {
    return std::uniform_int_distribution<std::size_t>(0, limit - 1)(random);
  };
  Diagnostics ignored;
  Lexer lexer(text, 0, ignored);
  std::vector<std::string> tokens;
  for (Token token = lexer.Next(); token.kind != TokenKind::kEnd; token = lexer.Next())
    tokens.push_back((token.starts_line ? "\n" : " ") + std::string(token.text));
  for (std::size_t i = 1 + below(3); i > 0 && tokens.size() > 1; --i) {
    const std::size_t at = below(tokens.size());
    const std::size_t other = below(tokens.size());
    if (below(3) == 0)
      tokens.erase(tokens.begin() + static_cast<std::ptrdiff_t>(at));
    else if (below(2) == 0)
      tokens[at] = tokens[other];
    else
      std::swap(tokens[at], tokens[other]);
  }
  std::string damaged;
  for (const std::string& token : tokens) damaged += token;
  return damaged;
}

TEST(EffectMutation, TheCorpusHoldsWhatMustHold) {
  ASSERT_GE(Corpus().size(), 20u);
  for (const auto& [path, text] : Corpus()) EXPECT_EQ(fuzz::CheckEffect(text), "") << path;
}

TEST(EffectMutation, DamageIsReportedOrHarmless) {
  for (unsigned seed = kSeed; seed < kSeed + kRounds; ++seed) {
    std::mt19937 random(seed);
    const auto& [path, text] = Corpus()[seed % Corpus().size()];
    const std::string damaged = Damaged(text, random);
    ASSERT_EQ(fuzz::CheckEffect(damaged), "") << "seed " << seed << ", " << path << "\n" << damaged;
  }
}

}  // namespace
}  // namespace burin::fx
