// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "tests/bench/edge_quality/bench_scenes.h"
#include "tests/bench/edge_quality/measures.h"

namespace burin::bench {
namespace {

constexpr int kAngles = 12;  // over half a turn
constexpr int kPlaces = 8;   // of each, within a pixel
constexpr int kMargin = 16;  // pixels at the frame's sides that don't count
constexpr double kPi = 3.141592653589793;

/// One unit is half of the frame.
scene::View FrontView() {
  scene::View view;
  view.view_from_world = glm::translate(glm::mat4(1.0f), glm::vec3(0, 0, -5));
  view.clip_from_view = glm::orthoRH_ZO(-1.0f, 1.0f, -1.0f, 1.0f, 1.0f, 10.0f);
  view.orthographic = true;
  view.znear = 1.0f;
  view.zfar = 10.0f;
  return view;
}

struct Errors {
  double sum = 0.0;
  double absolute = 0.0;
  int columns = 0;
};

/// Adds the error of each column (row of a steep edge). `offset`: how far the white reaches past the middle, pixels.
void AddErrors(const Picture& picture, double angle_rad, double offset, Errors& errors) {
  const double c = std::cos(angle_rad);
  const double s = std::sin(angle_rad);
  const bool is_steep = std::abs(s) > std::abs(c);
  const double scale = is_steep ? std::abs(s) : std::abs(c);  // from along the column to perpendicular to the edge
  const int size = picture.width;
  for (int k = kMargin; k < size - kMargin; ++k) {
    double covered = 0.0;
    for (int i = 0; i < size; ++i) {
      const int x = is_steep ? i : k;
      const int y = is_steep ? k : i;
      covered += picture.rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(size) + x)];
    }
    // White is where s * x - c * y + offset > 0, x right and y up from the middle.
    const double along = is_steep ? 0.5 * size - (k + 0.5) : k + 0.5 - 0.5 * size;
    const double edge = is_steep ? (c * along - offset) / s : (s * along + offset) / c;
    const bool is_beyond = is_steep ? s > 0 : c < 0;  // white is at the larger coordinate
    const double length = is_beyond ? 0.5 * size - edge : 0.5 * size + edge;
    const double error = (covered - std::clamp(length, 0.0, static_cast<double>(size))) * scale;
    errors.sum += error;
    errors.absolute += std::abs(error);
    ++errors.columns;
  }
}

}  // namespace

std::vector<Figure> Bloat(const std::vector<Method>& methods, int size) {
  std::vector<Errors> errors(methods.size());
  for (int a = 0; a < kAngles; ++a) {
    const double angle_rad = kPi * a / kAngles;
    for (int p = 0; p < kPlaces; ++p) {
      const double offset = (p + 0.5) / kPlaces - 0.5;  // symmetric: a method's rounding up and down cancels
      Stand stand(HalfPlane(angle_rad, 2.0 * offset / size), size, FrontView());
      for (std::size_t m = 0; m < methods.size(); ++m) {
        AddErrors(stand.Render(methods[m], {}), angle_rad, offset, errors[m]);
      }
    }
  }
  std::vector<Figure> figures;
  for (std::size_t m = 0; m < methods.size(); ++m) {
    figures.push_back({"bloat", methods[m].name, errors[m].sum / errors[m].columns});
    figures.push_back({"bloat abs", methods[m].name, errors[m].absolute / errors[m].columns});
  }
  return figures;
}

}  // namespace burin::bench
