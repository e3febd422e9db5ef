// SPDX-License-Identifier: Apache-2.0
// Samplers as declared, filled, handed on and put into arrays.
texture A; texture2D B; texture3D C3; textureCUBE D; texture t0 : TEX0; Texture2D Cap;
sampler sA = sampler_state { Texture = <A>; }; sampler sB = sampler_state { texture = (B); MinFilter = LINEAR; };
    sampler2D sC = sampler_state { TEXTURE = B; };
sampler sD : register(s3) = sampler_state { Texture = <D>; AddressU = CLAMP; AddressV = clamp; AddressW = Clamp;
    BorderColor = 0xff00ff00; BorderColor = float4(1,0,0,1); BorderColor = (float4)0; BorderColor = {0.f, 0, 0, 1}; };
sampler3D sV = sampler_state { Texture = <C3>; MipMapLodBias = -1.5; MaxMipLevel = 2; MaxAnisotropy = 16;
    SRGBTexture = true; MipMapLodBias = <bias>; MaxAnisotropy = (aniso * 2); ElementIndex = 0; };
float bias = 0; int aniso = 4; int linearFilter = 2;
sampler sE[2] = { sampler_state { Texture = <A>; MinFilter = <linearFilter>; }, sampler_state { Texture = <B>; } };
sampler sF[3] : register(s5); sampler sG; sampler sH = sampler_state { };
    samplerCUBE sI = sampler_state { Texture = <A>; };
sampler sJ { Texture = A; MinFilter = POINT; }; sampler2D sK { Texture = B; };
texture tN < string name = "a.jpg"; string type = "2D"; > ; texture tB <string filename = "a";> = NULL;
struct Holder { sampler2D s; float k; };
float4 Look(sampler s, float2 t) { return tex2D(s, t); }
float4 LookC(samplerCUBE s, float3 t) { return texCUBE(s, t); }
float4 Look2(uniform sampler2D s, in float2 t, const float k) { return Look(s, t) * k; }
float4 Arr(sampler s[2], float2 t) { return tex2D(s[0], t) + tex2D(s[1], t); }
float4 PS(float3 t : TEXCOORD0, uniform sampler s, uniform sampler2D q) : COLOR {
  float4 r = Look(sA, t) + Look(s, t.xy) + Look2(q, t.xy, 2) + Look2(sE[1], t, 1) + LookC(sD, t) + texCUBE(sI,
      t) + tex3D(sV, t) + tex2D(sC, t.xy) + tex2D(sJ, t.xy) + tex2D(sK, t.xy);
  for (int i = 0; i < 3; i++) r += tex2D(sF[i], t.xy);
  r += tex2Dproj(sA, float4(t, 1)) + tex2Dlod(sB, float4(t, 1)) + tex2Dbias(sB, float4(t, 1)) + tex2D(sG, t.xy,
      ddx(t.xy), ddy(t.xy)) + tex3Dproj(sV, t.xyzz) + texCUBEproj(sD, t.xyzz);
  return r + tex2D(sA, t.x) + tex2Dlod(sA, t.x) + Arr(sE, t.xy);
}
float4 One(float2 t : TEXCOORD) : COLOR0 { return tex2D(sH, t); }
technique T { pass P { PixelShader = compile ps_2_0 PS(sB, sC); } pass Q { PixelShader = compile ps_2_0 One();
    Sampler[0] = (sA); Texture[1] = <A>; sampler[2] = <sB>; MinFilter[0] = LINEAR; } }
