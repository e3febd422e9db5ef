// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace burin::fx {

/// "texcoord3" is TEXCOORD and 3; "POSITION" is POSITION and 0. Direct3D 10's and Cg's names become Direct3D 9's:
/// SV_Position POSITION, SV_Target COLOR, SV_Depth DEPTH, TEX TEXCOORD, COL COLOR, HPOS POSITION, WPOS VPOS.
struct Semantic {
  std::string name;  ///< upper case
  int index = 0;
  [[nodiscard]] std::string Key() const { return name + std::to_string(index); }
  bool operator==(const Semantic&) const = default;
};

[[nodiscard]] Semantic ParseSemantic(std::string_view text);

}  // namespace burin::fx
