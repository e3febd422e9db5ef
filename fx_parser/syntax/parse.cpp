// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/syntax/parse.h"

#include "fx_parser/syntax/parser.h"
#include "fx_parser/syntax/preprocessor.h"

namespace burin::fx {

ast::Module Parse(const std::string& path, const FileSystem& files, const PreprocessOptions& options,
                  SourceSet& sources, Diagnostics& diagnostics) {
  Preprocessor preprocessor(files, options, sources, diagnostics);
  TokenStream stream = preprocessor.Run(path);
  if (preprocessor.incomplete()) return {};
  return Parser(stream, diagnostics).ParseModule();
}

}  // namespace burin::fx
