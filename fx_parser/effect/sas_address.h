// SPDX-License-Identifier: Apache-2.0
#pragma once
// Addresses of DXSAS 1.0, which parameters name by the annotation SasBindAddress: "Sas.Camera.WorldToView".

#include <optional>
#include <string_view>

#include "fx_parser/effect/parameter_meaning.h"

namespace burin::fx {

/// In the words of semantics; empty for an address that names nothing here.
[[nodiscard]] std::optional<ParameterMeaning> MeaningOfSasAddress(std::string_view address);

}  // namespace burin::fx
