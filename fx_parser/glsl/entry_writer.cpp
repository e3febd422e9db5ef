// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/glsl/entry_writer.h"

#include <algorithm>

#include "fx_parser/glsl/interface.h"
#include "fx_parser/semantics/constant.h"
#include "fx_parser/semantics/conversion.h"

namespace burin::fx {
namespace {

bool IsSampler(const Type& type) { return type.kind == TypeKind::kSampler || type.kind == TypeKind::kTexture; }

/// Uniform parameters get the compile expression's arguments; samplers are uniform without the word.
bool IsUniform(const ast::Variable& parameter) {
  return (parameter.qualifiers & ast::kUniform) != 0 || IsSampler(parameter.type);
}

template <class List>
void AddOnce(List& list, const Semantic& semantic) {
  if (std::find(list.begin(), list.end(), semantic) == list.end()) list.push_back(semantic);
}

std::string Upper(std::string text) {
  for (char& c : text) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  return text;
}

}  // namespace

std::string EntryWriter::Missing(const char* code, const std::string& what, const Range& range) {
  stage_.Error(range, code, "'" + entry_.function->name + "': " + what + " missing semantics");
  return "0";
}

std::string EntryWriter::ToVec4(const std::string& value, const Type& type, bool alpha_one) {
  const int count = type.components();
  const Type floats = count == 1 ? ScalarType(Scalar::kFloat) : VectorType(Scalar::kFloat, count);
  const std::string text = main_.Convert(value, type, floats);
  switch (count) {
    case 1:
      return "vec4(" + text + ")";
    case 2:
      return "vec4(" + text + ", 0.0, " + (alpha_one ? "1.0)" : "0.0)");
    case 3:
      return "vec4(" + text + (alpha_one ? ", 1.0)" : ", 0.0)");
    default:
      return text;
  }
}

std::string EntryWriter::InputValue(const Type& type, const std::string& semantic, int& offset, const std::string& name,
                                    const Range& range) {
  if (type.is_array()) {
    const Type element = *ElementType(type);
    std::string text;
    for (std::uint32_t i = 0; i < type.array.front(); ++i) {
      if (stage_.failed()) return "0";
      text += (i > 0 ? ", " : "") + InputValue(element, semantic, offset, name, range);
    }
    return stage_.TypeText(type) + "(" + text + ")";
  }
  if (type.kind == TypeKind::kStruct && type.structure != nullptr) {
    std::string text;
    for (const auto& member : type.structure->members) {
      int member_offset = 0;
      const bool own = !member->semantic.empty();
      text += (text.empty() ? "" : ", ") + InputValue(member->type, own ? member->semantic : semantic,
                                                      own ? member_offset : offset, name + "." + member->name,
                                                      member->range);
    }
    return stage_.TypeText(type) + "(" + (text.empty() ? "0.0" : text) + ")";
  }
  if (!type.is_numeric()) {
    stage_.Error(range, "X3502",
                 "'" + entry_.function->name + "': input parameter '" + name + "' cannot be a " + ToString(type));
    return "0";
  }
  if (semantic.empty()) return Missing("X3502", "input parameter '" + name + "'", range);
  const Type line = type.is_matrix ? VectorType(type.scalar, type.columns) : type;
  std::vector<std::string> rows;
  for (int row = 0; row < (type.is_matrix ? type.rows : 1); ++row) {
    Semantic key = ParseSemantic(semantic);
    key.index += offset++;
    const std::string text = Input(key, semantic, range);
    rows.push_back(main_.Convert(text, VectorType(Scalar::kFloat, 4),
                                 WithScalar(line, StorageOf(type).is_matrix() ? Scalar::kFloat : type.scalar)));
  }
  if (rows.size() == 1) return rows.front();
  std::string text;
  for (const std::string& row : rows) text += (text.empty() ? "" : ", ") + row;
  return stage_.TypeText(type) + "(" + text + ")";
}

std::string EntryWriter::OutputValue(const Type& type, const std::string& semantic, int& offset,
                                     const std::string& text, const std::string& name, const Range& range) {
  std::string statements;
  if (stage_.failed()) return statements;
  if (type.is_array()) {
    const Type element = *ElementType(type);
    for (std::uint32_t i = 0; i < type.array.front(); ++i) {
      statements += OutputValue(element, semantic, offset, text + "[" + std::to_string(i) + "]", name, range);
    }
    return statements;
  }
  if (type.kind == TypeKind::kStruct && type.structure != nullptr) {
    for (const auto& member : type.structure->members) {
      int member_offset = 0;
      const bool own = !member->semantic.empty();
      statements += OutputValue(member->type, own ? member->semantic : semantic, own ? member_offset : offset,
                                text + "." + GlslMemberName(member->name), name + "." + member->name, member->range);
    }
    return statements;
  }
  if (!type.is_numeric()) return statements;
  if (semantic.empty())
    return Missing("X3503", name.empty() ? "function return value" : "output parameter '" + name + "'", range);
  const int rows = type.is_matrix && StorageOf(type).is_matrix() ? type.rows : 1;
  for (int row = 0; row < rows; ++row) {
    Semantic key = ParseSemantic(semantic);
    key.index += offset++;
    const std::string part = rows > 1 ? text + "[" + std::to_string(row) + "]" : text;
    statements += Output(key, part, rows > 1 ? VectorType(Scalar::kFloat, type.columns) : type, range);
  }
  return statements;
}

std::string EntryWriter::Write() {
  const ast::Function& function = *entry_.function;
  SamplerBindings bindings;
  std::vector<std::string> arguments;
  std::string before;
  std::string after;
  std::size_t uniforms = 0;
  struct Pending {
    const ast::Variable* parameter;
    std::string name;
  };
  std::vector<Pending> outs;
  for (const auto& parameter : function.parameters) {
    if (IsUniform(*parameter)) {
      const ast::Expression* value =
          uniforms < entry_.arguments.size() ? entry_.arguments[uniforms] : parameter->initializer.get();
      ++uniforms;
      if (value == nullptr) continue;  // counted and reported below
      if (IsSampler(parameter->type)) {
        const SamplerBinding binding = main_.ResolveSampler(*value);
        if (binding.sampler == nullptr) return {};
        bindings[parameter.get()] = binding;
      } else {
        arguments.push_back(main_.ExpressionAs(*value, parameter->type));
        // Not where the function writes to it.
        if (auto known = stage_.is_written(*parameter) ? std::nullopt : EvaluateAs(*value, parameter->type))
          stage_.SetConstant(*parameter, *std::move(known));
      }
      continue;
    }
    const bool is_out = (parameter->qualifiers & ast::kOut) != 0;
    const bool is_in = !is_out || (parameter->qualifiers & ast::kIn) != 0;
    const std::string name = stage_.UniqueName("a_", parameter->name);
    int offset = 0;
    before +=
        "  " + stage_.TypeText(parameter->type) + " " + name +
        (is_in ? " = " + InputValue(parameter->type, parameter->semantic, offset, parameter->name, parameter->range)
               : "") +
        ";\n";
    arguments.push_back(name);
    if (is_out) outs.push_back({parameter.get(), name});
  }
  if (entry_.arguments.size() > uniforms || (entry_.arguments.size() < uniforms && [&] {
        std::size_t at = 0;
        for (const auto& parameter : function.parameters) {
          if (IsUniform(*parameter) && at++ >= entry_.arguments.size() && parameter->initializer == nullptr)
            return true;
        }
        return false;
      }())) {
    stage_.Error(entry_.range, "X3013",
                 "'" + function.name + "': entry point takes " + std::to_string(uniforms) +
                     " uniform arguments, found " + std::to_string(entry_.arguments.size()));
    return {};
  }
  const std::string name = stage_.FunctionName(function, bindings, entry_.range);
  std::string list;
  for (const std::string& argument : arguments) list += (list.empty() ? "" : ", ") + argument;
  std::string call = name + "(" + list + ")";
  if (function.return_type.kind != TypeKind::kVoid) {
    const std::string result = stage_.UniqueName("a_", "result");
    call = stage_.TypeText(function.return_type) + " " + result + " = " + call;
    int offset = 0;
    after += OutputValue(function.return_type, function.semantic, offset, result, "", function.range);
  }
  for (const Pending& out : outs) {
    int offset = 0;
    after += OutputValue(out.parameter->type, out.parameter->semantic, offset, out.name, out.parameter->name,
                         out.parameter->range);
  }
  if (stage_.failed()) return {};
  return main_.Temporaries() + stage_.initialisers() + before + "  " + call + ";\n" + after;
}

std::string FragmentEntry::Input(const Semantic& semantic, const std::string& written_as, const Range&) {
  if (fills_texture && semantic.name == "POSITION") return "burin_texel_position()";
  if (fills_texture && semantic.name == "PSIZE") return std::string(kUniformTexel);
  if (semantic.name == "VPOS") return "vec4(gl_FragCoord.xy - 0.5, gl_FragCoord.zw)";
  if (semantic.name == "VFACE") return "vec4(gl_FrontFacing ? 1.0 : -1.0)";
  if (Upper(written_as).starts_with("SV_POSITION")) return "vec4(gl_FragCoord.xyz, 1.0 / gl_FragCoord.w)";
  AddOnce(varyings, semantic);
  return "burin_v_" + SanitisedName(semantic.Key());
}

std::string FragmentEntry::Output(const Semantic& semantic, const std::string& value, const Type& type,
                                  const Range& range) {
  if (semantic.name == "COLOR" && semantic.index < kMaxTargets) {
    targets.insert(semantic.index);
    return "  burin_out" + std::to_string(semantic.index) + " = " + ToVec4(value, type, true) + ";\n";
  }
  if (semantic.name == "COLOR") {
    stage_.Warning(range, "B1028",
                   "'" + entry_.function->name + "': there is no target " + std::to_string(semantic.index) +
                       ", so what goes there is lost");
    return {};
  }
  if (semantic.name == "DEPTH") {
    writes_depth = true;
    return "  gl_FragDepth = " + main_.Convert(value, type, ScalarType(Scalar::kFloat)) + ";\n";
  }
  stage_.Error(range, "X4502",
               "'" + entry_.function->name + "': invalid pixel shader output semantic '" + semantic.Key() + "'");
  return {};
}

std::string VertexEntry::Input(const Semantic& semantic, const std::string&, const Range& range) {
  if (semantic.name == "SV_VERTEXID") return "vec4(float(gl_VertexID))";
  if (semantic.name == "SV_INSTANCEID") return "vec4(float(gl_InstanceID))";
  if (!VertexInputLocation(semantic.Key())) {
    stage_.Warning(range, "B1016", "'" + semantic.Key() + "' is no vertex input of this host: it reads as 0");
    return "vec4(0.0)";
  }
  if (semantic == Semantic{"BINORMAL", 0}) {
    // No mesh brings binormals: they follow from normal and tangent, whose w is the handedness.
    AddOnce(inputs, Semantic{"NORMAL", 0});
    AddOnce(inputs, Semantic{"TANGENT", 0});
    return "vec4(cross(burin_in_NORMAL0.xyz, burin_in_TANGENT0.xyz) * burin_in_TANGENT0.w, 1.0)";
  }
  AddOnce(inputs, semantic);
  return "burin_in_" + semantic.Key();
}

std::string VertexEntry::Output(const Semantic& semantic, const std::string& value, const Type& type, const Range&) {
  std::string statements;
  if (semantic == Semantic{"POSITION", 0}) {
    writes_position = true;
    statements = "  gl_Position = " + ToVec4(value, type, true) + ";\n";
  } else if (semantic.name == "PSIZE") {
    statements = "  gl_PointSize = " + main_.Convert(value, type, ScalarType(Scalar::kFloat)) + ";\n";
  }
  if (std::find(varyings_.begin(), varyings_.end(), semantic) == varyings_.end()) return statements;
  written.insert(semantic.Key());
  const bool is_color = semantic.name == "COLOR";
  std::string text = ToVec4(value, type, is_color);
  if (is_color && entry_.shader_model < 3) text = stage_.PreludeName("burin_saturate", "vec4") + "(" + text + ")";
  return statements + "  burin_v_" + SanitisedName(semantic.Key()) + " = " + text + ";\n";
}

}  // namespace burin::fx
