// SPDX-License-Identifier: Apache-2.0
#include "core/render/pipeline.h"

#include <fmt/format.h>

#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "core/base/bounded_queue.h"
#include "core/render/frame_outcome.h"

namespace burin::render {
namespace {

/// Decoded frames waiting to be drawn: enough to ride out an uneven decoder.
constexpr std::size_t kDecodedAhead = 3;

/// Pictures whose memory waits to be decoded into again. As many as there are frames under way, never more.
class PicturePool {
 public:
  std::optional<image::Image> Take() {
    const std::lock_guard lock(mutex_);
    if (free_.empty()) return std::nullopt;
    std::optional<image::Image> picture = std::move(free_.back());
    free_.pop_back();
    return picture;
  }
  void Give(std::optional<image::Image>& picture) {
    if (!picture) return;
    const std::lock_guard lock(mutex_);
    if (free_.size() <= kDecodedAhead) free_.push_back(*std::move(picture));
  }

 private:
  std::mutex mutex_;
  std::vector<image::Image> free_;
};

class Pipeline {
 public:
  Pipeline(const Plan& plan, Source& source, FrameRenderer& renderer, Sink& sink, FrameOutcome& outcome,
           Progress& progress, const std::atomic<bool>& stop)
      : plan_(plan),
        source_(source),
        renderer_(renderer),
        sink_(sink),
        outcome_(outcome),
        progress_(progress),
        stop_(stop),
        decoded_(kDecodedAhead),
        encoded_(static_cast<std::size_t>(sink.workers())) {}

  void Run() {
    std::thread decoder([this] { Decode(); });
    std::vector<std::thread> encoders;
    for (int i = 0; i < sink_.workers(); ++i) encoders.emplace_back([this] { Encode(); });
    Draw();
    if (Halted()) {
      decoded_.Abort();
      encoded_.Abort();
    } else {
      encoded_.Close();
    }
    for (std::thread& encoder : encoders) encoder.join();
    decoded_.Abort();  // an encoder may have failed while the decoder was still ahead
    decoder.join();
  }

 private:
  [[nodiscard]] bool Halted() const { return stop_ || outcome_.broken(); }

  // ---- the decoding thread

  void Decode() {
    if (plan_.frames.empty()) {
      for (long number = 1; DecodeOne(number); ++number) {
      }
    } else {
      for (const long number : plan_.frames) {
        if (!DecodeOne(number)) break;
      }
    }
    decoded_.Close();
  }

  /// False when there is nothing more to decode.
  bool DecodeOne(long number) {
    if (Halted()) return false;
    SourceFrame frame;
    frame.picture = pool_.Take();
    const auto more = source_.Read(number, frame);
    if (!more) {
      const bool goes_on = outcome_.Failed(number, more.error());
      // After a fault in a stream its later frames are not what they seem.
      return goes_on && !IsStream();
    }
    if (!*more) {
      if (plan_.frames_were_asked_for) (void)outcome_.Failed(number, PastTheEnd(number));
      return false;
    }
    return decoded_.Push(std::move(frame));
  }

  [[nodiscard]] bool IsStream() const {
    const SourceKind kind = source_.info().kind;
    return kind == SourceKind::kVideo || kind == SourceKind::kY4mFile || kind == SourceKind::kY4mStream;
  }

  [[nodiscard]] static Error PastTheEnd(long number) {
    return {ErrorKind::kInput, fmt::format("--frames: the source ends before frame {}", number)};
  }

  // ---- the caller's thread

  void Draw() {
    while (!Halted()) {
      std::optional<SourceFrame> frame = decoded_.Pop();
      if (!frame) break;
      while (renderer_.in_flight() >= FrameRenderer::kInFlight) {
        if (!encoded_.Push(renderer_.Finish())) return;
      }
      const auto drawn = renderer_.Render(*frame);
      pool_.Give(frame->picture);
      for (const std::string& warning : frame->warnings) progress_.Warning(warning);
      for (const std::string& note : frame->notes) progress_.Info(note);
      for (const std::string& warning : renderer_.TakeWarnings()) progress_.Warning(warning);
      for (const std::string& note : renderer_.TakeNotes()) progress_.Info(note);
      if (!drawn && !outcome_.Failed(frame->number, drawn.error())) return;
    }
    while (!Halted() && renderer_.in_flight() > 0) {
      if (!encoded_.Push(renderer_.Finish())) return;
    }
  }

  // ---- encoding threads

  void Encode() {
    while (std::optional<RenderedFrame> frame = encoded_.Pop()) {
      const long number = frame->number;
      const auto path = sink_.Write(*std::move(frame));
      if (path) {
        outcome_.Done(number, *path);
        continue;
      }
      const bool is_one_file = plan_.output.is_video();
      if (is_one_file) outcome_.Broke(path.error());
      if (is_one_file || !outcome_.Failed(number, path.error())) {
        encoded_.Abort();
        decoded_.Abort();
        return;
      }
    }
  }

  const Plan& plan_;
  Source& source_;
  FrameRenderer& renderer_;
  Sink& sink_;
  FrameOutcome& outcome_;
  Progress& progress_;
  const std::atomic<bool>& stop_;
  base::BoundedQueue<SourceFrame> decoded_;
  base::BoundedQueue<RenderedFrame> encoded_;
  PicturePool pool_;
};

}  // namespace

Result<void> RunPipeline(const Plan& plan, Source& source, FrameRenderer& renderer, Sink& sink, bool keep_going,
                         Progress& progress, const std::atomic<bool>& stop, long& frames_done) {
  FrameOutcome outcome(keep_going, progress);
  Pipeline(plan, source, renderer, sink, outcome, progress, stop).Run();
  frames_done = outcome.done();
  if (stop) return Fail(ErrorKind::kFailed, "interrupted");
  const bool is_usable = !outcome.broken() && (outcome.done() > 0 || !plan.output.is_video());
  if (is_usable) {
    if (auto finished = sink.Finish(); !finished) return finished;
  }
  if (auto result = outcome.result(); !result) return result;
  if (outcome.done() == 0) return Fail(ErrorKind::kInput, "the source has no frames");
  return {};
}

}  // namespace burin::render
