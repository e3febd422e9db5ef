// SPDX-License-Identifier: Apache-2.0
// Techniques that MikuMikuEffect chooses by object: textured or not, by pass, made by a macro.
float4x4 WorldViewProj : WORLDVIEWPROJECTION;
float4x4 World : WORLD;
float3 LightWay : DIRECTION < string Object = "Light"; >;
float3 LightTint : DIFFUSE < string Object = "Light"; >;
float3 LightAround : AMBIENT < string Object = "Light"; >;
float3 Eye : POSITION < string Object = "Camera"; >;
float4 Paint : DIFFUSE < string Object = "Geometry"; >;
float3 PaintAround : AMBIENT < string Object = "Geometry"; >;
float3 Glow : EMISSIVE < string Object = "Geometry"; >;
float3 Shine : SPECULAR < string Object = "Geometry"; >;
float Sharpness : SPECULARPOWER < string Object = "Geometry"; >;
float4 EdgeInk : EDGECOLOR;

static float3 Around = saturate(PaintAround * LightAround + Glow);

texture Skin : MATERIALTEXTURE;
sampler SkinSampler = sampler_state { texture = <Skin>; MINFILTER = LINEAR; MAGFILTER = LINEAR; MIPFILTER = LINEAR; };
sampler Given0 : register(s0);

struct V
{
    float4 Pos : POSITION;
    float2 Uv : TEXCOORD0;
    float3 Normal : TEXCOORD1;
    float3 ToEye : TEXCOORD2;
};

V ObjectVS(float4 p : POSITION, float3 n : NORMAL, float2 uv : TEXCOORD0)
{
    V o = (V)0;
    o.Pos = mul(p, WorldViewProj);
    o.Normal = normalize(mul(n, (float3x3)World));
    o.ToEye = Eye - mul(p, World).xyz;
    o.Uv = uv;
    return o;
}

float4 ObjectPS(V i, uniform bool textured) : COLOR0
{
    float3 n = normalize(i.Normal);
    float4 color = float4(Around + Paint.rgb * LightTint * saturate(dot(n, -LightWay)), Paint.a);
    if (textured) color *= tex2D(SkinSampler, i.Uv);
    float3 h = normalize(normalize(i.ToEye) - LightWay);
    return color + float4(Shine * pow(saturate(dot(n, h)), Sharpness), 0);
}

float4 EdgeVS(float4 p : POSITION) : POSITION { return mul(p, WorldViewProj); }
float4 EdgePS() : COLOR0 { return EdgeInk; }

technique Edge < string MMDPass = "edge"; >
{
    pass Draw { VertexShader = compile vs_2_0 EdgeVS(); PixelShader = compile ps_2_0 EdgePS(); }
}

#define OBJECT(name, which, textured) \
technique name < string MMDPass = which; bool UseTexture = textured; bool UseToon = false; > \
{ \
    pass Draw { VertexShader = compile vs_2_0 ObjectVS(); PixelShader = compile ps_2_0 ObjectPS(textured); } \
}
OBJECT(Plain, "object", false)
OBJECT(Textured, "object", true)
OBJECT(PlainShadowed, "object_ss", false)
OBJECT(TexturedShadowed, "object_ss", true)

technique Depth < string MMDPass = "zplot"; > { pass Draw { VertexShader = compile vs_2_0 EdgeVS(); PixelShader = compile ps_2_0 EdgePS(); } }
