// SPDX-License-Identifier: Apache-2.0
#include "cli/command_table.h"

#include <algorithm>

namespace burin::cli {
namespace {

constexpr Example kRenderExamples[] = {
    {"burin render edges/dilated_edges scene.glb -o edges.png --size 1024x1024", "a scene through a shipped effect"},
    {"burin render toon.fx fox.glb --frames 1-48 --fps 24 -o walk.####.png", "an animation, an image a frame"},
    {"burin render edges/sobel clip.mp4 -o edges.mkv", "a video through an effect, lossless"},
    {"burin render edges/sobel 'in.####.png' -o 'out.####.png'", "an image sequence"},
    {"burin render scene.glb --attributes color,normal,depth -o gbuffer.exr", "the G-buffer as layers of an EXR"},
    {"ffmpeg -i clip.mp4 -f yuv4mpegpipe - | burin render edges/sobel - -o - | ffmpeg -i - out.mp4", "in a pipe"},
};
constexpr Example kCheckExamples[] = {
    {"burin check toon.fx", "compile everything, print what is wrong"},
    {"burin check effects/*.fx -I include -D QUALITY=2", "several files, with include folders and macros"},
};
constexpr Example kInfoExamples[] = {
    {"burin info edges/dilated_edges", "parameters, attributes, passes and data flow of an effect"},
    {"burin info toon.fx --dot | dot -Tsvg > toon.svg", "the data flow as a picture"},
    {"burin info scene.glb --json", "meshes, cameras, animations ... of a scene, for scripts"},
};
constexpr Example kTessellateExamples[] = {
    {"burin tessellate teapot.bpt -o teapot.glb --tessellation-factor 16", "patches as a mesh, each side in 16 pieces"},
    {"burin tessellate fox.glb -o fox.ply --frames 12 --edge-length 4",
     "a mesh as PN triangles, in one pose, as fine as "
     "a picture of it needs"},
};
constexpr Example kEffectsExamples[] = {
    {"burin effects", "every shipped effect, a line each"},
    {"burin effects edges", "those whose name holds 'edges'"},
};
constexpr Example kVersionExamples[] = {
    {"burin --version", "this program's version"},
    {"burin --version --verbose", "with those of the libraries, the GL device and what --device can name"},
};
constexpr Example kHelpExamples[] = {{"burin help render", "everything about one command"}};
constexpr Example kCompletionExamples[] = {{"source <(burin completion bash)", "in ~/.bashrc"}};

constexpr CommandSpec kCommands[] = {
    {"render", kRender, "[EFFECT.fx ...] [SOURCE] -o OUT",
     "Render a scene, or filter images and video, through effects",
     "Renders SOURCE through the effects and writes the result. SOURCE is a scene (.gltf, .glb, .obj, .bpt), an image, "
     "an image "
     "sequence (in.####.png), a video, or - for a YUV4MPEG2 stream on stdin; some effects need none. An effect is a "
     "file "
     "or the name of a shipped one (burin effects). Several form a chain: each one's result is the next one's color. "
     "With no effect the colour of the source is the frame.\n"
     "Files appear whole or not at all; two runs write identical bytes; a frame on its own has the same bits as in a "
     "full run. When OUT is - every message goes to stderr.",
     kRenderExamples, RunRender},
    {"check", kCheck, "EFFECT.fx ...", "Compile effect files and print what is wrong with them",
     "Preprocesses, parses and compiles everything in each file, and prints errors and warnings as a compiler does. "
     "The "
     "exit status is 0 when there are no errors, else 3. No GL device is needed.",
     kCheckExamples, RunCheck},
    {"info", kInfo, "FILE ...", "Show what an effect declares, or what a scene, image or video holds",
     "For an effect: its parameters, G-buffer attributes with formats and sizes, passes, the data flow between them, "
     "the "
     "technique that is used and why others are not. For a scene: meshes, materials, cameras, lights, animations. For "
     "images and videos: size, format and rate.",
     kInfoExamples, RunInfo},
    {"tessellate", kTessellate, "MODEL -o OUT", "Write the triangles of a curved surface as a mesh",
     "Tessellates MODEL (.bpt patches, .obj subdivision surfaces, and meshes in .obj, .gltf, .glb as PN triangles) and "
     "writes the triangles: watertight, two patches that share a side have the same positions there. The level of "
     "detail is the same as a picture's of this size and camera, or --tessellation-factor.\n"
     "Normals, texture coordinates and colours are written, pictures of materials are not. A .glb keeps world matrices "
     "as nodes; .obj and .ply have them applied.",
     kTessellateExamples, RunTessellate},
    {"effects", kEffects, "[WORD ...]", "List the shipped effects, a line each",
     "Prints the name and purpose of each shipped effect, or of those whose name or purpose holds every WORD. The name "
     "is "
     "what burin render takes.",
     kEffectsExamples, RunEffects},
    {"version", kVersion, "", "Show versions; with --verbose those of the libraries and the GL device",
     "Prints the version. With --verbose also those of the libraries, the GL device that --device gives, and the "
     "devices "
     "that it can name.",
     kVersionExamples, RunVersion},
    {"help", kHelp, "[COMMAND]", "Show help about a command", "Shows the help of COMMAND, or the list of commands.",
     kHelpExamples, RunHelp},
    {"completion", kCompletion, "bash", "Print a shell's completion script",
     "Prints a script that completes commands, options, their values and the names of shipped effects.",
     kCompletionExamples, RunCompletion},
};

}  // namespace

std::span<const CommandSpec> CommandTable() { return kCommands; }

const CommandSpec* FindCommand(std::string_view name) {
  const auto found = std::ranges::find(kCommands, name, &CommandSpec::name);
  return found == std::end(kCommands) ? nullptr : &*found;
}

}  // namespace burin::cli
