// SPDX-License-Identifier: Apache-2.0
// A loop: each turn adds a ring, whose number LoopGetIndex gives.
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

float Rings < string UIName = "Rings"; float UIMin = 0; float UIMax = 16; > = 4;
float Turn < string UIWidget = "None"; >;
bool bReset : FXCOMPOSER_RESETPULSE;

float4 CopyPS(QuadVertexOutput IN) : COLOR { return tex2D(gSceneSampler, IN.UV); }
float4 RingPS(QuadVertexOutput IN) : COLOR
{
    float radius = length((IN.UV - 0.5) * float2(gScreenSize.x / gScreenSize.y, 1));
    float ring = smoothstep(0.015, 0, abs(radius - 0.1 * (Turn + 1)));
    return float4(1, 0.8, 0.2, ring);
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
        "LoopByCount=bReset;" "Pass=Copy;" "LoopEnd=;" "LoopByCount=Rings;" "LoopGetIndex=Turn;" "Pass=Ring;" "LoopEnd=;";
> {
    pass Copy < string Script = "RenderColorTarget0=; Draw=Buffer;"; > {
        ZEnable = false; CullMode = None;
        VertexShader = compile vs_2_0 ScreenQuadVS();
        PixelShader = compile ps_2_0 CopyPS();
    }
    pass Ring < string Script = "RenderColorTarget0=; Draw=Buffer;"; > {
        ZEnable = false; CullMode = None;
        AlphaBlendEnable = true; SrcBlend = SrcAlpha; DestBlend = InvSrcAlpha;
        VertexShader = compile vs_2_0 ScreenQuadVS();
        PixelShader = compile ps_2_0 RingPS();
    }
}
