// SPDX-License-Identifier: Apache-2.0
#include "core/overdraw/silhouette_scan.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cstddef>

#if defined(__x86_64__)
#include <immintrin.h>
#define BURIN_AVX2 __attribute__((target("avx2")))
#endif

namespace burin::overdraw {
namespace {

/// Work of one task; a multiple of 32, so that no two tasks write one word of face bits.
constexpr std::size_t kChunk = 32768;

struct View {
  const FacePlanes& planes;
  const SilhouetteEdges& edges;
  glm::vec4 eye;
};

/// Eight faces from `face` on, one bit each: set in front.
std::uint32_t FrontBits(const View& view, std::size_t face) {
  std::uint32_t bits = 0;
  for (std::size_t k = 0; k < 8; ++k)
    bits |= static_cast<std::uint32_t>(FacingValue(view.planes.Plane(face + k), view.eye) > 0.0f) << k;
  return bits;
}

void MarkFront(const View& view, std::size_t begin, std::size_t end, std::uint32_t* front) {
  for (std::size_t f = begin; f < end; f += 8) front[f / 32] |= FrontBits(view, f) << (f % 32);
}

void CompareSides(const View& view, std::size_t begin, std::size_t end, const std::uint32_t* front,
                  std::vector<std::uint32_t>& found) {
  const auto is_front = [&](std::uint32_t face) { return front[face / 32] >> (face % 32) & 1u; };
  for (std::size_t e = begin; e < end; ++e) {
    if (is_front(view.edges.left[e]) != is_front(view.edges.right[e])) found.push_back(static_cast<std::uint32_t>(e));
  }
}

#if defined(__x86_64__)
BURIN_AVX2 void MarkFrontAvx2(const View& view, std::size_t begin, std::size_t end, std::uint32_t* front) {
  const FacePlanes& p = view.planes;
  const __m256 ex = _mm256_set1_ps(view.eye.x), ey = _mm256_set1_ps(view.eye.y), ez = _mm256_set1_ps(view.eye.z),
               ew = _mm256_set1_ps(view.eye.w), zero = _mm256_setzero_ps();
  for (std::size_t f = begin; f < end; f += 8) {
    const __m256 xy =
        _mm256_add_ps(_mm256_mul_ps(_mm256_loadu_ps(&p.x[f]), ex), _mm256_mul_ps(_mm256_loadu_ps(&p.y[f]), ey));
    const __m256 xyz = _mm256_add_ps(xy, _mm256_mul_ps(_mm256_loadu_ps(&p.z[f]), ez));
    const __m256 value = _mm256_add_ps(xyz, _mm256_mul_ps(_mm256_loadu_ps(&p.w[f]), ew));
    const auto bits = static_cast<std::uint32_t>(_mm256_movemask_ps(_mm256_cmp_ps(value, zero, _CMP_GT_OQ)));
    front[f / 32] |= bits << (f % 32);
  }
}

/// The bit of each of eight faces, at the top of its lane.
BURIN_AVX2 inline __m256i FaceBits(const std::uint32_t* front, __m256i faces) {
  const __m256i words = _mm256_i32gather_epi32(reinterpret_cast<const int*>(front), _mm256_srli_epi32(faces, 5), 4);
  // Shifting left by 31 - face % 32, which is the face's low five bits inverted.
  return _mm256_sllv_epi32(words, _mm256_andnot_si256(faces, _mm256_set1_epi32(31)));
}

BURIN_AVX2 inline __m256i Load8(const std::uint32_t* at) {
  return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(at));
}

BURIN_AVX2 void CompareSidesAvx2(const View& view, std::size_t begin, std::size_t end, const std::uint32_t* front,
                                 std::vector<std::uint32_t>& found) {
  std::size_t e = begin;
  for (; e + 8 <= end; e += 8) {
    const __m256i left = Load8(&view.edges.left[e]), right = Load8(&view.edges.right[e]);
    const __m256i differ = _mm256_xor_si256(FaceBits(front, left), FaceBits(front, right));
    for (auto mask = static_cast<std::uint32_t>(_mm256_movemask_ps(_mm256_castsi256_ps(differ))); mask != 0;
         mask &= mask - 1)
      found.push_back(static_cast<std::uint32_t>(e) + static_cast<std::uint32_t>(std::countr_zero(mask)));
  }
  CompareSides(view, e, end, front, found);
}
#endif

/// Calls body(begin, end, chunk) for every chunk of `count` items.
template <class Body>
void ForEachChunk(std::size_t count, bool is_parallel, const Body& body) {
  const std::size_t chunks = (count + kChunk - 1) / kChunk;
  const auto run = [&](std::size_t chunk) { body(chunk * kChunk, std::min(count, (chunk + 1) * kChunk), chunk); };
  if (is_parallel) {
    tbb::parallel_for(std::size_t{0}, chunks, run);
  } else {
    for (std::size_t chunk = 0; chunk < chunks; ++chunk) run(chunk);
  }
}

}  // namespace

void ScanSilhouettes(const FacePlanes& planes, const SilhouetteEdges& edges, const glm::vec4& local_eye,
                     const ScanOptions& options, std::vector<std::uint32_t>& found) {
  const View view{planes, edges, local_eye};
  auto mark = MarkFront;
  auto compare = CompareSides;
#if defined(__x86_64__)
  if (options.uses_avx2) {
    mark = MarkFrontAvx2;
    compare = CompareSidesAvx2;
  }
#endif
  std::vector<std::uint32_t> front((planes.x.size() + 31) / 32);
  ForEachChunk(planes.x.size(), options.is_parallel,
               [&](std::size_t begin, std::size_t end, std::size_t) { mark(view, begin, end, front.data()); });
  if (!options.is_parallel) {
    compare(view, 0, edges.size(), front.data(), found);
    return;
  }
  std::vector<std::vector<std::uint32_t>> parts((edges.size() + kChunk - 1) / kChunk);
  ForEachChunk(edges.size(), true, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
    compare(view, begin, end, front.data(), parts[chunk]);
  });
  for (const std::vector<std::uint32_t>& part : parts) found.insert(found.end(), part.begin(), part.end());
}

}  // namespace burin::overdraw
