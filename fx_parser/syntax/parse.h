// SPDX-License-Identifier: Apache-2.0
#pragma once
// Effect text to syntax tree: preprocessor, lexer and parser behind one function.

#include <string>
#include <utility>
#include <vector>

#include "fx_parser/source/diagnostic.h"
#include "fx_parser/source/file_system.h"
#include "fx_parser/source/source.h"
#include "fx_parser/syntax/ast.h"

namespace burin::fx {

struct PreprocessOptions {
  std::vector<std::string> include_folders;   ///< searched in order, after the including file's own folder
  /// NAME or NAME(a,b), and its value; an empty value defines it as 1. They override the predefined
  /// DIRECT3D_VERSION (0x900) and BURIN (1); __FILE__ and __LINE__ are predefined too.
  std::vector<std::pair<std::string, std::string>> definitions;
};

/// Reads and preprocesses `path`, then parses it. Always returns what could be parsed; whether it is whole,
/// Diagnostics::has_errors() says. A main file that cannot be read is an error like any other. After a missing include,
/// an #error or a passed limit the module is empty: what follows would only be errors of their making. Never throws.
///
/// What a semantic check may rely on after a parse without errors:
/// - every TypeName is a built-in type (TypeName::type complete, row_major set from qualifier and #pragma pack_matrix),
///   or the name of a struct or typedef declared before it (kind kStruct). An anonymous struct's users have
///   type.structure set already. An unknown type name has been reported and has kind kError.
/// - no expression tree is higher, and no statements nest deeper, than the limits below: recursion over them is safe.
/// - struct, typedef and variable names may still be declared twice.
[[nodiscard]] ast::Module Parse(const std::string& path, const FileSystem& files, const PreprocessOptions& options,
                                SourceSet& sources, Diagnostics& diagnostics);

inline constexpr int kMaxExpressionHeight = 512;   ///< levels of one expression tree
inline constexpr int kMaxNesting = 256;            ///< blocks, parentheses and initialiser braces inside one another

}  // namespace burin::fx
