// SPDX-License-Identifier: Apache-2.0
#include "core/render/media_description.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/render/frame_list.h"
#include "core/render/source.h"
#include "core/scene/describe.h"
#include "core/scene/read_scene.h"

namespace burin::render {
namespace {

const char* KindName(SourceKind kind) {
  switch (kind) {
    case SourceKind::kImage:
      return "image";
    case SourceKind::kSequence:
      return "sequence";
    case SourceKind::kVideo:
      return "video";
    case SourceKind::kY4mFile:
    case SourceKind::kY4mStream:
      return "y4m";
    case SourceKind::kScene:
      return "scene";
    case SourceKind::kNone:
      break;
  }
  return "none";
}

const char* TypeName(image::SampleType type) {
  switch (type) {
    case image::SampleType::kU8:
      return "8-bit";
    case image::SampleType::kU16:
      return "16-bit";
    case image::SampleType::kU32:
      return "32-bit integer";
    case image::SampleType::kF16:
      return "half";
    case image::SampleType::kF32:
      return "float";
  }
  return "unknown";
}

const char* ChromaName(video::Chroma chroma) {
  return chroma == video::Chroma::k420 ? "4:2:0" : chroma == video::Chroma::k422 ? "4:2:2" : "4:4:4";
}

bool HasRate(const SourceInfo& info) { return info.rate.has_value(); }

Result<SourceInfo> Look(const std::string& path) {
  Job job;
  job.source = path;
  auto source = OpenSource(job);
  if (!source) return std::unexpected(source.error());
  return (*source)->info();
}

Result<std::string> SceneDescription(const std::string& path, bool as_json) {
  const auto scene = scene::ReadScene(path, {});
  if (!scene) return std::unexpected(scene.error());
  return scene::DescribeScene(*scene, as_json);
}

}  // namespace

Result<std::string> MediaText(const std::string& path) {
  if (ClassifySource(path) == SourceKind::kScene) return SceneDescription(path, false);
  const auto info = Look(path);
  if (!info) return std::unexpected(info.error());
  std::string text =
      fmt::format("{}: {}\n\n  size      {}x{}\n", path, KindName(info->kind), info->width, info->height);
  text += fmt::format("  samples   {}{}\n", TypeName(info->type), info->has_alpha ? ", with alpha" : "");
  if (HasRate(*info)) {
    text += fmt::format("  rate      {}/{} ({:.6g} frames a second)\n", info->rate->numerator, info->rate->denominator,
                        info->rate->value());
  }
  if (info->chroma) text += fmt::format("  chroma    {}\n", ChromaName(*info->chroma));
  if (info->kind == SourceKind::kSequence) {
    text += fmt::format("  frames    {} ({})\n", info->frames.size(), FormatFrameList(info->frames));
  } else if (info->expected_frames) {
    text += fmt::format("  frames    {}\n", *info->expected_frames);
  }
  return text;
}

Result<std::string> MediaJson(const std::string& path) {
  if (ClassifySource(path) == SourceKind::kScene) return SceneDescription(path, true);
  using Json = nlohmann::ordered_json;
  const auto info = Look(path);
  if (!info) return std::unexpected(info.error());
  Json json = {{"file", path},           {"kind", KindName(info->kind)},    {"width", info->width},
               {"height", info->height}, {"samples", TypeName(info->type)}, {"alpha", info->has_alpha}};
  if (HasRate(*info)) json["rate"] = {info->rate->numerator, info->rate->denominator};
  if (info->chroma) json["chroma"] = ChromaName(*info->chroma);
  if (info->kind == SourceKind::kSequence) {
    json["frames"] = info->frames;
  } else if (info->expected_frames) {
    json["frame_count"] = *info->expected_frames;
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace burin::render
