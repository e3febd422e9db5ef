// SPDX-License-Identifier: Apache-2.0
#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/gbuffer/attribute_renderer.h"
#include "core/gbuffer/request_groups.h"
#include "core/gbuffer/storage.h"
#include "core/gl/framebuffer.h"
#include "core/gl/fullscreen_quad.h"
#include "core/gl/program.h"
#include "core/gl/state.h"

namespace burin::gbuffer {
namespace {

constexpr std::string_view kVertex = R"(#version 450 core
layout(location = 0) in vec4 position;
void main() { gl_Position = position; }
)";

// Filtered with associated alpha, so that hidden colours don't leak; by hand, since filtering units keep 8 bits of
// weight.
constexpr std::string_view kFetchFiltered = R"(
vec4 Texel(ivec2 p) {
  vec4 c = texelFetch(picture, clamp(p, ivec2(0), textureSize(picture, 0) - 1), 0);
  return ASSOCIATED ? c : vec4(c.rgb * c.a, c.a);
}
vec4 Fetch() {
  vec2 at = gl_FragCoord.xy * scale - 0.5;
  ivec2 p = ivec2(floor(at));
  vec2 f = at - vec2(p);
  vec4 top = mix(Texel(p), Texel(p + ivec2(1, 0)), f.x);
  vec4 bottom = mix(Texel(p + ivec2(0, 1)), Texel(p + ivec2(1, 1)), f.x);
  vec4 c = mix(top, bottom, f.y);
  return ASSOCIATED || c.a == 0.0 ? c : vec4(c.rgb / c.a, c.a);
}
)";

constexpr std::string_view kFetchSame = R"(
vec4 Fetch() { return texelFetch(picture, ivec2(gl_FragCoord.xy), 0); }
)";

struct ProgramKey {
  std::vector<Storage> storages;
  image::Encoding picture_encoding;
  bool same_size;
  bool operator==(const ProgramKey&) const = default;
};

std::string FragmentText(const ProgramKey& key) {
  std::string text = "#version 450 core\nlayout(binding = 0) uniform sampler2D picture;\nuniform vec2 scale;\n";
  text += fmt::format("const bool ASSOCIATED = {};\n", key.picture_encoding != image::Encoding::kDisplay);
  for (std::size_t i = 0; i < key.storages.size(); ++i) {
    text += fmt::format("layout(location = {0}) out vec4 out{0};\n", i);
  }
  text += StorageFunctions();
  text += key.same_size ? kFetchSame : kFetchFiltered;
  text += "void main() {\n  vec4 stored = Fetch();\n";
  switch (key.picture_encoding) {
    case image::Encoding::kDisplay:
      text += "  vec4 display = stored, scene = SceneFromDisplay(stored);\n";
      break;
    case image::Encoding::kSceneLinear:
      text += "  vec4 display = DisplayFromScene(stored), on_black = DisplayOnBlack(stored), scene = stored;\n";
      break;
    case image::Encoding::kData:
      text += "  vec4 display = stored, scene = stored;\n";
      break;
  }
  for (std::size_t i = 0; i < key.storages.size(); ++i) {
    const bool wants_display = key.storages[i].encoding == image::Encoding::kDisplay;
    const bool is_on_black = key.picture_encoding == image::Encoding::kSceneLinear && !KeepsAlpha(key.storages[i]);
    const bool wants_data = key.storages[i].encoding == image::Encoding::kData;
    text += fmt::format("  out{} = {};\n", i,
                        StorePictureExpression(key.storages[i], wants_data       ? "stored"
                                                                : !wants_display ? "scene"
                                                                : is_on_black    ? "on_black"
                                                                                 : "display"));
  }
  return text + "}\n";
}

bool IsPictureAttribute(Attribute attribute) { return IsColorClass(attribute) || attribute == Attribute::kVideo; }

bool HidesAlpha(const gl::Format& format) { return format.swizzle[3] == GL_ONE; }

bool SameColors(const gl::Format& a, const gl::Format& b) {
  return std::equal(a.swizzle.begin(), a.swizzle.begin() + 3, b.swizzle.begin());
}

