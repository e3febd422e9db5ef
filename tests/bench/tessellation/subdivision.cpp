// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/tessellation/rivals.h"

#if defined(BURIN_BENCH_OPENSUBDIV)

#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#include <opensubdiv/far/patchMap.h>
#include <opensubdiv/far/patchTableFactory.h>
#include <opensubdiv/far/stencilTableFactory.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefinerFactory.h>
#include <opensubdiv/osd/cpuEvaluator.h>
#include <opensubdiv/osd/cpuPatchTable.h>
#include <opensubdiv/osd/cpuVertexBuffer.h>

#include <cmath>

namespace burin::bench {
namespace {

namespace osd = OpenSubdiv::OPENSUBDIV_VERSION;

struct Torus {
  std::vector<int> sizes, corners;
  std::vector<float> positions;
  int count = 0;

  explicit Torus(int faces) {
    const int rows = 4, columns = faces / rows;
    count = rows * columns;
    for (int j = 0; j < rows; ++j) {
      for (int i = 0; i < columns; ++i) {
        const int right = (i + 1) % columns, up = (j + 1) % rows;
        sizes.push_back(4);
        for (const int corner : {j * columns + i, j * columns + right, up * columns + right, up * columns + i})
          corners.push_back(corner);
        const float a = 6.2831853f * static_cast<float>(i) / static_cast<float>(columns);
        const float b = 6.2831853f * static_cast<float>(j) / static_cast<float>(rows);
        const float radius = 2.0f + std::cos(b);
        positions.insert(positions.end(), {radius * std::cos(a), radius * std::sin(a), std::sin(b)});
      }
    }
  }
};

using Refiner = std::unique_ptr<osd::Far::TopologyRefiner>;

Refiner RefinerOf(const Torus& torus) {
  osd::Far::TopologyDescriptor descriptor;
  descriptor.numVertices = descriptor.numFaces = torus.count;
  descriptor.numVertsPerFace = torus.sizes.data();
  descriptor.vertIndicesPerFace = torus.corners.data();
  using Factory = osd::Far::TopologyRefinerFactory<osd::Far::TopologyDescriptor>;
  return Refiner(Factory::Create(descriptor, Factory::Options(osd::Sdc::SCHEME_CATMARK, osd::Sdc::Options())));
}

/// Control points, and limit positions and derivatives, three floats each.
struct Buffers {
  std::unique_ptr<osd::Osd::CpuVertexBuffer> source, out, du, dv;

  void Allocate(const Torus& torus, int sources, int vertices) {
    source.reset(osd::Osd::CpuVertexBuffer::Create(3, sources));
    source->UpdateData(torus.positions.data(), 0, torus.count);
    for (auto* buffer : {&out, &du, &dv}) buffer->reset(osd::Osd::CpuVertexBuffer::Create(3, vertices));
  }
};

std::vector<float> Parameters(std::uint32_t segments) {
  std::vector<float> parameters;
  for (std::uint32_t i = 0; i <= segments; ++i)
    parameters.push_back(static_cast<float>(i) / static_cast<float>(segments));
  return parameters;
}

double TriangleCount(const Torus& torus, std::uint32_t segments) { return 2.0 * torus.count * segments * segments; }

const osd::Osd::BufferDescriptor kThree(0, 3, 3);

struct PatchEvaluation {
  Refiner refiner;
  std::unique_ptr<osd::Far::PatchTable> table;
  std::unique_ptr<osd::Osd::CpuPatchTable> cpu_table;
  Buffers buffers;
  std::vector<osd::Osd::PatchCoord> coords;
};

struct StencilEvaluation {
  Refiner refiner;
  std::unique_ptr<const osd::Far::LimitStencilTable> table;
  Buffers buffers;
};

}  // namespace

TimedWork OpenSubdivPatches(std::size_t patch_count, std::uint32_t segments) {
  const Torus torus(static_cast<int>(patch_count));
  auto work = std::make_shared<PatchEvaluation>();
  work->refiner = RefinerOf(torus);
  osd::Far::PatchTableFactory::Options options(1);
  work->refiner->RefineAdaptive(options.GetRefineAdaptiveOptions());
  work->table.reset(osd::Far::PatchTableFactory::Create(*work->refiner, options));
  work->cpu_table.reset(osd::Osd::CpuPatchTable::Create(work->table.get()));
  const osd::Far::PatchMap map(*work->table);
  const std::vector<float> parameters = Parameters(segments);
  for (int face = 0; face < torus.count; ++face) {
    for (const float t : parameters) {
      for (const float s : parameters) work->coords.emplace_back(*map.FindPatch(face, s, t), s, t);
    }
  }
  const int vertices = static_cast<int>(work->coords.size());
  work->buffers.Allocate(torus, work->refiner->GetNumVerticesTotal(), vertices);
  const auto run = [work, vertices] {
    const Buffers& b = work->buffers;
    osd::Osd::CpuEvaluator::EvalPatches(b.source->BindCpuBuffer(), kThree, b.out->BindCpuBuffer(), kThree,
                                        b.du->BindCpuBuffer(), kThree, b.dv->BindCpuBuffer(), kThree, vertices,
                                        work->coords.data(), work->cpu_table->GetPatchArrayBuffer(),
                                        work->cpu_table->GetPatchIndexBuffer(), work->cpu_table->GetPatchParamBuffer());
  };
  return {run, TriangleCount(torus, segments)};
}

TimedWork OpenSubdivStencils(std::size_t patch_count, std::uint32_t segments) {
  const Torus torus(static_cast<int>(patch_count));
  auto work = std::make_shared<StencilEvaluation>();
  work->refiner = RefinerOf(torus);
  osd::Far::PatchTableFactory::Options options(1);
  work->refiner->RefineAdaptive(options.GetRefineAdaptiveOptions());
  std::vector<float> s, t;
  const std::vector<float> parameters = Parameters(segments);
  for (const float v : parameters) {
    s.insert(s.end(), parameters.begin(), parameters.end());
    t.insert(t.end(), parameters.size(), v);
  }
  osd::Far::LimitStencilTableFactory::LocationArrayVec locations(static_cast<std::size_t>(torus.count));
  for (int face = 0; face < torus.count; ++face) {
    auto& location = locations[static_cast<std::size_t>(face)];
    location.ptexIdx = face;
    location.numLocations = static_cast<int>(s.size());
    location.s = s.data();
    location.t = t.data();
  }
  work->table.reset(osd::Far::LimitStencilTableFactory::Create(*work->refiner, locations));
  if (!work->table) return {};
  work->buffers.Allocate(torus, torus.count, work->table->GetNumStencils());
  const auto run = [work] {
    const Buffers& b = work->buffers;
    osd::Osd::CpuEvaluator::EvalStencils(b.source.get(), kThree, b.out.get(), kThree, b.du.get(), kThree, b.dv.get(),
                                         kThree, work->table.get());
  };
  return {run, TriangleCount(torus, segments)};
}

}  // namespace burin::bench

#else

namespace burin::bench {

TimedWork OpenSubdivPatches(std::size_t, std::uint32_t) { return {}; }
TimedWork OpenSubdivStencils(std::size_t, std::uint32_t) { return {}; }

}  // namespace burin::bench

#endif
