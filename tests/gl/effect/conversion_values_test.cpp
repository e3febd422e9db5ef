// SPDX-License-Identifier: Apache-2.0
// Conversions between all scalars and numbers of lanes, and products of matrices of all shapes, by value.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "tests/gl/effect/effect_fixture.h"

namespace burin::effect {
namespace {

constexpr float kTolerance = 1e-4f;
const char* const kScalars[] = {"bool", "int", "uint", "half", "float", "double"};
// None is negative: what a negative number is as a uint, Direct3D 9 leaves open.
constexpr double kSource[4] = {2.75, 0, 0.5, 7};

double As(const std::string& scalar, double x) {
  if (scalar == "bool") return x != 0 ? 1 : 0;
  return scalar == "int" || scalar == "uint" ? std::trunc(x) : x;
}

PixelMap RunCells(const std::string& globals, const std::vector<std::vector<std::string>>& rows) {
  std::string text = globals + "float4 PS(float2 p : VPOS) : COLOR {\n  int row = p.y, column = p.x; float4 r = 0;\n";
  std::size_t width = 0;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    text += "  if (row == " + std::to_string(row) + ") {\n";
    for (std::size_t column = 0; column < rows[row].size(); ++column)
      text += "    if (column == " + std::to_string(column) + ") { " + rows[row][column] + " }\n";
    text += "  }\n";
    width = std::max(width, rows[row].size());
  }
  text +=
      "  return r;\n}\ntechnique T < string ColorSpace = \"linear\"; > { pass P { PixelShader = compile ps_3_0 PS(); } "
      "}\n";
  return RunText(text, static_cast<int>(width), static_cast<int>(rows.size()));
}

std::string Sized(const std::string& scalar, int lanes) { return scalar + std::to_string(lanes); }

TEST(ConversionValues, BetweenAllScalarsAndLanes) {
  struct Cell {
    int from, to;
  };
  std::vector<Cell> cells;
  for (int from = 1; from <= 4; ++from) {
    for (int to = 1; to <= (from == 1 ? 4 : from); ++to) cells.push_back({from, to});
  }
  std::vector<std::vector<std::string>> rows;
  std::vector<std::pair<std::string, std::string>> pairs;
  for (const std::string from : kScalars) {
    for (const std::string to : kScalars) {
      pairs.emplace_back(from, to);
      rows.emplace_back();
      for (const Cell& cell : cells) {
        const std::string lanes = std::string("xyzw").substr(0, static_cast<std::size_t>(cell.to));
        const std::string left = Sized(from, cell.from) + " x = v." +
                                 std::string("xyzw").substr(0, static_cast<std::size_t>(cell.from)) + "; ";
        // Assignment, cast, argument and return value in turn.
        const std::size_t kind = (rows.size() + rows.back().size()) % 2;
        rows.back().push_back(left + (kind == 0 ? Sized(to, cell.to) + " y = x; r." + lanes + " = y;"
                                                : "r." + lanes + " = (" + Sized(to, cell.to) + ")x;"));
      }
    }
  }
  const PixelMap pixels = RunCells("float4 v = { 2.75, 0, 0.5, 7 };\n", rows);
  for (std::size_t row = 0; row < rows.size(); ++row) {
    for (std::size_t column = 0; column < cells.size(); ++column) {
      const Cell& cell = cells[column];
      for (int lane = 0; lane < 4; ++lane) {
        const double source = kSource[cell.from == 1 ? 0 : lane];
        const double expected = lane < cell.to ? As(pairs[row].second, As(pairs[row].first, source)) : 0;
        EXPECT_NEAR(pixels.at(static_cast<int>(column), static_cast<int>(row))[static_cast<std::size_t>(lane)],
                    expected, kTolerance)
            << rows[row][column] << ", lane " << lane;
      }
    }
  }
}

TEST(ConversionValues, OfArgumentsAndResults) {
  const std::string globals =
      "float4 v = { 2.75, -1, 0.5, 7 };\n"
      "float One(float x) { return x; } int Whole(float2 x) { return x; } float3 Three(float4 x) { return x; }\n"
      "bool Truth(float x) { return x; } float4 Spread(float x) { return x; } half2 Two(int3 x) { return x; }\n"
      "void OutInt(out int x) { x = 7.9; } void OutWide(out float4 x) { x = float4(1, 2, 3, 4); }\n"
      "void InOut(inout int2 x) { x += 1; } float3x3 Small(float3x3 m) { return m; }\n"
      "float4x4 M = { 1,2,3,4, 5,6,7,8, 9,10,11,12, 13,14,15,16 };\n";
  const std::vector<std::pair<std::string, Rgba>> cases = {
      {"r = float4(One(v), Whole(v), Truth(v.z), Truth(v.y));", {2.75f, 2, 1, 1}},
      {"r.xyz = Three(v); r.w = Spread(v.y).w;", {2.75f, -1, 0.5f, -1}},
      {"r.xy = Two(v); float f; OutInt(f); r.z = f; int i = v.x * 2; r.w = i;", {2, -1, 7, 5}},
      {"float2 t = v.xy; InOut(t); r.xy = t; InOut(r.zw);", {3, 0, 1, 1}},
      {"r = v; OutInt(r.y); OutWide(r.wzyx);", {4, 3, 2, 1}},
      {"float3 t; OutWide(r); t = r; r = t.zyxx;", {3, 2, 1, 1}},
      {"r.xyz = Small(M)[1]; r.w = M;", {5, 6, 7, 1}},
      {"float2 a; float b; float4(a, b, r.w) = v; r.xyz = float3(b, a);", {0.5f, 2.75f, -1, 7}},
      {"float2 a = 1; float2 b = 2; float4(a, b) *= v; r = float4(b, a);", {1, 14, 2.75f, -1}},
      {"float x[4] = (float[4])v; int y[2] = { 1.9, 2 }; r = float4(x[3], x[0], y[0], y[1]);", {7, 2.75f, 1, 2}},
      {"float2x2 m = (float2x2)v; r = float4(m[1], m._m01_m00);", {0.5f, 7, -1, 2.75f}},
      {"float4x4 m = v.x; float3x2 n = (float3x2)M; r = float4(m[1][1], m[0][1], n[2]);", {2.75f, 2.75f, 9, 10}},
      {"r = v > 0 ? true : v; r += (v.x ? 1 : 0);", {2, 0, 2, 2}},
      {"int4 i = v; bool4 b = v; r = i / 2 + b;", {2, 1, 1, 4}},
      {"float f = 1; f /= 4; int i = 7; i /= 2; i *= 1.5; r = float4(f, i, 7 / 2, 7 / 2.0);", {0.25f, 4, 3, 3.5f}},
  };
  std::vector<std::vector<std::string>> rows;
  for (const auto& test : cases) rows.push_back({test.first});
  const PixelMap pixels = RunCells(globals, rows);
  for (std::size_t row = 0; row < cases.size(); ++row)
    EXPECT_TRUE(Near(pixels.at(0, static_cast<int>(row)), cases[row].second, kTolerance)) << cases[row].first;
}

/// HLSL's row-major text of a random matrix, and the matrix.
std::vector<double> RandomMatrix(std::mt19937& random, int count, std::string& text) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i) {
    values.push_back(static_cast<double>(std::uniform_int_distribution<int>(-9, 9)(random)) / 2);
    text += (i > 0 ? ", " : "") + std::to_string(values.back());
  }
  return values;
}

