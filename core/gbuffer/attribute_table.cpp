// SPDX-License-Identifier: Apache-2.0
#include "core/gbuffer/attribute_table.h"

#include <algorithm>
#include <cctype>

namespace burin::gbuffer {
namespace {

// Farther than anything: what Blender and Nuke expect of an empty Z. Half-float targets hold 65504 instead.
constexpr float kFar = 1e10f;

constexpr std::string_view kSceneUnits = "scene units (metres in glTF)";

constexpr std::array<AttributeInfo, static_cast<std::size_t>(Attribute::kCount)> kTable = {{
    {Attribute::kColor, "color", 4, false, true, false, {0, 0, 0, 0}, "-", ">= 0", "scene-linear radiance",
     {"R", "G", "B", "A"},
     "The shaded picture; alpha is coverage."},
    {Attribute::kIntensity, "intensity", 1, false, true, false, {0, 0, 0, 0}, "-", ">= 0", "as color",
     {"intensity.Y", "", "", ""},
     "Rec. 709 luma of color as this target would store it."},
    {Attribute::kAlpha, "alpha", 1, false, false, false, {0, 0, 0, 0}, "-", "0..1", "-",
     {"alpha.A", "", "", ""},
     "Coverage: the alpha of color."},
    {Attribute::kAlbedo, "albedo", 3, false, true, false, {0, 0, 0, 0}, "-", "0..1", "reflectance",
     {"albedo.R", "albedo.G", "albedo.B", ""},
     "Base colour: factor times texture times vertex colour, without light."},
    {Attribute::kDepth, "depth", 1, false, false, false, {kFar, 0, 0, 0}, "view", ">= 0", kSceneUnits,
     {"Z", "", "", ""},
     "Distance from the eye's plane along the viewing direction; linear."},
    {Attribute::kZbuffer, "zbuffer", 1, false, false, false, {1, 0, 0, 0}, "window", "0..1", "-",
     {"zbuffer.Z", "", "", ""},
     "Window depth as Direct3D has it: 0 on the near plane, 1 on the far one."},
    {Attribute::kNormal, "normal", 3, true, false, false, {0, 0, 0, 0}, "world", "-1..1", "unit vector",
     {"N.X", "N.Y", "N.Z", ""},
     "Shading normal, the normal map applied, on the side that is seen."},
    {Attribute::kViewNormal, "viewnormal", 3, true, false, false, {0, 0, 0, 0}, "view", "-1..1", "unit vector",
     {"viewnormal.X", "viewnormal.Y", "viewnormal.Z", ""},
     "The same normal with x to the right, y up and z towards the eye."},
    {Attribute::kTangent, "tangent", 3, true, false, false, {0, 0, 0, 0}, "world", "-1..1", "unit vector",
     {"tangent.X", "tangent.Y", "tangent.Z", ""},
     "Direction in which u grows on the surface; 0 without texture coordinates."},
    {Attribute::kPosition, "position", 3, true, false, false, {0, 0, 0, 0}, "world", "any", kSceneUnits,
     {"P.X", "P.Y", "P.Z", ""},
     "Position of the surface."},
    {Attribute::kViewPosition, "viewposition", 3, true, false, false, {0, 0, 0, 0}, "view", "any", kSceneUnits,
     {"viewposition.X", "viewposition.Y", "viewposition.Z", ""},
     "Position of the surface as the eye sees it: x to the right, y up, z negative in front."},
    {Attribute::kScreenPosition, "screenposition", 2, false, false, false, {0, 0, 0, 0}, "window", ">= 0",
     "pixels of the target",
     {"screenposition.X", "screenposition.Y", "", ""},
     "Centre of the pixel, from the top left corner: (0.5, 0.5) is the first."},
    {Attribute::kTexcoord, "texcoord", 2, false, false, false, {0, 0, 0, 0}, "texture", "any", "-",
     {"texcoord.U", "texcoord.V", "", ""},
     "First set of texture coordinates, untransformed; 0 without."},
    {Attribute::kTexcoord1, "texcoord1", 2, false, false, false, {0, 0, 0, 0}, "texture", "any", "-",
     {"texcoord1.U", "texcoord1.V", "", ""},
     "Second set of texture coordinates, untransformed; 0 without."},
    {Attribute::kVertexColor, "vertexcolor", 4, false, true, false, {0, 0, 0, 0}, "-", "0..1", "reflectance",
     {"vertexcolor.R", "vertexcolor.G", "vertexcolor.B", "vertexcolor.A"},
     "Vertex colour with its own, unassociated alpha; white without."},
    {Attribute::kObjectId, "objectid", 1, false, false, true, {0, 0, 0, 0}, "-", ">= 1", "-",
     {"objectid.ID", "", "", ""},
     "Number of the node among those with a mesh, in the file's order."},
    {Attribute::kMaterialId, "materialid", 1, false, false, true, {0, 0, 0, 0}, "-", ">= 0", "-",
     {"materialid.ID", "", "", ""},
     "1 + the material's index in the file; 0 is the default material."},
    {Attribute::kPrimitiveId, "primitiveid", 1, false, false, true, {0, 0, 0, 0}, "-", ">= 1", "-",
     {"primitiveid.ID", "", "", ""},
     "Number of the triangle, line or point in the frame."},
    {Attribute::kFacing, "facing", 1, true, false, false, {0, 0, 0, 0}, "-", "-1 or 1", "-",
     {"facing.Y", "", "", ""},
     "1 where the front of a surface is seen, -1 where its back is; lines and points are fronts."},
    {Attribute::kVelocity, "velocity", 2, true, false, false, {0, 0, 0, 0}, "window", "any",
     "pixels of the target a frame",
     {"velocity.X", "velocity.Y", "", ""},
     "Motion since the previous frame, x to the right and y down; camera, nodes, skins and morphs included."},
    {Attribute::kEmissive, "emissive", 3, false, true, false, {0, 0, 0, 0}, "-", ">= 0", "scene-linear radiance",
     {"emissive.R", "emissive.G", "emissive.B", ""},
     "Emitted light: factor times texture."},
    {Attribute::kRoughness, "roughness", 1, false, false, false, {0, 0, 0, 0}, "-", "0..1", "-",
     {"roughness.Y", "", "", ""},
     "Perceptual roughness: factor times texture."},
    {Attribute::kMetallic, "metallic", 1, false, false, false, {0, 0, 0, 0}, "-", "0..1", "-",
     {"metallic.Y", "", "", ""},
     "Metalness: factor times texture."},
    {Attribute::kLightDepth, "lightdepth", 1, false, false, false, {kFar, 0, 0, 0}, "light", "any", kSceneUnits,
     {"lightdepth.Z", "", "", ""},
     "Depth as the key light sees it: along its axis from its position, in every direction for a point light."},
    {Attribute::kVideo, "video", 4, false, true, false, {0, 0, 0, 0}, "-", "0..1", "as color",
     {"video.R", "video.G", "video.B", "video.A"},
     "The frame of the source video; without one the background."},
}};

constexpr bool IsInOrder() {
  for (std::size_t i = 0; i < kTable.size(); ++i) {
    if (static_cast<std::size_t>(kTable[i].attribute) != i) return false;
  }
  return true;
}
static_assert(IsInOrder(), "Info() takes the enumerator as an index");

bool EqualIgnoringCase(std::string_view a, std::string_view b) {
  return std::ranges::equal(a, b, [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

}  // namespace

std::optional<Attribute> FindAttribute(std::string_view name) {
  const auto* found = std::ranges::find_if(kTable, [&](const AttributeInfo& info) { return EqualIgnoringCase(info.name, name); });
  if (found == kTable.end()) return std::nullopt;
  return found->attribute;
}

const AttributeInfo& Info(Attribute attribute) { return kTable.at(static_cast<std::size_t>(attribute)); }

std::span<const AttributeInfo> AllAttributes() { return kTable; }

}  // namespace burin::gbuffer
