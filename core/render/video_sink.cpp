// SPDX-License-Identifier: Apache-2.0
// Videos by the video module, y4m files and streams by core/video/y4m.
#include <unistd.h>

#include <optional>

#include "core/base/atomic_file.h"
#include "core/render/colour.h"
#include "core/render/sink.h"
#include "core/video/y4m.h"

namespace burin::render {
namespace {

class VideoSink final : public Sink {
 public:
  VideoSink(std::optional<base::AtomicFile> file, std::unique_ptr<video::VideoWriter> writer, std::string name,
            std::shared_ptr<const image::ColorTransform> transform)
      : file_(std::move(file)), writer_(std::move(writer)), name_(std::move(name)), transform_(std::move(transform)) {}

  [[nodiscard]] int workers() const override { return 1; }

  [[nodiscard]] Result<std::string> Write(RenderedFrame frame) override {
    if (frame.picture.type != image::SampleType::kU8 || frame.picture.encoding == image::Encoding::kSceneLinear) {
      frame.picture = ConvertEncoding(frame.picture, image::Encoding::kDisplay, image::SampleType::kU8, *transform_);
    }
    if (auto written = writer_->Write(frame.picture); !written) return std::unexpected(written.error());
    return name_;
  }

  [[nodiscard]] Result<void> Finish() override {
    if (auto finished = writer_->Finish(); !finished) return finished;
    return file_ ? file_->Commit() : Result<void>();
  }

 private:
  std::optional<base::AtomicFile> file_;  // of a y4m file; outlives the writer
  std::unique_ptr<video::VideoWriter> writer_;
  std::string name_;
  std::shared_ptr<const image::ColorTransform> transform_;
};

}  // namespace

Result<std::unique_ptr<Sink>> OpenVideoSink(const Plan& plan, const Job& job, const SourceInfo& source,
                                            std::shared_ptr<const image::ColorTransform> transform) {
  video::VideoWriteOptions options;
  options.width = plan.width;
  options.height = plan.height;
  options.rate = plan.rate;
  options.chroma = job.chroma.value_or(source.chroma.value_or(video::Chroma::k444));
  const std::string& path = plan.output.pattern.text();
  if (plan.output.kind == OutputKind::kVideo) {
    auto module = video::LoadVideoModule();
    if (!module) return std::unexpected(module.error());
    auto writer = (*module)->OpenWriter(path, options);
    if (!writer) return std::unexpected(writer.error());
    return std::make_unique<VideoSink>(std::nullopt, *std::move(writer), path, std::move(transform));
  }
  const bool is_stream = plan.output.kind == OutputKind::kY4mStream;
  std::optional<base::AtomicFile> file;
  if (!is_stream) {
    auto created = base::AtomicFile::Create(path);
    if (!created) return std::unexpected(created.error());
    file = *std::move(created);
  }
  const std::string name = is_stream ? "stdout" : path;
  auto writer = video::OpenY4mWriter(is_stream ? STDOUT_FILENO : file->descriptor(), name, options);
  if (!writer) return std::unexpected(writer.error());
  return std::make_unique<VideoSink>(std::move(file), *std::move(writer), name, std::move(transform));
}

}  // namespace burin::render
