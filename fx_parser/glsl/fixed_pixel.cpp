// SPDX-License-Identifier: Apache-2.0
// The cascade of texture stages: Direct3D 9 documentation, D3DTEXTUREOP and D3DTA. Every stage's result is clamped to
// 0..1, as its devices did.
#include <algorithm>

#include "fx_parser/effect/fixed_function.h"
#include "fx_parser/glsl/fixed_pipeline.h"
#include "fx_parser/glsl/interface.h"

namespace burin::fx {
namespace {

enum Operation {
  kDisable = 1,
  kSelectArg1,
  kSelectArg2,
  kModulate,
  kModulate2x,
  kModulate4x,
  kAdd,
  kAddSigned,
  kAddSigned2x,
  kSubtract,
  kAddSmooth,
  kBlendDiffuseAlpha,
  kBlendTextureAlpha,
  kBlendFactorAlpha,
  kBlendTextureAlphaPm,
  kBlendCurrentAlpha,
  kPremodulate,
  kModulateAlphaAddColor,
  kModulateColorAddAlpha,
  kModulateInvAlphaAddColor,
  kModulateInvColorAddAlpha,
  kBumpEnvMap,
  kBumpEnvMapLuminance,
  kDotProduct3,
  kMultiplyAdd,
  kLerp
};

enum Argument { kDiffuse, kCurrent, kTexture, kFactor, kSpecular, kTemp, kConstant };
constexpr int kArgumentMask = 15;
constexpr int kComplement = 16;
constexpr int kAlphaReplicate = 32;

std::string Slot(int slot) { return std::string(kUniformFixed) + "[" + std::to_string(slot) + "]"; }

std::string Texture(std::size_t stage) { return "texel" + std::to_string(stage); }

/// A vec4.
std::string ArgumentText(int argument, std::size_t stage) {
  std::string text;
  switch (argument & kArgumentMask) {
    case kDiffuse:
      text = "burin_v_COLOR0";
      break;
    case kTexture:
      text = Texture(stage);
      break;
    case kFactor:
      text = Slot(kSlotTextureFactor);
      break;
    case kSpecular:
      text = "burin_v_COLOR1";
      break;
    case kTemp:
      text = "temporary";
      break;
    case kConstant:
      text = Slot(kSlotConstants + static_cast<int>(stage));
      break;
    default:
      text = "current";
      break;
  }
  if ((argument & kAlphaReplicate) != 0) text += ".aaaa";
  return (argument & kComplement) != 0 ? "(1.0 - " + text + ")" : text;
}

/// A vec4 of which the colour or the alpha is used.
std::string OperationText(int operation, const std::array<int, 3>& arguments, std::size_t stage) {
  const std::string a0 = ArgumentText(arguments[0], stage);
  const std::string a1 = ArgumentText(arguments[1], stage);
  const std::string a2 = ArgumentText(arguments[2], stage);
  const auto blend = [&](const std::string& alpha) { return "mix(" + a2 + ", " + a1 + ", " + alpha + ")"; };
  switch (operation) {
    case kSelectArg1:
      return a1;
    case kSelectArg2:
      return a2;
    case kModulate:
      return a1 + " * " + a2;
    case kModulate2x:
      return a1 + " * " + a2 + " * 2.0";
    case kModulate4x:
      return a1 + " * " + a2 + " * 4.0";
    case kAdd:
      return a1 + " + " + a2;
    case kAddSigned:
      return a1 + " + " + a2 + " - 0.5";
    case kAddSigned2x:
      return "(" + a1 + " + " + a2 + " - 0.5) * 2.0";
    case kSubtract:
      return a1 + " - " + a2;
    case kAddSmooth:
      return a1 + " + " + a2 + " - " + a1 + " * " + a2;
    case kBlendDiffuseAlpha:
      return blend("burin_v_COLOR0.a");
    case kBlendTextureAlpha:
      return blend(Texture(stage) + ".a");
    case kBlendFactorAlpha:
      return blend(Slot(kSlotTextureFactor) + ".a");
    case kBlendTextureAlphaPm:
      return a1 + " + " + a2 + " * (1.0 - " + Texture(stage) + ".a)";
    case kBlendCurrentAlpha:
      return blend("current.a");
    case kModulateAlphaAddColor:
      return a1 + " + " + a1 + ".a * " + a2;
    case kModulateColorAddAlpha:
      return a1 + " * " + a2 + " + " + a1 + ".a";
    case kModulateInvAlphaAddColor:
      return "(1.0 - " + a1 + ".a) * " + a2 + " + " + a1;
    case kModulateInvColorAddAlpha:
      return "(1.0 - " + a1 + ") * " + a2 + " + " + a1 + ".a";
    case kDotProduct3:
      return "vec4(4.0 * dot(" + a1 + ".rgb - 0.5, " + a2 + ".rgb - 0.5))";
    case kMultiplyAdd:
      return a0 + " + " + a1 + " * " + a2;
    case kLerp:
      return "mix(" + a2 + ", " + a1 + ", " + a0 + ")";
    case kPremodulate:
      return a1;
    default:
      return "current";
  }
}

void Read(std::vector<Semantic>& varyings, const Semantic& varying) {
  if (std::find(varyings.begin(), varyings.end(), varying) == varyings.end()) varyings.push_back(varying);
}

bool Uses(const FixedStage& stage, int argument) {
  const auto is = [&](int other) { return (other & kArgumentMask) == argument; };
  return std::any_of(stage.color_args.begin(), stage.color_args.end(), is) ||
         std::any_of(stage.alpha_args.begin(), stage.alpha_args.end(), is);
}

std::string LookUp(const FixedStage& stage, const std::string& coordinates) {
  const std::string c = stage.is_projected
                            ? "(" + coordinates + " / " + coordinates + (stage.transform_count == 3 ? ".z)" : ".w)")
                            : coordinates;
  switch (stage.dimension) {
    case Dimension::k1D:
      return "texture(" + stage.sampler + ", " + c + ".x)";
    case Dimension::k3D:
    case Dimension::kCube:
      return "texture(" + stage.sampler + ", " + c + ".xyz)";
    default:
      return "texture(" + stage.sampler + ", " + c + ".xy)";
  }
}

}  // namespace

std::string FixedPixelText(const FixedPipeline& pipeline, std::vector<Semantic>& varyings) {
  Read(varyings, {"COLOR", 0});
  bool reads_specular = pipeline.specular;
  for (const FixedStage& stage : pipeline.stages) reads_specular |= Uses(stage, kSpecular);
  if (reads_specular) Read(varyings, {"COLOR", 1});
  std::string main = "  vec4 current = burin_v_COLOR0;\n  vec4 temporary = vec4(0.0);\n";
  for (std::size_t i = 0; i < pipeline.stages.size(); ++i) {
    const FixedStage& stage = pipeline.stages[i];
    if (!stage.sampler.empty()) {
      const Semantic coordinates{"TEXCOORD", static_cast<int>(i)};
      Read(varyings, coordinates);
      main += "  vec4 " + Texture(i) + " = " + LookUp(stage, "burin_v_" + coordinates.Key()) + ";\n";
    } else {
      main += "  vec4 " + Texture(i) + " = vec4(1.0);\n";
    }
    const std::string color = OperationText(stage.color_op, stage.color_args, i);
    const std::string alpha =
        stage.color_op == kDotProduct3
            ? color
            : (stage.alpha_op == kDisable ? "current" : OperationText(stage.alpha_op, stage.alpha_args, i));
    const std::string target = stage.result == kTemp ? "temporary" : "current";
    main += "  " + target + " = clamp(vec4((" + color + ").rgb, (" + alpha + ").a), 0.0, 1.0);\n";
  }
  if (pipeline.specular) main += "  current.rgb += burin_v_COLOR1.rgb;\n";
  return main + "  burin_out0 = current;\n";
}

std::string FixedPixelDeclarations(const FixedPipeline& pipeline) {
  std::string text = "uniform vec4 " + std::string(kUniformFixed) + "[" + std::to_string(int{kFixedSlots}) + "];\n";
  for (const FixedStage& stage : pipeline.stages) {
    if (stage.sampler.empty()) continue;
    const char* type = stage.dimension == Dimension::k1D     ? "sampler1D"
                       : stage.dimension == Dimension::k3D   ? "sampler3D"
                       : stage.dimension == Dimension::kCube ? "samplerCube"
                                                             : "sampler2D";
    text += std::string("uniform ") + type + " " + stage.sampler + ";\n";
  }
  return text;
}

}  // namespace burin::fx
