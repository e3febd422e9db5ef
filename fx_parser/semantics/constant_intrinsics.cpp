// SPDX-License-Identifier: Apache-2.0
// Intrinsics over constants, with the arithmetic that Direct3D 9 hardware has (pow, log and roots act on |x|).
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numbers>
#include <string_view>

#include "fx_parser/semantics/constant.h"
#include "fx_parser/semantics/intrinsics.h"

namespace burin::fx {
namespace {

constexpr double kLargest = std::numeric_limits<float>::max();

using Components = std::vector<double>;
using Componentwise = double (*)(double, double, double);
using Geometric = std::function<Components(const std::vector<Value>&)>;

double Log2(double x) { return x == 0 ? -kLargest : std::log2(std::fabs(x)); }
double Saturate(double x) { return x > 0 ? std::min(x, 1.0) : 0.0; }
double Dot(const Components& a, const Components& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

const std::map<std::string_view, Componentwise>& ComponentwiseTable() {
  static const std::map<std::string_view, Componentwise> table = {
      {"abs", [](double x, double, double) { return std::fabs(x); }},
      {"acos", [](double x, double, double) { return std::acos(x); }},
      {"asin", [](double x, double, double) { return std::asin(x); }},
      {"atan", [](double x, double, double) { return std::atan(x); }},
      {"atan2", [](double y, double x, double) { return std::atan2(y, x); }},
      {"ceil", [](double x, double, double) { return std::ceil(x); }},
      {"clamp", [](double x, double low, double high) { return std::min(std::max(x, low), high); }},
      {"cos", [](double x, double, double) { return std::cos(x); }},
      {"cosh", [](double x, double, double) { return std::cosh(x); }},
      {"degrees", [](double x, double, double) { return x * 180 / std::numbers::pi; }},
      {"exp", [](double x, double, double) { return std::exp(x); }},
      {"exp2", [](double x, double, double) { return std::exp2(x); }},
      {"floor", [](double x, double, double) { return std::floor(x); }},
      {"fmod", [](double x, double y, double) { return std::fmod(x, y); }},
      {"frac", [](double x, double, double) { return x - std::floor(x); }},
      {"isfinite", [](double x, double, double) { return std::isfinite(x) ? 1.0 : 0.0; }},
      {"isinf", [](double x, double, double) { return std::isinf(x) ? 1.0 : 0.0; }},
      {"isnan", [](double x, double, double) { return std::isnan(x) ? 1.0 : 0.0; }},
      {"ldexp", [](double x, double e, double) { return x * std::exp2(e); }},
      {"lerp", [](double a, double b, double t) { return a * (1 - t) + b * t; }},
      {"log", [](double x, double, double) { return Log2(x) * std::numbers::ln2; }},
      {"log10", [](double x, double, double) { return Log2(x) * std::numbers::ln2 / std::numbers::ln10; }},
      {"log2", [](double x, double, double) { return Log2(x); }},
      {"mad", [](double a, double b, double c) { return a * b + c; }},
      {"max", [](double a, double b, double) { return std::max(a, b); }},
      {"min", [](double a, double b, double) { return std::min(a, b); }},
      {"pow", [](double x, double y, double) { return y == 0 ? 1.0 : std::pow(std::fabs(x), y); }},
      {"radians", [](double x, double, double) { return x * std::numbers::pi / 180; }},
      {"rcp", [](double x, double, double) { return x == 0 ? kLargest : 1 / x; }},
      {"round", [](double x, double, double) { return std::floor(x + 0.5); }},
      {"rsqrt", [](double x, double, double) { return x == 0 ? kLargest : 1 / std::sqrt(std::fabs(x)); }},
      {"saturate", [](double x, double, double) { return Saturate(x); }},
      {"sign", [](double x, double, double) { return x > 0   ? 1.0
                                                     : x < 0 ? -1.0
                                                             : 0.0; }},
      {"sin", [](double x, double, double) { return std::sin(x); }},
      {"sinh", [](double x, double, double) { return std::sinh(x); }},
      {"smoothstep",
       [](double a, double b, double x) {
         const double t = Saturate(a == b ? (x - a) * kLargest : (x - a) / (b - a));
         return t * t * (3 - 2 * t);
       }},
      {"sqrt", [](double x, double, double) { return std::sqrt(std::fabs(x)); }},
      {"step", [](double a, double x, double) { return x >= a ? 1.0 : 0.0; }},
      {"tan", [](double x, double, double) { return std::tan(x); }},
      {"tanh", [](double x, double, double) { return std::tanh(x); }},
      {"trunc", [](double x, double, double) { return std::trunc(x); }},
  };
  return table;
}

Components Mul(const std::vector<Value>& a) {
  const Type& left = a[0].type;
  const Type& right = a[1].type;
  const Components& x = a[0].numbers;
  const Components& y = a[1].numbers;
  const auto is_scalar = [](const Type& t) { return !t.is_vector && !t.is_matrix; };
  if (is_scalar(left) || is_scalar(right)) {
    Components result = is_scalar(left) ? y : x;
    for (double& c : result) c *= is_scalar(left) ? x[0] : y[0];
    return result;
  }
  const std::size_t rows = left.is_matrix ? left.rows : 1;
  const std::size_t inner = left.columns;
  const std::size_t columns = right.is_matrix ? right.columns : 1;
  Components result(rows * columns);
  for (std::size_t r = 0; r < rows; ++r) {
    for (std::size_t c = 0; c < columns; ++c) {
      for (std::size_t k = 0; k < inner; ++k) result[r * columns + c] += x[r * inner + k] * y[k * columns + c];
    }
  }
  return result;
}

Components Transpose(const std::vector<Value>& a) {
  const Type& type = a[0].type;
  Components result;
  for (std::size_t c = 0; c < type.columns; ++c) {
    for (std::size_t r = 0; r < type.rows; ++r) result.push_back(a[0].numbers[r * type.columns + c]);
  }
  return result;
}

double Determinant(const Components& m, std::size_t n) {
  if (n == 1) return m[0];
  double sum = 0;
  for (std::size_t skip = 0; skip < n; ++skip) {
    Components minor;
    for (std::size_t r = 1; r < n; ++r) {
      for (std::size_t c = 0; c < n; ++c) {
        if (c != skip) minor.push_back(m[r * n + c]);
      }
    }
    sum += (skip % 2 == 0 ? 1 : -1) * m[skip] * Determinant(minor, n - 1);
  }
  return sum;
}

Components Refract(const std::vector<Value>& a) {
  const Components& i = a[0].numbers;
  const Components& n = a[1].numbers;
  const double eta = a[2].numbers[0];
  const double d = Dot(n, i);
  const double k = 1 - eta * eta * (1 - d * d);
  Components result(i.size());
  if (k < 0) return result;
  for (std::size_t c = 0; c < i.size(); ++c) result[c] = eta * i[c] - (eta * d + std::sqrt(k)) * n[c];
  return result;
}

const std::map<std::string_view, Geometric>& GeometricTable() {
  using V = const std::vector<Value>&;
  static const std::map<std::string_view, Geometric> table = {
      {"all",
       [](V a) -> Components {
         return {std::ranges::all_of(a[0].numbers, [](double x) { return x != 0; }) ? 1.0 : 0.0};
       }},
      {"any",
       [](V a) -> Components {
         return {std::ranges::any_of(a[0].numbers, [](double x) { return x != 0; }) ? 1.0 : 0.0};
       }},
      {"cross",
       [](V a) -> Components {
         const Components& x = a[0].numbers;
         const Components& y = a[1].numbers;
         return {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
       }},
      {"D3DCOLORtoUBYTE4",
       [](V a) -> Components {
         const Components& c = a[0].numbers;
         return {std::trunc(c[2] * 255.002), std::trunc(c[1] * 255.002), std::trunc(c[0] * 255.002),
                 std::trunc(c[3] * 255.002)};
       }},
      {"determinant", [](V a) -> Components { return {Determinant(a[0].numbers, a[0].type.rows)}; }},
      {"distance",
       [](V a) -> Components {
         Components d = a[0].numbers;
         for (std::size_t i = 0; i < d.size(); ++i) d[i] -= a[1].numbers[i];
         return {std::sqrt(Dot(d, d))};
       }},
      {"dot", [](V a) -> Components { return {Dot(a[0].numbers, a[1].numbers)}; }},
      {"dst",
       [](V a) -> Components {
         return {1, a[0].numbers[1] * a[1].numbers[1], a[0].numbers[2], a[1].numbers[3]};
       }},
      {"faceforward",
       [](V a) {
         Components n = a[0].numbers;
         if (!(Dot(a[1].numbers, a[2].numbers) < 0)) {
           for (double& x : n) x = -x;
         }
         return n;
       }},
      {"length", [](V a) -> Components { return {std::sqrt(Dot(a[0].numbers, a[0].numbers))}; }},
      {"lit",
       [](V a) -> Components {
         const double l = a[0].numbers[0], h = a[1].numbers[0], m = a[2].numbers[0];
         return {1, std::max(l, 0.0), l < 0 || h < 0 ? 0 : std::pow(h, m), 1};
       }},
      {"mul", Mul},
      {"normalize",
       [](V a) {
         Components v = a[0].numbers;
         const double length = std::sqrt(Dot(v, v));
         for (double& x : v) x = length == 0 ? 0 : x / length;
         return v;
       }},
      {"reflect",
       [](V a) {
         Components i = a[0].numbers;
         const double d = Dot(i, a[1].numbers);
         for (std::size_t c = 0; c < i.size(); ++c) i[c] -= 2 * d * a[1].numbers[c];
         return i;
       }},
      {"refract", Refract},
      {"transpose", Transpose},
  };
  return table;
}

}  // namespace

std::optional<Value> EvaluateIntrinsic(int intrinsic, const std::vector<Value>& arguments, const Type& result) {
  const std::string_view name = Intrinsics()[static_cast<std::size_t>(intrinsic)].name;
  Value value{result, {}, {}};
  if (const auto geometric = GeometricTable().find(name); geometric != GeometricTable().end()) {
    value.numbers = geometric->second(arguments);
  } else if (const auto componentwise = ComponentwiseTable().find(name); componentwise != ComponentwiseTable().end()) {
    for (std::size_t i = 0; i < arguments[0].numbers.size(); ++i) {
      const auto at = [&](std::size_t k) { return k < arguments.size() ? arguments[k].numbers[i] : 0.0; };
      value.numbers.push_back(componentwise->second(at(0), at(1), at(2)));
    }
  } else {
    return std::nullopt;
  }
  for (double& number : value.numbers) number = RoundToScalar(number, result.scalar);
  return value;
}

}  // namespace burin::fx
