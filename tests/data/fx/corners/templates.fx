// SPDX-License-Identifier: Apache-2.0
// Many small habits of effect templates: UI annotations, sincos, a mouse, a fractal.
// the older templates: bool/int UI, texobjs, sincos, matrix3, multi lights
#define MAX_LIGHTS (2)
bool Script : STANDARDSGLOBAL < string UIWidget="none"; string ScriptClass="object"; string ScriptOrder="standard";
    string ScriptOutput="color"; > = false;
float gTimer : TIME < string UIWidget = "none"; >;
float4x4 gWvp : WORLDVIEWPROJECTION;
float3x3 gW3 : WorldInverse;
float4x3 gWV : WORLDVIEW;
half4x4 gHalf : World;
float4 gMouse : MOUSEPOSITION < string UIWidget="None"; >;
int iters < int UIMin = 1; int UIMax = 50; string UIWidget = "slider"; > = 10;
float2 center = {0.5, 0.1};
float3 cA <string UIWidget="Color";> = float3(1, .5, 0), cB <string UIWidget="Color";> = {0, 0, 1.f};
static float2 NormOff = float2(cos(0.25), sin(0.25));
static const float kPi = 3.14159265, k2Pi = 2.0*kPi;
struct L { float3 pos; half3 col; };
L lights[MAX_LIGHTS];
void rot(float a, inout float2 p) { float s, c; sincos(a, s, c); p = float2(c*p.x - s*p.y, s*p.x + c*p.y); }
float3 hsv(float h) { return saturate(abs(frac(h + float3(3, 2, 1)/3) * 6 - 3) - 1); }
struct IO { float4 P : POSITION; float4 C : COLOR0; float2 T : TEXCOORD0; float s : PSIZE; float f : FOG; };
IO V0(float3 P : POSITION, float3 N : NORMAL, float2 T : TEXCOORD0) {
  IO o = (IO)0;
  float3 dn = (float3)0;
  dn.x = sin(gTimer*k2Pi); dn.yz = cos(gTimer).xx;
  float4 Po = float4(P + dn*N, 1);
  o.P = mul(Po, gWvp);
  o.C.xyz = mul(N, gW3) + mul(Po, gWV) + mul(N, (float3x3)gHalf);
  float2 t = T.xy; rot(gTimer % 6.28f, t);
  o.T = t; o.s = 4; o.f = 1;
  return o;
}
float4 P0(IO IN, uniform int n) : COLOR {
  float2 z = 0; int k; float r2 = 0, last;
  for (k = 0; k < n && (r2 < 4.0); k++) { last = z.x; z.x = z.x*z.x - z.y*z.y + IN.T.x; z.y = 2*last*z.y + IN.T.y;
      r2 = dot(z,z); }
  float3 c = (r2 < 4) ? cA : lerp(cA, cB, frac(k * 0.05));
  for (int i = 0; i < MAX_LIGHTS; i++) c += lights[i].col * saturate(dot(lights[i].pos, lights[i].pos));
  float g = (gMouse.z > 0.5) * length(gMouse.xy - IN.T);
  if (any(c > 1)) c = hsv(g); else if (!all(c)) c += g.xxx;
  return float4(c, k >= n ? 1 : 0.5) + NormOff.xyxy * (iters > 4);
}
technique t <string Script = "Pass=a;";> { pass a <string Script="Draw=geometry;";> { VertexShader = compile vs_1_1 V0(); PixelShader = compile ps_3_0 P0(10); } };
