// SPDX-License-Identifier: Apache-2.0
// Numbers: learn.microsoft.com, D3DRENDERSTATETYPE and the enumerations it names, D3DSAMPLERSTATETYPE,
// D3DTEXTUREFILTERTYPE, D3DTEXTUREADDRESS; "Effect States (Direct3D 9)". Cg's names of the same values stand beside
// them.
#include "fx_parser/effect/state_table.h"

#include <algorithm>
#include <array>

#include "fx_parser/effect/case.h"

namespace burin::fx {
namespace {

constexpr Enumerant kNoValues[] = {{"none", 0}};
constexpr Enumerant kZBuffer[] = {{"usew", 2}, {"none", 0}};
constexpr Enumerant kCompare[] = {{"never", 1},  {"less", 2},    {"equal", 3},    {"lessequal", 4},
                                  {"lequal", 4}, {"greater", 5}, {"notequal", 6}, {"greaterequal", 7},
                                  {"gequal", 7}, {"always", 8}};
constexpr Enumerant kCull[] = {{"none", 1}, {"cw", 2}, {"ccw", 3}};
constexpr Enumerant kFill[] = {{"point", 1}, {"wireframe", 2}, {"solid", 3}};
constexpr Enumerant kBlend[] = {{"zero", 1},
                                {"one", 2},
                                {"srccolor", 3},
                                {"invsrccolor", 4},
                                {"srcalpha", 5},
                                {"invsrcalpha", 6},
                                {"destalpha", 7},
                                {"invdestalpha", 8},
                                {"destcolor", 9},
                                {"invdestcolor", 10},
                                {"srcalphasat", 11},
                                {"bothsrcalpha", 12},
                                {"bothinvsrcalpha", 13},
                                {"blendfactor", 14},
                                {"invblendfactor", 15},
                                {"oneminussrcalpha", 6},
                                {"oneminussrccolor", 4},
                                {"oneminusdestcolor", 10},
                                {"oneminusdestalpha", 8},
                                {"dstalpha", 7},
                                {"dstcolor", 9},
                                {"invdstalpha", 8},
                                {"invdstcolor", 10},
                                {"srcalphasaturate", 11},
                                {"constantcolor", 14},
                                {"oneminusconstantcolor", 15},
                                {"oneminusdstcolor", 10},
                                {"oneminusdstalpha", 8}};
constexpr Enumerant kBlendOps[] = {{"add", 1}, {"subtract", 2}, {"revsubtract", 3},  {"min", 4},
                                   {"max", 5}, {"funcadd", 1},  {"funcsubtract", 2}, {"funcreversesubtract", 3}};
constexpr Enumerant kStencilOp[] = {{"keep", 1},    {"zero", 2},   {"replace", 3}, {"incrsat", 4},
                                    {"decrsat", 5}, {"invert", 6}, {"incr", 7},    {"decr", 8}};
constexpr Enumerant kChannels[] = {{"red", 1}, {"green", 2}, {"blue", 4}, {"alpha", 8}, {"none", 0}, {"all", 15}};

using enum RenderState;
using RS = StateInfo<RenderState>;
constexpr StateKind kI = StateKind::kInteger;
constexpr StateKind kF = StateKind::kFloat;
constexpr RS kRenderStates[] = {
    {"ZEnable", kZEnable, kI, kZBuffer},
    {"ZWriteEnable", kZWriteEnable, kI, kNoValues},
    {"ZFunc", kZFunc, kI, kCompare},
    {"CullMode", kCullMode, kI, kCull},
    {"FillMode", kFillMode, kI, kFill},
    {"AlphaTestEnable", kAlphaTestEnable, kI, kNoValues},
    {"AlphaFunc", kAlphaFunc, kI, kCompare},
    {"AlphaRef", kAlphaRef, kI, kNoValues},
    {"AlphaBlendEnable", kAlphaBlendEnable, kI, kNoValues},
    {"SrcBlend", kSrcBlend, kI, kBlend},
    {"DestBlend", kDestBlend, kI, kBlend},
    {"BlendOp", kBlendOp, kI, kBlendOps},
    {"SeparateAlphaBlendEnable", kSeparateAlphaBlendEnable, kI, kNoValues},
    {"SrcBlendAlpha", kSrcBlendAlpha, kI, kBlend},
    {"DestBlendAlpha", kDestBlendAlpha, kI, kBlend},
    {"BlendOpAlpha", kBlendOpAlpha, kI, kBlendOps},
    {"BlendFactor", kBlendFactor, StateKind::kColor, kNoValues},
    {"StencilEnable", kStencilEnable, kI, kNoValues},
    {"StencilFunc", kStencilFunc, kI, kCompare},
    {"StencilRef", kStencilRef, kI, kNoValues},
    {"StencilMask", kStencilMask, kI, kNoValues},
    {"StencilWriteMask", kStencilWriteMask, kI, kNoValues},
    {"StencilFail", kStencilFail, kI, kStencilOp},
    {"StencilZFail", kStencilZFail, kI, kStencilOp},
    {"StencilPass", kStencilPass, kI, kStencilOp},
    {"TwoSidedStencilMode", kTwoSidedStencilMode, kI, kNoValues},
    {"CCW_StencilFail", kCcwStencilFail, kI, kStencilOp},
    {"CCW_StencilZFail", kCcwStencilZFail, kI, kStencilOp},
    {"CCW_StencilPass", kCcwStencilPass, kI, kStencilOp},
    {"CCW_StencilFunc", kCcwStencilFunc, kI, kCompare},
    {"ColorWriteEnable", kColorWriteEnable, kI, kChannels},
    {"ColorWriteEnable0", kColorWriteEnable, kI, kChannels},
    {"ColorWriteEnable1", kColorWriteEnable1, kI, kChannels},
    {"ColorWriteEnable2", kColorWriteEnable2, kI, kChannels},
    {"ColorWriteEnable3", kColorWriteEnable3, kI, kChannels},
    {"ScissorTestEnable", kScissorTestEnable, kI, kNoValues},
    {"DepthBias", kDepthBias, kF, kNoValues},
    {"SlopeScaleDepthBias", kSlopeScaleDepthBias, kF, kNoValues},
    {"SRGBWriteEnable", kSrgbWriteEnable, kI, kNoValues},
    // Cg's names of the same states.
    {"DepthTestEnable", kZEnable, kI, kNoValues},
    {"DepthMask", kZWriteEnable, kI, kNoValues},
    {"DepthFunc", kZFunc, kI, kCompare},
    {"BlendEnable", kAlphaBlendEnable, kI, kNoValues},
    {"StencilTestEnable", kStencilEnable, kI, kNoValues},
};

constexpr Enumerant kFilter[] = {{"none", 0},
                                 {"point", 1},
                                 {"nearest", 1},
                                 {"linear", 2},
                                 {"anisotropic", 3},
                                 {"pyramidalquad", 6},
                                 {"gaussianquad", 7},
                                 {"nearestmipmapnearest", 1},
                                 {"nearestmipmaplinear", 1},
                                 {"linearmipmapnearest", 2},
                                 {"linearmipmaplinear", 2}};
constexpr Enumerant kAddress[] = {{"wrap", 1},           {"mirror", 2},      {"clamp", 3},
                                  {"border", 4},         {"mirroronce", 5},  {"repeat", 1},
                                  {"mirroredrepeat", 2}, {"clamptoedge", 3}, {"clamptoborder", 4}};
using SS = StateInfo<SamplerStateName>;
using Sampling = SamplerStateName;
constexpr SS kSamplerStates[] = {
    {"AddressU", Sampling::kAddressU, kI, kAddress},
    {"AddressV", Sampling::kAddressV, kI, kAddress},
    {"AddressW", Sampling::kAddressW, kI, kAddress},
    {"WrapS", Sampling::kAddressU, kI, kAddress},
    {"WrapT", Sampling::kAddressV, kI, kAddress},
    {"WrapR", Sampling::kAddressW, kI, kAddress},
    {"BorderColor", Sampling::kBorderColor, StateKind::kColor, kNoValues},
    {"MagFilter", Sampling::kMagFilter, kI, kFilter},
    {"MinFilter", Sampling::kMinFilter, kI, kFilter},
    {"MipFilter", Sampling::kMipFilter, kI, kFilter},
    {"MipMapLodBias", Sampling::kMipMapLodBias, kF, kNoValues},
    {"MipLODBias", Sampling::kMipMapLodBias, kF, kNoValues},
    {"LODBias", Sampling::kMipMapLodBias, kF, kNoValues},
    {"MaxMipLevel", Sampling::kMaxMipLevel, kI, kNoValues},
    {"MaxAnisotropy", Sampling::kMaxAnisotropy, kI, kNoValues},
    {"SRGBTexture", Sampling::kSrgbTexture, kI, kNoValues},
};

constexpr std::string_view kHarmlessSamplerStates[] = {"generatemipmap", "minmiplevel",  "minlod",
                                                       "maxlod",         "elementindex", "dmapoffset",
                                                       "comparefunc",    "comparemode",  "depthmode"};

constexpr std::string_view kHarmless[] = {
    "shademode", "lastpixel", "ditherenable", "fogenable", "fogcolor", "fogtablemode", "fogstart", "fogend",
    "fogdensity", "fogvertexmode", "rangefogenable", "wrap0", "wrap1", "wrap2", "wrap3", "wrap4", "wrap5", "wrap6",
    "wrap7", "clipping", "clipplaneenable", "pointsize", "pointsize_min", "pointsize_max", "pointspriteenable",
    "pointscaleenable", "pointscale_a", "pointscale_b", "pointscale_c", "multisampleantialias", "multisamplemask",
    "patchedgestyle", "patchsegments", "debugmonitortoken", "indexedvertexblendenable", "antialiasedlineenable",
    "mintessellationlevel", "maxtessellationlevel", "adaptivetess_x", "adaptivetess_y", "adaptivetess_z",
    "adaptivetess_w", "enableadaptivetessellation", "positiondegree", "normaldegree", "npatchmode", "tweenfactor",
    "texturefactor", "fvf",
    // the Xbox 360's
    "histencilenable", "histencilwriteenable", "histencilfunc", "histencilref", "hizenable", "hizwriteenable",
    "alphatomaskenable", "alphatomaskoffsets", "halfpixeloffset", "highprecisionblendenable",
    "highprecisionblendenable0", "highprecisionblendenable1", "highprecisionblendenable2", "highprecisionblendenable3",
    "presentinterval", "presentimmediatethreshold", "primitiveresetenable", "primitiveresetindex", "viewportenable",
    // CgFX's
    "clearcolor", "cleardepth", "clearstencil", "linewidth", "linesmoothenable", "linestippleenable",
    "pointsmoothenable", "pointspritecoordreplace", "polygonsmoothenable", "polygonstippleenable",
    "polygonoffsetfillenable", "polygonoffsetlineenable", "polygonoffsetpointenable", "multisampleenable",
    "samplealphatocoverageenable", "lightingenable", "lightmodelambient", "lightmodeltwosideenable",
    "colormaterialenable", "normalizeenable", "rescalenormalenable", "autonormalenable", "shademodel", "fogmode",
    "fogcoordsrc", "depthrange", "depthbounds", "depthboundsenable", "depthclampenable", "logicopenable",
    "texture1denable", "texture2denable", "texture3denable", "texturecubemapenable", "texturerectangleenable",
    "vertexprogramtwosideenable", "vertexprogrampointsizeenable", "colorlogicopenable", "colormaterial", "colormatrix",
    "colortransform", "logicop", "linestipple", "fogdistancemode", "lightmodelcolorcontrol",
    "lightmodellocalviewerenable", "pointdistanceattenuation", "pointfadethresholdsize", "pointsizemin", "pointsizemax",
    "pointspritecoordorigin", "pointspritermode", "samplealphatooneenable", "samplecoverageenable", "scissor",
    "scissortest", "stencilfuncseparate", "stencilmaskseparate", "stencilopseparate", "stenciltesttwosideenable",
    "clipplane", "texgenqenable", "texgenrenable", "texgensenable", "texgentenable"};
constexpr std::string_view kFixedVertex[] = {
    "lighting", "ambient", "specularenable", "normalizenormals", "localviewer", "colorvertex", "vertexblend",
    "diffusematerialsource", "specularmaterialsource", "ambientmaterialsource", "emissivematerialsource",
    "materialambient", "materialdiffuse", "materialemissive", "materialpower", "materialspecular", "lighttype",
    "lightdiffuse", "lightspecular", "lightambient", "lightposition", "lightdirection", "lightrange", "lightfalloff",
    "lightattenuation0", "lightattenuation1", "lightattenuation2", "lighttheta", "lightphi", "lightenable",
    "worldtransform", "viewtransform", "projectiontransform", "texturetransform", "vertexshaderconstant",
    "vertexshaderconstantf", "vertexshaderconstantb", "vertexshaderconstanti", "vertexshaderconstant1",
    "vertexshaderconstant2", "vertexshaderconstant3", "vertexshaderconstant4",
    // CgFX's
    "materialemission", "materialshininess", "lightconstantattenuation", "lightlinearattenuation",
    "lightquadraticattenuation", "lightspotcutoff", "lightspotdirection", "lightspotexponent", "modelviewmatrix",
    "modelviewtransform", "projectionmatrix", "texturematrix", "vertexenvparameter", "vertexlocalparameter"};
constexpr std::string_view kFixedPixel[] = {
    "colorop", "colorarg0", "colorarg1", "colorarg2", "alphaop", "alphaarg0", "alphaarg1", "alphaarg2", "resultarg",
    "bumpenvmat00", "bumpenvmat01", "bumpenvmat10", "bumpenvmat11", "bumpenvlscale", "bumpenvloffset", "texcoordindex",
    "texturetransformflags", "texture", "sampler", "minfilter", "magfilter", "mipfilter", "addressu", "addressv",
    "addressw", "bordercolor", "maxanisotropy", "maxmiplevel", "mipmaplodbias", "srgbtexture", "elementindex",
    "dmapoffset", "pixelshaderconstant", "pixelshaderconstantf", "pixelshaderconstantb", "pixelshaderconstanti",
    "pixelshaderconstant1", "pixelshaderconstant2", "pixelshaderconstant3", "pixelshaderconstant4", "constant",
    "texturestage",
    // CgFX's
    "texture1d", "texture2d", "texture3d", "texturecubemap", "texturerectangle", "textureenvcolor", "textureenvmode",
    "texgenqmode", "texgenrmode", "texgensmode", "texgentmode", "texgenqeyeplane", "texgenreyeplane", "texgenseyeplane",
    "texgenteyeplane", "texgenqobjectplane", "texgenrobjectplane", "texgensobjectplane", "texgentobjectplane",
    "fragmentenvparameter", "fragmentlocalparameter"};
constexpr std::string_view kOtherStages[] = {"geometryshader",
                                             "geometryprogram",
                                             "hullshader",
                                             "domainshader",
                                             "computeshader",
                                             "tessellationcontrolprogram",
                                             "tessellationevaluationprogram"};

template <class Table>
bool Contains(const Table& table, std::string_view name) {
  return std::any_of(std::begin(table), std::end(table),
                     [&](std::string_view entry) { return EqualsIgnoringCase(entry, name); });
}

}  // namespace

std::span<const StateInfo<RenderState>> RenderStates() { return kRenderStates; }
std::span<const StateInfo<SamplerStateName>> SamplerStates() { return kSamplerStates; }

template <class NameType>
const StateInfo<NameType>* FindState(std::span<const StateInfo<NameType>> table, std::string_view name) {
  for (const auto& info : table) {
    if (EqualsIgnoringCase(info.name, name)) return &info;
  }
  return nullptr;
}
template const StateInfo<RenderState>* FindState(std::span<const StateInfo<RenderState>>, std::string_view);
template const StateInfo<SamplerStateName>* FindState(std::span<const StateInfo<SamplerStateName>>, std::string_view);

std::optional<int> FindEnumerant(std::span<const Enumerant> values, std::string_view name) {
  if (EqualsIgnoringCase(name, "true")) return 1;
  if (EqualsIgnoringCase(name, "false")) return 0;
  for (const Enumerant& value : values) {
    if (EqualsIgnoringCase(value.name, name)) return value.value;
  }
  return std::nullopt;
}

OtherState Classify(std::string_view name) {
  if (Contains(kHarmless, name)) return OtherState::kHarmless;
  if (Contains(kFixedVertex, name)) return OtherState::kFixedVertex;
  if (Contains(kFixedPixel, name)) return OtherState::kFixedPixel;
  if (Contains(kOtherStages, name)) return OtherState::kOtherStage;
  return OtherState::kUnknown;
}

std::vector<std::string> KnownPassStates() {
  std::vector<std::string> names = {"VertexShader", "PixelShader"};
  for (const auto& info : kRenderStates) names.emplace_back(info.name);
  return names;
}

std::vector<std::string> KnownSamplerStates() {
  std::vector<std::string> names = {"Texture"};
  for (const auto& info : kSamplerStates) names.emplace_back(info.name);
  return names;
}

bool IsHarmlessSamplerState(std::string_view name) { return Contains(kHarmlessSamplerStates, name); }

}  // namespace burin::fx
