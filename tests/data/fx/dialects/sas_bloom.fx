// SPDX-License-Identifier: Apache-2.0
// Targets of half the size in floats, blurred in two directions.
float Script : STANDARDSGLOBAL <
    string UIWidget = "none";
    string ScriptClass = "scene";
    string ScriptOrder = "postprocess";
    string ScriptOutput = "color";
    string Script = "Technique=Main;";
> = 0.8;

float4 gClearColor < string UIWidget = "Color"; > = { 0.1, 0.1, 0.2, 1.0 };
float gClearDepth < string UIWidget = "none"; > = 1.0;

texture gSceneTexture : RENDERCOLORTARGET <
    float2 ViewPortRatio = { 1.0, 1.0 };
    int MipLevels = 1;
    string Format = "X8R8G8B8";
    string UIWidget = "None";
>;
sampler2D gSceneSampler = sampler_state {
    texture = <gSceneTexture>;
    AddressU = Clamp;
    AddressV = Clamp;
    MagFilter = Linear;
    MinFilter = Linear;
    MipFilter = Point;
};
texture DepthBuffer : RENDERDEPTHSTENCILTARGET <
    float2 ViewPortRatio = { 1.0, 1.0 };
    string Format = "D24S8";
    string UIWidget = "None";
>;
float2 gScreenSize : VIEWPORTPIXELSIZE < string UIWidget = "None"; >;

struct QuadVertexOutput {
    float4 Position : POSITION;
    float2 UV : TEXCOORD0;
};

QuadVertexOutput ScreenQuadVS(float3 Position : POSITION, float3 TexCoord : TEXCOORD0)
{
    QuadVertexOutput OUT;
    OUT.Position = float4(Position, 1);
    OUT.UV = TexCoord.xy + 0.5 / gScreenSize;   // Direct3D 9's half texel
    return OUT;
}

#define HALF_TARGET(name) texture name : RENDERCOLORTARGET < float2 ViewPortRatio = { 0.5, 0.5 }; \
        string Format = "A16B16G16R16F"; string UIWidget = "None"; >; \
    sampler2D name##Sampler = sampler_state { texture = <name>; AddressU = Clamp; AddressV = Clamp; \
        MinFilter = Linear; MagFilter = Linear; MipFilter = None; }
HALF_TARGET(Across);
HALF_TARGET(Both);

float Glow < string UIName = "Glow"; string UIWidget = "slider"; float UIMin = 0; float UIMax = 2; > = 0.9;
static const float kWeights[5] = { 0.30, 0.22, 0.14, 0.06, 0.03 };

float4 BlurPS(QuadVertexOutput IN, uniform sampler2D Source, uniform float2 Direction) : COLOR
{
    float2 texel = Direction * 2 / gScreenSize;
    float4 sum = kWeights[0] * tex2D(Source, IN.UV);
    for (int i = 1; i < 5; i++)
        sum += kWeights[i] * (tex2D(Source, IN.UV + i * texel) + tex2D(Source, IN.UV - i * texel));
    return sum;
}
float4 BrightPS(QuadVertexOutput IN) : COLOR
{
    return tex2D(gSceneSampler, IN.UV) + Glow * max(0, tex2D(BothSampler, IN.UV) - 0.3);
}

technique Main <
    string Script =
        "RenderColorTarget0=gSceneTexture;"
        "RenderDepthStencilTarget=DepthBuffer;"
        "ClearSetColor=gClearColor;"
        "ClearSetDepth=gClearDepth;"
        "Clear=Color;"
        "Clear=Depth;"
        "ScriptExternal=color;"
        "Pass=Horizontal;" "Pass=Vertical;" "Pass=Final;";
> {
    pass Horizontal < string Script = "RenderColorTarget0=Across;" "RenderDepthStencilTarget=;" "Draw=Buffer;"; > {
        ZEnable = false; CullMode = None;
        VertexShader = compile vs_2_0 ScreenQuadVS();
        PixelShader = compile ps_2_0 BlurPS(gSceneSampler, float2(1, 0));
    }
    pass Vertical < string Script = "RenderColorTarget0=Both; Draw=Buffer;"; > {
        ZEnable = false; CullMode = None;
        VertexShader = compile vs_2_0 ScreenQuadVS();
        PixelShader = compile ps_2_0 BlurPS(AcrossSampler, float2(0, 1));
    }
    pass Final < string Script = "RenderColorTarget0=;;Draw=Buffer"; > {
        ZEnable = false; CullMode = None;
        VertexShader = compile vs_2_0 ScreenQuadVS();
        PixelShader = compile ps_2_0 BrightPS();
    }
}
