// SPDX-License-Identifier: Apache-2.0
// Inputs and outputs of both stages, many targets, places and faces of pixels.
float4x4 w; float4 pca[6]; int idx : _INDEX0;
struct VO { float4 p : POSITION; float fog : FOG; float psz : PSIZE; float4 c[2] : COLOR0; float2 t[4] : TEXCOORD0; };
VO VS(float4 p : POSITION, float3 n : NORMAL, in float4 bw[2] : BLENDWEIGHT1, int4 bi : BLENDINDICES,
    float vid : SV_VertexID, int index : _INDEX, float4 d : DIFFUSE, float4 a : ATTR8) { VO o = (VO)0;
    o.p = mul(p, w); o.t[2] = bw[1].xy; o.c[1] = pca[bi.x]; o.fog = 1; o.psz = 3; return o; }
struct PO { float4 c0 : COLOR0; float4 c1 : COLOR1; float4 c2 : COLOR2; half4 c3 : COLOR3; float d : DEPTH; };
PO PS(VO i, float2 vp : VPOS, float vf : VFACE) { PO o; o.c0 = i.c[0] + i.t[2].xyxy; o.c1 = i.c[1]; o.c2 = vp.xyxy;
    o.c3 = vf; o.d = 0.5; return o; }
void PS2(in float2 t : TEXCOORD0, out float3 c : COLOR, out float dd : DEPTH0) { c = t.xyx; dd = t.x; }
half3 PS3(half2 t : TEXCOORD0, half4 pos : POSITION, half3 nn : NORMAL,
    float tan : TANGENT) : COLOR0 { return t.x + pos.x + nn + tan; }
float PS4(float2 t : TEXCOORD) : COLOR { return 1; }
float4 PS5(float4 scr : SV_POSITION, bool front : SV_IsFrontFace,
    float4 t : TEXCOORD0_centroid) : SV_TARGET { return scr + front + t; }
float4 PS6(float4 t : TEXCOORD0) : COLOR10 { return t; }
technique T { pass A { VertexShader = compile vs_3_0 VS(); PixelShader = compile ps_3_0 PS();
    } pass B { VertexShader = compile vs_3_0 VS(); PixelShader = compile ps_2_0 PS2();
    } pass C { VertexShader = compile vs_3_0 VS(); PixelShader = compile ps_2_0 PS3();
    } pass D { PixelShader = compile ps_2_0 PS4(); } pass E { PixelShader = compile ps_4_0 PS5();
    } pass F { PixelShader = compile ps_3_0 PS6(); } }
