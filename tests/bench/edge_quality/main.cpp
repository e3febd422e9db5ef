// SPDX-License-Identifier: Apache-2.0
// Measures the antialiasing methods against a reference of many samples; tests/bench/edges.py runs it and prints the
// tables. One JSON object a line on stdout: {"measure", "scene", "clean", "method", "value"}.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>

#include "core/gl/context.h"
#include "tests/bench/edge_quality/bench_scenes.h"
#include "tests/bench/edge_quality/dump.h"
#include "tests/bench/edge_quality/edge_mask.h"
#include "tests/bench/edge_quality/measures.h"

namespace burin::bench {
namespace {

struct Options {
  Effort effort;
  std::string shared_data;
  std::string device = "auto";
  std::string scenes;  ///< names separated by commas; empty: all
  std::string measures = "rmse,crawl,bloat,time";
  std::string dump;  ///< a folder; empty: no pictures
};

constexpr const char* kUsage =
    "usage: edge_quality [--quick] [--shared-data FOLDER] [--device DEVICE] [--scenes A,B] "
    "[--measures rmse,crawl,bloat,time] [--size N] [--samples N] [--pan-samples N] [--turn-samples N] "
    "[--frames N] [--dump FOLDER]\n";

bool Lists(const std::string& list, const std::string& name) {
  return ("," + list + ",").find("," + name + ",") != std::string::npos;
}

[[noreturn]] void Refuse(std::string_view word) {
  fmt::print(stderr, "edge_quality: {}: not understood\n{}", word, kUsage);
  std::exit(2);
}

int Number(std::string_view text, int lowest) {
  int value = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (status != std::errc() || end != text.data() + text.size() || value < lowest) Refuse(text);
  return value;
}

Options Parse(int count, char** words) {
  Options options;
  if (const char* folder = std::getenv("BURIN_SHARED_DATA"); folder != nullptr) options.shared_data = folder;
  for (int i = 1; i < count; ++i) {
    const std::string_view word = words[i];
    if (word == "--quick") {
      options.effort = {.size = 256,
                        .reference_samples = 256,
                        .frames = 24,
                        .pan_samples = 640,
                        .turn_samples = 64,
                        .time_size = 1024,
                        .time_rounds = 5};
      continue;
    }
    if (i + 1 == count) Refuse(word);
    const char* const value = words[++i];
    if (word == "--shared-data")
      options.shared_data = value;
    else if (word == "--device")
      options.device = value;
    else if (word == "--scenes")
      options.scenes = value;
    else if (word == "--measures")
      options.measures = value;
    else if (word == "--dump")
      options.dump = value;
    else if (word == "--size")
      options.effort.size = Number(value, 64);
    else if (word == "--samples")
      options.effort.reference_samples = Number(value, 1);
    else if (word == "--pan-samples")
      options.effort.pan_samples = Number(value, 20);
    else if (word == "--turn-samples")
      options.effort.turn_samples = Number(value, 1);
    else if (word == "--frames")
      options.effort.frames = Number(value, 3);
    else
      Refuse(word);
  }
  return options;
}

void Print(const std::string& scene, bool is_clean, const std::vector<Figure>& figures) {
  for (const Figure& figure : figures) {
    fmt::print(R"({{"measure":"{}","scene":"{}","clean":{},"method":"{}","value":{:.6g}}})"
               "\n",
               figure.measure, scene, is_clean, figure.method, figure.value);
  }
  std::fflush(stdout);
}

void Measure(const BenchScene& bench, const scene::Scene& scene, const std::vector<Method>& methods,
             const Options& options) {
  const Effort& effort = options.effort;
  Stand stand(scene, effort.size);
  if (Lists(options.measures, "rmse")) Print(bench.name, bench.is_clean, StillErrors(stand, methods, effort));
  if (Lists(options.measures, "crawl")) {
    for (const bool is_turn : {false, true}) Print(bench.name, bench.is_clean, Crawl(stand, methods, effort, is_turn));
  }
  if (Lists(options.measures, "time")) {
    Stand large(scene, effort.time_size);
    Print(bench.name, bench.is_clean, FrameTimes(large, methods, effort.time_rounds));
  }
}

/// Each method's picture beside the reference, and what the mask leaves, under FOLDER.
void Dump(const BenchScene& bench, const scene::Scene& scene, const std::vector<Method>& methods,
          const Options& options) {
  Stand stand(scene, options.effort.size);
  const Method& plain = methods.front();
  const Mask mask = EdgeMask(stand, plain, {});
  const Picture reference = Reference(stand, plain, {}, options.effort.reference_samples);
  const auto write = [&](std::string name, const Picture& picture, const Mask* only) {
    name = fmt::format("{} - {}.ppm", bench.name, name);
    std::ranges::replace(name, ' ', '_');
    if (!WritePpm(options.dump + "/" + name, picture, only)) {
      fmt::print(stderr, "edge_quality: {}/{}: cannot be written\n", options.dump, name);
      std::exit(1);
    }
  };
  write("reference", reference, nullptr);
  write("mask", reference, &mask);
  for (const Method& method : methods) write(method.name, stand.Render(method, {}), nullptr);
}

int Main(int count, char** words) {
  const Options options = Parse(count, words);
  gl::SetDriverEnvironment(0);
  auto context = gl::Context::Create({.device = options.device, .debug = false});
  if (!context) {
    fmt::print(stderr, "edge_quality: {}\n", context.error().message);
    return 4;
  }
  fmt::print(R"({{"measure":"device","scene":"","clean":true,"method":"{}","value":0}})"
             "\n",
             (*context)->info().renderer);
  // Dim and opaque, so that outlines count as much as what is within.
  const glm::vec4 background(0.03f, 0.03f, 0.03f, 1.0f);
  const std::vector<Method> methods = Methods(background);
  if (Lists(options.measures, "bloat")) {
    Print("half-plane", true, Bloat(Methods({0.0f, 0.0f, 0.0f, 1.0f}), options.effort.size));
  }
  for (const BenchScene& bench : BenchScenes(options.shared_data)) {
    if (!options.scenes.empty() && !Lists(options.scenes, bench.name)) continue;
    const auto scene = bench.make();
    if (!scene) {
      fmt::print(stderr, "edge_quality: {}: not there, left out\n", bench.name);
      continue;
    }
    if (!options.dump.empty()) Dump(bench, *scene, methods, options);
    Measure(bench, *scene, methods, options);
  }
  return 0;
}

}  // namespace
}  // namespace burin::bench

int main(int count, char** words) { return burin::bench::Main(count, words); }
