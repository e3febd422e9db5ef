// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/source/source.h"

#include <algorithm>
#include <iterator>

namespace burin::fx {

PresumedLine Presume(const SourceFile& file, std::uint32_t line) {
  const auto after = std::ranges::lower_bound(file.line_directives, line, {}, &LineDirective::line);
  if (after == file.line_directives.begin()) return {file.path, line};
  const LineDirective& directive = *std::prev(after);
  return {directive.path.empty() ? file.path : directive.path, directive.presumed_line + (line - directive.line - 1)};
}

}  // namespace burin::fx
