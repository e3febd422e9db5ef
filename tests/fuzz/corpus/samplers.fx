// SPDX-License-Identifier: Apache-2.0
sampler s[2]; sampler2D z[3] = { sampler_state { Texture = <t>; } };
texture t;
float4 f(sampler q[2], float i) { return tex2D(q[i], i); }
float4 PS(float2 u : TEXCOORD0, uniform int n) : COLOR { return tex2D(s[n], u) + tex2D(s[u.x], u) + tex2D(z[n - 9], u) + f(s, u.x) + tex2D(s, u); }
technique T { pass { PixelShader = compile ps_3_0 PS(1); } pass { PixelShader = compile ps_3_0 PS(-1); } pass { PixelShader = compile ps_3_0 PS(1e30); } }
