// SPDX-License-Identifier: Apache-2.0
#include "core/image/module/color.h"

#include <OpenColorIO/OpenColorIO.h>
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace burin::image {
namespace ocio = OCIO_NAMESPACE;

namespace {

class OcioTransform final : public ColorTransform {
 public:
  OcioTransform(ocio::ConstCPUProcessorRcPtr to_display, ocio::ConstCPUProcessorRcPtr to_scene)
      : to_display_(std::move(to_display)), to_scene_(std::move(to_scene)) {}
  void SceneToDisplay(std::span<float> rgba) const override { Apply(*to_display_, rgba); }
  void DisplayToScene(std::span<float> rgba) const override { Apply(*to_scene_, rgba); }
  [[nodiscard]] bool is_srgb() const override { return false; }

 private:
  // A block at a time through RGB alone: a configuration may carry alpha through a matrix, and ours is left alone.
  static void Apply(const ocio::CPUProcessor& processor, std::span<float> rgba) {
    constexpr std::size_t kBlockPixels = 1024;
    float alpha[kBlockPixels];
    for (std::size_t done = 0; done + 3 < rgba.size(); done += kBlockPixels * 4) {
      const std::span<float> block =
          rgba.subspan(done, std::min(kBlockPixels * 4, (rgba.size() - done) & ~std::size_t{3}));
      const std::size_t pixels = block.size() / 4;
      for (std::size_t i = 0; i < pixels; ++i) alpha[i] = block[4 * i + 3];
      ocio::PackedImageDesc description(block.data(), static_cast<long>(pixels), 1, 4);
      processor.apply(description);
      for (std::size_t i = 0; i < pixels; ++i) block[4 * i + 3] = alpha[i];
    }
  }

  ocio::ConstCPUProcessorRcPtr to_display_;
  ocio::ConstCPUProcessorRcPtr to_scene_;
};

std::string FirstLine(std::string_view text) { return std::string(text.substr(0, text.find('\n'))); }

template <class Count, class Name>
std::vector<std::string> Names(Count count, Name name) {
  std::vector<std::string> names;
  for (int i = 0; i < count; ++i) names.emplace_back(name(i));
  return names;
}

Result<ocio::ConstConfigRcPtr> LoadConfig(const std::string& path) {
  if (path.starts_with("ocio://") && ocio::GetVersionHex() < 0x02020000) {
    return Fail(ErrorKind::kUsage,
                fmt::format("cannot use the OpenColorIO configuration '{}': configurations built into "
                            "the library come with OpenColorIO 2.2, this is {}; give the path of a "
                            "configuration file",
                            path, ocio::GetVersion()));
  }
  try {
    ocio::ConstConfigRcPtr config = ocio::Config::CreateFromFile(path.c_str());
    config->validate();
    return config;
  } catch (const std::exception& e) {
    return Fail(ErrorKind::kInput,
                fmt::format("cannot read the OpenColorIO configuration '{}': {}", path, FirstLine(e.what())));
  }
}

// Names compare as OpenColorIO compares them, without case.
Result<std::string> Choose(std::string_view what, const std::string& wanted, const std::string& fallback,
                           const std::vector<std::string>& there, const std::string& where) {
  const auto lower = [](std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
  };
  if (wanted.empty() && !fallback.empty()) return fallback;
  for (const std::string& name : there) {
    if (!wanted.empty() && lower(name) == lower(wanted)) return name;
  }
  if (there.empty()) return Fail(ErrorKind::kInput, fmt::format("{} has no {}s", where, what));
  return Fail(ErrorKind::kUsage,
              fmt::format("{} has no {} '{}'; it has: {}", where, what, wanted, fmt::join(there, ", ")));
}

ocio::ConstCPUProcessorRcPtr Processor(const ocio::Config& config, const std::string& display, const std::string& view,
                                       ocio::TransformDirection direction) {
  const ocio::DisplayViewTransformRcPtr transform = ocio::DisplayViewTransform::Create();
  transform->setSrc(ocio::ROLE_SCENE_LINEAR);
  transform->setDisplay(display.c_str());
  transform->setView(view.c_str());
  const ocio::ConstProcessorRcPtr processor = config.getProcessor(transform, direction);
  // The default optimisation's fast logarithms and powers are good to 12 bits only.
  constexpr auto kExactMath =
      static_cast<ocio::OptimizationFlags>(static_cast<unsigned>(ocio::OPTIMIZATION_VERY_GOOD) &
                                           ~static_cast<unsigned>(ocio::OPTIMIZATION_FAST_LOG_EXP_POW));
  return processor->getOptimizedCPUProcessor(kExactMath);
}

}  // namespace

Result<std::shared_ptr<const ColorTransform>> MakeOcioTransform(const ColorOptions& options) {
  const Result<ocio::ConstConfigRcPtr> loaded = LoadConfig(options.config);
  if (!loaded) return std::unexpected(loaded.error());
  const ocio::Config& config = **loaded;
  const std::string where = fmt::format("the OpenColorIO configuration '{}'", options.config);
  try {
    if (!config.hasRole(ocio::ROLE_SCENE_LINEAR)) {
      return Fail(ErrorKind::kInput, fmt::format("{} has no scene_linear role", where));
    }
    const Result<std::string> display =
        Choose("display", options.display, config.getDefaultDisplay(),
               Names(config.getNumDisplays(), [&](int i) { return config.getDisplay(i); }), where);
    if (!display) return std::unexpected(display.error());
    const Result<std::string> view =
        Choose("view", options.view, config.getDefaultView(display->c_str()),
               Names(config.getNumViews(display->c_str()), [&](int i) { return config.getView(display->c_str(), i); }),
               fmt::format("display '{}' of {}", *display, where));
    if (!view) return std::unexpected(view.error());
    return std::make_shared<const OcioTransform>(Processor(config, *display, *view, ocio::TRANSFORM_DIR_FORWARD),
                                                 Processor(config, *display, *view, ocio::TRANSFORM_DIR_INVERSE));
  } catch (const std::exception& e) {
    return Fail(ErrorKind::kInput, fmt::format("{} gives no transform: {}", where, FirstLine(e.what())));
  }
}

}  // namespace burin::image
