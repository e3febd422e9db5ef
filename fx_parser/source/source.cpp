// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/source/source.h"

namespace burin::fx {

PresumedLine Presume(const SourceFile& file, std::uint32_t line) {
  PresumedLine result{file.path, line};
  for (const LineDirective& directive : file.line_directives) {
    if (directive.line >= line) break;
    if (!directive.path.empty()) result.path = directive.path;
    result.line = directive.presumed_line + (line - directive.line - 1);
  }
  return result;
}

}  // namespace burin::fx
