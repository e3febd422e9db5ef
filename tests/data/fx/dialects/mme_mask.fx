// SPDX-License-Identifier: Apache-2.0
// A post-process over an offscreen target in which another effect draws the scene.
float Script : STANDARDSGLOBAL <
    string ScriptOutput = "color";
    string ScriptClass = "scene";
    string ScriptOrder = "postprocess";
> = 0.8;

float Strength : CONTROLOBJECT < string name = "(self)"; string item = "Tr"; >;
float2 ViewportSize : VIEWPORTPIXELSIZE;
static const float2 ViewportOffset = float2(0.5, 0.5) / ViewportSize;
float4 ClearColor = { 1, 1, 1, 0 };
float ClearDepth = 1.0;

texture MaskMap : OFFSCREENRENDERTARGET <
    string Description = "what is to be tinted";
    float2 ViewPortRatio = { 0.5, 0.5 };
    float4 ClearColor = { 0, 0, 0.4, 1 };
    float ClearDepth = 1.0;
    bool AntiAlias = true;
    string Format = "D3DFMT_A8R8G8B8";
    string DefaultEffect =
        "self = hide;"
        "*.x = none;"
        "* = mme_mask_red.fx;";
>;
sampler MaskSamp = sampler_state { texture = <MaskMap>; MinFilter = LINEAR; MagFilter = LINEAR; AddressU = CLAMP; AddressV = CLAMP; };

texture2D ScnMap : RENDERCOLORTARGET < float2 ViewPortRatio = { 1.0, 1.0 }; int MipLevels = 1; string Format = "A8R8G8B8"; >;
sampler2D ScnSamp = sampler_state { texture = <ScnMap>; MinFilter = LINEAR; MagFilter = LINEAR; AddressU = CLAMP; AddressV = CLAMP; };
texture2D DepthBuffer : RENDERDEPTHSTENCILTARGET < float2 ViewPortRatio = { 1.0, 1.0 }; string Format = "D24S8"; >;

struct V { float4 Pos : POSITION; float2 Tex : TEXCOORD0; };

V QuadVS(float4 Pos : POSITION, float2 Tex : TEXCOORD0)
{
    V o;
    o.Pos = Pos;
    o.Tex = Tex + ViewportOffset;
    return o;
}

float4 TintPS(float2 t : TEXCOORD0) : COLOR
{
    return float4(lerp(tex2D(ScnSamp, t).rgb, tex2D(MaskSamp, t).rgb, 0.5 * Strength), 1);
}

technique Tint <
    string Script =
        "RenderColorTarget0=ScnMap;"
        "RenderDepthStencilTarget=DepthBuffer;"
        "ClearSetColor=ClearColor;"
        "ClearSetDepth=ClearDepth;"
        "Clear=Color;"
        "Clear=Depth;"
        "ScriptExternal=Color;"
        "RenderColorTarget0=;"
        "RenderDepthStencilTarget=;"
        "Pass=Tint;";
>
{
    pass Tint < string Script = "Draw=Buffer;"; >
    {
        AlphaBlendEnable = FALSE;
        VertexShader = compile vs_3_0 QuadVS();
        PixelShader = compile ps_3_0 TintPS();
    }
}
