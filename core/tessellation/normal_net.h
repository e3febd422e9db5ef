// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/tessellation/kernels.h"
#include "core/tessellation/net.h"

namespace burin::tessellation {

/// The net of a patch's normals, of any length: the cross product of its derivatives (Moreton, section 6), a
/// polynomial whose degree is about twice the position's, three times for rational patches.
/// `du`, `dv`: from DeriveU and DeriveV of `position`.
void MakeNormalNet(const Kernels& kernels, const Net& position, const Net& du, const Net& dv, bool is_rational,
                   Net& normal);

}  // namespace burin::tessellation
