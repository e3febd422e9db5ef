// SPDX-License-Identifier: Apache-2.0
// Any bytes as an effect: preprocessed, parsed, and every message printed. The text up to a line "//--" is the main
// file, the rest a file that it may include as "inner.fxh".

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "fx_parser/syntax/parse.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace burin::fx;
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  const std::string separator = "\n//--\n";
  const std::size_t split = bytes.find(separator);
  InMemoryFileSystem files;
  files.files["main.fx"] = bytes.substr(0, split);
  files.files["inner.fxh"] = split == std::string::npos ? "" : bytes.substr(split + separator.size());
  SourceSet sources;
  Diagnostics diagnostics;
  const ast::Module module = Parse("main.fx", files, {}, sources, diagnostics);
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    if (FormatDiagnostic(diagnostic, sources).empty()) std::abort();
  }
  if (diagnostics.error_count() > Diagnostics::kMaxErrors) std::abort();
  return 0;
}
