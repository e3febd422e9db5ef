// SPDX-License-Identifier: Apache-2.0
#include "tests/gl/effect/effect_fixture.h"

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <random>

#include "core/effect/target_format.h"
#include "core/gl/context.h"
#include "core/gl/readback.h"
#include "fx_parser/fx_parser.h"

namespace burin::effect {
namespace {

// One debug context for the whole process: what the driver calls an error ends the test.
class ContextEnvironment final : public ::testing::Environment {
 public:
  void SetUp() override {
    auto context = gl::Context::Create({.device = "software", .debug = true});
    ASSERT_TRUE(context.has_value()) << context.error().message;
    // Kept to the end of the process: a driver that is unloaded earlier has its leaks reported without its name, which
    // is what lsan.supp goes by.
    static gl::Context* const kept = context->release();
    ASSERT_NE(kept, nullptr);
  }
};
[[maybe_unused]] const auto* const kEnvironment = ::testing::AddGlobalTestEnvironment(new ContextEnvironment);

std::shared_ptr<const fx::Effect> Compile(const std::string& path, const fx::FileSystem& files) {
  fx::Options options;
  options.attributes = {"color",    "intensity",  "alpha",       "albedo",    "depth",        "zbuffer",
                        "normal",   "viewnormal", "tangent",     "position",  "viewposition", "screenposition",
                        "texcoord", "texcoord1",  "vertexcolor", "objectid",  "materialid",   "primitiveid",
                        "facing",   "velocity",   "emissive",    "roughness", "metallic",     "lightdepth",
                        "video",    "edges",      "edgedist",    "patchuv",   "patchid"};
  fx::CompileResult result = fx::CompileEffect(path, files, options);
  if (!result.effect) {
    std::string text;
    for (const fx::Diagnostic& diagnostic : result.diagnostics) text += FormatDiagnostic(diagnostic, result.sources);
    ADD_FAILURE() << text;
    return nullptr;
  }
  return std::make_shared<const fx::Effect>(std::move(*result.effect));
}

}  // namespace

std::string SourceFolder() {
  const char* folder = std::getenv("BURIN_SOURCE_DIR");
  return folder != nullptr ? folder : ".";
}

std::shared_ptr<const fx::Effect> CompileText(const std::string& text, const std::string& path) {
  fx::InMemoryFileSystem files;
  files.files[path] = text;
  return Compile(path, files);
}

std::shared_ptr<const fx::Effect> CompileFile(const std::string& path) {
  return Compile(SourceFolder() + "/" + path, fx::DiskFileSystem());
}

image::Image MakeImage(int width, int height, image::SampleType type, const std::function<Rgba(int, int)>& at) {
  image::Image image{.width = width, .height = height, .channels = 4, .type = type, .encoding = {}, .pixels = {}};
  image.pixels.resize(image.RowBytes() * static_cast<std::size_t>(height));
  std::size_t next = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (const float value : at(x, y)) {
        if (type == image::SampleType::kF32) {
          image.As<float>()[next++] = value;
        } else if (type == image::SampleType::kU16) {
          image.As<std::uint16_t>()[next++] = static_cast<std::uint16_t>(std::lround(value * 65535.0f));
        } else {
          image.As<std::uint8_t>()[next++] = static_cast<std::uint8_t>(std::lround(value * 255.0f));
        }
      }
    }
  }
  return image;
}

image::Image MakeNoise(int width, int height, image::SampleType type, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
  return MakeImage(width, height, type, [&](int, int) {
    return Rgba{uniform(random), uniform(random), uniform(random), uniform(random)};
  });
}

Bench::Bench(std::shared_ptr<const fx::Effect> effect, int width, int height, const Settings& parameters,
             const std::string& technique, TextureLoader loader) {
  context.width = width;
  context.height = height;
  if (!effect) return;
  RunnerOptions options;
  options.technique = technique;
  options.parameters = parameters;
  options.load_texture = std::move(loader);
  options.width = width;
  options.height = height;
  options.display_frame_format = gl::PlainFormat(gl::Numeric::kUnorm, 8, 4);
  options.linear_frame_format = gl::PlainFormat(gl::Numeric::kFloat, 32, 4);
  auto created = EffectRunner::Create(std::move(effect), options);
  if (!created) {
    ADD_FAILURE() << created.error().message;
    return;
  }
  runner = std::move(*created);
}

void Bench::Fill(const std::string& attribute, const image::Image& picture) {
  if (!runner) return;
  bool found = false;
  for (const AttributeTarget& target : runner->attributes()) {
    if (target.attribute != attribute) continue;
    found = true;
    ASSERT_EQ(target.texture->width(), picture.width);
    ASSERT_EQ(target.texture->height(), picture.height);
    const_cast<gl::Texture*>(target.texture)->Upload(picture);
  }
  EXPECT_TRUE(found) << "no attribute " << attribute;
}

const gl::Texture* Bench::Run(const SceneDraws& scene) {
  if (!runner) return nullptr;
  auto frame = runner->Run(context, scene);
  if (!frame) {
    ADD_FAILURE() << frame.error().message;
    return nullptr;
  }
  return *frame;
}

PixelMap Bench::RunPixels(const SceneDraws& scene) {
  const gl::Texture* frame = Run(scene);
  // Of the asked-for size even after a failure, so that tests fail by values.
  if (frame == nullptr) {
    const auto count = static_cast<std::size_t>(context.width) * static_cast<std::size_t>(context.height);
    return {context.width, context.height, std::vector<Rgba>(count, Rgba{-99, -99, -99, -99})};
  }
  return ReadPixels(*frame);
}

image::Image Bench::RunImage(image::SampleType type) {
  const gl::Texture* frame = Run();
  return frame == nullptr ? image::Image{} : gl::Read(*frame, type, 4, image::Encoding::kDisplay);
}

PixelMap ReadPixels(const gl::Texture& texture) {
  const image::Image image = gl::Read(texture, image::SampleType::kF32, 4, image::Encoding::kData);
  PixelMap map{image.width, image.height, {}};
  const auto samples = image.As<float>();
  map.pixels.resize(samples.size() / 4);
  std::memcpy(map.pixels.data(), samples.data(), samples.size_bytes());
  return map;
}

PixelMap RunText(const std::string& text, int width, int height, const Settings& parameters) {
  Bench bench(CompileText(text), width, height, parameters);
  return bench.RunPixels();
}

Rgba Evaluate(const std::string& expression, const std::string& globals, const Settings& parameters) {
  const std::string text =
      globals + "\nfloat4 Result() : COLOR { return " + expression +
      "; }\ntechnique T < string ColorSpace = \"linear\"; > { pass P { PixelShader = compile ps_3_0 "
      "Result(); } }\n";
  return RunText(text, 1, 1, parameters).at(0, 0);
}

::testing::AssertionResult Near(const Rgba& actual, const Rgba& expected, float tolerance) {
  for (std::size_t i = 0; i < 4; ++i) {
    const float scale = std::max(1.0f, std::abs(expected[i]));
    if (!(std::abs(actual[i] - expected[i]) <= tolerance * scale)) {
      return ::testing::AssertionFailure()
             << "(" << actual[0] << ", " << actual[1] << ", " << actual[2] << ", " << actual[3] << ") instead of ("
             << expected[0] << ", " << expected[1] << ", " << expected[2] << ", " << expected[3] << ")";
    }
  }
  return ::testing::AssertionSuccess();
}

}  // namespace burin::effect
