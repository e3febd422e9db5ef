// SPDX-License-Identifier: Apache-2.0
#include "core/scene/gltf_animation.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <optional>

#include "core/scene/gltf_accessor.h"

namespace burin::scene {
namespace {

std::unexpected<Error> Bad(const std::string& where, const std::string& what) {
  return Fail(ErrorKind::kInput, fmt::format("{}: {}", where, what));
}

std::optional<AnimationPath> PathOf(const std::string& word) {
  if (word == "translation") return AnimationPath::kTranslation;
  if (word == "rotation") return AnimationPath::kRotation;
  if (word == "scale") return AnimationPath::kScale;
  if (word == "weights") return AnimationPath::kWeights;
  return std::nullopt;
}

Interpolation InterpolationOf(const std::string& word) {
  if (word == "STEP") return Interpolation::kStep;
  if (word == "CUBICSPLINE") return Interpolation::kCubicSpline;
  return Interpolation::kLinear;
}

int MorphTargets(const Scene& scene, const Node& node) {
  return node.mesh == kNone ? 0 : static_cast<int>(scene.meshes[static_cast<std::size_t>(node.mesh)].weights.size());
}

/// Key times, strictly increasing. Of keys at one time, which some exporters write, the last stays.
Result<std::vector<float>> ReadTimes(GltfDocument& document, int accessor, const std::string& where) {
  auto times = ReadFloats(document, accessor, 1);
  if (!times) return Bad(where, times.error().message);
  for (std::size_t i = 0; i < times->size(); ++i) {
    if ((*times)[i] < 0.0f)
      return Bad(where, fmt::format("accessor {}: key {} is at {} s, before 0", accessor, i, (*times)[i]));
    if (i > 0 && (*times)[i] < (*times)[i - 1]) {
      return Bad(where, fmt::format("accessor {}: key {} at {} s is before the one at {} s", accessor, i, (*times)[i],
                                    (*times)[i - 1]));
    }
  }
  return times;
}

void DropRepeatedKeys(AnimationChannel& channel) {
  const std::size_t width = channel.values.size() / channel.times.size();
  std::size_t kept = 0;
  for (std::size_t i = 0; i < channel.times.size(); ++i) {
    if (i + 1 < channel.times.size() && channel.times[i + 1] == channel.times[i]) continue;
    channel.times[kept] = channel.times[i];
    std::copy_n(channel.values.begin() + static_cast<std::ptrdiff_t>(i * width), width,
                channel.values.begin() + static_cast<std::ptrdiff_t>(kept * width));
    ++kept;
  }
  channel.times.resize(kept);
  channel.values.resize(kept * width);
}

/// Values of a channel: accessor elements are SCALAR for weights, else one element a value.
Result<std::vector<float>> ReadValues(GltfDocument& document, int accessor, const AnimationChannel& channel,
                                      const std::string& where) {
  const int element = channel.path == AnimationPath::kWeights ? 1 : channel.components;
  auto values = ReadFloats(document, accessor, element, Integers::kAlwaysNormalised);
  if (!values) return Bad(where, values.error().message);
  const std::size_t per_key = channel.interpolation == Interpolation::kCubicSpline ? 3 : 1;
  const std::size_t wanted = channel.times.size() * per_key * static_cast<std::size_t>(channel.components);
  if (values->size() != wanted) {
    const auto size = static_cast<std::size_t>(element);
    return Bad(where, fmt::format("accessor {} has {} elements, {} keys need {}", accessor, values->size() / size,
                                  channel.times.size(), wanted / size));
  }
  return values;
}

class AnimationReader {
 public:
  AnimationReader(GltfDocument& document, const Scene& scene) : document_(document), scene_(scene) {}

  Result<Animation> Read(const tinygltf::Animation& source, const std::string& where) {
    Animation animation;
    animation.name = source.name;
    for (std::size_t i = 0; i < source.channels.size(); ++i) {
      const std::string at = fmt::format("{}.channels[{}]", where, i);
      if (source.channels[i].sampler >= static_cast<int>(source.samplers.size())) {
        return Bad(at + ".sampler", fmt::format("index {} is out of range, \"samplers\" has {}",
                                                source.channels[i].sampler, source.samplers.size()));
      }
      auto channel = Target(source.channels[i], at);
      if (!channel) continue;
      const int sampler = source.channels[i].sampler;
      auto ok = Keys(source.samplers[static_cast<std::size_t>(sampler)], fmt::format("{}.samplers[{}]", where, sampler),
                     *channel);
      if (!ok) return std::unexpected(ok.error());
      animation.duration_s = std::max(animation.duration_s, channel->times.back());
      animation.channels.push_back(std::move(*channel));
    }
    return animation;
  }

 private:
  /// The channel's node and path, or nothing when there is nothing to move.
  std::optional<AnimationChannel> Target(const tinygltf::AnimationChannel& source, const std::string& where) {
    const std::optional<AnimationPath> path = PathOf(source.target_path);
    if (source.target_node < 0 || !path) {
      document_.Warn(fmt::format("{}: its target is ignored", where));
      return std::nullopt;
    }
    const Node& node = scene_.nodes[static_cast<std::size_t>(source.target_node)];
    AnimationChannel channel;
    channel.node = source.target_node;
    channel.path = *path;
    channel.components = *path == AnimationPath::kRotation  ? 4
                         : *path == AnimationPath::kWeights ? MorphTargets(scene_, node)
                                                            : 3;
    if (*path == AnimationPath::kWeights && channel.components == 0) {
      document_.Warn(fmt::format("{}: nodes[{}] has no morph targets; the channel is ignored", where, channel.node));
      return std::nullopt;
    }
    if (*path != AnimationPath::kWeights && node.matrix) {
      document_.Warn(fmt::format("{}: nodes[{}] has a matrix, which is not animated; the channel is ignored", where,
                                 channel.node));
      return std::nullopt;
    }
    return channel;
  }

  Result<void> Keys(const tinygltf::AnimationSampler& sampler, const std::string& where, AnimationChannel& channel) {
    channel.interpolation = InterpolationOf(sampler.interpolation);
    auto times = ReadTimes(document_, sampler.input, where + ".input");
    if (!times) return std::unexpected(times.error());
    channel.times = std::move(*times);
    auto values = ReadValues(document_, sampler.output, channel, where + ".output");
    if (!values) return std::unexpected(values.error());
    channel.values = std::move(*values);
    DropRepeatedKeys(channel);
    return {};
  }

  GltfDocument& document_;
  const Scene& scene_;
};

}  // namespace

Result<std::vector<Animation>> ReadAnimations(GltfDocument& document, const Scene& scene) {
  std::vector<Animation> animations;
  AnimationReader reader(document, scene);
  for (std::size_t i = 0; i < document.model().animations.size(); ++i) {
    auto animation = reader.Read(document.model().animations[i], fmt::format("animations[{}]", i));
    if (!animation) return std::unexpected(animation.error());
    animations.push_back(std::move(*animation));
  }
  return animations;
}

}  // namespace burin::scene
