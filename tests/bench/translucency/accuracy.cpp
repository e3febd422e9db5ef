// SPDX-License-Identifier: Apache-2.0
// Accuracy of the translucency stage against the brute-force reference: root of the mean squared error over the
// surface, relative to the reference's mean, worst of the lights.
//   bench_translucency_accuracy [QUALITY...] [--shape NAME] [--points N]
#include <cstring>

#include "core/gl/context.h"
#include "core/scene/gltf_reader.h"
#include "tests/support/scattering_stand.h"

namespace burin::translucency {
namespace {

struct Named {
  std::string name;
  Surface surface;
};

Surface FromScene(const std::string& path) {
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

std::vector<Named> Shapes() {
  std::vector<Named> shapes = {
      {"sphere", Ball(15.0, 128)}, {"slab", Block({30, 30, 8}, 24)}, {"plate", Block({30, 30, 1}, 24)}};
  const char* data = std::getenv("BURIN_SHARED_DATA");
  if (data != nullptr) {
    shapes.push_back({"spot", FromScene(std::string(data) + "/mesh/spot.glb")});
    shapes.push_back({"teapot", ReadObj(std::string(data) + "/mesh/teapot_materialx.obj")});
  }
  std::erase_if(shapes, [](const Named& shape) { return shape.surface.indices.empty(); });
  return shapes;
}

struct NamedLight {
  const char* name;
  Lighting lighting;
};

std::vector<NamedLight> Lights() {
  const auto lamp = [](const glm::dvec3& at) {
    Lighting lighting;
    lighting.lamp = at;
    return lighting;
  };
  Lighting sky;
  sky.sky = Gradient;
  return {{"front", lamp({5, 10, 69})}, {"side", lamp({69, 12, 4})}, {"back", lamp({-6, 8, -69})}, {"sky", sky}};
}

void Measure(const Named& shape, Scattering scattering, std::size_t points) {
  const std::vector<glm::vec3> eyes = {{30, 35, 70}, {-40, -30, 65}, {45, -25, -66}, {-50, 40, -50}};
  const Occlusion occlusion(shape.surface);
  for (const char* medium_name : {"Marble", "Skin1", "Wholemilk", "Ketchup"}) {
    const Medium medium = *FindMeasuredMedium(medium_name);
    std::printf("%-7s %-10s", shape.name.c_str(), medium_name);
    for (const NamedLight& light : Lights()) {
      const double ior = static_cast<double>(medium.ior);
      const Entering entering = light.lighting.lamp
                                    ? PointLight(*light.lighting.lamp, light.lighting.intensity, ior, occlusion)
                                    : Environment(light.lighting.sky, ior);
      const Pieces pieces(shape.surface, 120000, entering);
      Stand stand(shape.surface, medium, light.lighting, scattering);
      const Deviation d = Compare(stand, pieces, medium, points, eyes);
      std::printf("  %s %5.1f%% (%+5.1f%%) g %4.2f%s", light.name, 100.0 * d.rmse, 100.0 * d.bias, d.gradient,
                  d.is_finite && d.least >= 0.0f ? "" : " BAD");
      std::fflush(stdout);
    }
    std::printf("\n");
  }
}

int Main(int argc, char** argv) {
  std::vector<Scattering> ways;
  std::string only;
  std::size_t points = 400;
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word == "paper") ways.push_back(Scattering::kPaper);
    if (word == "fast") ways.push_back(Scattering::kFast);
    if (word == "full") ways.push_back(Scattering::kFull);
    if (word == "high") ways.push_back(Scattering::kHigh);
    if (word == "--shape" && i + 1 < argc) only = argv[++i];
    if (word == "--points" && i + 1 < argc) points = static_cast<std::size_t>(std::atoi(argv[++i]));
  }
  if (ways.empty()) ways = {Scattering::kPaper, Scattering::kFast, Scattering::kFull, Scattering::kHigh};
  gl::SetDriverEnvironment(0);
  const auto context = Take(gl::Context::Create({}));
  std::printf("%s\n", context->info().renderer.c_str());
  constexpr std::array kNames = {"paper", "fast", "full", "high"};
  const std::vector<Named> shapes = Shapes();
  for (const Scattering way : ways) {
    std::printf("-- %s\n", kNames[static_cast<std::size_t>(way)]);
    for (const Named& shape : shapes) {
      if (only.empty() || only == shape.name) Measure(shape, way, points);
    }
  }
  return 0;
}

}  // namespace
}  // namespace burin::translucency

int main(int argc, char** argv) { return burin::translucency::Main(argc, argv); }
