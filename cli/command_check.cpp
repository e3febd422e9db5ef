// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <unistd.h>

#include <nlohmann/json.hpp>
#include <optional>

#include "cli/command_table.h"
#include "cli/console.h"
#include "cli/glsl_files.h"
#include "core/render/effect_file.h"
#include "core/render/effect_library.h"

namespace burin::cli {
namespace {

using Json = nlohmann::ordered_json;

const char* SeverityName(fx::Severity severity) {
  switch (severity) {
    case fx::Severity::kNote:
      return "note";
    case fx::Severity::kWarning:
      return "warning";
    case fx::Severity::kError:
      return "error";
  }
  return "error";
}

Json PlaceJson(const fx::Range& range, const fx::SourceSet& sources) {
  Json json = Json::object();
  if (range.begin.file < sources.files.size()) {
    const fx::PresumedLine place = fx::Presume(sources.files[range.begin.file], range.begin.line);
    json["file"] = place.path.empty() ? sources.files[range.begin.file].path : place.path;
    json["line"] = place.line;
    json["column"] = range.begin.column;
  }
  return json;
}

Json FileJson(const render::EffectFile& file) {
  Json list = Json::array();
  for (const fx::Diagnostic& diagnostic : file.diagnostics) {
    Json json = PlaceJson(diagnostic.range, file.sources);
    json["severity"] = SeverityName(diagnostic.severity);
    json["code"] = diagnostic.code;
    json["message"] = diagnostic.text;
    for (const fx::Note& note : diagnostic.notes) {
      Json place = PlaceJson(note.range, file.sources);
      place["message"] = note.text;
      json["notes"].push_back(std::move(place));
    }
    list.push_back(std::move(json));
  }
  return {{"file", file.path}, {"errors", file.errors}, {"warnings", file.warnings}, {"diagnostics", std::move(list)}};
}

std::string Summary(const render::EffectFile& file) {
  const auto plural = [](int count, const char* what) {
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
  };
  if (file.errors > 0)
    return fmt::format("{}: {}, {}\n", file.path, plural(file.errors, "error"), plural(file.warnings, "warning"));
  return file.warnings > 0 ? fmt::format("{}: good, {}\n", file.path, plural(file.warnings, "warning"))
                           : fmt::format("{}: good\n", file.path);
}

}  // namespace

int RunCheck(const Settings& settings) {
  if (settings.arguments.empty()) {
    PrintError({ErrorKind::kUsage, "burin check: no effect; expected burin check EFFECT.fx ..."});
    return kExitUsage;
  }
  int status = kExitDone;
  std::optional<GlslFiles> glsl;
  if (!settings.glsl_folder.empty()) {
    auto folder = GlslFiles::Create(settings.glsl_folder);
    if (!folder) {
      PrintError(folder.error());
      return ExitStatus(folder.error());
    }
    glsl = std::move(*folder);
  }
  Json all = Json::array();
  for (const std::string& argument : settings.arguments) {
    const auto path = render::FindEffect(argument);
    if (!path) {
      PrintError(path.error());
      if (status == kExitDone) status = ExitStatus(path.error());
      continue;
    }
    const render::EffectFile file =
        render::CompileEffectFile(*path, {settings.job.include_folders, settings.job.definitions});
    if (file.effect == nullptr) status = kExitInput;
    if (glsl && file.effect != nullptr) {
      if (const auto written = glsl->Write(*file.effect); !written) {
        PrintError(written.error());
        return ExitStatus(written.error());
      }
    }
    if (settings.json) {
      all.push_back(FileJson(file));
      continue;
    }
    WriteText(STDERR_FILENO, file.DiagnosticText(UsesColor(STDERR_FILENO)));
    if (settings.log_level > LogLevel::kError) WriteText(STDERR_FILENO, Summary(file));
  }
  if (settings.json) {
    const int printed = PrintData(all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
    if (printed != kExitDone) return printed;
  }
  return status;
}

}  // namespace burin::cli
