// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <deque>
#include <functional>

#include "tests/bench/edge_quality/edge_mask.h"
#include "tests/bench/edge_quality/measures.h"

namespace burin::bench {
namespace {

constexpr double kStep = 0.05;        // pixels a frame
constexpr int kStepsAPixel = 20;      // 1 / kStep
constexpr int kFramesAMask = 20;      // a mask is right to half a pixel for so many
constexpr double kTurnRadius = 0.4;   // of the frame's width: about what lies nearest to the camera has from the axis
constexpr double kRollRadius = 0.35;  // of the frame's width: about what the outlines have from the roll's pivot
constexpr double kRadian_deg = 57.29577951308232;

/// The references of a pan. Sliding the picture by whole strips of 0.05 pixels, a frame's box filter is the union of
/// 20 of them, and the next frame's shares 19: each strip is rendered once, with samples spread over it on no grid.
class PanReference {
 public:
  PanReference(Stand& stand, const Method& plain, int samples)
      : stand_(stand),
        plain_(plain),
        per_strip_(std::max(1, samples / kStepsAPixel)),
        mean_(stand.size(), stand.size()) {}

  Picture Next() {
    while (strips_.size() < kStepsAPixel) AddStrip();
    std::vector<float> sum(strips_.front().size(), 0.0f);
    for (const std::vector<float>& strip : strips_) {
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += strip[i];
    }
    for (float& x : sum) x /= kStepsAPixel;
    strips_.pop_front();
    return ToPicture(std::move(sum), stand_.size());
  }

 private:
  void AddStrip() {
    mean_.Clear();
    for (int i = 0; i < per_strip_; ++i) {
      const glm::dvec2 point = R2(next_ * per_strip_ + i);
      stand_.AddSample(plain_, {0.0, {-0.5 + kStep * (next_ + point.x + 0.5), point.y}}, mean_);
    }
    strips_.push_back(mean_.Rgb());
    ++next_;
  }

  Stand& stand_;
  const Method& plain_;
  int per_strip_;
  Mean mean_;
  std::deque<std::vector<float>> strips_;
  int next_ = 0;
};

/// The last three frames, newest last.
using History = std::deque<Picture>;

void Keep(History& history, Picture picture) {
  history.push_back(std::move(picture));
  if (history.size() > 3) history.pop_front();
}

double Change(const History& h, std::size_t i) {
  const std::size_t n = h.size();
  return static_cast<double>(h[n - 1].rgb[i]) - h[n - 2].rgb[i];
}

double SecondChange(const History& h, std::size_t i) {
  return static_cast<double>(h[2].rgb[i]) - 2.0 * h[1].rgb[i] + h[0].rgb[i];
}

/// Sums over pixels, channels and frames.
struct Sums {
  double crawl = 0.0;
  double second = 0.0;
};

template <class Term>
double OverMask(const Mask& mask, Term term) {
  double sum = 0.0;
  for (std::size_t p = 0; p < mask.size(); ++p) {
    if (mask[p] != 0) sum += term(3 * p) + term(3 * p + 1) + term(3 * p + 2);
  }
  return sum;
}

}  // namespace

std::vector<Figure> Crawl(Stand& stand, const std::vector<Method>& methods, const Effort& effort, bool is_turn) {
  const Method& plain = methods.front();
  const double turn_deg = kStep / (kTurnRadius * stand.size()) * kRadian_deg;
  const double roll_rad = kStep / (kRollRadius * stand.size());
  const auto place_of = [&](double frame) {
    return is_turn ? Place{.orbit_deg = frame * turn_deg, .roll_rad = frame * roll_rad}
                   : Place{.shift = {frame * kStep, 0.0}};
  };
  PanReference pan(stand, plain, effort.pan_samples);
  std::vector<History> histories(methods.size());
  History reference;
  std::vector<Sums> sums(methods.size() + 1);  // the last is the reference's own
  double terms = 0.0;
  double second_terms = 0.0;
  Mask mask;
  for (int frame = 0; frame < effort.frames; ++frame) {
    if (frame % kFramesAMask == 0) mask = EdgeMask(stand, plain, place_of(frame + 0.5 * kFramesAMask));
    Keep(reference, is_turn ? Reference(stand, plain, place_of(frame), effort.turn_samples) : pan.Next());
    const double pixels = 3.0 * Share(mask) * static_cast<double>(mask.size());
    terms += frame >= 1 ? pixels : 0.0;
    second_terms += frame >= 2 ? pixels : 0.0;
    for (std::size_t m = 0; m < methods.size(); ++m) {
      History& history = histories[m];
      Keep(history, stand.Render(methods[m], place_of(frame)));
      if (frame >= 1) {
        sums[m].crawl +=
            OverMask(mask, [&](std::size_t i) { return std::abs(Change(history, i) - Change(reference, i)); });
      }
      if (frame >= 2)
        sums[m].second += OverMask(mask, [&](std::size_t i) { return std::abs(SecondChange(history, i)); });
    }
    if (frame >= 2) {
      sums.back().second += OverMask(mask, [&](std::size_t i) { return std::abs(SecondChange(reference, i)); });
    }
  }
  const std::string name = is_turn ? "turn" : "pan";
  std::vector<Figure> figures;
  if (terms == 0.0 || second_terms == 0.0) return figures;
  for (std::size_t m = 0; m < methods.size(); ++m) {
    figures.push_back({"crawl " + name, methods[m].name, 255.0 * sums[m].crawl / terms});
    figures.push_back(
        {"second " + name, methods[m].name, 255.0 * (sums[m].second - sums.back().second) / second_terms});
  }
  return figures;
}

}  // namespace burin::bench
