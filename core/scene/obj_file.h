// SPDX-License-Identifier: Apache-2.0
#pragma once
// A Wavefront .obj as it stands in the file: polygons, indices checked and counted from 0.

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"

namespace burin::scene {

inline constexpr std::uint32_t kNoIndex = 0xFFFFFFFFu;

struct ObjCorner {
  std::uint32_t position = 0;
  std::uint32_t texcoord = kNoIndex;
  std::uint32_t normal = kNoIndex;
};

enum class ObjElement : std::uint8_t { kFace, kLine, kPoint };

struct ObjPolygon {
  ObjElement element = ObjElement::kFace;
  std::uint32_t first_corner = 0;
  std::uint32_t corners = 0;          ///< faces: at least 3; lines: at least 2
  std::uint32_t object = 0;           ///< index in ObjFile::objects
  std::uint32_t material = kNoIndex;  ///< index in ObjFile::materials
  std::uint32_t smoothing_group = 0;  ///< 0: flat, unless there are normals
};

struct ObjFile {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> colors;  ///< empty, or one a position (the "v x y z r g b" extension)
  std::vector<glm::vec2> texcoords;
  std::vector<glm::vec3> normals;
  std::vector<ObjCorner> corners;
  std::vector<ObjPolygon> polygons;
  std::vector<std::string> objects;    ///< names of "o"; the first may be empty
  std::vector<std::string> materials;  ///< names of "usemtl"
  std::vector<std::string> libraries;  ///< files of "mtllib"
  /// "t crease" and "t corner" tags of OpenSubdiv's .obj files.
  struct Crease {
    std::array<std::uint32_t, 2> positions{};
    float sharpness = 0.0f;
  };
  std::vector<Crease> creases;
  struct SharpVertex {
    std::uint32_t position = 0;
    float sharpness = 0.0f;
  };
  std::vector<SharpVertex> sharp_vertices;
  std::vector<std::string> warnings;
};

/// Reads v, vt, vn, f, l, p, o, g, s, usemtl, mtllib and t; g is not kept; free-form curves and surfaces are warned of
/// and left out. Errors: kInput, "line 12: ..." with what was found and what was expected; the caller names the file.
[[nodiscard]] Result<ObjFile> ParseObj(std::string_view text);

}  // namespace burin::scene
