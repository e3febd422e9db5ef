// SPDX-License-Identifier: Apache-2.0
// Speed of the translucency stage: whole frames of 512 x 512 against the same frames with a shadow map and plain
// lighting, medians of one run, deforming every frame and with the camera alone moving. Wall clock and CPU time of all
// threads, for a machine that others use too.
//   bench_translucency_speed [FRAMES] [WAY...]
#include <epoxy/gl.h>

#include <chrono>
#include <cstring>
#include <ctime>

#include "core/gl/context.h"
#include "core/scene/gltf_reader.h"
#include "core/scene/morph_to_sphere.h"
#include "core/translucency/shadow_maps.h"
#include "tests/support/scattering_stand.h"

namespace burin::translucency {
namespace {

constexpr int kSize = 512;

scene::Scene SceneOf(Surface surface) {
  scene::Scene scene;
  scene::Material material;
  material.name = "medium";
  material.metallic = 0.0f;
  scene.materials.push_back(material);
  scene.meshes.emplace_back();
  scene.meshes[0].primitives.push_back(ToPrimitive(surface, 0));
  scene::Light light;
  light.type = scene::LightType::kPoint;
  light.intensity = 14000.0f;
  scene.lights.push_back(light);
  scene.nodes.resize(2);
  scene.nodes[0].mesh = 0;
  scene.nodes[1].light = 0;
  scene.nodes[1].transform.translation = glm::vec3(30.0f, 40.0f, 50.0f);
  scene.roots = {0, 1};
  return scene;
}

Surface Load(const std::string& path) {
  Surface surface;
  auto scene = scene::ReadGltf(path, {});
  if (!scene) return surface;
  const scene::Primitive& primitive = scene->meshes.at(0).primitives.at(0);
  for (const glm::vec3& p : primitive.positions) surface.positions.emplace_back(p);
  for (const glm::vec3& n : primitive.normals) surface.normals.emplace_back(n);
  surface.indices = primitive.indices;
  Fit(surface, 30.0);
  return surface;
}

// A stage that draws a shadow map and then shades as ever: what the ratios are of.
class ShadowOnly final : public gbuffer::TranslucencyStage {
 public:
  [[nodiscard]] bool IsTranslucent(int) const override { return false; }
  Result<void> Update(const gbuffer::TranslucencyInput& input) override {
    return pass_.Draw(input.lights, {*input.draws, *input.materials}, {glm::vec3(0.0f), 26.0f}, 1024, maps_, block_);
  }
  void Bind(std::size_t) const override {}
  [[nodiscard]] const std::string& ShaderText() const override { return text_; }

