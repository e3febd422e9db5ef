// SPDX-License-Identifier: Apache-2.0
// Every intrinsic over every number of lanes, by value: a row of pixels for each function and number of lanes, a column
// for each set of arguments, all in a few renders. What is expected is computed here, in double precision, from the
// definitions in the HLSL documentation with Direct3D 9's rules for edges.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "tests/gl/effect/effect_fixture.h"

namespace burin::effect {
namespace {

/// Of functions that devices approximate, by the result's size.
constexpr double kApproximate = 2e-4;
constexpr double kExact = 1e-6;
constexpr int kColumns = 16;

// Signs, zeros of both signs, halves, whole numbers, small and large ones.
constexpr double kA[kColumns] = {-2.5, -1, -0.5, -0.0, 0, 0.25, 0.5, 1, 1.5, 2, 3, 64, 0.001, -100, 0.75, -7.75};
constexpr double kB[kColumns] = {2, -3, 0.5, 1, 2, -0.25, 3, 1, -1.5, 0.5, 2, 1.25, -1, 7, 0.125, 2};
constexpr double kC[kColumns] = {0.5, 2, 3, 4, -1, 0.75, 4, 2, 0, 1, 0.25, 80, 1, 8, 1, 0};

/// Lane `lane` of column `column` takes the values of another column, so that no two lanes are alike.
int Source(int column, int lane) { return (column + 5 * lane) % kColumns; }

std::string Table(const char* name, const double* values) {
  std::string text = "static const float4 " + std::string(name) + "[16] = {";
  for (int column = 0; column < kColumns; ++column) {
    for (int lane = 0; lane < 4; ++lane)
      text += (column + lane > 0 ? ", " : "") + std::to_string(values[Source(column, lane)]);
  }
  return text + "};\n";
}

const std::string& Tables() {
  static const std::string text = Table("A", kA) + Table("B", kB) + Table("C", kC);
  return text;
}

std::string Swizzle(int lanes) { return std::string("xyzw").substr(0, static_cast<std::size_t>(lanes)); }

/// An effect whose row r runs `rows[r]`, statements that may read a, b and c and set r.
PixelMap RunRows(const std::vector<std::string>& rows, const std::string& globals = {}) {
  std::string text = Tables() + globals + "float4 PS(float2 p : VPOS) : COLOR {\n  int row = p.y; int column = p.x;\n" +
                     "  float4 a = A[column], b = B[column], c = C[column], r = 0;\n";
  for (std::size_t i = 0; i < rows.size(); ++i)
    text += "  " + std::string(i > 0 ? "else " : "") + "if (row == " + std::to_string(i) + ") { " + rows[i] + " }\n";
  text +=
      "  return r;\n}\ntechnique T < string ColorSpace = \"linear\"; > { pass P { PixelShader = compile ps_3_0 PS(); } "
      "}\n";
  return RunText(text, kColumns, static_cast<int>(rows.size()));
}

using Function = std::function<double(double, double, double)>;
struct Case {
  std::string call;  ///< with $: the lanes' swizzle
  Function expected;
  double tolerance = kApproximate;
};

double Clamp01(double x) { return std::isnan(x) ? 0 : std::min(std::max(x, 0.0), 1.0); }

/// Rows for one to four lanes each; undefined or overflowing results are not compared.
void Compare(const std::vector<Case>& cases) {
  std::vector<std::string> rows;
  for (const Case& test : cases) {
    for (int lanes = 1; lanes <= 4; ++lanes) {
      std::string row;
      for (const char c : test.call)
        row += c == '$' ? Swizzle(lanes) : c == '#' ? std::to_string(lanes) : std::string(1, c);
      rows.push_back(row);
    }
  }
  const PixelMap pixels = RunRows(rows);
  ASSERT_EQ(pixels.pixels.size(), rows.size() * kColumns);
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const Case& test = cases[row / 4];
    const int lanes = static_cast<int>(row % 4) + 1;
    for (int column = 0; column < kColumns; ++column) {
      const Rgba& pixel = pixels.at(column, static_cast<int>(row));
      for (int lane = 0; lane < 4; ++lane) {
        const int from = Source(column, lane);
        const double expected = lane < lanes ? test.expected(kA[from], kB[from], kC[from]) : 0;
        if (!std::isfinite(expected) || std::abs(expected) > 1e30) continue;
        const double error = std::abs(pixel[static_cast<std::size_t>(lane)] - expected);
        EXPECT_LE(error, test.tolerance * std::max(1.0, std::abs(expected)))
            << rows[row] << " with " << kA[from] << ", " << kB[from] << ", " << kC[from] << " is "
            << pixel[static_cast<std::size_t>(lane)] << ", not " << expected;
      }
    }
  }
}

Case Unary(const std::string& name, double (*f)(double), double tolerance = kApproximate) {
  return {"r.$ = " + name + "(a.$);", [f](double a, double, double) { return f(a); }, tolerance};
}

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

TEST(IntrinsicValues, OfOneArgument) {
  Compare({
      Unary(
          "abs", [](double x) { return std::abs(x); }, kExact),
      Unary(
          "ceil", [](double x) { return std::ceil(x); }, kExact),
      Unary(
          "floor", [](double x) { return std::floor(x); }, kExact),
      Unary(
          "frac", [](double x) { return x - std::floor(x); }, kExact),
      Unary(
          "round", [](double x) { return std::floor(x + 0.5); }, kExact),
      Unary(
          "trunc", [](double x) { return std::trunc(x); }, kExact),
      Unary(
          "saturate", [](double x) { return Clamp01(x); }, kExact),
      Unary(
          "sign", [](double x) { return x > 0   ? 1.0
                                        : x < 0 ? -1.0
                                                : 0.0; }, kExact),
      Unary(
          "degrees", [](double x) { return x * 180 / M_PI; }, 1e-5),
      Unary(
          "radians", [](double x) { return x * M_PI / 180; }, 1e-5),
      Unary("rcp", [](double x) { return x == 0 ? kNone : 1 / x; }),
      Unary(
          "isnan", [](double) { return 0.0; }, kExact),
      Unary(
          "isinf", [](double) { return 0.0; }, kExact),
      Unary(
          "isfinite", [](double) { return 1.0; }, kExact),
  });
}

TEST(IntrinsicValues, OfTranscendentalFunctions) {
  Compare({
      Unary("sin", [](double x) { return std::sin(x); }),
      Unary("cos", [](double x) { return std::cos(x); }),
      Unary("tan", [](double x) { return std::tan(x); }),
      Unary(
          "asin", [](double x) { return std::abs(x) > 1 ? kNone : std::asin(x); }, 1e-3),
      Unary(
          "acos", [](double x) { return std::abs(x) > 1 ? kNone : std::acos(x); }, 1e-3),
      Unary("atan", [](double x) { return std::atan(x); }),
      Unary("sinh", [](double x) { return std::sinh(x); }),
      Unary("cosh", [](double x) { return std::cosh(x); }),
      Unary("tanh", [](double x) { return std::abs(x) > 10 ? kNone : std::tanh(x); }),
      Unary("exp", [](double x) { return std::exp(x); }),
      Unary("exp2", [](double x) { return std::exp2(x); }),
      // Of the absolute value, as on hardware; of 0 something large.
      Unary("log", [](double x) { return x == 0 ? kNone : std::log(std::abs(x)); }),
      Unary("log2", [](double x) { return x == 0 ? kNone : std::log2(std::abs(x)); }),
      Unary("log10", [](double x) { return x == 0 ? kNone : std::log10(std::abs(x)); }),
      Unary("sqrt", [](double x) { return std::sqrt(std::abs(x)); }),
      Unary("rsqrt", [](double x) { return x == 0 ? kNone : 1 / std::sqrt(std::abs(x)); }),
  });
}

TEST(IntrinsicValues, OfTwoAndThreeArguments) {
  Compare({
      {"r.$ = max(a.$, b.$);", [](double a, double b, double) { return std::max(a, b); }, kExact},
      {"r.$ = min(a.$, b.$);", [](double a, double b, double) { return std::min(a, b); }, kExact},
      {"r.$ = step(a.$, b.$);", [](double a, double b, double) { return b >= a ? 1.0 : 0.0; }, kExact},
      {"r.$ = fmod(a.$, b.$);", [](double a, double b, double) { return std::fmod(a, b); }, 1e-5},
      {"r.$ = a.$ % b.$;", [](double a, double b, double) { return std::fmod(a, b); }, 1e-5},
      {"r.$ = atan2(a.$, b.$);", [](double a, double b, double) { return std::atan2(a == 0 ? 0.0 : a, b); }, 1e-3},
      {"r.$ = pow(a.$, b.$);", [](double a, double b, double) { return a == 0 ? kNone : std::pow(std::abs(a), b); }},
      {"r.$ = ldexp(a.$, b.$);", [](double a, double b, double) { return a * std::exp2(b); }},
      {"r.$ = mad(a.$, b.$, c.$);", [](double a, double b, double c) { return a * b + c; }, 1e-5},
      {"r.$ = lerp(a.$, b.$, c.$);", [](double a, double b, double c) { return a + (b - a) * c; }, 1e-5},
      {"r.$ = lerp(a.$, b.$, 0.25);", [](double a, double b, double) { return a + (b - a) * 0.25; }, 1e-5},
      {"r.$ = clamp(a.$, b.$, c.$);", [](double a, double b, double c) { return std::min(std::max(a, b), c); }, kExact},
      {"r.$ = clamp(a.$, 0, 1);", [](double a, double, double) { return Clamp01(a); }, kExact},
      {"r.$ = max(a.$, 0);", [](double a, double, double) { return std::max(a, 0.0); }, kExact},
      {"r.$ = smoothstep(b.$, c.$, a.$);",
       [](double a, double b, double c) {
         if (b == c) return kNone;
         const double t = Clamp01((a - b) / (c - b));
         return t * t * (3 - 2 * t);
       }},
  });
}

TEST(IntrinsicValues, OfOutArguments) {
  Compare({
      {"float# w; modf(a.$, w); r.$ = w;", [](double a, double, double) { return std::trunc(a); }, kExact},
      {"float# w; r.$ = modf(a.$, w);", [](double a, double, double) { return a - std::trunc(a); }, kExact},
      {"int# w; modf(a.$, w); r.$ = w;", [](double a, double, double) { return std::trunc(a); }, kExact},
      {"float# w; r.$ = frexp(a.$, w);",
       [](double a, double, double) {
         int exponent = 0;
         return std::frexp(a, &exponent);
       }},
      {"float# w; frexp(a.$, w); r.$ = w;",
       [](double a, double, double) {
         int exponent = 0;
         std::frexp(a, &exponent);
         return double{static_cast<double>(exponent)};
       },
       kExact},
      {"float# s, k; sincos(a.$, s, k); r.$ = s;", [](double a, double, double) { return std::sin(a); }},
      {"half# s, k; sincos(a.$, s, k); r.$ = k;", [](double a, double, double) { return std::cos(a); }},
  });
}

TEST(IntrinsicValues, OfIntegersAndBools) {
  const auto whole = [](double x) { return std::trunc(x); };
  Compare({
      {"r.$ = abs((int#)a.$);", [=](double a, double, double) { return std::abs(whole(a)); }, kExact},
      {"r.$ = max((int#)a.$, (int#)b.$);", [=](double a, double b, double) { return std::max(whole(a), whole(b)); },
       kExact},
      {"r.$ = min((int#)a.$, 1);", [=](double a, double, double) { return std::min(whole(a), 1.0); }, kExact},
      {"r.$ = clamp((int#)a.$, -1, 2);",
       [=](double a, double, double) { return std::min(std::max(whole(a), -1.0), 2.0); }, kExact},
      {"r.$ = sign((int#)a.$);",
       [=](double a, double, double) { return whole(a) > 0   ? 1.0
                                              : whole(a) < 0 ? -1.0
                                                             : 0.0; }, kExact},
      {"r.$ = mad((int#)a.$, 2, 1);", [=](double a, double, double) { return whole(a) * 2 + 1; }, kExact},
      {"r.$ = saturate((int#)a.$);", [=](double a, double, double) { return Clamp01(whole(a)); }, kExact},
      {"r.$ = sqrt((int#)a.$);", [=](double a, double, double) { return std::sqrt(std::abs(whole(a))); }},
      {"r.$ = lerp((int#)a.$, 2, 0.5);", [=](double a, double, double) { return whole(a) + (2 - whole(a)) * 0.5; },
       kExact},
      {"r.$ = max(a.$ > 0, b.$);", [](double a, double b, double) { return std::max(a > 0 ? 1.0 : 0.0, b); }, kExact},
      {"r.$ = abs(a.$ > 0);", [](double a, double, double) { return a > 0 ? 1.0 : 0.0; }, kExact},
      {"r.$ = max((uint#)abs(a.$), 2);", [=](double a, double, double) { return std::max(whole(std::abs(a)), 2.0); },
       kExact},
      {"r.$ = asfloat(asint(a.$));", [](double a, double, double) { return a; }, kExact},
      {"r.$ = asfloat(asuint(a.$) & 0x7fffffff);", [](double a, double, double) { return std::abs(a); }, kExact},
  });
}

TEST(IntrinsicValues, OfOperators) {
  const auto whole = [](double x) { return std::trunc(x); };
  Compare({
      {"r.$ = a.$ + b.$ * c.$ - b.$;", [](double a, double b, double c) { return a + b * c - b; }, 1e-5},
      {"r.$ = a.$ / b.$;", [](double a, double b, double) { return a / b; }, 1e-5},
      {"r.$ = (int#)a.$ / (int#)c.$;",
       [=](double a, double, double c) { return whole(c) == 0 ? kNone : whole(whole(a) / whole(c)); }, kExact},
      {"r.$ = (int#)a.$ % (int#)c.$;",
       [=](double a, double, double c) { return whole(c) == 0 ? kNone : std::fmod(whole(a), whole(c)); }, kExact},
      {"r.$ = a.$ < b.$;", [](double a, double b, double) { return a < b ? 1.0 : 0.0; }, kExact},
      {"r.$ = (a.$ >= b.$) + 2 * (a.$ == b.$) + 4 * (a.$ != 0);",
       [](double a, double b, double) { return (a >= b ? 1.0 : 0) + (a == b ? 2 : 0) + (a != 0 ? 4 : 0); }, kExact},
      {"r.$ = a.$ && b.$ > 0;", [](double a, double b, double) { return a != 0 && b > 0 ? 1.0 : 0.0; }, kExact},
      {"r.$ = a.$ > 0 || c.$;", [](double a, double, double c) { return a > 0 || c != 0 ? 1.0 : 0.0; }, kExact},
      {"r.$ = !a.$;", [](double a, double, double) { return a == 0 ? 1.0 : 0.0; }, kExact},
      {"r.$ = a.$ > b.$ ? a.$ : c.$;", [](double a, double b, double c) { return a > b ? a : c; }, kExact},
      {"r.$ = a.$ ? 1 : b.$;", [](double a, double b, double) { return a != 0 ? 1 : b; }, kExact},
      {"r.$ = ((int#)a.$ << 2) + ((int#)c.$ & 5) + ((int#)c.$ ^ 3) + ~(int#)a.$;",
       [=](double a, double, double c) {
         const int i = static_cast<int>(whole(a)), k = static_cast<int>(whole(c));
         return double{static_cast<double>(i * 4 + (k & 5) + (k ^ 3) + ~i)};
       },
       kExact},
      {"float# x = a.$; x += b.$; x *= 2; x -= c.$; x /= 4; r.$ = x++ + x--;",
       [](double a, double b, double c) { return 2 * (((a + b) * 2 - c) / 4) + 1; }, 1e-5},
      {"int# x = a.$; x += b.$; x *= 1.5; r.$ = x;",
       [=](double a, double b, double) { return whole(whole(whole(a) + b) * 1.5); }, kExact},
  });
}

using Vector = std::vector<double>;
double Dot(const Vector& x, const Vector& y) {
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += x[i] * y[i];
  return sum;
}
Vector Scaled(const Vector& x, double k) {
  Vector result = x;
  for (double& value : result) value *= k;
  return result;
}
Vector Plus(const Vector& x, const Vector& y) {
  Vector result = x;
  for (std::size_t i = 0; i < x.size(); ++i) result[i] += y[i];
  return result;
}
Vector Unit(const Vector& x) { return Scaled(x, Dot(x, x) > 0 ? 1 / std::sqrt(Dot(x, x)) : 0); }

struct Geometric {
  std::string call;
  std::function<Vector(const Vector&, const Vector&, const Vector&)> expected;
};

TEST(IntrinsicValues, OfVectors) {
  const std::vector<Geometric> cases = {
      {"r = dot(a.$, b.$);", [](auto& a, auto& b, auto&) { return Vector(4, Dot(a, b)); }},
      {"r = length(a.$);", [](auto& a, auto&, auto&) { return Vector(4, std::sqrt(Dot(a, a))); }},
      {"r = distance(a.$, b.$);",
       [](auto& a, auto& b, auto&) {
         const Vector d = Plus(a, Scaled(b, -1));
         return Vector(4, std::sqrt(Dot(d, d)));
       }},
      {"r.$ = normalize(a.$);", [](auto& a, auto&, auto&) { return Unit(a); }},
      {"r.$ = reflect(a.$, b.$);", [](auto& a, auto& b, auto&) { return Plus(a, Scaled(b, -2 * Dot(a, b))); }},
      {"r.$ = faceforward(a.$, b.$, c.$);",
       [](auto& a, auto& b, auto& c) { return Scaled(a, Dot(b, c) < 0 ? 1 : -1); }},
      {"r.$ = refract(normalize(a.$), normalize(b.$), 0.75);",
       [](auto& a, auto& b, auto&) {
         const Vector i = Unit(a), n = Unit(b);
         const double d = Dot(n, i), k = 1 - 0.75 * 0.75 * (1 - d * d);
         return k < 0 ? Vector(a.size()) : Plus(Scaled(i, 0.75), Scaled(n, -(0.75 * d + std::sqrt(k))));
       }},
      {"r = all(a.$);",
       [](auto& a, auto&, auto&) {
         return Vector(4, std::ranges::all_of(a, [](double x) { return x != 0; }) ? 1 : 0);
       }},
      {"r = any(a.$ > 1);",
       [](auto& a, auto&, auto&) { return Vector(4, std::ranges::any_of(a, [](double x) { return x > 1; }) ? 1 : 0); }},
  };
  std::vector<std::string> rows;
  for (const Geometric& test : cases) {
    for (int lanes = 1; lanes <= 4; ++lanes) {
      std::string row;
      for (const char c : test.call) row += c == '$' ? Swizzle(lanes) : std::string(1, c);
      rows.push_back(row);
    }
  }
  rows.emplace_back("r.xyz = cross(a.xyz, b.xyz);");
  rows.emplace_back("r = lit(a.x, b.x, c.x);");
  rows.emplace_back("r = dst(a, b);");
  rows.emplace_back("r = D3DCOLORtoUBYTE4(saturate(a));");
  const PixelMap pixels = RunRows(rows);
  const auto expect = [&](int column, std::size_t row, const Vector& expected) {
    for (std::size_t lane = 0; lane < 4; ++lane) {
      const double wanted = lane < expected.size() ? expected[lane] : 0;
      if (!std::isfinite(wanted)) continue;
      EXPECT_NEAR(pixels.at(column, static_cast<int>(row))[lane], wanted,
                  kApproximate * std::max(1.0, std::abs(wanted)))
          << rows[row] << ", column " << column;
    }
  };
  for (int column = 0; column < kColumns; ++column) {
    const auto take = [&](const double* values, int lanes) {
      Vector result;
      for (int lane = 0; lane < lanes; ++lane) result.push_back(values[Source(column, lane)]);
      return result;
    };
    for (std::size_t row = 0; row < cases.size() * 4; ++row) {
      const int lanes = static_cast<int>(row % 4) + 1;
      expect(column, row, cases[row / 4].expected(take(kA, lanes), take(kB, lanes), take(kC, lanes)));
    }
    const Vector a = take(kA, 4), b = take(kB, 4), c = take(kC, 4);
    const std::size_t row = cases.size() * 4;
    expect(column, row, {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]});
    expect(column, row + 1,
           {1, std::max(a[0], 0.0),
            a[0] < 0 || b[0] < 0 ? 0
            : b[0] == 0          ? kNone
                                 : std::pow(b[0], c[0]),
            1});
    expect(column, row + 2, {1, a[1] * b[1], a[2], b[3]});
    const auto byte = [](double x) { return std::trunc(Clamp01(x) * 255.002); };
    expect(column, row + 3, {byte(a[2]), byte(a[1]), byte(a[0]), byte(a[3])});
  }
}

}  // namespace
}  // namespace burin::effect
