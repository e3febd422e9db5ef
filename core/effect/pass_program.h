// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/effect/parameter_values.h"
#include "core/gl/program.h"
#include "fx_parser/effect/effect.h"

namespace burin::effect {

/// The host's own uniforms (fx_parser/glsl/interface.h).
struct HostUniforms {
  std::array<float, 4> pixel_offset{0, 0, 0, 0};
  std::array<float, 2> alpha_test{8, 0};
  std::array<float, 4> target_size{1, 1, 1, 1};
};

/// One pass's program with the places of its parameters, found once.
class PassProgram {
 public:
  [[nodiscard]] static Result<PassProgram> Create(const fx::Effect& effect, const fx::ShaderProgram& shaders,
                                                  const std::string& label);
  /// Makes it current and uploads the parameters that changed since its last use.
  void Use(const ParameterValues& values, const HostUniforms& host);
  /// Of a program that fills a texture, while it is current: fx::kUniformTexel.
  void SetTexel(const std::array<float, 4>& texel);
  /// fx::kUniformFixed, while it is current: FixedValues().
  void SetFixed(const std::vector<float>& numbers);
  [[nodiscard]] bool has_fixed() const { return fixed_ >= 0; }
  /// Between draws: uploads what changed.
  void UpdateParameters(const ParameterValues& values);

 private:
  struct Leaf {
    int location = -1;
    fx::Scalar scalar = fx::Scalar::kFloat;
    int rows = 1, columns = 1;
    bool is_matrix = false;
    int count = 1;           ///< array elements
    std::size_t offset = 0;  ///< in Value::numbers
  };
  struct Uniform {
    std::size_t parameter = 0;
    std::uint64_t version = 0;
    std::vector<Leaf> leaves;
  };
  void AddLeaves(const fx::Type& type, const std::string& name, std::size_t& offset, std::vector<Leaf>& leaves) const;
  void Upload(const Leaf& leaf, const std::vector<double>& numbers);

  gl::Program program_;
  std::vector<Uniform> uniforms_;
  int pixel_offset_ = -1;
  int alpha_test_ = -1;
  int target_size_ = -1;
  int texel_ = -1;
  int fixed_ = -1;
  std::vector<float> floats_;
  std::vector<std::int32_t> ints_;
};

}  // namespace burin::effect
