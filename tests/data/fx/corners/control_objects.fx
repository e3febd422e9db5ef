// SPDX-License-Identifier: Apache-2.0
// The style of MikuMikuEffect: control objects, computed globals, techniques per pass of the host.
#define CTRL "Ctrl.pmx"
#define P(n, it) float n : CONTROLOBJECT < string name = CTRL; string item = it; >;
P(mR, "R+") P(mG, "G+")
shared texture2D Sh : RENDERCOLORTARGET;
    texture2D F16 : RENDERCOLORTARGET < string Format = "D3DFMT_A16B16G16R16F"; float2 ViewportRatio = {0.5, 0.5};
    bool AntiAlias = false; int Miplevels = 0; >; sampler2D F16S = sampler_state { texture = <F16>;
    Filter = LINEAR; AddressU = BORDER; BorderColor = float4(0,0,0,0); };
float4 TexVal[4] : TEXTUREVALUE < string TextureName = "F16"; >; bool opadd; int VertexCount; int SubsetCount;
    float elapsed : ELAPSEDTIME; float time : TIME < bool SyncInEditMode = true; >; float2 mouse : MOUSEPOSITION;
    float4 lmb : LEFTMOUSEDOWN;
static float mX = mR - mG; static const float3x3 K = float3x3(1,0,0,0,1,0,0,0,1); const float4 BG = 0.0;
    const float D = 1.0; uniform const float3 UC = float3(1,2,3);
static float Rot = sin(time) > 0 ? 1 : -1; static float4x4 Mt = { 1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1 };
    float4x4 inverse(float4x4 m) { return transpose(m); } static float4x4 Inv = inverse(Mt);
    static float3 Arr[2] = { UC, UC * 2 };
float4 blur(uniform sampler2D s, float2 uv, uniform const int n, const bool h) { float4 c = 0;
    [unroll(5)] for (int i = -n; i <= n; i++) { float2 o = h ? float2(i, 0) : float2(0, i);
    c += tex2Dlod(s, float4(uv + o / 512, 0, 0)); } return c / (2 * n + 1); }
void VS(in float4 Position : POSITION, in float4 Texcoord : TEXCOORD, out float4 oTexcoord : TEXCOORD0,
    out float4 oPosition : POSITION, uniform int n) { oPosition = Position; oTexcoord = Texcoord.xyxy;
    oTexcoord.zw *= n; }
float4 PSx(in float4 coord : TEXCOORD0, uniform sampler2D src, uniform bool h) : COLOR { float4 c = blur(src,
    coord.xy, 2, h); c.rgb = mul(K, c.rgb); if (opadd) clip(c.a - 0.5); clip(c.a <= 0 ? -1 : 1);
    return c * mX + Rot + Inv[0] + Arr[1].xyzz + BG + D + TexVal[1]; }
#define PASS(name, h) pass name < string Script = "RenderColorTarget0=; Draw=Buffer;"; > { AlphaBlendEnable = false; AlphaTestEnable = false; ZEnable = false; ZWriteEnable = false; VertexShader = compile vs_3_0 VS(2); PixelShader = compile ps_3_0 PSx(F16S, h); }
technique T < string MMDPass = "object"; string Subset = "0"; bool UseTexture = true; bool UseToon = false;
    string Script = "Pass=A;" "Pass=B;"; > { PASS(A, true) PASS(B, false) }
technique E < string MMDPass = "edge"; > {} technique S < string MMDPass = "shadow"; >{ pass {} }
