// SPDX-License-Identifier: Apache-2.0
#include "core/scene/gltf_accessor.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <limits>
#include <type_traits>

namespace burin::scene {
namespace {

// An accessor without a buffer view is zeros: its count is not bounded by the file's size.
constexpr std::size_t kMaxUnbackedCount = std::size_t{1} << 24;

std::unexpected<Error> Bad(int accessor, const std::string& what) {
  return Fail(ErrorKind::kInput, fmt::format("accessor {}: {}", accessor, what));
}

const tinygltf::Accessor& At(const GltfDocument& document, int accessor) {
  return document.model().accessors[static_cast<std::size_t>(accessor)];
}

std::size_t ComponentBytes(int component_type) {
  return static_cast<std::size_t>(tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(component_type)));
}

/// Bytes of one element. Matrix columns start on multiples of four bytes (specification 3.6.2.4).
std::size_t ElementBytes(const tinygltf::Accessor& accessor) {
  const std::size_t component = ComponentBytes(accessor.componentType);
  const auto columns = [component](std::size_t n) { return n * ((n * component + 3) / 4 * 4); };
  switch (accessor.type) {
    case TINYGLTF_TYPE_MAT2:
      return columns(2);
    case TINYGLTF_TYPE_MAT3:
      return columns(3);
    default:
      return component *
             static_cast<std::size_t>(tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type)));
  }
}

/// `count` elements of `element` bytes, `stride` apart, from `offset`, inside `length` bytes.
bool Fits(std::size_t offset, std::size_t count, std::size_t stride, std::size_t element, std::size_t length) {
  if (count == 0) return true;
  if (offset > length || element > length - offset) return false;
  return count - 1 <= (length - offset - element) / stride;
}

struct Elements {
  const std::byte* data = nullptr;
  std::size_t stride = 0;
  std::size_t count = 0;
};

std::size_t Stride(const GltfDocument& document, const tinygltf::Accessor& accessor) {
  const std::size_t stride = document.model().bufferViews[static_cast<std::size_t>(accessor.bufferView)].byteStride;
  return stride != 0 ? stride : ElementBytes(accessor);
}

template <class T>
T Load(const std::byte* at) {
  T value;
  std::memcpy(&value, at, sizeof(T));  // glTF is little-endian, as are the machines that this program runs on
  return value;
}

/// Specification 3.11: how a normalised integer stands for a fraction.
template <class T>
float ToFloat(T value, bool normalised) {
  if constexpr (std::is_floating_point_v<T>) {
    return value;
  } else {
    if (!normalised) return static_cast<float>(value);
    const float fraction = static_cast<float>(value) / static_cast<float>(std::numeric_limits<T>::max());
    return std::max(fraction, -1.0f);
  }
}

template <class T>
void DecodeFloats(const Elements& from, int components, bool normalised, float* out) {
  for (std::size_t i = 0; i < from.count; ++i) {
    const std::byte* element = from.data + i * from.stride;
    for (int c = 0; c < components; ++c) {
      *out++ = ToFloat(Load<T>(element + static_cast<std::size_t>(c) * sizeof(T)), normalised);
    }
  }
}

void Decode(const Elements& from, const AccessorShape& shape, bool normalised, float* out) {
  switch (shape.component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return DecodeFloats<std::int8_t>(from, shape.components, normalised, out);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return DecodeFloats<std::uint8_t>(from, shape.components, normalised, out);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return DecodeFloats<std::int16_t>(from, shape.components, normalised, out);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return DecodeFloats<std::uint16_t>(from, shape.components, normalised, out);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return DecodeFloats<std::uint32_t>(from, shape.components, normalised, out);
    default:
      return DecodeFloats<float>(from, shape.components, normalised, out);
  }
}

template <class T>
void DecodeUnsigned(const Elements& from, int components, std::uint32_t* out) {
  for (std::size_t i = 0; i < from.count; ++i) {
    for (int c = 0; c < components; ++c) {
      *out++ = Load<T>(from.data + i * from.stride + static_cast<std::size_t>(c) * sizeof(T));
    }
  }
}

void DecodeIntegers(const Elements& from, int component_type, int components, std::uint32_t* out) {
  switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return DecodeUnsigned<std::uint8_t>(from, components, out);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return DecodeUnsigned<std::uint16_t>(from, components, out);
    default:
      return DecodeUnsigned<std::uint32_t>(from, components, out);
  }
}

