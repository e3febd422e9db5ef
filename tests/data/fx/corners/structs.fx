// SPDX-License-Identifier: Apache-2.0
// Structs inside structs, arrays of them, initialisers flat and nested, arrays as parameters.
struct In { float4 p : POSITION; float3 n : NORMAL; };
struct Base { float3 a; float2x2 m; float arr[2]; }; struct Nest { Base b; Base c[2]; float4 d; };
struct { float q; } anon; struct Named { float z; } named, namedArr[2]; typedef struct { float w; } Td;
    typedef float4 F4; typedef Base BaseAlias; typedef float Arr3[3];
Nest g; static Nest h; static const Base kb = { 1, 2, 3, 4, 5, 6, 7, 8, 9 };
    static const Base kb2 = { {1, 2, 3}, {4, 5, 6, 7}, {8, 9} };
    const struct Base kc = { float3(1,2,3), float2x2(1,0,0,1), { 1, 2 } };
Base mk() { Base b = (Base)0; b.m[0][1] = 2; b.arr[1] = 3; return b; }
void mod(inout Nest n, out Base o) { n.c[1].a.x = 1; o = n.b; n.b = (Base)0; }
float sum(float a[3]) { return a[0] + a[1] + a[2]; } float sum2(Arr3 a) { return sum(a);
    } float4 sumv(float4 a[2], const int n) { float4 r = 0; for (int i = 0; i < n; i++) r += a[i]; return r; }
void fill(out float a[3]) { a[0] = a[1] = a[2] = 1; } void fill2(inout Base bs[2]) { bs[1].arr[0] = 4; }
struct Empty {}; struct Semi { float a; ; float b;;; }; struct Multi { float a, b[2], c : TEXCOORD0; };
struct Inner { float2 x : TEXCOORD4; float y : TEXCOORD5; }; struct VO { float4 p : POSITION; float4 c[2] : COLOR0;
    float3x3 t : TEXCOORD0; Inner i; };
VO VS(In input, Inner other, uniform float k = 2) { VO o = (VO)k; o.p = input.p; o.c[1] = 2; o.t[0] = input.n;
    o.t._m11 = 1; o.i = other; return o; }
float4 PS(VO v, out float4 c1 : COLOR1) : COLOR0 {
  Nest n = (Nest)0; Base o; mod(n, o); n.c[0] = n.c[1] = mk(); h.d = 1; h = n; float a3[3] = { 1, 2, 3 }; fill(a3);
      Arr3 a4 = { 1, 2, 3 }; float4 vs[2] = { v.c[0], v.c[1] }; fill2(n.c);
  Base arr[2] = { kb, kb2 }; arr[0] = kc; Base cp = arr[1]; int k = 1; cp = n.c[k]; n.c[k].arr[k] += 1;
      n.c[k].m[k][k] *= 2; Td td; td.w = 1; F4 f4 = 1; BaseAlias ba = kb;
  Named nm = named; nm = (Named)1; namedArr[0].z;
      float4 fl[4] = (float4[4])float4x4(1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16); c1 = fl[k];
  float3x3 mm = v.t; float2x2 m2 = n.c[k].m; float3 row = v.t[k]; const float w[3] = { .1, .2, .3 };
      static const float ws[] = { 1, 2 };
  return float4(n.c[k].a, sum(a3) + sum2(a4) + w[k] + ws[k]) + sumv(vs,
      2) + cp.m._m00_m01_m10_m11 + o.a.xyzz + g.d + h.d + anon.q + nm.z + mm[0].xyzz + m2[1].xyxy + row.xyzz + td.w + f4 + ba.arr[k] + mk().arr[k] + mk().m[0][1] + v.i.x.xyxy + v.i.y;
}
technique T { pass P { VertexShader = compile vs_3_0 VS(); PixelShader = compile ps_3_0 PS();
    } pass Q { VertexShader = compile vs_3_0 VS(3.5); PixelShader = compile ps_3_0 PS(); } }
