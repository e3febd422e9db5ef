// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/effect/sas_address.h"

#include "fx_parser/effect/case.h"

namespace burin::fx {
namespace {

struct Address {
  std::string_view name;  ///< lower case; "[]" stands for an index
  std::string_view semantic;
  std::string_view object;  ///< with the index behind it where it has one
};
// "Standard Annotations and Semantics for DirectX", version 1.0.
constexpr Address kAddresses[] = {
    {"sas.skeleton.meshtojointtoworld[]", "world", ""},
    {"sas.skeleton.meshtojointtoworld", "world", ""},
    {"sas.camera.worldtoview", "view", ""},
    {"sas.camera.projection", "projection", ""},
    {"sas.camera.viewtoprojection", "projection", ""},
    {"sas.camera.worldtoprojection", "viewprojection", ""},
    {"sas.camera.worldtoviewprojection", "viewprojection", ""},
    {"sas.camera.viewtoworld", "viewinverse", ""},
    {"sas.camera.position", "position", "camera"},
    {"sas.camera.direction", "direction", "camera"},
    {"sas.ambientlight[].color", "ambient", "light"},
    {"sas.directionallight[].color", "diffuse", "directionallight"},
    {"sas.directionallight[].direction", "direction", "directionallight"},
    {"sas.pointlight[].color", "diffuse", "pointlight"},
    {"sas.pointlight[].position", "position", "pointlight"},
    {"sas.pointlight[].range", "range", "pointlight"},
    {"sas.spotlight[].color", "diffuse", "spotlight"},
    {"sas.spotlight[].position", "position", "spotlight"},
    {"sas.spotlight[].direction", "direction", "spotlight"},
    {"sas.spotlight[].range", "range", "spotlight"},
    {"sas.numambientlights", "numlights", "light"},
    {"sas.numdirectionallights", "numlights", "directionallight"},
    {"sas.numpointlights", "numlights", "pointlight"},
    {"sas.numspotlights", "numlights", "spotlight"},
    {"sas.hasambientlight", "numlights", "light"},
    {"sas.hasdirectionallight", "numlights", "directionallight"},
    {"sas.haspointlight", "numlights", "pointlight"},
    {"sas.hasspotlight", "numlights", "spotlight"},
    {"sas.time.now", "time", ""},
    {"sas.time.last", "lasttime", ""},
    {"sas.time.framenumber", "frame", ""},
    {"sas.viewport.size", "viewportpixelsize", ""},
};

}  // namespace

std::optional<ParameterMeaning> MeaningOfSasAddress(std::string_view address) {
  std::string name;
  std::string index;
  bool is_index = false;
  for (const char c : LowerCase(address)) {
    if (c == ' ') continue;
    if (c == ']') is_index = false;
    if (is_index)
      index += c;
    else
      name += c;
    if (c == '[') is_index = true;
  }
  for (const Address& known : kAddresses) {
    if (known.name != name) continue;
    ParameterMeaning meaning;
    meaning.semantic = known.semantic;
    meaning.object = known.object;
    if (!meaning.object.empty() && index != "*" && meaning.object != "camera") meaning.object += index;
    return meaning;
  }
  return std::nullopt;
}

}  // namespace burin::fx