Result<void> CheckSparse(const GltfDocument& document, int index) {
  const tinygltf::Accessor& accessor = At(document, index);
  const auto& sparse = accessor.sparse;
  const auto count = static_cast<std::size_t>(sparse.count);
  if (count > accessor.count) {
    return Bad(index, fmt::format("sparse count {} is over the accessor's count {}", count, accessor.count));
  }
  const std::size_t index_bytes = ComponentBytes(sparse.indices.componentType);
  const std::size_t element = ElementBytes(accessor);
  if (!Fits(static_cast<std::size_t>(sparse.indices.byteOffset), count, index_bytes, index_bytes,
            document.ViewBytes(sparse.indices.bufferView).size())) {
    return Bad(index,
               fmt::format("its {} sparse indices do not fit in buffer view {}", count, sparse.indices.bufferView));
  }
  if (!Fits(static_cast<std::size_t>(sparse.values.byteOffset), count, element, element,
            document.ViewBytes(sparse.values.bufferView).size())) {
    return Bad(index,
               fmt::format("its {} sparse values do not fit in buffer view {}", count, sparse.values.bufferView));
  }
  return {};
}

/// The places that a sparse accessor replaces: strictly increasing, below the count.
Result<std::vector<std::uint32_t>> SparsePlaces(const GltfDocument& document, int index) {
  const tinygltf::Accessor& accessor = At(document, index);
  const auto& indices = accessor.sparse.indices;
  std::vector<std::uint32_t> places(static_cast<std::size_t>(accessor.sparse.count));
  const std::span<const std::byte> view = document.ViewBytes(indices.bufferView);
  const Elements from{view.data() + indices.byteOffset, ComponentBytes(indices.componentType), places.size()};
  DecodeIntegers(from, indices.componentType, 1, places.data());
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (places[i] >= accessor.count) {
      return Bad(index, fmt::format("sparse index {} is out of range, the count is {}", places[i], accessor.count));
    }
    if (i > 0 && places[i] <= places[i - 1]) return Bad(index, "its sparse indices do not increase");
  }
  return places;
}

Elements DenseElements(const GltfDocument& document, const tinygltf::Accessor& accessor) {
  const std::span<const std::byte> view = document.ViewBytes(accessor.bufferView);
  return {view.data() + accessor.byteOffset, Stride(document, accessor), accessor.count};
}

Elements SparseElements(const GltfDocument& document, const tinygltf::Accessor& accessor) {
  const std::span<const std::byte> view = document.ViewBytes(accessor.sparse.values.bufferView);
  return {view.data() + accessor.sparse.values.byteOffset, ElementBytes(accessor),
          static_cast<std::size_t>(accessor.sparse.count)};
}

std::string TypeName(int components) {
  switch (components) {
    case 1:
      return "SCALAR";
    case 16:
      return "MAT4";
    default:
      return fmt::format("VEC{}", components);
  }
}

Result<AccessorShape> CheckShape(const GltfDocument& document, int accessor, int components) {
  auto shape = CheckAccessor(document, accessor);
  if (shape && shape->components != components) {
    return Bad(accessor, fmt::format("expected {}, found {}", TypeName(components), TypeName(shape->components)));
  }
  return shape;
}

Result<void> CheckFinite(int accessor, std::span<const float> values, int components) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isfinite(values[i])) continue;
    return Bad(accessor, fmt::format("element {} holds {}", i / static_cast<std::size_t>(components), values[i]));
  }
  return {};
}

/// Fills `out`, count * components floats of zeros, from dense and sparse data.
Result<void> ReadFloatsInto(const GltfDocument& document, int index, const AccessorShape& shape, Integers integers,
                            std::span<float> out) {
  const tinygltf::Accessor& accessor = At(document, index);
  const bool normalised = shape.normalized || integers == Integers::kAlwaysNormalised;
  if (accessor.bufferView >= 0) Decode(DenseElements(document, accessor), shape, normalised, out.data());
  if (accessor.sparse.isSparse) {
    auto places = SparsePlaces(document, index);
    if (!places) return std::unexpected(places.error());
    const auto components = static_cast<std::size_t>(shape.components);
    std::vector<float> values(places->size() * components);
    Decode(SparseElements(document, accessor), shape, normalised, values.data());
    for (std::size_t i = 0; i < places->size(); ++i) {
      std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(i * components), components,
                  out.begin() + static_cast<std::ptrdiff_t>((*places)[i] * components));
    }
  }
  return CheckFinite(index, out, shape.components);
}

}  // namespace

