// SPDX-License-Identifier: Apache-2.0
// Blended vertices, a vertex shader for every number of bones, and no pixel shader: the fixed pipeline textures.
float4x3 Bones[20] : WORLDMATRIXARRAY;
float4x4 ViewProj : VIEWPROJECTION;
float4 Paint : MATERIALDIFFUSE = { 0.8, 0.8, 0.8, 1 };
float3 ToLight = { 0.3, 0.6, 0.74 };
int BoneCount = 2;

struct Output
{
    float4 Position : POSITION;
    float4 Diffuse : COLOR0;
    float2 Uv : TEXCOORD0;
};

Output Blend(float4 p : POSITION, float4 weights : BLENDWEIGHT, float4 indices : BLENDINDICES, float3 n : NORMAL,
             float2 uv : TEXCOORD0, uniform int count)
{
    int bones[4] = (int[4])D3DCOLORtoUBYTE4(indices);
    float shares[4] = (float[4])weights;
    float left = 1;
    float3 place = 0;
    float3 normal = 0;
    for (int i = 0; i < count; i++)
    {
        float share = i == count - 1 ? left : shares[i];
        left -= share;
        place += share * mul(p, Bones[bones[i]]);
        normal += share * mul(n, (float3x3)Bones[bones[i]]);
    }
    Output o;
    o.Position = mul(float4(place, 1), ViewProj);
    o.Diffuse = float4(Paint.rgb * (0.2 + 0.8 * saturate(dot(normalize(normal), ToLight))), Paint.a);
    o.Uv = uv;
    return o;
}

VertexShader Blended[3] = { compile vs_2_0 Blend(1), compile vs_2_0 Blend(2), compile vs_2_0 Blend(3) };

technique Skin
{
    pass P0
    {
        VertexShader = (Blended[BoneCount - 1]);
    }
}
