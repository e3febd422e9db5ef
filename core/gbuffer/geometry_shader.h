// SPDX-License-Identifier: Apache-2.0
#pragma once
// The geometry pass's shaders, written for a set of outputs and a kind of draw. Text only; no GL.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/gbuffer/storage.h"

namespace burin::gbuffer {

/// What a draw has. Software rasterizers pay for every texture look-up, so absent ones are left out of the text.
enum DrawFeature : std::uint32_t {
  kHasBaseColorTexture = 1u << 0,
  kHasMetallicRoughnessTexture = 1u << 1,
  kHasNormalTexture = 1u << 2,
  kHasOcclusionTexture = 1u << 3,
  kHasEmissiveTexture = 1u << 4,
  kIsUnlit = 1u << 5,
  kIsMasked = 1u << 6,  ///< alpha mode MASK
  kHasNormals = 1u << 7,
  kHasTangents = 1u << 8,
  kHasTexcoords = 1u << 9,
  kHasLights = 1u << 10,  ///< of the scene
  kIsBlend = 1u << 11,    ///< alpha mode BLEND, drawn for the attributes that take the nearest opaque-enough surface
  kIsBlendedColor = 1u << 12,  ///< alpha mode BLEND, drawn for its colour alone
  kIsSample = 1u << 13,        ///< FaceSamples, one a fragment (face_samples.h says where), for their colour alone
  kHasPatches = 1u << 14,      ///< the draw is a tessellated surface
  kIsTranslucent = 1u << 15,   ///< light scatters through it (translucency_stage.h)
  kIsFaceMap = 1u << 16,       ///< drawn by a TranslucencyStage itself: every surface is a front
};

/// BLEND surfaces with less alpha than this are not there for any attribute but color, intensity and alpha.
inline constexpr float kBlendCutoff = 0.5f;

/// One colour output.
struct Output {
  int location = 0;
  Storage storage;
  /// Colour for blending: scene-linear with associated alpha as it is; the targets' encodings come later.
  bool is_blended = false;
};

/// `features`: those of the fragment text that it goes with.
[[nodiscard]] std::string GeometryVertexText(std::uint32_t features);
/// `translucency`: TranslucencyStage::ShaderText(), for draws with kIsTranslucent.
[[nodiscard]] std::string GeometryFragmentText(const std::vector<Output>& outputs, std::uint32_t features,
                                               std::string_view translucency = {});
/// The beginning of a fragment shader that calls `Surface GetSurface()`, and `vec3 ScatterTint(Surface s)`, by which
/// light is multiplied where it enters and where it leaves. Blocks, inputs and functions.
[[nodiscard]] std::string SurfaceText(std::uint32_t features);

/// The features that make a difference to these outputs.
[[nodiscard]] std::uint32_t RelevantFeatures(const std::vector<Output>& outputs, std::uint32_t features);

}  // namespace burin::gbuffer
