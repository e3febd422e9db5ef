// SPDX-License-Identifier: Apache-2.0
// Prototypes, overloads, defaults, qualifiers, entry points with uniform parameters.
float4 c0; sampler s; int N = 4; float3 Vals[2];
float f(float a); float f(float2 a); float f(float3); float f(float4x4 a) { return a[0][0]; }
float f(float a) { return a; } float f(float2 a) { return a.x; } float f(float3 a) { return a.y; }
float3 over(float3 a, float3 b) { return a + b; } float over(float a, float b) { return a * b;
    } float4 over(float4 a, float4 b) { return a - b; }
int g(int a) { return a; } float g(float a) { return a; } float g(half4 a) { return a.x;
    } bool g(bool a) { return a; }
float defs(float a, float b = 2, float c = 3) { return a + b + c; }
inline float inl(const in float a, in const float b, float c[2]) { return a + b + c[1];
    } static float st() { return 1; } float noname(float, float b) { return b;
    } void nothing(void) { } float noargs() { return 2; };
float3 saturate3(float3 x) { return saturate(x); } float lerp(float a, float b) { return (a + b) / 2;
    } float4 luminance(float4 c) { return dot(c, float4(0.3, 0.59, 0.11, 0));
    } float max3(float a, float b, float c) { return max(a, max(b, c));
    } float2 pow(float2 a, int b, int c) { return a; }
float early(float x) { if (x > 1) return 1; return 0; } float early2(float x) { if (x > 1) { return 1;
    } else { return 0; } } float loopret(float x) { for (int i = 0; i < 4; i++) { if (i > x) return i; } return 5;
    } float wh(float x) { while (true) { x++; if (x > 4) return x;
    } } float sw(int x) { switch (x) { case 0: return 1; case 1: { return 2; } default: return 3; } }
void multi(float2 a, out float x, out float y) { x = a.x; y = a.y; }
float4 VSp(float4 p : POSITION, uniform float k, out float2 t : TEXCOORD0,
    const uniform bool b) : POSITION { t = p.xy * k * b; return p; }
float4 PS(float2 t : TEXCOORD0, float f2 : TEXCOORD1, uniform const int n, uniform float3 arr) : COLOR0 {
  float a[2] = { 1, 2 }; float x, y; multi(t, x, y); multi(t.yx, x, a[0]); nothing();
  float r = f(1) + f(1.5) + f(t) + f(c0.xyz) + f(true) + g(1) + g(1.5) + g(true) + g(c0.x > 0) + g((half4)c0) + defs(1) + defs(1, 2) + defs(1, 2, 3) + inl(1, 2, a) + st() + noname(1, 2) + noargs() + lerp(1, 2) + lerp(1, 2, 0.5) + max3(1, 2, 3) + early(x) + early2(x) + loopret(x) + wh(x) + sw(n) + over(1, 2) + over(t.x, 2) + over(1, x);
  float3 q = over(c0.xyz, 1) + over(c0.xyz, c0.xyz) + over(1, c0.xyz) + saturate3(c0);
  return luminance(c0) + r + q.xyzz + over(c0, 1) + over(c0, c0) + arr.xyzz + pow(t, 1, 2).xyxy;
}
technique T { pass P { VertexShader = compile vs_2_0 VSp(1.5, true);
    PixelShader = compile ps_2_0 PS(3, float3(1,2,3));
    } pass Q { VertexShader = compile vs_2_0 VSp(c0.x, c0.y > 0); PixelShader = compile ps_2_0 PS(N, c0);
    } pass R { VertexShader = compile vs_2_0 VSp(-1.5, !false);
    PixelShader = compile ps_2_0 PS((1 + 2) * 3, Vals[1]); } }
