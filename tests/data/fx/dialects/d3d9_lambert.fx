// SPDX-License-Identifier: Apache-2.0
// The style of Direct3D 9's samples: upper-case semantics, vertex shaders that light, Texture in parentheses.
float4x4 g_mWorld : WORLD;
float4x4 g_mWorldViewProjection : WORLDVIEWPROJECTION;
float3 g_vLightDir = float3(0.4, -0.8, -0.45);
float4 g_vDiffuse = { 0.85, 0.55, 0.25, 1.0 };

struct VS_OUTPUT
{
    float4 Position : POSITION;
    float4 Diffuse : COLOR0;
};

VS_OUTPUT LambertVS(float4 vPos : POSITION, float3 vNormal : NORMAL, uniform bool bAmbient)
{
    VS_OUTPUT Output = (VS_OUTPUT)0;
    Output.Position = mul(vPos, g_mWorldViewProjection);
    float3 n = normalize(mul(vNormal, (float3x3)g_mWorld));
    Output.Diffuse.rgb = g_vDiffuse * max(0, dot(n, -normalize(g_vLightDir)));
    if (bAmbient) Output.Diffuse.rgb += 0.15;
    Output.Diffuse.a = 1.0f;
    return Output;
}

technique RenderScene
{
    pass P0
    {
        VertexShader = compile vs_1_1 LambertVS(true);
        PixelShader = NULL;
        ColorOp[0] = SelectArg1;
        ColorArg1[0] = Diffuse;
        ColorOp[1] = Disable;
    }
}