TEST(ConversionValues, OfProductsOfAllShapes) {
  constexpr unsigned kSeed = 20061;
  RecordProperty("seed", static_cast<int>(kSeed));
  std::mt19937 random(kSeed);
  std::vector<std::vector<std::string>> rows;
  std::vector<std::vector<Rgba>> expected;
  for (int r = 1; r <= 4; ++r) {
    for (int c = 1; c <= 4; ++c) {
      std::string m_text, v_text, u_text;
      const auto m = RandomMatrix(random, r * c, m_text);
      const auto v = RandomMatrix(random, r, v_text);  // a row of r
      const auto u = RandomMatrix(random, c, u_text);  // a column of c
      const auto at = [&](int i, int j) { return m[static_cast<std::size_t>(i * c + j)]; };
      const std::string shape = "float" + std::to_string(r) + "x" + std::to_string(c) + " m = { " + m_text + " }; ";
      const std::string xyzw = "xyzw";
      const auto lanes = [&](int n) { return xyzw.substr(0, static_cast<std::size_t>(n)); };
      rows.push_back({shape + "float" + std::to_string(r) + " v = { " + v_text + " }; r." + lanes(c) + " = mul(v, m);",
                      shape + "float" + std::to_string(c) + " u = { " + u_text + " }; r." + lanes(r) + " = mul(m, u);",
                      shape + "r." + lanes(r) + " = transpose(m)[" + std::to_string(c - 1) + "];",
                      shape + "r." + lanes(c) + " = mul(m, transpose(m))[0][0] * m[" + std::to_string(r - 1) + "];",
                      shape + "m = m * 2 + m / 2 - 1; r.x = m[" + std::to_string(r - 1) + "][" + std::to_string(c - 1) +
                          "]; r.y = m._" + std::to_string(r) + std::to_string(c) + ";"});
      Rgba row{}, column{}, last{}, scaled{}, changed{};
      double square = 0;
      for (int j = 0; j < c; ++j) square += at(0, j) * at(0, j);
      for (int j = 0; j < c; ++j) {
        for (int i = 0; i < r; ++i)
          row[static_cast<std::size_t>(j)] += static_cast<float>(v[static_cast<std::size_t>(i)] * at(i, j));
        scaled[static_cast<std::size_t>(j)] = static_cast<float>(square * at(r - 1, j));
      }
      for (int i = 0; i < r; ++i) {
        for (int j = 0; j < c; ++j)
          column[static_cast<std::size_t>(i)] += static_cast<float>(u[static_cast<std::size_t>(j)] * at(i, j));
        last[static_cast<std::size_t>(i)] = static_cast<float>(at(i, c - 1));
      }
      changed[0] = changed[1] = static_cast<float>(at(r - 1, c - 1) * 2.5 - 1);
      expected.push_back({row, column, last, scaled, changed});
    }
  }
  const PixelMap pixels = RunCells("", rows);
  for (std::size_t row = 0; row < rows.size(); ++row) {
    for (std::size_t column = 0; column < rows[row].size(); ++column) {
      EXPECT_TRUE(Near(pixels.at(static_cast<int>(column), static_cast<int>(row)), expected[row][column], kTolerance))
          << rows[row][column] << " (seed " << kSeed << ")";
    }
  }
}

}  // namespace
}  // namespace burin::effect
