// SPDX-License-Identifier: Apache-2.0
#include "cli/option_table.h"

#include <fmt/format.h>

#include <string>

#include "cli/option_values.h"
#include "core/render/frame_list.h"

namespace burin::cli {
namespace {

/// Puts a parsed value in its place.
template <class T, class U>
Result<void> Store(U& place, Result<T> value) {
  if (!value) return std::unexpected(std::move(value).error());
  place = static_cast<U>(*std::move(value));
  return {};
}

template <class T>
Result<void> Append(std::vector<T>& list, Result<T> value) {
  if (!value) return std::unexpected(std::move(value).error());
  list.push_back(*std::move(value));
  return {};
}

Result<void> StoreFrames(Settings& settings, const std::string& value) {
  return Store(settings.job.frames, render::ParseFrameList(value));
}

Result<void> StoreAttributes(Settings& settings, const std::string& value) {
  auto names = ParseNames("attributes", value);
  if (!names) return std::unexpected(names.error());
  for (std::string& name : *names) settings.job.attributes.push_back(std::move(name));
  return {};
}

Result<void> StoreDepth(Settings& settings, const std::string& value) {
  settings.job.depth_bits = std::stoi(value);
  return {};
}

Result<void> StoreSamples(Settings& settings, const std::string& value) {
  settings.job.samples = std::stoi(value);
  return {};
}

Result<void> StoreWithin(float& place, const std::string& option, const std::string& value, double least, double most) {
  const Result<double> number = ParseNumber(option, value);
  if (!number) return std::unexpected(number.error());
  if (!(*number >= least && *number <= most)) {
    return Fail(ErrorKind::kUsage, fmt::format("--{}: {} is not between {} and {}", option, value, least, most));
  }
  place = static_cast<float>(*number);
  return {};
}

Result<void> StoreEdges(Settings& settings, const std::string& value) {
  using enum overdraw::EdgeMode;
  settings.job.edges.mode = value == "off"        ? kOff
                            : value == "unsorted" ? kUnsorted
                            : value == "sorted"   ? kSorted
                                                  : kResolve;
  return {};
}

Result<void> StoreUp(Settings& settings, const std::string& value) {
  using enum scene::UpAxis;
  const bool is_minus = value.front() == '-';
  const char axis = value.back();
  settings.job.up = axis == 'x'   ? (is_minus ? kMinusX : kX)
                    : axis == 'z' ? (is_minus ? kMinusZ : kZ)
                                  : (is_minus ? kMinusY : kY);
  return {};
}

Result<void> StoreTessellation(Settings& settings, const std::string& value) {
  using enum scene::TessellationMode;
  settings.job.tessellation.mode = value == "off" ? kOff : value == "integer" ? kInteger : kFractional;
  return {};
}

Result<void> StoreEdgeLength(Settings& settings, const std::string& value) {
  return StoreWithin(settings.job.tessellation.edge_length_px.emplace(), "edge-length", value, 0.25, 10'000.0);
}

Result<void> StoreFactor(Settings& settings, const std::string& value) {
  const Result<double> factor = ParseNumber("tessellation-factor", value);
  if (!factor) return std::unexpected(factor.error());
  settings.job.tessellation.factor = static_cast<float>(*factor);
  return {};
}

Result<void> StoreScattering(Settings& settings, const std::string& value) {
  using enum translucency::Scattering;
  settings.job.translucency.scattering = value == "paper"  ? kPaper
                                         : value == "fast" ? kFast
                                         : value == "high" ? kHigh
                                                           : kFull;
  return {};
}

Result<void> AddTranslucency(Settings& settings, const std::string& value) {
  Result<translucency::Assignment> assignment = translucency::ParseAssignment(value);
  if (!assignment) return Fail(ErrorKind::kUsage, "--translucency: " + assignment.error().message);
  settings.job.translucency.assignments.push_back(*std::move(assignment));
  return {};
}

Result<void> StoreUnit(Settings& settings, const std::string& value) {
  float unit_mm = 0.0f;
  if (auto good = StoreWithin(unit_mm, "unit-mm", value, 1e-9, 1e9); !good) return good;
  settings.job.translucency.unit_mm = std::stod(value);
  return {};
}

Result<void> StoreAlpha(Settings& settings, const std::string& value) {
  using enum render::AlphaOutput;
  settings.job.alpha = value == "keep" ? kKeep : value == "drop" ? kDrop : kAuto;
  return {};
}

Result<void> StoreChroma(Settings& settings, const std::string& value) {
  settings.job.chroma = value == "420"   ? video::Chroma::k420
                        : value == "422" ? video::Chroma::k422
                                         : video::Chroma::k444;
  return {};
}

Result<void> StoreProgress(Settings& settings, const std::string& value) {
  using enum ProgressMode;
  settings.progress = value == "bar"      ? kBar
                      : value == "plain"  ? kPlain
                      : value == "json"   ? kJson
                      : value == "openjd" ? kOpenJd
                                          : kNone;
  return {};
}

Result<void> StoreLogLevel(Settings& settings, const std::string& value) {
  settings.log_level = value == "error" ? LogLevel::kError : value == "warning" ? LogLevel::kWarning : LogLevel::kInfo;
  return {};
}

constexpr std::string_view kInput = "Input";
constexpr std::string_view kFrames = "Frames";
constexpr std::string_view kScene = "Scene";
constexpr std::string_view kEffect = "Effect";
constexpr std::string_view kOutput = "Output";
constexpr std::string_view kColor = "Colour";
constexpr std::string_view kRunning = "Running";
constexpr std::string_view kMessages = "Messages";

constexpr unsigned kLanguage = kRender | kCheck | kInfo;
constexpr unsigned kAny = ~0u;

constexpr OptionSpec kTable[] = {
    {"output", 'o', "FILE", kRender, kOutput,
     "Where the result goes; the extension says what it is: .png .jpg .tif .exr ... for images, .mkv .avi (lossless "
     "FFV1) .mp4 .mov (H.264) for video, .y4m or - (stdout) for a YUV4MPEG2 stream. A name for several images holds "
     "the "
     "frame number: walk.####.png, walk.%04d.png or walk.{frame:04}.png.",
     "", Repeat::kLast,
     [](Settings& s, const std::string& v) {
       s.job.output = v;
       return Result<void>();
     }},
    {"output", 'o', "FILE", kTessellate, kOutput,
     "Where the triangles go: .glb (glTF binary), .obj, .ply (binary), or - for GLB on stdout.", "", Repeat::kLast,
     [](Settings& s, const std::string& v) {
       s.job.output = v;
       return Result<void>();
     }},
    {"mkdir", 0, "", kRender | kTessellate, kOutput, "Make the output's folder when it is not there.", "", Repeat::kLast,
     [](Settings& s, const std::string&) {
       s.job.make_folders = true;
       return Result<void>();
     }},
    {"size", 0, "WxH", kRender | kTessellate, kOutput,
     "Size of the frame in pixels. Otherwise that of the picture or video, and 1280x720 for a scene. Pictures are "
     "resized to it (bilinear).",
     "", Repeat::kLast, [](Settings& s, const std::string& v) { return Store(s.job.size, ParseSize(v)); }},
    {"depth", 0, "BITS", kRender, kOutput,
     "Bits a channel: 8 or 16 for PNG and TIFF (8, or 16 for a 16-bit source), 16 (half) or 32 (float) for EXR "
     "(half for colours, float for what needs it).",
     "8|16|32", Repeat::kLast, StoreDepth},
    {"alpha", 0, "MODE", kRender, kOutput,
     "Whether the frame's alpha goes into the file: auto keeps it where the source has one (scenes, pictures with "
     "alpha), keep and drop decide.",
     "auto|keep|drop", Repeat::kLast, StoreAlpha},
    {"quality", 0, "N", kRender, kOutput, "JPEG quality, 1 to 100. Otherwise 95.", "", Repeat::kLast,
     [](Settings& s, const std::string& v) { return Store(s.job.quality, ParseInteger("quality", v, 1, 100)); }},
    {"chroma", 0, "MODE", kRender, kOutput,
     "Chroma subsampling of y4m output. Otherwise that of a video source, and 444 for the rest.", "420|422|444",
     Repeat::kLast, StoreChroma},
    {"attributes", 0, "LIST", kRender, kOutput,
     "Write these G-buffer attributes (color, normal, depth ...; burin-attributes(7)), separated by commas, as layers "
     "of "
     "an EXR file, beside the frame when there is an effect. An output that is no EXR takes one attribute and no "
     "effect.",
     "", Repeat::kLast, StoreAttributes},

    {"frames", 0, "LIST", kRender | kTessellate, kFrames,
     "Frames to do, by absolute number: 1-10, 1..10, 1-10x2 or 1-10:2 (every second), lists by comma, negative ones "
     "(-3--1). Otherwise all of a video or sequence; of a scene the whole animation when the output takes several "
     "frames, else frame 1.",
     "", Repeat::kLast, StoreFrames},
    {"fps", 0, "RATE", kRender | kTessellate, kFrames,
     "Frames a second, such as 24, 23.976 or 30000/1001: frame n shows the time (n - 1) / RATE. Otherwise the "
     "source's, "
     "and 24 where it has none.",
     "", Repeat::kLast, [](Settings& s, const std::string& v) { return Store(s.job.fps, ParseFrameRate(v)); }},

    {"camera", 0, "CAMERA", kRender | kTessellate, kScene,
     "Name or index of the scene's camera, or auto, which frames the whole scene. Otherwise the first camera, or auto "
     "where there is none.",
     "", Repeat::kLast,
     [](Settings& s, const std::string& v) {
       s.job.camera = v;
       return Result<void>();
     }},
    {"orbit", 0, "DEGREES", kRender | kTessellate, kScene,
     "Turn the camera about the vertical axis through the scene's centre, the same for all frames. With it the "
     "automatic camera stands where every angle shows the whole scene.",
     "", Repeat::kLast,
     [](Settings& s, const std::string& v) { return Store(s.job.orbit_deg, ParseNumber("orbit", v)); }},
    {"turntable", 0, "N", kRender, kScene,
     "Turn the camera evenly, once in N frames; without --frames, N frames are done.", "", Repeat::kLast,
     [](Settings& s, const std::string& v) {
       return Store(s.job.turntable_frames, ParseInteger("turntable", v, 1, 1'000'000));
     }},
    {"animation", 0, "NAME", kRender | kTessellate, kScene,
     "Name or index of the animation that plays, all, none, or auto: every one whose targets no earlier one moves. "
     "Otherwise auto.",
     "", Repeat::kLast,
     [](Settings& s, const std::string& v) {
       s.job.animation = v;
       return Result<void>();
     }},
    {"up", 0, "AXIS", kRender | kTessellate, kScene,
     "Which of the file's axes points upwards; patch models and .obj files often have z there. Otherwise y, glTF's.",
     "x|-x|y|-y|z|-z", Repeat::kLast, StoreUp},
    {"environment", 0, "FILE", kRender, kScene,
     "Map (.hdr, .exr) that lights the scene: equirectangular, or a cube as a cross (4:3, 3:4) or a row or column of "
     "faces (+x -x +y -y +z -z). Otherwise a neutral one that is built in.", "",
     Repeat::kLast,
     [](Settings& s, const std::string& v) {
       s.job.environment = v;
       return Result<void>();
     }},
    {"background", 0, "COLOR", kRender, kScene,
     "Colour behind the scene: #RRGGBB or #RRGGBBAA (sRGB), R,G,B or R,G,B,A (scene-linear), black, white. Otherwise "
     "transparent.",
     "", Repeat::kLast, [](Settings& s, const std::string& v) { return Store(s.job.background, ParseColor(v)); }},
    {"samples", 0, "N", kRender, kScene,
     "Supersample the scene: color, intensity and alpha are the mean of 1, 4 (2x2) or 16 (4x4) samples a pixel, in "
     "linear light. Ids and other data are never averaged. Otherwise 1.",
     "1|4|16", Repeat::kLast, StoreSamples},

    {"edges", 0, "MODE", kRender, kScene,
     "Antialias the scene's discontinuity edges: resolve mixes the two sides of an edge by the area that each has of a "
     "pixel; sorted and unsorted draw smooth lines over the edges (discontinuity edge overdraw), back to front or in "
     "any order; off. Ids and other data are never touched. Otherwise resolve.",
     "off|unsorted|sorted|resolve", Repeat::kLast, StoreEdges},
    {"crease-angle", 0, "DEGREES", kRender | kTessellate, kScene,
     "Faces that meet at more than this angle, 0 to 180, are a crease even where the shading is smooth. Otherwise 60.",
     "", Repeat::kLast,
     [](Settings& s, const std::string& v) {
       return StoreWithin(s.job.edges.crease_angle_deg, "crease-angle", v, 0.0, 180.0);
     }},
    {"edge-tau", 0, "T", kRender, kScene,
     "sorted, unsorted: how far, 0 to 1, a sharp edge turns from its left face to its right one before it takes on the "
     "right one's shading. Otherwise 0.9.",
     "", Repeat::kLast,
     [](Settings& s, const std::string& v) { return StoreWithin(s.job.edges.tau, "edge-tau", v, 0.0, 1.0); }},
    {"edge-order", 0, "ORDER", kRender, kScene,
     "sorted: the edges of the whole scene in one order, or object by object. Otherwise scene.", "scene|object",
     Repeat::kLast,
     [](Settings& s, const std::string& v) {
       s.job.edges.sorts_whole_scene = v == "scene";
       return Result<void>();
     }},
    {"translucency", 0, "GLOB=MEDIUM", kRender, kScene,
     "Make the materials whose names fit translucent: a measured medium (Apple, Chicken1, Chicken2, Cream, Ketchup, "
     "Marble, Potato, Skimmilk, Skin1, Skin2, Spectralon, Wholemilk), scattering:R,G,B;absorption:R,G,B[;ior:N] per "
     "millimetre, albedo:R,G,B;path:R,G,B[;ior:N] with the mean free path in millimetres, or none. Can be given several "
     "times; the last that fits counts. Otherwise what the file says.",
     "", Repeat::kCollect, AddTranslucency},
    {"unit-mm", 0, "N", kRender, kScene, "Millimetres a scene unit, for translucency. Otherwise 1000, glTF's metre.",
     "", Repeat::kLast, StoreUnit},
    {"scattering", 0, "HOW", kRender, kScene,
     "How translucent light is gathered: paper is the published method with its kernel of one mean free path; fast, full "
     "and high take in all of it, ever more closely. Otherwise full.",
     "paper|fast|full|high", Repeat::kLast, StoreScattering},
    {"paper-kernel", 0, "N", kRender, kScene,
     "With --scattering paper: samples across the kernel, 1 to 32. Otherwise 5, which the paper finds enough.", "",
     Repeat::kLast,
     [](Settings& s, const std::string& v) {
       const Result<long> number = ParseInteger("paper-kernel", v, 1, 32);
       if (!number) return Result<void>(std::unexpected(number.error()));
       s.job.translucency.paper_kernel = static_cast<int>(*number);
       return Result<void>();
     }},
    {"morph-to-sphere", 0, "T", kRender, kScene,
     "Deform each object towards its bounding sphere: 0 not at all, 1 all the way. Otherwise 0.", "", Repeat::kLast,
     [](Settings& s, const std::string& v) {
       return StoreWithin(s.job.morph_to_sphere, "morph-to-sphere", v, 0.0, 1.0);
     }},

    {"tessellation", 0, "MODE", kRender | kTessellate, kScene,
     "Draw curved surfaces as triangles: integer cuts sides into equal pieces; fractional moves smoothly from one number "
     "of pieces to the next, for animations; off draws the triangles of the file. Meshes become PN triangles, which "
     "follow their normals. Otherwise fractional for patch models (.bpt) and subdivision surfaces (.obj), and for "
     "meshes off, but fractional with --edge-length or --tessellation-factor.",
     "off|integer|fractional", Repeat::kLast, StoreTessellation},
    {"edge-length", 0, "PIXELS", kRender | kTessellate, kScene,
     "Tessellation: how long a triangle's side may be in the picture, 0.25 to 10000. Otherwise 8.", "", Repeat::kLast,
     StoreEdgeLength},
    {"tessellation-factor", 0, "N", kRender | kTessellate, kScene,
     "Tessellation: cut every side in N pieces, 1 to 256, whatever the view.", "", Repeat::kLast, StoreFactor},

    {"param", 0, "NAME=VALUE", kRender, kEffect,
     "Set a parameter of the effect: numbers separated by commas, true or false, or a file for a texture. Can be given "
     "several times; burin info EFFECT lists the parameters.",
     "", Repeat::kCollect,
     [](Settings& s, const std::string& v) { return Append(s.job.parameters, ParseAssignment("param", v, nullptr)); }},
    {"texture", 0, "NAME=FILE", kRender, kEffect,
     "Give a texture of the effect this picture instead of the one that it names. Can be given several times.", "",
     Repeat::kCollect,
     [](Settings& s, const std::string& v) {
       return Append(s.job.parameters, ParseAssignment("texture", v, nullptr, "FILE"));
     }},
    {"technique", 0, "NAME", kRender | kInfo, kEffect,
     "Use this technique. Otherwise the first that this device can run.", "", Repeat::kLast,
     [](Settings& s, const std::string& v) {
       s.job.technique = v;
       return Result<void>();
     }},
    {"include", 'I', "FOLDER", kLanguage, kEffect,
     "Look for included files here too, after the including file's own folder. Can be given several times.", "",
     Repeat::kCollect,
     [](Settings& s, const std::string& v) {
       s.job.include_folders.push_back(v);
       return Result<void>();
     }},
    {"define", 'D', "NAME[=VALUE]", kLanguage, kEffect,
     "Define a macro for the effect's preprocessor; without VALUE it is 1. Can be given several times.", "",
     Repeat::kCollect,
     [](Settings& s, const std::string& v) { return Append(s.job.definitions, ParseAssignment("define", v, "1")); }},

    {"ocio", 0, "CONFIG", kRender, kColor,
     "OpenColorIO configuration whose display and view turn scene-linear light into what 8- and 16-bit files and video "
     "hold. Otherwise $OCIO, and plain sRGB without either.",
     "", Repeat::kLast,
     [](Settings& s, const std::string& v) {
       s.job.color.config = v;
       return Result<void>();
     }},
    {"display", 0, "NAME", kRender, kColor, "Display of the configuration. Otherwise its default.", "", Repeat::kLast,
     [](Settings& s, const std::string& v) {
       s.job.color.display = v;
       return Result<void>();
     }},
    {"view", 0, "NAME", kRender, kColor, "View of the display. Otherwise its default.", "", Repeat::kLast,
     [](Settings& s, const std::string& v) {
       s.job.color.view = v;
       return Result<void>();
     }},

    {"device", 0, "DEVICE", kRender | kVersion, kRunning,
     "auto (hardware if it works, else software), software, the number of a device, cuda:N, or a part of a renderer's "
     "name. burin --version --verbose lists them.",
     "", Repeat::kLast,
     [](Settings& s, const std::string& v) {
       s.job.device = v;
       return Result<void>();
     }},
    {"threads", 0, "N", kRender, kRunning,
     "Threads for encoding and software rendering. Otherwise as many as this process may use processors.", "",
     Repeat::kLast,
     [](Settings& s, const std::string& v) { return Store(s.job.threads, ParseInteger("threads", v, 1, 1024)); }},
    {"keep-going", 0, "", kRender, kRunning,
     "Leave out a frame that fails and go on with the next; the exit status is still 1.", "", Repeat::kLast,
     [](Settings& s, const std::string&) {
       s.job.keep_going = true;
       return Result<void>();
     }},

    {"progress", 0, "MODE", kRender, kMessages,
     "bar, plain (a line a frame), json (an object a line), openjd (Open Job Description), or none. Otherwise bar on a "
     "terminal and plain elsewhere.",
     "bar|plain|json|openjd|none", Repeat::kLast, StoreProgress},
    {"progress-fd", 0, "N", kRender, kMessages, "File descriptor that the progress goes to. Otherwise 2 (stderr).", "",
     Repeat::kLast,
     [](Settings& s, const std::string& v) {
       return Store(s.progress_descriptor, ParseInteger("progress-fd", v, 1, 1023));
     }},
    {"json", 0, "", kCheck | kInfo | kEffects, kMessages, "Write JSON to stdout.", "", Repeat::kLast,
     [](Settings& s, const std::string&) {
       s.json = true;
       return Result<void>();
     }},
    {"glsl", 0, "FOLDER", kCheck, kMessages,
     "Write the GLSL of every pass into this folder, as EFFECT.TECHNIQUE.PASS.vert and .frag. It is made if it is not "
     "there.",
     "", Repeat::kLast,
     [](Settings& s, const std::string& v) {
       s.glsl_folder = v;
       return Result<void>();
     }},
    {"dot", 0, "", kInfo, kMessages, "Write the effect's data flow as a Graphviz graph to stdout.", "", Repeat::kLast,
     [](Settings& s, const std::string&) {
       s.dot = true;
       return Result<void>();
     }},
    {"quiet", 'q', "", kAny, kMessages, "Errors only: no progress, no warnings.", "", Repeat::kLast,
     [](Settings& s, const std::string&) {
       s.log_level = LogLevel::kError;
       if (s.progress == ProgressMode::kAuto) s.progress = ProgressMode::kNone;
       return Result<void>();
     }},
    {"verbose", 'v', "", kAny, kMessages, "Say more: the device, sizes, what was chosen and why.", "", Repeat::kLast,
     [](Settings& s, const std::string&) {
       s.log_level = LogLevel::kInfo;
       return Result<void>();
     }},
    {"log-level", 0, "LEVEL", kAny, kMessages, "What is said: error, warning (otherwise) or info.",
     "error|warning|info", Repeat::kLast, StoreLogLevel},
    {"help", 'h', "", kAny, kMessages, "Show this help.", "", Repeat::kLast,
     [](Settings& s, const std::string&) {
       s.help = true;
       return Result<void>();
     }},
};

}  // namespace

std::span<const OptionSpec> OptionTable() { return kTable; }

}  // namespace burin::cli