 private:
  ShadowPass pass_;
  ShadowMaps maps_;
  ShadowBlock block_;
  std::string text_;
};

struct Times {
  double wall_ms = 0.0;
  double cpu_ms = 0.0;  ///< of all the process's threads
};

Times Now() {
  Times now;
  now.wall_ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
  timespec cpu{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &cpu);
  now.cpu_ms = 1e3 * static_cast<double>(cpu.tv_sec) + 1e-6 * static_cast<double>(cpu.tv_nsec);
  return now;
}

double Median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

Times FrameTime(const scene::Scene& scene, gbuffer::TranslucencyStage* stage, bool deforms, int frames) {
  const image::Image environment = FloatMap(16, 8, [](const glm::dvec3&) { return glm::dvec3(0.2); });
  auto renderer = Take(gbuffer::SceneRenderer::Create(scene, &environment));
  gl::Texture target = Take(gl::Texture::Create(gl::PlainFormat(gl::Numeric::kFloat, 16, 4), kSize, kSize, 1, "speed"));
  const gbuffer::Request request{gbuffer::Attribute::kColor, &target, image::Encoding::kSceneLinear};
  const scene::Pose pose = scene::EvaluatePose(scene, {}, 0.0);
  std::vector<double> wall, cpu;
  for (int i = 0; i < frames + 2; ++i) {
    std::vector<scene::DrawItem> items = scene::BuildDrawItems(scene, pose, pose);
    // Either way the vertices are uploaded anew.
    scene::MorphToSphere(scene, 0.05f + (deforms ? 0.01f * static_cast<float>(i) : 0.0f), items);
    const float angle = 0.05f * static_cast<float>(i);
    scene::View view;
    view.view_from_world = glm::lookAt(70.0f * glm::vec3(std::sin(angle), 0.4f, std::cos(angle)), glm::vec3(0.0f),
                                       glm::vec3(0.0f, 1.0f, 0.0f));
    view.clip_from_view = glm::perspectiveRH_ZO(0.6f, 1.0f, 5.0f, 500.0f);
    view.znear = 5.0f;
    view.zfar = 500.0f;
    glFinish();
    const Times begin = Now();
    gbuffer::FrameInput input{view, view, &pose, items, glm::vec4(0.0f), nullptr, stage};
    if (auto drawn = renderer->Render(input, {&request, 1}); !drawn) {
      std::fprintf(stderr, "%s\n", drawn.error().message.c_str());
      std::exit(1);
    }
    glFinish();
    const Times end = Now();
    if (i < 2) continue;
    wall.push_back(end.wall_ms - begin.wall_ms);
    cpu.push_back(end.cpu_ms - begin.cpu_ms);
  }
  return {Median(wall), Median(cpu)};
}

Times TranslucentTime(const scene::Scene& scene, Scattering way, bool deforms, int frames) {
  const image::Image environment = FloatMap(16, 8, [](const glm::dvec3&) { return glm::dvec3(0.2); });
  TranslucencyOptions options;
  options.unit_mm = 1.0;
  options.scattering = way;
  options.assignments = {{"medium", FindMeasuredMedium("Marble")}};
  auto stage = Take(TranslucencyRenderer::Create(scene, &environment, options));
  return FrameTime(scene, stage.get(), deforms, frames);
}

struct Way {
  const char* name;
  Scattering scattering;
};
constexpr std::array kWays = {Way{"paper", Scattering::kPaper}, Way{"fast", Scattering::kFast},
                              Way{"full", Scattering::kFull}, Way{"high", Scattering::kHigh}};

// Table 2 of the paper: a frame took 13.9 ms at 7700 triangles, 45.5 ms at 381500.
double PaperGrowth(double triangles_ratio) {
  return std::pow(triangles_ratio, std::log(45.5 / 13.9) / std::log(381500.0 / 7700.0));
}

void Print(const char* what, const Times& times, const Times& plain) {
  std::printf("  %-13s %7.1f ms (%5.2f)  CPU %7.1f ms (%5.2f)\n", what, times.wall_ms, times.wall_ms / plain.wall_ms,
              times.cpu_ms, times.cpu_ms / plain.cpu_ms);
  std::fflush(stdout);
}

/// What the command line chooses; all where it chooses nothing.
struct Choice {
  int frames = 9;
  std::vector<std::string> words;
  [[nodiscard]] bool Has(std::string_view word) const {
    return words.empty() || std::ranges::find(words, word) != words.end();
  }
};

/// The times of a deforming mesh, by way, of the smallest mesh so far.
struct Smallest {
  std::size_t triangles = 0;
  std::map<std::string, double> cpu_ms;
};

void Measure(const Surface& surface, const Choice& choice, Smallest& smallest) {
  if (surface.indices.empty()) return;
  const scene::Scene scene = SceneOf(surface);
  ShadowOnly shadow_only;
  const Times plain = FrameTime(scene, &shadow_only, true, choice.frames);
  std::printf("%zu triangles\n", surface.triangles());
  Print("plain", plain, plain);
  if (smallest.triangles == 0) smallest.triangles = surface.triangles();
  for (const Way& way : kWays) {
    if (!choice.Has(way.name)) continue;
    const Times deforming = TranslucentTime(scene, way.scattering, true, choice.frames);
    Print(way.name, deforming, plain);
    Print("  camera only", TranslucentTime(scene, way.scattering, false, choice.frames), plain);
    const double first = smallest.cpu_ms.try_emplace(way.name, deforming.cpu_ms).first->second;
    const double more = static_cast<double>(surface.triangles()) / static_cast<double>(smallest.triangles);
    if (more > 1.0) {
      std::printf("    %.2f times the CPU time of %zu triangles (paper's table 2: %.2f)\n", deforming.cpu_ms / first,
                  smallest.triangles, PaperGrowth(more));
    }
  }
}

int Main(int argc, char** argv) {
  Choice choice;
  for (int i = 1; i < argc; ++i) {
    const int number = std::atoi(argv[i]);
    number > 0 ? void(choice.frames = number) : void(choice.words.emplace_back(argv[i]));
  }
  gl::SetDriverEnvironment(0);
  const auto context = Take(gl::Context::Create({}));
  std::printf("%s; in brackets: over a frame with a shadow map and plain lighting\n", context->info().renderer.c_str());
  const char* data = std::getenv("BURIN_SHARED_DATA");
  Smallest smallest;
  if (data == nullptr) {
    for (const int slices : {76, 306, 612}) Measure(Ball(15.0, slices), choice, smallest);
    return 0;
  }
  for (const char* name : {"spot", "spot_loop2", "spot_loop3"}) {
    Measure(Load(std::string(data) + "/mesh/" + name + ".glb"), choice, smallest);
  }
  return 0;
}

}  // namespace
}  // namespace burin::translucency

int main(int argc, char** argv) { return burin::translucency::Main(argc, argv); }
