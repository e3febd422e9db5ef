// SPDX-License-Identifier: Apache-2.0
#include "core/tessellation/patch_nets.h"

#include "core/tessellation/normal_net.h"

namespace burin::tessellation {

using geometry::BezierPatch;
using geometry::BezierPatches;

void PatchNets::Load(const Kernels& kernels, const BezierPatches& patches, const BezierPatch& patch,
                     bool wants_tangents) {
  const auto mark = [&](Channel channel, bool is_there) {
    has[static_cast<std::size_t>(channel)] = is_there;
    return is_there;
  };
  PatchNets& nets = *this;
  mark(Channel::kPosition, true);
  LoadNet(patch.domain, patch.position, std::span(patches.positions), nets[Channel::kPosition]);
  if (!patch.is_rational) {
    Net& position = nets[Channel::kPosition];
    for (int k = 0; k < position.Count(); ++k) position.value[k][3] = 0.0;
  }
  mark(Channel::kPositionDu, wants_tangents);
  mark(Channel::kPositionDv, wants_tangents);
  if (wants_tangents || !patch.normal) {
    DeriveU(nets[Channel::kPosition], nets[Channel::kPositionDu]);
    DeriveV(nets[Channel::kPosition], nets[Channel::kPositionDv]);
  }
  mark(Channel::kNormal, true);
  if (patch.normal) {
    LoadNet(patch.domain, patch.normal, std::span(patches.normals), nets[Channel::kNormal]);
  } else {
    MakeNormalNet(kernels, nets[Channel::kPosition], nets[Channel::kPositionDu], nets[Channel::kPositionDv],
                  patch.is_rational, nets[Channel::kNormal]);
  }
  kernels.rescale(nets[Channel::kNormal].value.data(), nets[Channel::kNormal].Count());
  if (mark(Channel::kTexcoord0, static_cast<bool>(patch.texcoord[0])))
    LoadNet(patch.domain, patch.texcoord[0], std::span(patches.texcoords[0]), nets[Channel::kTexcoord0]);
  if (mark(Channel::kTexcoord1, static_cast<bool>(patch.texcoord[1])))
    LoadNet(patch.domain, patch.texcoord[1], std::span(patches.texcoords[1]), nets[Channel::kTexcoord1]);
  if (mark(Channel::kColor, static_cast<bool>(patch.color)))
    LoadNet(patch.domain, patch.color, std::span(patches.colors), nets[Channel::kColor]);
  const bool has_texcoord_derivatives = wants_tangents && patch.texcoord[0];
  if (mark(Channel::kTexcoordDu, has_texcoord_derivatives))
    DeriveU(nets[Channel::kTexcoord0], nets[Channel::kTexcoordDu]);
  if (mark(Channel::kTexcoordDv, has_texcoord_derivatives))
    DeriveV(nets[Channel::kTexcoord0], nets[Channel::kTexcoordDv]);
}

}  // namespace burin::tessellation
