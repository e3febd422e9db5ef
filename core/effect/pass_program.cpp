// SPDX-License-Identifier: Apache-2.0
#include "core/effect/pass_program.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include "fx_parser/glsl/interface.h"

namespace burin::effect {
namespace {

std::size_t ElementCount(const std::vector<std::uint32_t>& array) {
  std::size_t count = 1;
  for (const std::uint32_t size : array) count *= size;
  return count;
}

void UploadVectors(GLuint program, GLint location, int columns, GLsizei count, const float* data) {
  switch (columns) {
    case 1:
      glProgramUniform1fv(program, location, count, data);
      break;
    case 2:
      glProgramUniform2fv(program, location, count, data);
      break;
    case 3:
      glProgramUniform3fv(program, location, count, data);
      break;
    default:
      glProgramUniform4fv(program, location, count, data);
      break;
  }
}

void UploadInts(GLuint program, GLint location, int columns, GLsizei count, const std::int32_t* data) {
  switch (columns) {
    case 1:
      glProgramUniform1iv(program, location, count, data);
      break;
    case 2:
      glProgramUniform2iv(program, location, count, data);
      break;
    case 3:
      glProgramUniform3iv(program, location, count, data);
      break;
    default:
      glProgramUniform4iv(program, location, count, data);
      break;
  }
}

void UploadUints(GLuint program, GLint location, int columns, GLsizei count, const std::uint32_t* data) {
  switch (columns) {
    case 1:
      glProgramUniform1uiv(program, location, count, data);
      break;
    case 2:
      glProgramUniform2uiv(program, location, count, data);
      break;
    case 3:
      glProgramUniform3uiv(program, location, count, data);
      break;
    default:
      glProgramUniform4uiv(program, location, count, data);
      break;
  }
}

// `rows` and `columns` are HLSL's; GLSL's matCxR holds an HLSL row in each column.
void UploadMatrices(GLuint program, GLint location, int rows, int columns, GLsizei count, const float* data) {
  const auto call = [&](auto function) { function(program, location, count, GL_FALSE, data); };
  switch (rows * 10 + columns) {
    case 22:
      call(glProgramUniformMatrix2fv);
      break;
    case 23:
      call(glProgramUniformMatrix2x3fv);
      break;
    case 24:
      call(glProgramUniformMatrix2x4fv);
      break;
    case 32:
      call(glProgramUniformMatrix3x2fv);
      break;
    case 33:
      call(glProgramUniformMatrix3fv);
      break;
    case 34:
      call(glProgramUniformMatrix3x4fv);
      break;
    case 42:
      call(glProgramUniformMatrix4x2fv);
      break;
    case 43:
      call(glProgramUniformMatrix4x3fv);
      break;
    case 44:
      call(glProgramUniformMatrix4fv);
      break;
    default:
      UploadVectors(program, location, rows * columns, count, data);
      break;  // one row or one column
  }
}

}  // namespace

Result<PassProgram> PassProgram::Create(const fx::Effect& effect, const fx::ShaderProgram& shaders,
                                        const std::string& label) {
  PassProgram result;
  auto program = gl::Program::Create(shaders.vertex_glsl, shaders.fragment_glsl, label);
  if (!program) return std::unexpected(program.error());
  result.program_ = std::move(*program);
  result.pixel_offset_ = result.program_.UniformLocation(std::string(fx::kUniformPixelOffset));
  result.alpha_test_ = result.program_.UniformLocation(std::string(fx::kUniformAlphaTest));
  result.target_size_ = result.program_.UniformLocation(std::string(fx::kUniformTargetSize));
  result.texel_ = result.program_.UniformLocation(std::string(fx::kUniformTexel));
  result.fixed_ = result.program_.UniformLocation(std::string(fx::kUniformFixed) + "[0]");
  if (result.fixed_ < 0) result.fixed_ = result.program_.UniformLocation(std::string(fx::kUniformFixed));
  for (const std::size_t index : shaders.parameters) {
    const fx::Parameter& parameter = effect.parameters[index];
    Uniform uniform{.parameter = index, .version = 0, .leaves = {}};
    std::size_t offset = 0;
    result.AddLeaves(parameter.type, "burin_p_" + parameter.name, offset, uniform.leaves);
    if (!uniform.leaves.empty()) result.uniforms_.push_back(std::move(uniform));
  }
  for (std::size_t unit = 0; unit < shaders.samplers.size(); ++unit) {
    const int location = result.program_.UniformLocation("burin_s_" + effect.samplers[shaders.samplers[unit]].name);
    if (location >= 0) glProgramUniform1i(result.program_.id(), location, static_cast<GLint>(unit));
  }
  return result;
}

void PassProgram::AddLeaves(const fx::Type& type, const std::string& name, std::size_t& offset,
                            std::vector<Leaf>& leaves) const {
  const bool is_struct = type.kind == fx::TypeKind::kStruct;
  // GL names each element of an array of structs or of arrays; an innermost array of numbers has one location.
  if (type.is_array() && (is_struct || type.array.size() > 1)) {
    fx::Type element = type;
    element.array.erase(element.array.begin());
    for (std::uint32_t i = 0; i < type.array.front(); ++i) {
      AddLeaves(element, fmt::format("{}[{}]", name, i), offset, leaves);
    }
    return;
  }
  if (is_struct) {
    if (type.structure == nullptr) return;
    for (const auto& member : type.structure->members) {
      AddLeaves(member->type, name + "." + fx::GlslMemberName(member->name), offset, leaves);
    }
    return;
  }
  if (type.kind != fx::TypeKind::kNumeric) return;
  Leaf leaf{.location = program_.UniformLocation(name),
            .scalar = type.scalar,
            .rows = type.rows,
            .columns = type.columns,
            .is_matrix = type.is_matrix,
            .count = static_cast<int>(ElementCount(type.array)),
            .offset = offset};
  if (leaf.location < 0 && type.is_array()) leaf.location = program_.UniformLocation(name + "[0]");
  offset += static_cast<std::size_t>(type.components()) * ElementCount(type.array);
  if (leaf.location >= 0) leaves.push_back(leaf);
}

void PassProgram::Use(const ParameterValues& values, const HostUniforms& host) {
  glUseProgram(program_.id());
  if (pixel_offset_ >= 0) glUniform4fv(pixel_offset_, 1, host.pixel_offset.data());
  if (alpha_test_ >= 0) glUniform2fv(alpha_test_, 1, host.alpha_test.data());
  if (target_size_ >= 0) glUniform4fv(target_size_, 1, host.target_size.data());
  UpdateParameters(values);
}

void PassProgram::SetTexel(const std::array<float, 4>& texel) {
  if (texel_ >= 0) glUniform4fv(texel_, 1, texel.data());
}

void PassProgram::SetFixed(const std::vector<float>& numbers) {
  if (fixed_ >= 0) glUniform4fv(fixed_, static_cast<GLsizei>(numbers.size() / 4), numbers.data());
}

void PassProgram::UpdateParameters(const ParameterValues& values) {
  for (Uniform& uniform : uniforms_) {
    if (uniform.version == values.version(uniform.parameter)) continue;
    uniform.version = values.version(uniform.parameter);
    for (const Leaf& leaf : uniform.leaves) Upload(leaf, values.value(uniform.parameter).numbers);
  }
}

void PassProgram::Upload(const Leaf& leaf, const std::vector<double>& numbers) {
  const std::size_t size = static_cast<std::size_t>(leaf.rows) * static_cast<std::size_t>(leaf.columns) *
                           static_cast<std::size_t>(leaf.count);
  const auto number = [&](std::size_t i) { return leaf.offset + i < numbers.size() ? numbers[leaf.offset + i] : 0.0; };
  const bool is_integer =
      leaf.scalar == fx::Scalar::kBool || leaf.scalar == fx::Scalar::kInt || leaf.scalar == fx::Scalar::kUint;
  if (is_integer && !leaf.is_matrix) {
    ints_.resize(size);
    for (std::size_t i = 0; i < size; ++i) ints_[i] = static_cast<std::int32_t>(static_cast<std::int64_t>(number(i)));
    if (leaf.scalar == fx::Scalar::kUint) {
      UploadUints(program_.id(), leaf.location, leaf.columns, leaf.count,
                  reinterpret_cast<const std::uint32_t*>(ints_.data()));
    } else {
      UploadInts(program_.id(), leaf.location, leaf.columns, leaf.count, ints_.data());
    }
    return;
  }
  floats_.resize(size);
  for (std::size_t i = 0; i < size; ++i) floats_[i] = static_cast<float>(number(i));
  if (leaf.is_matrix) {
    UploadMatrices(program_.id(), leaf.location, leaf.rows, leaf.columns, leaf.count, floats_.data());
  } else {
    UploadVectors(program_.id(), leaf.location, leaf.columns, leaf.count, floats_.data());
  }
}

}  // namespace burin::effect
