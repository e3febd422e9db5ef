// SPDX-License-Identifier: Apache-2.0
#include "core/render/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "core/render/frame_list.h"
#include "fx_parser/source/diagnostic.h"

namespace burin::render {
namespace {

/// "walk.png" as "walk.####.png".
std::string WithToken(const std::string& path) {
  const std::filesystem::path name(path);
  return (name.parent_path() / (name.stem().string() + ".####" + name.extension().string())).string();
}

Result<void> ChooseFrames(Plan& plan, const Job& job, const SourceInfo& source) {
  plan.frames_were_asked_for = !job.frames.empty();
  if (plan.frames_were_asked_for) {
    plan.frames = job.frames;
  } else if (source.kind == SourceKind::kScene && !plan.output.takes_several() && job.turntable_frames == 0) {
    plan.frames = {1};
  } else {
    plan.frames = source.frames;
  }
  if (plan.output.takes_several() || plan.frames.size() == 1) return {};
  const std::string frames =
      plan.frames.empty() ? std::string("all frames of a video") : fmt::format("{} frames", plan.frames.size());
  return Fail(ErrorKind::kUsage,
              fmt::format("{}: {} need a name with a place for the number, such as {}; or choose one by --frames",
                          job.output, frames, WithToken(job.output)));
}

Result<void> ChooseLayers(Plan& plan, const Job& job) {
  if (job.attributes.empty()) return {};
  auto layers = FindAttributes(job.attributes);
  if (!layers) return std::unexpected(layers.error());
  plan.layers = *std::move(layers);
  plan.has_frame = !job.effects.empty();
  if (plan.output.is_exr) return {};
  if (plan.has_frame) {
    return Fail(
        ErrorKind::kUsage,
        fmt::format("{}: --attributes beside an effect's frame needs layers; expected an .exr output", job.output));
  }
  if (plan.layers.size() > 1) {
    return Fail(ErrorKind::kUsage,
                fmt::format("{}: {} attributes need layers; expected an .exr output, or one attribute", job.output,
                            plan.layers.size()));
  }
  return {};
}

}  // namespace

Result<std::vector<gbuffer::Attribute>> FindAttributes(const std::vector<std::string>& names) {
  std::vector<gbuffer::Attribute> attributes;
  for (const std::string& name : names) {
    const auto attribute = gbuffer::FindAttribute(name);
    if (!attribute) {
      std::vector<std::string> known;
      for (const gbuffer::AttributeInfo& info : gbuffer::AllAttributes()) known.emplace_back(info.name);
      const std::string nearest = fx::NearestName(name, known);
      return Fail(ErrorKind::kUsage,
                  fmt::format("--attributes: unknown attribute '{}'{}; burin-attributes(7) lists them", name,
                              nearest.empty() ? "" : fmt::format(", did you mean {}?", nearest)));
    }
    if (std::ranges::find(attributes, *attribute) != attributes.end()) {
      return Fail(ErrorKind::kUsage, fmt::format("--attributes: '{}' stands twice", name));
    }
    attributes.push_back(*attribute);
  }
  return attributes;
}

Result<Plan> MakePlan(const Job& job, Output output, const SourceInfo& source) {
  Plan plan;
  plan.output = std::move(output);
  std::tie(plan.width, plan.height) = job.size           ? *job.size
                                      : source.width > 0 ? std::pair(source.width, source.height)
                                                         : kDefaultSize;
  plan.rate = job.fps ? *job.fps : source.rate.value_or(kDefaultRate);
  if (source.kind == SourceKind::kNone && job.effects.empty()) {
    return Fail(ErrorKind::kUsage, "nothing to render: no source and no effect");
  }
  if (auto good = ChooseLayers(plan, job); !good) return std::unexpected(good.error());
  if (auto good = ChooseFrames(plan, job, source); !good) return std::unexpected(good.error());
  if (auto good = ChooseSamples(plan.output, job, source, plan.width, plan.height); !good) {
    return std::unexpected(good.error());
  }
  return plan;
}

}  // namespace burin::render
