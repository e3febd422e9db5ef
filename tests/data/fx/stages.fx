// SPDX-License-Identifier: Apache-2.0
// Inputs and outputs of both stages in every form.

float4x4 WorldViewProjection : WORLDVIEWPROJECTION;

struct Inner { float3 normal : NORMAL; float2 uv[2] : TEXCOORD2; };
struct VSIn { float4 position : POSITION; Inner inner; float4 color : COLOR; int4 bones : BLENDINDICES; half3 tangent : TANGENT0; float id : SV_VertexID; };
struct VSOut
{
    float4 position : POSITION;
    float size : PSIZE;
    float fog : FOG;
    float4 diffuse : COLOR0;
    float3 specular : COLOR1;
    float2 uv[2] : TEXCOORD0;
    float3x3 frame : TEXCOORD2;
    int whole : TEXCOORD6;
    bool flag : TEXCOORD7;
};

VSOut VSStruct(VSIn i)
{
    VSOut o;
    o.position = mul(i.position, WorldViewProjection);
    o.size = 2;
    o.diffuse = i.color;
    o.specular = i.inner.normal;
    o.uv[0] = i.inner.uv[0];
    o.uv[1] = i.inner.uv[1];
    o.frame = float3x3(i.tangent, i.inner.normal, i.inner.normal);
    o.whole = i.bones.y;
    o.flag = i.id > 2;
    return o;
}

void VSOutParameters(float3 p : POSITION, inout float2 uv : TEXCOORD0, out float4 position : POSITION, out float3 unwritten : TEXCOORD1)
{
    position = float4(p, 1);
    uv = 1 - uv;
}

float4 PSStruct(VSOut i, float4 never : TEXCOORD9) : COLOR
{
    return i.diffuse + i.specular.xyzz + i.uv[1].xyxy + float4(mul(i.uv[0].xyx, i.frame), i.whole) * i.flag + never;
}

struct Targets { float4 first : COLOR0; float2 second : COLOR1; float third : COLOR2; float depth : DEPTH; };
Targets PSTargets(float2 uv : TEXCOORD0, float2 pixel : VPOS, float face : VFACE)
{
    Targets o = (Targets)0;
    o.first = uv.xyxy;
    o.second = pixel;
    o.third = face > 0 ? 1 : -1;
    o.depth = 0.5;
    return o;
}

void PSOutParameters(in float2 uv : TEXCOORD0, float4 place : SV_Position, out float4 a : COLOR0, out float3 b : SV_Target1) { a = uv.x; b = place.xyz; }
float PSScalar(float4 p : POSITION) : COLOR { return p.x; }

technique T
{
    pass A { VertexShader = compile vs_1_1 VSStruct(); PixelShader = compile ps_2_0 PSStruct(); }
    pass B { VertexShader = compile vs_3_0 VSOutParameters(); PixelShader = compile ps_3_0 PSTargets(); AlphaTestEnable = true; }
    pass C { VertexShader = compile arbvp1 VSOutParameters(); PixelShader = compile arbfp1 PSOutParameters(); }
    pass D { PixelShader = compile ps_2_a PSScalar(); }
    pass E { VertexShader = compile vs_2_sw VSStruct(); PixelShader = NULL; ColorWriteEnable = 0; }
}
