// SPDX-License-Identifier: Apache-2.0
// Row and column packing, matrices made of rows, interpolation modifiers.
row_major float4x4 VP; column_major float4x4 W0; const row_major float3x4 M34;
#define MAX 59
float4x4 Places[MAX] : register(c0); float4 Tints[MAX];
struct VO { float4 p : POSITION0; float4 c : COLOR0; nointerpolation float2 t : TEXCOORD0;
    centroid float2 u : TEXCOORD1; };
VO Common(float4 p, float4x4 w) { VO o; float4 wp = mul(p, w); o.p = mul(wp, VP); o.c = 1; o.t = o.u = wp.xy;
    return o; }
VO HW(float4 p : POSITION0, float4x4 w : BLENDWEIGHT) { return Common(p, mul(W0, transpose(w))); }
VO Shader(float4 p : POSITION0, float index : TEXCOORD1, float4 m0 : TEXCOORD2, float4 m1 : TEXCOORD3) {
  VO o = Common(p, Places[index]);
  float3x4 m = { m0, m1, m0 };
  o.c = Tints[index] + float4(mul(m, p), 1) + float4(mul(M34, p), M34[1][2]); o.c.rgb *= M34._m00_m11_m22;
      o.c.a = M34._11 + m._34;
  return o; }
float4 PS(float4 c : COLOR0, float2 t : TEXCOORD) : COLOR0 { return c * t.xyxy; }
Technique A { Pass Pass1 { VertexShader = compile vs_3_0 HW(); PixelShader = compile ps_3_0 PS(); } }
Technique B { Pass Pass1 { VertexShader = compile vs_3_0 Shader(); PixelShader = compile ps_3_0 PS(); } }
