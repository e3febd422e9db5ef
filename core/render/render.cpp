// SPDX-License-Identifier: Apache-2.0
#include "core/render/render.h"

#include <fmt/format.h>
#include <malloc.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <future>
#include <optional>

#include "core/gl/context.h"
#include "core/image/convert.h"
#include "core/render/effect_file.h"
#include "core/render/effect_parameters.h"
#include "core/render/frame_renderer.h"
#include "core/render/pipeline.h"
#include "core/render/plan.h"

namespace burin::render {
namespace {

using Effects = std::vector<std::shared_ptr<const fx::Effect>>;

/// What needs no device: made on a thread of its own while EGL starts.
struct Prepared {
  std::unique_ptr<Source> source;
  Plan plan;
  std::shared_ptr<const image::ColorTransform> transform;
  std::optional<image::Image> environment;
  std::string warning;  ///< of the environment; may be empty
};

Result<Effects> CompileEffects(const Job& job, Progress& progress) {
  Effects effects;
  std::optional<Error> first;
  for (const std::string& path : job.effects) {
    EffectFile file = CompileEffectFile(path, {job.include_folders, job.definitions});
    if (!file.diagnostics.empty()) progress.Diagnostics(file.DiagnosticText(progress.wants_color()));
    if (file.effect == nullptr && !first) first = ErrorOf(file);
    effects.push_back(std::move(file.effect));
  }
  if (first) return std::unexpected(*std::move(first));
  return effects;
}

/// Technique names that are wrong should not wait for a device.
Result<void> CheckTechniques(const Effects& effects, const std::vector<std::string>& techniques) {
  for (std::size_t i = 0; i < effects.size(); ++i) {
    if (auto choice = effect::ChooseTechnique(*effects[i], techniques[i]); !choice) {
      Error error = choice.error();
      if (error.message.find(effects[i]->path) == std::string::npos) {
        error.message = fmt::format("{}: {}", effects[i]->path, error.message);
      }
      return std::unexpected(std::move(error));
    }
  }
  return {};
}

Result<std::shared_ptr<const image::ColorTransform>> MakeTransform(const image::ColorOptions& options) {
  if (options.config.empty() && options.display.empty() && options.view.empty()) return image::SrgbTransform();
  if (options.config.empty()) {
    return Fail(ErrorKind::kUsage, "--display and --view choose from a configuration; expected --ocio or $OCIO too");
  }
  auto module = image::LoadImageModule();
  if (!module) return std::unexpected(module.error());
  return (*module)->MakeColorTransform(options);
}

bool ReadsTangents(const std::shared_ptr<const fx::Effect>& effect) {
  for (const fx::Technique& technique : effect->techniques) {
    for (const fx::Pass& pass : technique.passes) {
      if (std::ranges::find(pass.program.vertex_inputs, "TANGENT0") != pass.program.vertex_inputs.end()) return true;
    }
  }
  return false;
}

/// Scene-linear RGB floats, as the renderer takes it.
Result<image::Image> ReadEnvironment(const std::string& path) {
  auto module = image::LoadImageModule();
  if (!module) return std::unexpected(module.error());
  auto map = (*module)->Read(path);
  if (!map) return map;
  image::Image rgba = image::ToType(image::ToChannels(*map, 4), image::SampleType::kF32);
  if (rgba.encoding == image::Encoding::kDisplay) image::SrgbTransform()->DisplayToScene(rgba.As<float>());
  rgba.encoding = image::Encoding::kSceneLinear;
  return image::ToChannels(rgba, 3);
}

/// What of an environment counts otherwise than it says (gbuffer::EnvironmentFromImage); empty: nothing.
std::string DescribeOddTexels(const std::string& path, const image::Image& map) {
  std::size_t infinite = 0;
  std::size_t nan = 0;
  std::size_t negative = 0;
  for (const float value : map.As<float>()) {
    if (std::isnan(value))
      ++nan;
    else if (std::isinf(value))
      ++infinite;
    else if (value < 0.0f)
      ++negative;
  }
  std::string found;
  const auto add = [&](std::size_t count, std::string_view what) {
    if (count > 0) found += fmt::format("{}{} {}", found.empty() ? "" : ", ", count, what);
  };
  add(nan, "not a number (taken as 0)");
  add(infinite, "infinite (taken as 65504)");
  add(negative, "negative (taken as 0)");
  return found.empty() ? found : fmt::format("{}: of its values {}", path, found);
}

Result<Prepared> Prepare(const Job& job, Output output, bool wants_tangents) {
  Prepared prepared;
  auto transform = MakeTransform(job.color);
  if (!transform) return std::unexpected(transform.error());
  prepared.transform = *std::move(transform);
  auto source = OpenSource(job, wants_tangents);
  if (!source) return std::unexpected(source.error());
  prepared.source = *std::move(source);
  auto plan = MakePlan(job, std::move(output), prepared.source->info());
  if (!plan) return std::unexpected(plan.error());
  prepared.plan = *std::move(plan);
  if (!job.environment.empty()) {
    auto environment = ReadEnvironment(job.environment);
    if (!environment) return std::unexpected(environment.error());
    prepared.environment = *std::move(environment);
    prepared.warning = DescribeOddTexels(job.environment, *prepared.environment);
  }
  if (auto good = CheckPlace(prepared.plan.output, job.make_folders); !good) return std::unexpected(good.error());
  return prepared;
}

Result<void> CheckLimits(const Plan& plan, const Job& job, const SourceInfo& source, const gl::DeviceInfo& device) {
  const int limit = device.max_texture_size;
  if (plan.width > limit || plan.height > limit) {
    return Fail(ErrorKind::kFailed, fmt::format("the frame is {}x{}, over this device's limit of {}x{} ({})",
                                                plan.width, plan.height, limit, limit, device.renderer));
  }
  const int per_axis = job.samples == 16 ? 4 : job.samples == 4 ? 2 : 1;
  if (source.kind == SourceKind::kScene && std::max(plan.width, plan.height) > limit / per_axis) {
    return Fail(
        ErrorKind::kFailed,
        fmt::format("the frame is {}x{}, with --samples {} rendered at {}x{}, over this device's limit of {}x{} "
                    "({})",
                    plan.width, plan.height, job.samples, static_cast<long>(plan.width) * per_axis,
                    static_cast<long>(plan.height) * per_axis, limit, limit, device.renderer));
  }
  if (source.width > limit || source.height > limit) {
    return Fail(ErrorKind::kFailed, fmt::format("the source is {}x{}, over this device's limit of {}x{} ({})",
                                                source.width, source.height, limit, limit, device.renderer));
  }
  return {};
}

long ExpectedFrames(const Plan& plan, const SourceInfo& source) {
  if (!plan.frames.empty()) return static_cast<long>(plan.frames.size());
  return source.expected_frames.value_or(-1);
}

/// A frame without alpha shows a scene on black; with effects the pixels are theirs.
std::optional<std::array<float, 4>> Background(const Job& job, const Output& output) {
  if (job.background) return job.background;
  const bool is_dropped = output.is_video() || output.channels < 4;
  if (is_dropped && job.effects.empty() && job.attributes.empty()) return std::array<float, 4>{0, 0, 0, 1};
  return std::nullopt;
}

/// Everything from the opened source on, with the context current.
Result<void> RenderFrames(const Job& job, Prepared& prepared, Effects effects, RendererInput input,
                          const gl::DeviceInfo& device, Progress& progress, const std::atomic<bool>& stop,
                          long& frames_done) {
  const Plan& plan = prepared.plan;
  const SourceInfo& source = prepared.source->info();
  if (auto good = CheckLimits(plan, job, source, device); !good) return good;
  input.scene = prepared.source->scene();
  input.has_source = source.kind != SourceKind::kNone;
  input.is_opaque = !source.has_alpha;
  input.environment = prepared.environment ? &*prepared.environment : nullptr;
  input.background = Background(job, plan.output);
  input.samples = job.samples;
  input.edges = job.edges;
  input.translucency = job.translucency;
  input.effects = std::move(effects);
  input.include_folders = job.include_folders;
  input.transform = prepared.transform;
  auto renderer = FrameRenderer::Create(plan, std::move(input));
  if (!renderer) return std::unexpected(renderer.error());
  for (const std::string& choice : (*renderer)->choices()) progress.Info(choice);
  for (const std::string& warning : prepared.source->warnings()) progress.Warning(warning);
  if (!prepared.warning.empty()) progress.Warning(prepared.warning);
  if (job.samples > 1 && source.kind != SourceKind::kScene) {
    progress.Warning(fmt::format("--samples {}: the source is no scene, so there is nothing to sample", job.samples));
  }
  if (job.tessellation.curves_meshes() && source.kind != SourceKind::kScene) {
    progress.Warning("--tessellation: the source is no scene, so there is nothing to tessellate");
  }
  for (const std::string& warning : (*renderer)->TakeWarnings()) progress.Warning(warning);
  auto sink = OpenSink(plan, job, source, prepared.transform);
  if (!sink) return std::unexpected(sink.error());
  progress.Info(fmt::format("frame: {}x{}, {:g} frames a second", plan.width, plan.height, plan.rate.value()));
  progress.Started(ExpectedFrames(plan, source));
  const auto begin = std::chrono::steady_clock::now();
  auto result = RunPipeline(plan, *prepared.source, **renderer, **sink, job.keep_going, progress, stop, frames_done);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
  for (const std::string& note : prepared.source->Summary(elapsed.count())) progress.Info(note);
  return result;
}

Result<void> RunJob(const Job& job, Progress& progress, const std::atomic<bool>& stop, long& frames_done) {
  auto output = ClassifyOutput(job);
  if (!output) return std::unexpected(output.error());
  // The module takes longer to load than all else; whoever needs it first waits for this load.
  std::future<void> preload;
  if (output->kind == OutputKind::kImages) {
    preload = std::async(std::launch::async, [] { (void)image::LoadImageModule(); });
  }
  auto effects = CompileEffects(job, progress);
  if (!effects) return std::unexpected(effects.error());
  RendererInput input;
  auto techniques = ShareTechnique(*effects, job.technique);
  if (!techniques) return std::unexpected(techniques.error());
  auto parameters = ShareParameters(*effects, job.parameters);
  if (!parameters) return std::unexpected(parameters.error());
  if (auto good = CheckTechniques(*effects, *techniques); !good) return good;
  input.techniques = *std::move(techniques);
  input.parameters = *std::move(parameters);

  auto preparing = std::async(std::launch::async, Prepare, std::cref(job), *std::move(output),
                              std::ranges::any_of(*effects, ReadsTangents));
  auto context = gl::Context::Create({.device = job.device, .debug = false});
  auto prepared = preparing.get();
  if (!prepared) return std::unexpected(prepared.error());
  if (!context) return std::unexpected(context.error());
  const gl::DeviceInfo& device = (*context)->info();
  progress.DeviceChosen(device.renderer);
  if (stop) return Fail(ErrorKind::kFailed, "interrupted");
  return RenderFrames(job, *prepared, *std::move(effects), std::move(input), device, progress, stop, frames_done);
}

/// Frames are megabytes that come and go: kept in the heap instead of being mapped, and zeroed by the kernel, each
/// time.
void KeepLargeBlocks() {
  mallopt(M_MMAP_THRESHOLD, 32 << 20);  // the most that glibc takes
  mallopt(M_TRIM_THRESHOLD, 256 << 20);
}

}  // namespace

Result<void> Run(const Job& job, Progress& progress, const std::atomic<bool>& stop) {
  KeepLargeBlocks();
  gl::SetDriverEnvironment(job.threads);
  long frames_done = 0;
  Result<void> result = RunJob(job, progress, stop, frames_done);
  progress.Finished(result, frames_done);
  return result;
}

}  // namespace burin::render
