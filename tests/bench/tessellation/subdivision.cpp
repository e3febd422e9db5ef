// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/tessellation/rivals.h"

#if defined(BURIN_BENCH_OPENSUBDIV)

#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#include <opensubdiv/far/patchMap.h>
#include <opensubdiv/far/patchTableFactory.h>
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

struct Evaluation {
  std::unique_ptr<osd::Far::TopologyRefiner> refiner;
  std::unique_ptr<osd::Far::PatchTable> table;
  std::unique_ptr<osd::Osd::CpuPatchTable> cpu_table;
  std::unique_ptr<osd::Osd::CpuVertexBuffer> source, out, du, dv;
  std::vector<osd::Osd::PatchCoord> coords;
};

}  // namespace

TimedWork OpenSubdivPatches(std::size_t patch_count, std::uint32_t segments) {
  const Torus torus(static_cast<int>(patch_count));
  osd::Far::TopologyDescriptor descriptor;
  descriptor.numVertices = descriptor.numFaces = torus.count;
  descriptor.numVertsPerFace = torus.sizes.data();
  descriptor.vertIndicesPerFace = torus.corners.data();
  using Factory = osd::Far::TopologyRefinerFactory<osd::Far::TopologyDescriptor>;
  auto work = std::make_shared<Evaluation>();
  work->refiner.reset(Factory::Create(descriptor, Factory::Options(osd::Sdc::SCHEME_CATMARK, osd::Sdc::Options())));
  osd::Far::PatchTableFactory::Options options(1);
  work->refiner->RefineAdaptive(options.GetRefineAdaptiveOptions());
  work->table.reset(osd::Far::PatchTableFactory::Create(*work->refiner, options));
  work->cpu_table.reset(osd::Osd::CpuPatchTable::Create(work->table.get()));
  const osd::Far::PatchMap map(*work->table);
  for (int face = 0; face < torus.count; ++face) {
    for (std::uint32_t j = 0; j <= segments; ++j) {
      for (std::uint32_t i = 0; i <= segments; ++i) {
        const float s = static_cast<float>(i) / static_cast<float>(segments);
        const float t = static_cast<float>(j) / static_cast<float>(segments);
        work->coords.emplace_back(*map.FindPatch(face, s, t), s, t);
      }
    }
  }
  const int vertices = static_cast<int>(work->coords.size());
  work->source.reset(osd::Osd::CpuVertexBuffer::Create(3, work->refiner->GetNumVerticesTotal()));
  work->source->UpdateData(torus.positions.data(), 0, torus.count);
  for (auto* buffer : {&work->out, &work->du, &work->dv}) buffer->reset(osd::Osd::CpuVertexBuffer::Create(3, vertices));
  const auto run = [work, vertices] {
    const osd::Osd::BufferDescriptor three(0, 3, 3);
    osd::Osd::CpuEvaluator::EvalPatches(work->source->BindCpuBuffer(), three, work->out->BindCpuBuffer(), three,
                                        work->du->BindCpuBuffer(), three, work->dv->BindCpuBuffer(), three, vertices,
                                        work->coords.data(), work->cpu_table->GetPatchArrayBuffer(),
                                        work->cpu_table->GetPatchIndexBuffer(), work->cpu_table->GetPatchParamBuffer());
  };
  return {run, 2.0 * torus.count * segments * segments};
}

}  // namespace burin::bench

#else

namespace burin::bench {

TimedWork OpenSubdivPatches(std::size_t, std::uint32_t) { return {}; }

}  // namespace burin::bench

#endif
