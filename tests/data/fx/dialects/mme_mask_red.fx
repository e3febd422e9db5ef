// SPDX-License-Identifier: Apache-2.0
// The effect of mme_mask.fx's offscreen target: everything red, no edges.
float4x4 WorldViewProj : WORLDVIEWPROJECTION;

float4 RedVS(float4 p : POSITION) : POSITION { return mul(p, WorldViewProj); }
float4 RedPS() : COLOR { return float4(1, 0, 0, 1); }

technique Object < string MMDPass = "object"; >
{
    pass Draw { VertexShader = compile vs_2_0 RedVS(); PixelShader = compile ps_2_0 RedPS(); }
}
technique Shadowed < string MMDPass = "object_ss"; >
{
    pass Draw { VertexShader = compile vs_2_0 RedVS(); PixelShader = compile ps_2_0 RedPS(); }
}
