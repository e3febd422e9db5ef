// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/gbuffer/storage.h"
#include "core/gl/buffer_texture.h"
#include "core/gl/handle.h"
#include "core/gl/program.h"
#include "core/gl/texture.h"
#include "core/overdraw/edge_records.h"
#include "core/overdraw/edge_tiles.h"

namespace burin::overdraw {

/// Works on the pixels of a finished picture that edges may touch: each is written once, from a loop over the edges of
/// its tile, so that nothing is kept in between. After tiled shading (Olsson and Assarsson, "Tiled Shading", 2011),
/// with edges in place of lights.
class TilePass {
 public:
  /// `body`: GLSL that declares
  ///   void Edge(int record)              once for each edge of the tile, in the records' order
  ///   float Touched()                    how much edges have to do with the pixel: with 0 it stays as it is
  ///   vec4 End(ivec2 p)                  its colour, scene-linear with associated alpha
  /// and may call EdgeAreaFunctions' and
  ///   vec4 Stored(ivec2 p)               the picture's colour there, before this pass, as it is stored; in this form
  ///                                      `least` and `most` bound what End's colour becomes
  ///   vec4 Linear(vec4 stored)           the same, scene-linear with associated alpha
  ///   vec4 SegmentOf(int record), DepthOf(int record), uvec4 ShadeOf(int record)   EdgeRecord's members
  ///   float depth_here, DepthBeside(ivec2 to)   the picture's depth at the pixel and at the four beside it
  ///   vec4 ColorOf(uint first, uint points, float t)   a face's colour at the share t of the edge
  /// `reach`: as in BinEdges.
  TilePass(std::string_view label, std::string_view body, float reach);

  /// Works on `color` in place. `storage`: how it is kept; CanLoadColor(storage). `depth`: reversed, of the same size.
  /// `shades`: what `records` have places in. Errors: kFailed when memory is short.
  [[nodiscard]] Result<void> Draw(const gl::Texture& color, const gbuffer::Storage& storage, const gl::Texture& depth,
                                  std::span<const EdgeRecord> records, const gl::Texture& shades);

  /// Of the first picture that had edges: see ShareNearEdges.
  [[nodiscard]] std::optional<float> share() const { return share_; }

 private:
  struct Variant {
    gbuffer::Storage storage;
    gl::Program program;
  };
  [[nodiscard]] Result<const gl::Program*> ProgramOf(const gbuffer::Storage& storage);
  [[nodiscard]] Result<const gl::Texture*> CopyOf(const gl::Texture& color);
  void UploadRuns(int width, int height);

  std::string label_;
  std::string body_;
  float reach_;
  EdgeTiles tiles_;
  std::vector<Variant> variants_;
  std::vector<gl::Texture> copies_;
  gl::BufferTexture records_;
  gl::BufferTexture edges_;
  gl::BufferTexture lists_;
  gl::BufferHandle corners_;
  gl::VertexArrayHandle vertex_array_;
  std::optional<float> share_;
};

}  // namespace burin::overdraw
