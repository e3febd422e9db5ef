// SPDX-License-Identifier: Apache-2.0
// No semantics at all: a program sets the values by name, up to two lights of an array.
float4x4 g_mWorld;
float4x4 g_mWorldViewProjection;
float3 g_vEyePt;
float3 g_LightDir[2];
float4 g_LightDiffuse[2];
float4 g_LightAmbient;
float4 g_MaterialDiffuseColor;
float g_fTime;
texture g_MeshTexture;

sampler MeshSampler = sampler_state
{
    Texture = <g_MeshTexture>;
    MinFilter = LINEAR;
    MagFilter = LINEAR;
    MipFilter = LINEAR;
};

struct Vertex
{
    float4 Position : POSITION;
    float4 Diffuse : COLOR0;
    float2 Uv : TEXCOORD0;
};

Vertex LitVS(float4 p : POSITION, float3 n : NORMAL, float2 uv : TEXCOORD0, uniform int lights, uniform bool textured)
{
    Vertex o = (Vertex)0;
    p.xyz += n * 0.001 * sin(g_fTime);
    o.Position = mul(p, g_mWorldViewProjection);
    float3 normal = normalize(mul(n, (float3x3)g_mWorld));
    float3 sum = g_LightAmbient.rgb;
    for (int i = 0; i < lights; i++)
        sum += g_LightDiffuse[i].rgb * saturate(dot(normal, g_LightDir[i]));
    float rim = 1 - saturate(dot(normal, normalize(g_vEyePt - mul(p, g_mWorld).xyz)));
    o.Diffuse = float4(g_MaterialDiffuseColor.rgb * sum + 0.2 * pow(rim, 4), 1);
    if (textured)
        o.Uv = uv;
    return o;
}

float4 LitPS(Vertex i, uniform bool textured) : COLOR0
{
    return textured ? tex2D(MeshSampler, i.Uv) * i.Diffuse : i.Diffuse;
}

technique TwoLights
{
    pass P0
    {
        VertexShader = compile vs_2_0 LitVS(2, true);
        PixelShader = compile ps_2_0 LitPS(true);
    }
}
