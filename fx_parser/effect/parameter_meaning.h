// SPDX-License-Identifier: Apache-2.0
#pragma once
// What parameters mean to a host, however they say it: by a semantic, by an address of DXSAS 1.0, by the annotations of
// smaller engines or, where a file uses none of these, by their names, as the programs that such files came with set
// them by name.

#include <string>
#include <string_view>
#include <vector>

#include "fx_parser/effect/effect.h"

namespace burin::fx {

struct ParameterMeaning {
  std::string semantic;     ///< lower case, as NVIDIA's SAS spells it: "worldviewprojection", "position"; empty: none
  std::string object;       ///< whose: "camera", "light", "pointlight1", "geometry"; lower case, may be empty
  bool is_implied = false;  ///< by the name
  bool is_known_address = true;  ///< false: a SasBindAddress that names nothing here
  bool operator==(const ParameterMeaning&) const = default;
};

/// Names count only where `uses_names`: not in files of the G2-buffer's extension, whose parameters are their own.
[[nodiscard]] ParameterMeaning MeaningOf(const Parameter& parameter, bool uses_names);

/// "g_mWorldViewProjection", "matWVP", "objectToWorld" as a semantic in lower case; empty when it is no such name.
[[nodiscard]] std::string MatrixOfName(std::string_view name);

/// Whether a matrix of this semantic takes vertices to clip space.
[[nodiscard]] bool IsProjection(std::string_view semantic);

}  // namespace burin::fx
