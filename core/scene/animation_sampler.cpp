// SPDX-License-Identifier: Apache-2.0
// Keyframe interpolation as glTF 2.0, appendix C, defines it.

#include "core/scene/animation_sampler.h"

#include <algorithm>
#include <cmath>

namespace burin::scene {
namespace {

// Closer than this the arc's sine loses its digits and the chord is as good.
constexpr float kNearlyParallel = 0.9995f;

void Copy(const float* from, std::span<float> out) { std::copy_n(from, out.size(), out.begin()); }

glm::quat LoadQuat(const float* xyzw) { return {xyzw[3], xyzw[0], xyzw[1], xyzw[2]}; }

void Store(const glm::quat& q, std::span<float> out) {
  out[0] = q.x;
  out[1] = q.y;
  out[2] = q.z;
  out[3] = q.w;
}

glm::quat Normalised(const glm::quat& q) {
  const float length = glm::length(q);
  return length > 0.0f ? q / length : glm::quat(1.0f, 0.0f, 0.0f, 0.0f);
}

/// Appendix C.5; `dt` is the time between the keys, `t` 0..1 between them.
void Cubic(const float* key, const float* next, std::size_t width, float dt, float t, std::span<float> out) {
  const float t2 = t * t;
  const float t3 = t2 * t;
  for (std::size_t i = 0; i < width; ++i) {
    const float value = key[width + i];
    const float out_tangent = key[2 * width + i];
    const float next_in_tangent = next[i];
    const float next_value = next[width + i];
    out[i] = (2.0f * t3 - 3.0f * t2 + 1.0f) * value + dt * (t3 - 2.0f * t2 + t) * out_tangent +
             (-2.0f * t3 + 3.0f * t2) * next_value + dt * (t3 - t2) * next_in_tangent;
  }
}

}  // namespace

glm::quat Slerp(const glm::quat& a, const glm::quat& b, float t) {
  const float dot = glm::dot(a, b);
  const glm::quat target = dot < 0.0f ? -b : b;
  const float cosine = std::min(std::abs(dot), 1.0f);
  if (cosine > kNearlyParallel) return Normalised(a * (1.0f - t) + target * t);
  const float angle = std::acos(cosine);
  return Normalised((a * std::sin((1.0f - t) * angle) + target * std::sin(t * angle)) / std::sin(angle));
}

void SampleChannel(const AnimationChannel& channel, float time_s, std::span<float> out) {
  const auto width = static_cast<std::size_t>(channel.components);
  const bool cubic = channel.interpolation == Interpolation::kCubicSpline;
  const bool rotation = channel.path == AnimationPath::kRotation;
  const std::size_t stride = cubic ? 3 * width : width;
  const std::size_t value_at = cubic ? width : 0;
  const std::vector<float>& times = channel.times;
  const float* values = channel.values.data();

  const auto after = std::upper_bound(times.begin(), times.end(), time_s);
  const std::size_t next = static_cast<std::size_t>(after - times.begin());
  if (next == 0 || next == times.size() || channel.interpolation == Interpolation::kStep) {
    const std::size_t key = next == 0 ? 0 : next - 1;
    Copy(values + key * stride + value_at, out);
  } else {
    const std::size_t key = next - 1;
    const float dt = times[next] - times[key];
    const float t = (time_s - times[key]) / dt;
    const float* a = values + key * stride;
    const float* b = values + next * stride;
    if (cubic) {
      Cubic(a, b, width, dt, t, out);
    } else if (rotation) {
      Store(Slerp(Normalised(LoadQuat(a)), Normalised(LoadQuat(b)), t), out);
      return;
    } else {
      for (std::size_t i = 0; i < width; ++i) out[i] = a[i] + (b[i] - a[i]) * t;
    }
  }
  if (rotation) Store(Normalised(LoadQuat(out.data())), out);
}

}  // namespace burin::scene
