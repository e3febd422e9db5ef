// SPDX-License-Identifier: Apache-2.0
// A postprocess effect with one pass.
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

float4 InvertPS(QuadVertexOutput IN) : COLOR { return float4(1 - tex2D(gSceneSampler, IN.UV).rgb, 1); }

technique Main <
    string Script =
        "RenderColorTarget0=gSceneTexture;"
        "RenderDepthStencilTarget=DepthBuffer;"
        "ClearSetColor=gClearColor;"
        "ClearSetDepth=gClearDepth;"
        "Clear=Color;"
        "Clear=Depth;"
        "ScriptExternal=color;"
        "Pass=p0;";
> {
    pass p0 < string Script = "RenderColorTarget0=;" "RenderDepthStencilTarget=;" "Draw=Buffer;"; > {
        VertexShader = compile vs_2_0 ScreenQuadVS();
        PixelShader = compile ps_2_0 InvertPS();
        ZEnable = false;
        ZWriteEnable = false;
        CullMode = None;
        AlphaBlendEnable = false;
    }
}
