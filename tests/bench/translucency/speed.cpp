// SPDX-License-Identifier: Apache-2.0
// Speed of the translucency stage: whole frames of 512 x 512 against the same frames with a shadow map and plain
// lighting, medians of one run, deforming every frame and with the camera alone moving.
//   bench_translucency_speed [FRAMES]
#include <epoxy/gl.h>

#include <chrono>
#include <ctime>
#include <cstring>

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
    return maps_.Draw(input.lights, *input.draws, {glm::vec3(0.0f), 26.0f}, 1024, block_);
  }
  void Bind(std::size_t) const override {}
  [[nodiscard]] const std::string& ShaderText() const override { return text_; }

 private:
  ShadowMaps maps_;
  ShadowBlock block_;
  std::string text_;
};

// Milliseconds; with BURIN_BENCH_CPU=1 of all the process's threads, for a machine that others use too.
double Now() {
  static const bool is_cpu = std::getenv("BURIN_BENCH_CPU") != nullptr;
  if (!is_cpu) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
  }
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

double FrameTime(const scene::Scene& scene, gbuffer::TranslucencyStage* stage, bool deforms, int frames) {
  const image::Image environment = FloatMap(16, 8, [](const glm::dvec3&) { return glm::dvec3(0.2); });
  auto renderer = Take(gbuffer::SceneRenderer::Create(scene, &environment));
  gl::Texture target = Take(gl::Texture::Create(gl::PlainFormat(gl::Numeric::kFloat, 16, 4), kSize, kSize, 1, "speed"));
  const gbuffer::Request request{gbuffer::Attribute::kColor, &target, image::Encoding::kSceneLinear};
  const scene::Pose pose = scene::EvaluatePose(scene, {}, 0.0);
  std::vector<double> times;
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
    const auto begin = Now();
    gbuffer::FrameInput input{view, view, &pose, items, glm::vec4(0.0f), nullptr, stage};
    if (auto drawn = renderer->Render(input, {&request, 1}); !drawn) {
      std::fprintf(stderr, "%s\n", drawn.error().message.c_str());
      std::exit(1);
    }
    glFinish();
    if (i >= 2) times.push_back(Now() - begin);
  }
  std::nth_element(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2), times.end());
  return times[times.size() / 2];
}

double TranslucentTime(const scene::Scene& scene, Scattering way, bool deforms, int frames) {
  const image::Image environment = FloatMap(16, 8, [](const glm::dvec3&) { return glm::dvec3(0.2); });
  TranslucencyOptions options;
  options.unit_mm = 1.0;
  options.scattering = way;
  options.assignments = {{"medium", FindMeasuredMedium("Marble")}};
  auto stage = Take(TranslucencyRenderer::Create(scene, &environment, options));
  return FrameTime(scene, stage.get(), deforms, frames);
}

void Measure(const char* name, const Surface& surface, int frames) {
  if (surface.indices.empty()) return;
  const scene::Scene scene = SceneOf(surface);
  ShadowOnly shadow_only;
  const double plain = FrameTime(scene, &shadow_only, true, frames);
  std::printf("%-10s %7zu triangles: plain %6.1f ms", name, surface.triangles(), plain);
  constexpr std::array kWays = {std::pair("paper", Scattering::kPaper), std::pair("fast", Scattering::kFast),
                                std::pair("full", Scattering::kFull), std::pair("high", Scattering::kHigh)};
  for (const auto& [way_name, way] : kWays) {
    const double deforming = TranslucentTime(scene, way, true, frames);
    const double still = TranslucentTime(scene, way, false, frames);
    std::printf("  %s %6.1f ms (%4.1f), camera alone %6.1f ms (%4.2f)", way_name, deforming, deforming / plain, still,
                still / plain);
    std::fflush(stdout);
  }
  std::printf("\n");
}

int Main(int argc, char** argv) {
  const int frames = argc > 1 ? std::max(1, std::atoi(argv[1])) : 9;
  gl::SetDriverEnvironment(0);
  const auto context = Take(gl::Context::Create({}));
  std::printf("%s; frame / (shadow map + plain lighting) in brackets\n", context->info().renderer.c_str());
  const char* data = std::getenv("BURIN_SHARED_DATA");
  if (data == nullptr) {
    Measure("sphere", Ball(15.0, 76), frames);
    Measure("sphere", Ball(15.0, 306), frames);
    Measure("sphere", Ball(15.0, 612), frames);
    return 0;
  }
  for (const char* name : {"spot", "spot_loop2", "spot_loop3"}) {
    Measure(name, Load(std::string(data) + "/mesh/" + name + ".glb"), frames);
  }
  return 0;
}

}  // namespace
}  // namespace burin::translucency

int main(int argc, char** argv) { return burin::translucency::Main(argc, argv); }
