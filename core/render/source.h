// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/effect/frame_context.h"
#include "core/image/image.h"
#include "core/render/job.h"
#include "core/scene/camera.h"
#include "core/scene/pose.h"
#include "core/scene/scene.h"
#include "core/video/video_module.h"

namespace burin::render {

enum class SourceKind { kNone, kScene, kImage, kSequence, kVideo, kY4mFile, kY4mStream };

/// What --source is by its name: "-" is a y4m stream, a name with a frame number a sequence unless a file has that very
/// name, the rest by extension. kScene: .gltf .glb .obj .bpt.
[[nodiscard]] SourceKind ClassifySource(const std::string& source);

struct SourceInfo {
  SourceKind kind = SourceKind::kNone;
  int width = 0;  ///< 0: the source has no size of its own (scene, none)
  int height = 0;
  std::optional<video::FrameRate> rate;
  bool has_alpha = true;  ///< false: opaque pictures
  image::SampleType type = image::SampleType::kU8;
  std::optional<video::Chroma> chroma;
  /// All frames that there are, ascending; empty: frames 1, 2 ... until Read() says that there are no more.
  std::vector<long> frames;
  std::optional<long> expected_frames;  ///< of those unlisted, what the container says
};

/// A scene at one frame, deformed and ready to draw.
struct SceneFrame {
  scene::Pose pose;
  std::vector<scene::DrawItem> items;
  scene::View view;
  scene::View previous_view;
  effect::FrameContext context;  ///< matrices, eye and key light; time and size are the caller's
};

/// What the source gives for one frame: a picture, a scene, or nothing but the number.
struct SourceFrame {
  long number = 1;
  std::optional<image::Image> picture;
  std::unique_ptr<SceneFrame> scene;
  std::vector<std::string> warnings;  ///< that this frame brought up
  std::vector<std::string> notes;     ///< worth a line of --verbose
};

/// Where frames come from. One thread at a time calls Read.
class Source {
 public:
  virtual ~Source() = default;
  [[nodiscard]] virtual const SourceInfo& info() const = 0;
  /// Fills `frame` for `number`; numbers ascend from call to call. False: the source ends before it. `frame.picture`
  /// may hold an earlier frame, whose memory is used again. Errors: kInput.
  [[nodiscard]] virtual Result<bool> Read(long number, SourceFrame& frame) = 0;
  /// Null but for scenes; valid as long as the source.
  [[nodiscard]] virtual const scene::Scene* scene() const { return nullptr; }
  /// Said once each.
  [[nodiscard]] virtual std::vector<std::string> warnings() const { return {}; }
  /// After the last Read: what is worth a line of --verbose about all of them, which took `elapsed_s` to render.
  [[nodiscard]] virtual std::vector<std::string> Summary(double /*elapsed_s*/) const { return {}; }
};

/// Size of a scene's frame without --size.
inline constexpr std::pair<int, int> kDefaultSize{1280, 720};
/// Rate of what has none of its own, without --fps.
inline constexpr video::FrameRate kDefaultRate{24, 1};

/// Opens the job's source. `wants_tangents`: of a scene, see scene::AddTangents. Errors: kInput, naming the file;
/// kUsage for a camera or animation that is not there.
[[nodiscard]] Result<std::unique_ptr<Source>> OpenSource(const Job& job, bool wants_tangents = false);

// One file each.
[[nodiscard]] Result<std::unique_ptr<Source>> OpenSceneSource(const Job& job, bool wants_tangents);
[[nodiscard]] Result<std::unique_ptr<Source>> OpenPictureSource(const Job& job, SourceKind kind);
[[nodiscard]] Result<std::unique_ptr<Source>> OpenVideoSource(const Job& job, SourceKind kind);

}  // namespace burin::render
