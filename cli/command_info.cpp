// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <unistd.h>

#include "cli/command_table.h"
#include "cli/console.h"
#include "core/render/effect_description.h"
#include "core/render/effect_library.h"
#include "core/render/media_description.h"
#include "core/render/source.h"

namespace burin::cli {
namespace {

Result<std::string> EffectInfo(const std::string& path, const Settings& settings) {
  const render::EffectFile file =
      render::CompileEffectFile(path, {settings.job.include_folders, settings.job.definitions});
  if (file.effect == nullptr || settings.log_level >= LogLevel::kInfo) {
    WriteText(STDERR_FILENO, file.DiagnosticText(UsesColor(STDERR_FILENO)));
  }
  if (file.effect == nullptr) return std::unexpected(render::ErrorOf(file));
  if (settings.dot) return render::EffectDot(file, settings.job.technique);
  return settings.json ? render::EffectJson(file, settings.job.technique)
                       : render::EffectText(file, settings.job.technique);
}

Result<std::string> InfoOf(const std::string& argument, const Settings& settings) {
  const auto inputs = render::SortInputs({argument});
  if (!inputs) return std::unexpected(inputs.error());
  if (!inputs->effects.empty()) return EffectInfo(inputs->effects.front(), settings);
  if (settings.dot) {
    return Fail(ErrorKind::kUsage, fmt::format("--dot {}: only an effect has a data flow", argument));
  }
  return settings.json ? render::MediaJson(argument) : render::MediaText(argument);
}

}  // namespace

int RunInfo(const Settings& settings) {
  if (settings.arguments.empty()) {
    PrintError({ErrorKind::kUsage, "burin info: no file; expected burin info FILE ..."});
    return kExitUsage;
  }
  if (settings.json && settings.dot) {
    PrintError({ErrorKind::kUsage, "--json and --dot: expected one of the two"});
    return kExitUsage;
  }
  int status = kExitDone;
  const bool is_list = settings.json && settings.arguments.size() > 1;
  std::string text;
  for (const std::string& argument : settings.arguments) {
    auto info = InfoOf(argument, settings);
    if (!info) {
      PrintError(info.error());
      if (status == kExitDone) status = ExitStatus(info.error());
      continue;
    }
    if (!info->ends_with('\n')) *info += '\n';
    if (!text.empty()) text += is_list ? ",\n" : "\n";
    text += *info;
  }
  if (is_list) text = "[\n" + text + "]\n";
  const int printed = PrintData(text);
  return printed != kExitDone ? printed : status;
}

}  // namespace burin::cli
