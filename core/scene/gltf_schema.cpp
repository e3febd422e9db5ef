// SPDX-License-Identifier: Apache-2.0
#include "core/scene/gltf_schema.h"

// Source: Khronos glTF 2.0 specification (ISO/IEC 12113:2022), section 5 "Properties Reference", and the KHR extensions
// of the same names. Looser than the schema where readers agree to be: empty arrays are let through, and factors
// outside 0..1 are clamped where they are used.

#include <array>
#include <utility>

namespace burin::scene {
namespace {

using enum Shape;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr bool kRequired = true;

constexpr Rule kRoot[] = {
    {"asset", kObject, kRequired, "asset"},
    {"scene", kIndex, false, "scenes"},
    {"extensionsUsed", kStrings},
    {"extensionsRequired", kStrings},
    {"accessors", kObjects, false, "accessor"},
    {"animations", kObjects, false, "animation"},
    {"buffers", kObjects, false, "buffer"},
    {"bufferViews", kObjects, false, "bufferView"},
    {"cameras", kObjects, false, "camera"},
    {"images", kObjects, false, "image"},
    {"materials", kObjects, false, "material"},
    {"meshes", kObjects, false, "mesh"},
    {"nodes", kObjects, false, "node"},
    {"samplers", kObjects, false, "sampler"},
    {"scenes", kObjects, false, "scene"},
    {"skins", kObjects, false, "skin"},
    {"textures", kObjects, false, "texture"},
};
constexpr Rule kAsset[] = {
    {"version", kString, kRequired}, {"minVersion", kString}, {"generator", kString}, {"copyright", kString}};
constexpr Rule kAccessor[] = {
    {"name", kString},
    {"bufferView", kIndex, false, "bufferViews"},
    {"byteOffset", kInteger},
    {"componentType", kCode, kRequired, "5120|5121|5122|5123|5125|5126"},
    {"normalized", kBoolean},
    {"count", kInteger, kRequired, {}, 1},
    {"type", kWord, kRequired, "SCALAR|VEC2|VEC3|VEC4|MAT2|MAT3|MAT4"},
    {"min", kNumbers},
    {"max", kNumbers},
    {"sparse", kObject, false, "sparse"},
};
constexpr double kIntMax = std::numeric_limits<int>::max();  // tinygltf keeps these as int
constexpr Rule kSparse[] = {{"count", kInteger, kRequired, {}, 1, kIntMax},
                            {"indices", kObject, kRequired, "sparseIndices"},
                            {"values", kObject, kRequired, "sparseValues"}};
constexpr Rule kSparseIndices[] = {{"bufferView", kIndex, kRequired, "bufferViews"},
                                   {"byteOffset", kInteger, false, {}, 0, kIntMax},
                                   {"componentType", kCode, kRequired, "5121|5123|5125"}};
constexpr Rule kSparseValues[] = {{"bufferView", kIndex, kRequired, "bufferViews"},
                                  {"byteOffset", kInteger, false, {}, 0, kIntMax}};
constexpr Rule kAnimation[] = {{"name", kString},
                               {"channels", kObjects, kRequired, "channel"},
                               {"samplers", kObjects, kRequired, "animationSampler"}};
constexpr Rule kChannel[] = {{"sampler", kInteger, kRequired, {}, 0, kIntMax},
                             {"target", kObject, kRequired, "target"}};
constexpr Rule kTarget[] = {{"node", kIndex, false, "nodes"}, {"path", kString, kRequired}};
constexpr Rule kAnimationSampler[] = {{"input", kIndex, kRequired, "accessors"},
                                      {"interpolation", kWord, false, "LINEAR|STEP|CUBICSPLINE"},
                                      {"output", kIndex, kRequired, "accessors"}};
constexpr Rule kBuffer[] = {{"name", kString}, {"uri", kString}, {"byteLength", kInteger, kRequired, {}, 1}};
constexpr Rule kBufferView[] = {{"name", kString},
                                {"buffer", kIndex, kRequired, "buffers"},
                                {"byteOffset", kInteger},
                                {"byteLength", kInteger, kRequired, {}, 1},
                                {"byteStride", kInteger, false, {}, 4, 252},
                                {"target", kInteger, false, {}, 0, kIntMax}};
constexpr Rule kCamera[] = {{"name", kString},
                            {"type", kWord, kRequired, "perspective|orthographic"},
                            {"perspective", kObject, false, "perspective"},
                            {"orthographic", kObject, false, "orthographic"}};
constexpr Rule kPerspective[] = {{"aspectRatio", kNumber, false, {}, kPositive},
                                 {"yfov", kNumber, kRequired, {}, kPositive, 3.14159},
                                 {"zfar", kNumber, false, {}, kPositive},
                                 {"znear", kNumber, kRequired, {}, kPositive}};
constexpr Rule kOrthographic[] = {{"xmag", kNumber, kRequired},
                                  {"ymag", kNumber, kRequired},
                                  {"zfar", kNumber, kRequired, {}, kPositive},
                                  {"znear", kNumber, kRequired, {}, 0}};
constexpr Rule kImage[] = {
    {"name", kString}, {"uri", kString}, {"mimeType", kString}, {"bufferView", kIndex, false, "bufferViews"}};
constexpr Rule kMaterial[] = {{"name", kString},
                              {"pbrMetallicRoughness", kObject, false, "pbrMetallicRoughness"},
                              {"normalTexture", kObject, false, "normalTextureInfo"},
                              {"occlusionTexture", kObject, false, "occlusionTextureInfo"},
                              {"emissiveTexture", kObject, false, "textureInfo"},
                              {"emissiveFactor", kNumbers, false, {}, -kInfinity, kInfinity, 3},
                              {"alphaMode", kWord, false, "OPAQUE|MASK|BLEND"},
                              {"alphaCutoff", kNumber, false, {}, 0},
                              {"doubleSided", kBoolean}};
constexpr Rule kPbr[] = {{"baseColorFactor", kNumbers, false, {}, -kInfinity, kInfinity, 4},
                         {"baseColorTexture", kObject, false, "textureInfo"},
                         {"metallicFactor", kNumber},
                         {"roughnessFactor", kNumber},
                         {"metallicRoughnessTexture", kObject, false, "textureInfo"}};
constexpr Rule kTextureInfo[] = {{"index", kIndex, kRequired, "textures"},
                                 {"texCoord", kInteger, false, {}, 0, kIntMax}};
constexpr Rule kNormalTextureInfo[] = {
    {"index", kIndex, kRequired, "textures"}, {"texCoord", kInteger, false, {}, 0, kIntMax}, {"scale", kNumber}};
constexpr Rule kOcclusionTextureInfo[] = {
    {"index", kIndex, kRequired, "textures"}, {"texCoord", kInteger, false, {}, 0, kIntMax}, {"strength", kNumber}};
constexpr Rule kMesh[] = {{"name", kString}, {"primitives", kObjects, kRequired, "primitive"}, {"weights", kNumbers}};
constexpr Rule kPrimitive[] = {{"attributes", kAccessorMap, kRequired},
                               {"indices", kIndex, false, "accessors"},
                               {"material", kIndex, false, "materials"},
                               {"mode", kCode, false, "0|1|2|3|4|5|6"},
                               {"targets", kAccessorMaps}};
constexpr Rule kNode[] = {{"name", kString},
                          {"camera", kIndex, false, "cameras"},
                          {"children", kIndices, false, "nodes"},
                          {"skin", kIndex, false, "skins"},
                          {"mesh", kIndex, false, "meshes"},
                          {"matrix", kNumbers, false, {}, -kInfinity, kInfinity, 16},
                          {"rotation", kNumbers, false, {}, -kInfinity, kInfinity, 4},
                          {"scale", kNumbers, false, {}, -kInfinity, kInfinity, 3},
                          {"translation", kNumbers, false, {}, -kInfinity, kInfinity, 3},
                          {"weights", kNumbers}};
constexpr Rule kSampler[] = {{"name", kString},
                             {"magFilter", kCode, false, "9728|9729"},
                             {"minFilter", kCode, false, "9728|9729|9984|9985|9986|9987"},
                             {"wrapS", kCode, false, "33071|33648|10497"},
                             {"wrapT", kCode, false, "33071|33648|10497"}};
constexpr Rule kScene[] = {{"name", kString}, {"nodes", kIndices, false, "nodes"}};
constexpr Rule kSkin[] = {{"name", kString},
                          {"inverseBindMatrices", kIndex, false, "accessors"},
                          {"skeleton", kIndex, false, "nodes"},
                          {"joints", kIndices, kRequired, "nodes"}};
constexpr Rule kTexture[] = {
    {"name", kString}, {"sampler", kIndex, false, "samplers"}, {"source", kIndex, false, "images"}};

// The root's object has `lights`, a node's has `light`.
constexpr Rule kLightsPunctual[] = {{"lights", kObjects, false, "light"}, {"light", kIndex, false, "lights"}};
constexpr Rule kLight[] = {{"name", kString},
                           {"type", kWord, kRequired, "directional|point|spot"},
                           {"color", kNumbers, false, {}, -kInfinity, kInfinity, 3},
                           {"intensity", kNumber, false, {}, 0},
                           {"range", kNumber, false, {}, kPositive},
                           {"spot", kObject, false, "spot"}};
constexpr Rule kSpot[] = {{"innerConeAngle", kNumber, false, {}, 0, 1.570797},
                          {"outerConeAngle", kNumber, false, {}, kPositive, 1.570797}};
constexpr Rule kTextureTransform[] = {{"offset", kNumbers, false, {}, -kInfinity, kInfinity, 2},
                                      {"rotation", kNumber},
                                      {"scale", kNumbers, false, {}, -kInfinity, kInfinity, 2},
                                      {"texCoord", kInteger, false, {}, 0, kIntMax}};
constexpr Rule kEmissiveStrength[] = {{"emissiveStrength", kNumber, false, {}, 0}};
constexpr Rule kIor[] = {{"ior", kNumber, false, {}, 0}};
constexpr Rule kDiffuseTransmission[] = {{"diffuseTransmissionFactor", kNumber, false, {}, 0},
                                         {"diffuseTransmissionColorFactor", kNumbers, false, {}, 0, kInfinity, 3}};
constexpr Rule kVolume[] = {{"attenuationDistance", kNumber, false, {}, kPositive},
                            {"attenuationColor", kNumbers, false, {}, 0, kInfinity, 3}};

constexpr std::pair<std::string_view, std::span<const Rule>> kTypes[] = {
    {"root", kRoot},
    {"asset", kAsset},
    {"accessor", kAccessor},
    {"sparse", kSparse},
    {"sparseIndices", kSparseIndices},
    {"sparseValues", kSparseValues},
    {"animation", kAnimation},
    {"channel", kChannel},
    {"target", kTarget},
    {"animationSampler", kAnimationSampler},
    {"buffer", kBuffer},
    {"bufferView", kBufferView},
    {"camera", kCamera},
    {"perspective", kPerspective},
    {"orthographic", kOrthographic},
    {"image", kImage},
    {"material", kMaterial},
    {"pbrMetallicRoughness", kPbr},
    {"textureInfo", kTextureInfo},
    {"normalTextureInfo", kNormalTextureInfo},
    {"occlusionTextureInfo", kOcclusionTextureInfo},
    {"mesh", kMesh},
    {"primitive", kPrimitive},
    {"node", kNode},
    {"sampler", kSampler},
    {"scene", kScene},
    {"skin", kSkin},
    {"texture", kTexture},
    {"KHR_lights_punctual", kLightsPunctual},
    {"light", kLight},
    {"spot", kSpot},
    {"KHR_texture_transform", kTextureTransform},
    {"KHR_materials_emissive_strength", kEmissiveStrength},
    {"KHR_materials_ior", kIor},
    {"KHR_materials_diffuse_transmission", kDiffuseTransmission},
    {"KHR_materials_volume", kVolume},
};

}  // namespace

std::span<const Rule> RulesOf(std::string_view object_type) {
  for (const auto& [name, rules] : kTypes) {
    if (name == object_type) return rules;
  }
  return {};
}

}  // namespace burin::scene