Result<AccessorShape> CheckAccessor(const GltfDocument& document, int index) {
  const tinygltf::Accessor& accessor = At(document, index);
  const int components = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type));
  if (accessor.bufferView >= 0) {
    const std::size_t length = document.ViewBytes(accessor.bufferView).size();
    if (!Fits(accessor.byteOffset, accessor.count, Stride(document, accessor), ElementBytes(accessor), length)) {
      return Bad(index,
                 fmt::format("{} elements of {} bytes, {} apart, from byte {} do not fit in buffer view {} of {} bytes",
                             accessor.count, ElementBytes(accessor), Stride(document, accessor), accessor.byteOffset,
                             accessor.bufferView, length));
    }
  } else if (accessor.count > kMaxUnbackedCount) {
    return Bad(index, fmt::format("{} elements without a buffer view, over the limit of {}", accessor.count,
                                  kMaxUnbackedCount));
  }
  if (accessor.sparse.isSparse) {
    if (auto ok = CheckSparse(document, index); !ok) return std::unexpected(ok.error());
  }
  return AccessorShape{accessor.count, components, accessor.componentType, accessor.normalized};
}

Result<std::vector<float>> ReadFloats(GltfDocument& document, int accessor, int components, Integers integers) {
  auto shape = CheckShape(document, accessor, components);
  if (!shape) return std::unexpected(shape.error());
  const std::size_t size = shape->count * static_cast<std::size_t>(components);
  if (auto ok = document.Spend(size * sizeof(float)); !ok) return std::unexpected(ok.error());
  std::vector<float> values(size);
  if (auto ok = ReadFloatsInto(document, accessor, *shape, integers, values); !ok) return std::unexpected(ok.error());
  return values;
}

template <class V>
Result<std::vector<V>> ReadVectors(GltfDocument& document, int accessor, Integers integers) {
  constexpr int components = static_cast<int>(sizeof(V) / sizeof(float));
  auto shape = CheckShape(document, accessor, components);
  if (!shape) return std::unexpected(shape.error());
  if (auto ok = document.Spend(shape->count * sizeof(V)); !ok) return std::unexpected(ok.error());
  std::vector<V> values(shape->count, V(0.0f));
  const std::span<float> floats(reinterpret_cast<float*>(values.data()), values.size() * components);
  if (auto ok = ReadFloatsInto(document, accessor, *shape, integers, floats); !ok) return std::unexpected(ok.error());
  return values;
}

template Result<std::vector<glm::vec2>> ReadVectors<glm::vec2>(GltfDocument&, int, Integers);
template Result<std::vector<glm::vec3>> ReadVectors<glm::vec3>(GltfDocument&, int, Integers);
template Result<std::vector<glm::vec4>> ReadVectors<glm::vec4>(GltfDocument&, int, Integers);
template Result<std::vector<glm::mat4>> ReadVectors<glm::mat4>(GltfDocument&, int, Integers);

Result<std::vector<std::uint32_t>> ReadIntegers(GltfDocument& document, int index, int components) {
  auto shape = CheckShape(document, index, components);
  if (!shape) return std::unexpected(shape.error());
  const int type = shape->component_type;
  if (type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE && type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT &&
      type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT) {
    return Bad(index, fmt::format("expected unsigned integers, found component type {}", type));
  }
  const std::size_t size = shape->count * static_cast<std::size_t>(components);
  if (auto ok = document.Spend(size * sizeof(std::uint32_t)); !ok) return std::unexpected(ok.error());
  std::vector<std::uint32_t> values(size);
  const tinygltf::Accessor& accessor = At(document, index);
  if (accessor.bufferView >= 0) DecodeIntegers(DenseElements(document, accessor), type, components, values.data());
  if (!accessor.sparse.isSparse) return values;

  auto places = SparsePlaces(document, index);
  if (!places) return std::unexpected(places.error());
  std::vector<std::uint32_t> replaced(places->size() * static_cast<std::size_t>(components));
  DecodeIntegers(SparseElements(document, accessor), type, components, replaced.data());
  for (std::size_t i = 0; i < replaced.size(); ++i) {
    const auto width = static_cast<std::size_t>(components);
    values[(*places)[i / width] * width + i % width] = replaced[i];
  }
  return values;
}

}  // namespace burin::scene
