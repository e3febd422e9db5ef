// SPDX-License-Identifier: Apache-2.0
// Shader variables, an array of shaders and states of parameters.
float4x4 WorldViewProj : WORLDVIEWPROJECTION;
int Detail < string UIName = "Detail"; int UIMin = 0; int UIMax = 1; > = 1;
int Culling = 1;   // D3DCULL_NONE

void VS(in float4 p : POSITION, in float3 n : NORMAL, out float4 op : POSITION, out float3 on : TEXCOORD0)
{
    op = mul(p, WorldViewProj);
    on = n;
}

float4 Flat(float3 n : TEXCOORD0) : COLOR { return float4(0.5.xxx, 1); }
float4 Fine(float3 n : TEXCOORD0) : COLOR { return float4(normalize(n) * 0.5 + 0.5, 1); }

VertexShader vs = compile vs_2_0 VS();
PixelShader shaders[2] = { compile ps_2_0 Flat(), compile ps_2_0 Fine() };

technique t0
{
    pass p0
    {
        VertexShader = (vs);
        PixelShader = (shaders[Detail]);
        CullMode = <Culling>;
        ZEnable = (Detail >= 0);
    }
}
