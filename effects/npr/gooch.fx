// SPDX-License-Identifier: Apache-2.0
// Technical illustration: cool-to-warm shading after Gooch et al., highlights and black outlines.
//
// A. Gooch, B. Gooch, P. Shirley, E. Cohen, "A Non-Photorealistic Lighting Model for Automatic Technical Illustration" (1998).
// The shading is a custom attribute: technique GBAgooch draws the scene with its own shaders into the textures GBAgooch_...,
// at twice the frame's size; the technique Illustration then halves it and adds lines where objects or normals change.
//
// Parameters: CoolColor and WarmColor, and how much of the surface colour goes into each (Alpha, Beta); SurfaceColor;
// Shininess and HighlightAmount; CreaseAngle in degrees; PaperColor.

float4x4 WorldViewProj : WorldViewProjection;
float4x4 NormalMatrix : WorldInverseTranspose;
float4x4 World : World;
float3 EyePosition : CameraPosition;
float3 LightDirection : Direction < string Object = "DirectionalLight0"; string Space = "World"; > = {-0.5, -0.8, -0.4};

float3 SurfaceColor < string UIName = "Surface"; string UIWidget = "Color"; > = {0.7, 0.7, 0.7};
float3 CoolColor < string UIName = "Cool"; string UIWidget = "Color"; > = {0.0, 0.0, 0.55};
float3 WarmColor < string UIName = "Warm"; string UIWidget = "Color"; > = {0.3, 0.3, 0.0};
float Alpha < string UIName = "Surface in cool"; float UIMin = 0.0; float UIMax = 1.0; float UIStep = 0.01; > = 0.25;
float Beta < string UIName = "Surface in warm"; float UIMin = 0.0; float UIMax = 1.0; float UIStep = 0.01; > = 0.5;
float Shininess < string UIName = "Shininess"; float UIMin = 1.0; float UIMax = 200.0; float UIStep = 1.0; > = 40.0;
float HighlightAmount < string UIName = "Highlights"; float UIMin = 0.0; float UIMax = 1.0; float UIStep = 0.05; > = 0.8;
float CreaseAngle < string UIName = "Crease angle"; string units = "degrees"; float UIMin = 1.0; float UIMax = 180.0; float UIStep = 1.0; > = 40.0;
float3 PaperColor < string UIName = "Paper"; string UIWidget = "Color"; > = {1.0, 1.0, 1.0};

float4 TexelSize;

texture GBAgooch_A8R8G8B8_S2;
texture GBAnormal_A16B16G16R16F;
texture GBAobjectid_R32F;

sampler Shading = sampler_state
{
    Texture = <GBAgooch_A8R8G8B8_S2>;
    AddressU = CLAMP;
    AddressV = CLAMP;
    MinFilter = LINEAR;
    MagFilter = LINEAR;
};
sampler Normal = sampler_state
{
    Texture = <GBAnormal_A16B16G16R16F>;
    AddressU = CLAMP;
    AddressV = CLAMP;
};
sampler ObjectId = sampler_state
{
    Texture = <GBAobjectid_R32F>;
    AddressU = CLAMP;
    AddressV = CLAMP;
};

struct SurfacePoint
{
    float4 clip : POSITION;
    float3 normal : TEXCOORD0;
    float3 eye : TEXCOORD1;
};

SurfacePoint Transform(float4 position : POSITION, float3 normal : NORMAL)
{
    SurfacePoint o;
    o.clip = mul(position, WorldViewProj);
    o.normal = mul(normal, (float3x3)NormalMatrix);
    o.eye = EyePosition - mul(position, World).xyz;
    return o;
}

float4 Shade(SurfacePoint i, float face : VFACE) : COLOR
{
    float3 n = normalize(i.normal);
    if (face < 0.0)
        n = -n;
    float3 toLight = -normalize(LightDirection);
    float3 cool = saturate(CoolColor + Alpha * SurfaceColor);
    float3 warm = saturate(WarmColor + Beta * SurfaceColor);
    float3 color = lerp(cool, warm, 0.5 + 0.5 * dot(n, toLight));
    float3 halfway = normalize(toLight + normalize(i.eye));
    float highlight = HighlightAmount * pow(saturate(dot(n, halfway)), Shininess);
    return float4(lerp(color, 1.0, highlight), 1.0);
}

technique GBAgooch
{
    pass P0
    {
        CullMode = None;
        VertexShader = compile vs_3_0 Transform();
        PixelShader = compile ps_3_0 Shade();
    }
}

float Line(float2 uv, float2 across)
{
    float before = tex2D(ObjectId, uv - across).r;
    float after = tex2D(ObjectId, uv + across).r;
    float bend = dot(tex2D(Normal, uv - across).xyz, tex2D(Normal, uv + across).xyz);
    float crease = before > 0.0 && after > 0.0 && bend < cos(radians(CreaseAngle));
    return max(before != after, crease);
}

float4 Compose(float2 uv : TEXCOORD0) : COLOR
{
    // A linear look-up at the pixel's centre averages the 2x2 texels of twice the size. What is transparent is black there.
    float4 shading = tex2D(Shading, uv);
    float3 color = shading.rgb + (1.0 - shading.a) * PaperColor;
    float edge = max(Line(uv, TexelSize.xw), Line(uv, TexelSize.wy));
    return float4(color * (1.0 - edge), 1.0);
}

technique Illustration
{
    pass P0
    {
        PixelShader = compile ps_3_0 Compose();
    }
}