// True when the same bits mean the same in both. A target that reads alpha as 1 may hold any.
bool CanCopy(const gl::Texture& picture, image::Encoding encoding, const Request& request) {
  if (request.attribute != Attribute::kColor && request.attribute != Attribute::kVideo) return false;
  const gl::Texture& target = *request.target;
  const gl::Format& from = picture.format();
  const gl::Format& to = target.format();
  const bool same_meaning =
      encoding == request.encoding || encoding == image::Encoding::kData || request.encoding == image::Encoding::kData;
  return same_meaning && picture.width() == target.width() && picture.height() == target.height() &&
         from.internal == to.internal && SameColors(from, to) && (from.swizzle[3] == to.swizzle[3] || HidesAlpha(to));
}

class Renderer final : public PictureRenderer {
 public:
  explicit Renderer(gl::FullscreenQuad quad) : quad_(std::move(quad)) {}

  Result<void> Render(const gl::Texture& picture, image::Encoding encoding,
                      std::span<const Request> requests) override {
    gl::ResetState();
    std::vector<Request> drawn;
    for (const Request& request : requests) {
      const gl::Texture& target = *request.target;
      if (!IsPictureAttribute(request.attribute)) {
        const Storage storage{request.attribute, target.format(), request.encoding};
        const std::array<float, 4> value = StoredBackground(storage, {0, 0, 0, 0});
        glClearTexImage(target.id(), 0, GL_RGBA, GL_FLOAT, value.data());
      } else if (CanCopy(picture, encoding, request)) {
        glCopyImageSubData(picture.id(), GL_TEXTURE_2D, 0, 0, 0, 0, target.id(), GL_TEXTURE_2D, 0, 0, 0, 0,
                           picture.width(), picture.height(), 1);
      } else {
        drawn.push_back(request);
      }
    }
    for (const std::vector<Request>& group : GroupRequests(drawn)) {
      if (Result<void> result = Draw(picture, encoding, group); !result) return result;
    }
    return {};
  }

 private:
  Result<void> Draw(const gl::Texture& picture, image::Encoding encoding, const std::vector<Request>& group) {
    ProgramKey key{.storages = {}, .picture_encoding = encoding, .same_size = true};
    std::vector<const gl::Texture*> targets;
    for (const Request& request : group) {
      key.storages.push_back({request.attribute, request.target->format(), request.encoding});
      targets.push_back(request.target);
    }
    const gl::Texture& first = *targets.front();
    key.same_size = first.width() == picture.width() && first.height() == picture.height();
    const Result<const gl::Program*> program = FindProgram(key);
    if (!program) return std::unexpected(program.error());
    const Result<gl::Framebuffer> framebuffer = gl::Framebuffer::Create(targets, nullptr, "picture's attributes");
    if (!framebuffer) return std::unexpected(framebuffer.error());

    framebuffer->Bind();
    glUseProgram((*program)->id());
    glUniform2f((*program)->UniformLocation("scale"),
                static_cast<float>(picture.width()) / static_cast<float>(first.width()),
                static_cast<float>(picture.height()) / static_cast<float>(first.height()));
    glBindTextureUnit(0, picture.id());
    glBindSampler(0, 0);
    quad_.Draw();
    return {};
  }

  Result<const gl::Program*> FindProgram(const ProgramKey& key) {
    const auto found = std::ranges::find(programs_, key, &Entry::key);
    if (found != programs_.end()) return &found->program;
    Result<gl::Program> program = gl::Program::Create(kVertex, FragmentText(key), "picture's attributes");
    if (!program) return std::unexpected(program.error());
    programs_.push_back({key, std::move(*program)});
    return &programs_.back().program;
  }

  struct Entry {
    ProgramKey key;
    gl::Program program;
  };
  gl::FullscreenQuad quad_;
  std::vector<Entry> programs_;
};

}  // namespace

bool PictureRenderer::CanAlias(const gl::Texture& picture, image::Encoding picture_encoding, const Request& request) {
  return CanCopy(picture, picture_encoding, request) && picture.format().swizzle == request.target->format().swizzle;
}

Result<std::unique_ptr<PictureRenderer>> PictureRenderer::Create() {
  Result<gl::FullscreenQuad> quad = gl::FullscreenQuad::Create();
  if (!quad) return std::unexpected(quad.error());
  return std::make_unique<Renderer>(std::move(*quad));
}

}  // namespace burin::gbuffer
