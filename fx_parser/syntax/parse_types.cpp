// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <iterator>

#include "fx_parser/syntax/builtin_types.h"
#include "fx_parser/syntax/glsl_words.h"
#include "fx_parser/syntax/literal.h"
#include "fx_parser/syntax/parser.h"

namespace burin::fx {

namespace {

struct QualifierWord {
  std::string_view word;
  std::uint32_t bits;
};

// `varying`, the interpolation modes and the geometry shader's primitive words say nothing that this host needs.
constexpr QualifierWord kQualifiers[] = {
    {"static", ast::kStatic},
    {"const", ast::kConst},
    {"uniform", ast::kUniform},
    {"extern", ast::kExtern},
    {"shared", ast::kShared},
    {"volatile", ast::kVolatile},
    {"row_major", ast::kRowMajor},
    {"column_major", ast::kColumnMajor},
    {"in", ast::kIn},
    {"out", ast::kOut},
    {"inout", ast::kIn | ast::kOut},
    {"inline", ast::kInline},
    {"nointerpolation", ast::kNoInterpolation},
    {"centroid", ast::kCentroid},
    {"precise", ast::kPrecise},
    {"varying", 0},
    {"linear", 0},
    {"noperspective", 0},
    {"sample", 0},
    {"point", 0},
    {"line", 0},
    {"triangle", 0},
    {"lineadj", 0},
    {"triangleadj", 0},
    {"snorm", 0},
    {"unorm", 0},
};

const QualifierWord* FindQualifier(const Token& token) {
  if (token.kind != TokenKind::kIdentifier) return nullptr;
  const auto found = std::ranges::find(kQualifiers, token.text, &QualifierWord::word);
  return found == std::end(kQualifiers) ? nullptr : found;
}

// Words that begin a statement and so never a declaration.
bool IsStatementWord(std::string_view word) {
  constexpr std::string_view kWords[] = {"return", "else", "if",      "for",   "while",    "do",
                                         "switch", "case", "default", "break", "continue", "discard"};
  return std::ranges::find(kWords, word) != std::end(kWords);
}

}  // namespace

// `line`, `point`, `sample` ... are names too: qualifiers only where a type or another qualifier follows.
bool Parser::StartsQualifier(std::size_t ahead) const {
  if (IsTypeName(Peek(ahead).text)) return false;
  return FindQualifier(Peek(ahead)) && (Is(TokenKind::kIdentifier, ahead + 1));
}

bool Parser::StartsType(std::size_t ahead) const {
  const Token& token = Peek(ahead);
  if (Is(TokenKind::kScope, ahead + 1) || token.kind == TokenKind::kScope) return StartsQualifiedType(ahead, nullptr);
  if (token.kind != TokenKind::kIdentifier) return false;
  return token.text == "struct" || token.text == "unsigned" || IsTypeName(token.text) ||
         FindBuiltinType(token.text).has_value();
}

bool Parser::IsTypeName(std::string_view name) const {
  return space_.empty() ? names_.IsType(name) : names_.IsType(names_.Resolve(name, space_));
}

// `outer::Type`; `end` is then where it ends, counted as `ahead` is.
bool Parser::StartsQualifiedType(std::size_t ahead, std::size_t* end) const {
  std::string name;
  if (Is(TokenKind::kScope, ahead)) name = Peek(ahead++).text;
  while (Is(TokenKind::kIdentifier, ahead)) {
    name += Peek(ahead++).text;
    if (!Is(TokenKind::kScope, ahead)) break;
    name += Peek(ahead++).text;
  }
  if (end) *end = ahead;
  return names_.IsType(names_.Resolve(name, space_));
}

// In a function's body. `Foo bar` is a declaration whose type is unknown, `texture = x` is an expression.
bool Parser::StartsDeclaration() const {
  if (Is(TokenKind::kScope) || Is(TokenKind::kScope, 1)) {
    std::size_t end = 0;
    return StartsQualifiedType(0, &end) && Is(TokenKind::kIdentifier, end);
  }
  if (!Is(TokenKind::kIdentifier) || IsStatementWord(Peek().text)) return false;
  if (IsWord("struct") || IsWord("typedef")) return true;
  if (Is(TokenKind::kIdentifier, 1)) return true;
  const bool takes_arguments = IsEffectWord("vector") || IsEffectWord("matrix");
  return takes_arguments && Is(TokenKind::kLess, 1);
}

bool Parser::StartsCast() const {
  if (Is(TokenKind::kScope, 1) || Is(TokenKind::kScope, 2)) {
    std::size_t end = 0;
    return StartsQualifiedType(1, &end) && Is(TokenKind::kRightParen, end);
  }
  if (!StartsType(1) || IsWord("struct", 1)) return false;
  const bool takes_arguments = IsEffectWord("vector", 1) || IsEffectWord("matrix", 1);
  if (takes_arguments && Is(TokenKind::kLess, 2)) return true;
  if (IsWord("unsigned", 1)) return true;
  if (!Is(TokenKind::kRightParen, 2) && !Is(TokenKind::kLeftBracket, 2)) return false;
  if (Is(TokenKind::kLeftBracket, 2) && !Is(TokenKind::kInteger, 3)) return false;
  if (IsTypeName(Peek(1).text)) return true;
  return FindBuiltinType(Peek(1).text)->kind == TypeKind::kNumeric;
}

std::uint32_t Parser::ParseQualifiers() {
  std::uint32_t qualifiers = 0;
  while (const QualifierWord* qualifier = StartsQualifier(0) ? FindQualifier(Peek()) : nullptr) {
    qualifiers |= qualifier->bits;
    Advance();
  }
  return qualifiers;
}

bool Parser::ParseSpecifiers(Specifiers& specifiers) {
  specifiers.qualifiers = ParseQualifiers();
  if (IsWord("struct") && (Is(TokenKind::kLeftBrace, 1) || Is(TokenKind::kLeftBrace, 2) || Is(TokenKind::kColon, 2))) {
    const std::size_t first = position_;
    specifiers.structure = ParseStruct();
    if (!specifiers.structure) return false;
    ast::TypeName& type = specifiers.type;
    type.range = RangeFrom(first);
    type.name = specifiers.structure->name;
    type.type.kind = TypeKind::kStruct;
    if (type.name.empty()) type.type.structure = specifiers.structure.get();
  } else {
    AcceptWord("struct");  // C's `struct Light light;`
    if (!ParseTypeName(specifiers.type, specifiers.qualifiers)) return false;
  }
  specifiers.qualifiers |= ParseQualifiers();  // `float const x`
  if (AcceptWord("const")) specifiers.qualifiers |= ast::kConst;
  return true;
}

bool Parser::ParseTypeName(ast::TypeName& type, std::uint32_t qualifiers) {
  const std::size_t first = position_;
  const bool is_unsigned = IsWord("unsigned") && AcceptWord("unsigned");
  if (is_unsigned && !IsWord("int")) {
    type.name = "uint";
    type.type = *FindBuiltinType("uint");
    type.range = RangeFrom(first);
    return true;
  }
  if (!Is(TokenKind::kIdentifier) && !Is(TokenKind::kScope)) {
    ReportUnexpected("a type");
    return false;
  }
  if (!ParseQualifiedName("a type", type.name, type.range)) return false;
  if (names_.IsType(type.name)) {
    type.type.kind = TypeKind::kStruct;
  } else if (const std::optional<Type> builtin = FindBuiltinType(type.name)) {
    type.type = *builtin;
    if (is_unsigned) type.type.scalar = Scalar::kUint;
    if (!ParseTypeArguments(type)) return false;
    type.type.row_major = type.type.is_matrix && ((qualifiers & ast::kRowMajor) != 0 ||
                                                  ((qualifiers & ast::kColumnMajor) == 0 && DefaultRowMajor()));
  } else {
    ReportUnknownType(type);
  }
  type.range = RangeFrom(first);
  return true;
}

// `vector<float, 3>`, `matrix<half, 4, 3>`; Direct3D 10's `Texture2D<float4>`, whose element its look-ups give.
bool Parser::ParseTypeArguments(ast::TypeName& type) {
  if (!Is(TokenKind::kLess)) return true;
  if (EqualsIgnoringCase(type.name, "vector") || EqualsIgnoringCase(type.name, "matrix")) {
    return ParseVectorArguments(type);
  }
  const bool takes_element = type.type.kind == TypeKind::kTexture || type.type.kind == TypeKind::kObject;
  if (!takes_element || !StartsType(1)) return true;
  std::size_t close = 2;
  if (Is(TokenKind::kComma, close)) close += 2;  // the samples of a Texture2DMS, the points of a patch
  if (!Is(TokenKind::kGreater, close)) return true;
  const std::optional<Type> element = FindBuiltinType(Peek(1).text);
  if (type.type.kind == TypeKind::kTexture && element && element->kind == TypeKind::kNumeric) {
    type.type.is_vector = true;
    type.type.columns = element->columns;
    type.type.scalar = element->scalar;
  }
  position_ += close + 1;
  return true;
}

bool Parser::ParseVectorArguments(ast::TypeName& type) {
  const Range opening = Advance().range();
  const Token scalar_token = Peek();
  const std::optional<Scalar> scalar = FindScalar(scalar_token.text);
  if (!scalar) {
    ReportUnexpected("a scalar type in " + type.name + "<...>");
    return false;
  }
  Advance();
  type.type.scalar = *scalar;
  std::uint8_t* const sizes[] = {type.type.is_matrix ? &type.type.rows : &type.type.columns, &type.type.columns};
  const Setting angle(stop_at_greater_, true);
  for (int i = 0; i < (type.type.is_matrix ? 2 : 1); ++i) {
    if (!Expect(TokenKind::kComma, "',' and a size in " + type.name + "<...>")) return false;
    const std::size_t first = position_;
    const ast::ExpressionPtr size = ParseBinary(1);
    if (!size) return false;
    const auto* literal = std::get_if<ast::IntLiteral>(&size->node);
    if (!literal || literal->value < 1 || literal->value > 4) {
      const std::string found = TextOf(first, position_);
      Report(size->range, "the size of a " + type.name + " is a number from 1 to 4, not '" + found + "'", "X3052");
      return false;
    }
    *sizes[i] = static_cast<std::uint8_t>(literal->value);
  }
  return ExpectClosingAngle(opening);
}

// Goes on as if the type were known: its users then stay silent.
bool Parser::ReportUnknownType(ast::TypeName& type) {
  std::vector<std::string> names = names_.TypeNames();
  std::ranges::move(BuiltinTypeNames(), std::back_inserter(names));
  std::string text = "unknown type '" + type.name + "'";
  std::string near(HlslWordFor(type.name));
  if (near.empty()) near = NearestName(type.name, names);
  if (!near.empty()) text += "; did you mean '" + near + "'?";
  Report(type.range, text);
  type.type.kind = TypeKind::kError;
  return false;
}

bool Parser::DefaultRowMajor() const {
  const auto after = std::ranges::upper_bound(stream_.pack_matrix, position_, {}, &TokenStream::PackMatrix::from);
  return after != stream_.pack_matrix.begin() && std::prev(after)->row_major;
}

}  // namespace burin::fx
