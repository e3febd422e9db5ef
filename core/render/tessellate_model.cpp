// SPDX-License-Identifier: Apache-2.0
#include "core/render/tessellate_model.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <optional>

#include "core/base/atomic_file.h"
#include "core/base/file_io.h"
#include "core/base/path.h"
#include "core/render/source.h"
#include "core/scene/mesh_writer.h"

namespace burin::render {
namespace {

Result<scene::MeshFormat> FormatOf(const std::string& output) {
  if (output.empty()) return Fail(ErrorKind::kUsage, "no output; expected -o FILE, a .glb, .obj or .ply, or -");
  const std::string extension = base::LowerExtension(output);
  if (output == "-" || extension == "glb") return scene::MeshFormat::kGlb;
  if (extension == "obj") return scene::MeshFormat::kObj;
  if (extension == "ply") return scene::MeshFormat::kPly;
  return Fail(ErrorKind::kUsage, fmt::format("{}: expected a mesh to write: .glb, .obj, .ply, or -", output));
}

Result<void> Check(const Job& job) {
  if (job.source.empty()) return Fail(ErrorKind::kUsage, "no model; expected burin tessellate MODEL -o OUT");
  if (job.source != "-" && ClassifySource(job.source) != SourceKind::kScene) {
    return Fail(ErrorKind::kUsage, fmt::format("{}: expected a model: .bpt, .obj, .gltf or .glb", job.source));
  }
  if (job.source == "-") return Fail(ErrorKind::kUsage, "-: a model is read from a file; expected its name");
  if (job.frames.size() > 1) {
    return Fail(ErrorKind::kUsage, fmt::format("--frames: {} frames, expected one", job.frames.size()));
  }
  return {};
}

scene::ByteSink SinkTo(int descriptor, const std::string& name) {
  return [descriptor, name](std::span<const std::byte> bytes) -> Result<void> {
    const int error = base::WriteAll(descriptor, bytes);
    if (error == 0) return {};
    return Fail(ErrorKind::kFailed, fmt::format("{}: cannot be written: {}", name, std::strerror(error)));
  };
}

Result<void> MakeFolder(const std::string& output) {
  const std::filesystem::path folder = std::filesystem::path(output).parent_path();
  if (folder.empty()) return {};
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!error) return {};
  return Fail(ErrorKind::kFailed, fmt::format("{}: cannot be made: {}", folder.string(), error.message()));
}

Result<void> Write(const Job& job, scene::MeshFormat format, const scene::Scene& scene, const SceneFrame& frame) {
  if (job.output == "-") return WriteMesh(format, scene, frame.items, SinkTo(STDOUT_FILENO, "stdout"));
  if (job.make_folders) {
    if (Result<void> made = MakeFolder(job.output); !made) return made;
  }
  Result<base::AtomicFile> file = base::AtomicFile::Create(job.output);
  if (!file) return std::unexpected(file.error());
  if (auto written = WriteMesh(format, scene, frame.items, SinkTo(file->descriptor(), job.output)); !written) {
    return written;
  }
  return file->Commit();
}

bool HasPictures(const scene::Scene& scene) {
  return std::ranges::any_of(scene.materials, [](const scene::Material& m) {
    return m.base_color_texture || m.metallic_roughness_texture || m.normal_texture || m.occlusion_texture ||
           m.emissive_texture;
  });
}

}  // namespace

Result<TessellatedModel> TessellateModel(const Job& asked) {
  Job job = asked;
  if (job.tessellation.mode == scene::TessellationMode::kAuto) {
    job.tessellation.mode = scene::TessellationMode::kFractional;
  }
  if (Result<void> good = Check(job); !good) return std::unexpected(good.error());
  const Result<scene::MeshFormat> format = FormatOf(job.output);
  if (!format) return std::unexpected(format.error());
  Result<std::unique_ptr<Source>> source = OpenSource(job);
  if (!source) return std::unexpected(source.error());
  SourceFrame frame;
  const Result<bool> read = (*source)->Read(job.frames.empty() ? 1 : job.frames.front(), frame);
  if (!read) return std::unexpected(read.error());
  const scene::Scene& scene = *(*source)->scene();
  if (Result<void> written = Write(job, *format, scene, *frame.scene); !written) {
    Error error = written.error();
    if (error.kind == ErrorKind::kInput) error.message = fmt::format("{}: {}", job.source, error.message);
    return std::unexpected(error);
  }
  TessellatedModel model{.warnings = (*source)->warnings(), .notes = std::move(frame.notes)};
  model.warnings.insert(model.warnings.end(), frame.warnings.begin(), frame.warnings.end());
  if (HasPictures(scene)) {
    model.warnings.push_back(fmt::format("{}: the pictures of its materials are not written", job.source));
  }
  return model;
}

}  // namespace burin::render
