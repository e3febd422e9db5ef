// SPDX-License-Identifier: Apache-2.0
#pragma once
// main() of one stage: gathers an entry point's inputs from where the pipeline has them, calls it, hands its outputs
// on.

#include <map>
#include <string>
#include <vector>

#include "fx_parser/glsl/function_writer.h"
#include "fx_parser/glsl/program.h"
#include "fx_parser/glsl/semantic.h"

namespace burin::fx {

class EntryWriter {
 public:
  EntryWriter(StageWriter& stage, const EntryPoint& entry) : stage_(stage), entry_(entry), main_(stage, {}) {}
  virtual ~EntryWriter() = default;

  /// Statements of main: inputs, the call, outputs. Empty after an error.
  std::string Write();

 protected:
  /// A vec4 expression for what one register of a semantic holds.
  virtual std::string Input(const Semantic& semantic, const std::string& written_as, const Range& range) = 0;
  /// Statements that hand `value` (of numeric type) on.
  virtual std::string Output(const Semantic& semantic, const std::string& value, const Type& type,
                             const Range& range) = 0;
  /// `value` as a vec4 with the last components from `padding` ("0.0, 0.0, 0.0, 1.0" by position).
  std::string ToVec4(const std::string& value, const Type& type, bool alpha_one);

  StageWriter& stage_;
  const EntryPoint& entry_;
  FunctionWriter main_;

 private:
  std::string InputValue(const Type& type, const std::string& semantic, int& offset, const std::string& name,
                         const Range& range);
  std::string OutputValue(const Type& type, const std::string& semantic, int& offset, const std::string& text,
                          const std::string& name, const Range& range);
  std::string Missing(const char* code, const std::string& what, const Range& range);
};

class FragmentEntry final : public EntryWriter {
 public:
  using EntryWriter::EntryWriter;
  std::vector<Semantic> varyings;  ///< read, in order of first use
  std::set<int> targets;
  bool writes_depth = false;
  bool fills_texture = false;

 private:
  std::string Input(const Semantic& semantic, const std::string& written_as, const Range& range) override;
  std::string Output(const Semantic& semantic, const std::string& value, const Type& type, const Range& range) override;
};

class VertexEntry final : public EntryWriter {
 public:
  VertexEntry(StageWriter& stage, const EntryPoint& entry, const std::vector<Semantic>& varyings)
      : EntryWriter(stage, entry), varyings_(varyings) {}
  std::vector<Semantic> inputs;
  std::set<std::string> written;  ///< varyings' keys
  bool writes_position = false;

 private:
  std::string Input(const Semantic& semantic, const std::string& written_as, const Range& range) override;
  std::string Output(const Semantic& semantic, const std::string& value, const Type& type, const Range& range) override;
  const std::vector<Semantic>& varyings_;
};

}  // namespace burin::fx
