// SPDX-License-Identifier: Apache-2.0
// Statements and expressions as tightly as people write them.
float4 g; float4x4 M; float3 t0, b0, n0; int n = 4; float w9[3][4] = { {1,2,3,4}, {5,6,7,8}, {9,10,11,12} };
    float w8[2][2] = { 1, 2, 3, 4 }; sampler S;
static const float2 offs[2][2] = { { {0,1}, {2,3} }, { {4,5}, {6,7} } };
float4 PS(float4 c : color0, float2 uv : texcoord0, float4 d : Color1) : color {
 float4 a, b, e; a = b = e = 0; a.xyz = b.xyz = 1; a = (b, e); float f = (float)(a.x > b.x); f = a.x > b.x;
     float3x3 tbn = { t0, b0, n0 }; float3x3 tb2 = float3x3(t0, b0, n0); float2x2 r = float2x2(f, -f, f, f);
 float3 q = mul(float4(t0, 1), M).xyz; float q1 = mul(float4(t0,1), M)[2]; q = M[0].xyz; q1 = transpose(M)[2][1];
     M._m00_m01_m02 = q; q = (tbn[0] + tb2[1]).zyx; q = -q.xyz; bool bb = !q.x; q = 1.0.xxx; q = 2..xxx;
     q = 1.f.xxx; q = 0.xxx; q = .5.xxx; q = 1f;
 for (;;) { if (f > 2) break; f += 1; } for (int i = 0, j = 1; i < 3; i++, j++) q += i * j; for (float x = 0.;
     x < 1.; x += .1) q += x; int k = n; while (k --> 0) q.x += k; do { q.y += 1; } while (0);
 const float w[3] = { .1, .2, .3 }; float2 o[] = { float2(0, 1), uv }; static float sw[2] = { 1, 2 };
     q.x += w[n] + o[n].x + sw[1] + w9[1][n] + w8[n][1] + offs[n][1].x + offs[1][n][0];
 float4 z = tex2D(S, uv).rgba.bgra; z.rgb *= z.a; z.rg = z.gr; z = z.x; z += z.xyzw.wzyx.xy.xxyy;
     z.xyz += (float3)z.a; z = z * float4(z.xyz, 1) + float4((float2)uv, uv.yx); z[0] = 1; z[n % 4] = 2; z.xy[1] = 3;
 if (z.x > 1) if (z.y > 1) z.x = 2; else z.x = 3;
 int2 ip = (int2)uv; int3 i3 = int3(uv, 1); bool2 b2 = uv > 0.5; b2 = bool2(true, false); z.x = b2.x ? b2.y : ip.x;
     uint u = (uint)uv.x; z.y = u / 2 + u % 3 + (u >> 1) + (u & 1); float3x4 m34 = (float3x4)M;
     float4x3 m43 = transpose(m34); z.xyz = mul(m34, z) + mul(z, m43); z = mul(z.xyz, m34);
 float s, co; sincos(f, s, co); float2 sc; sincos(f, sc.x, sc.y); z.xy = sc; float3 v = lerp(t0, b0, n0);
     v = lerp(t0, b0, 0.5); v = clamp(v, 0, 1); v = clamp(v, t0, b0); v = max(v, 0.xxx); v = pow(abs(v), 2.2);
     v = pow(v, 1/2.2f); v = smoothstep(0, 1, v); v = step(0.5, v); v = saturate(v * 2 - 1);
     v = normalize(v) * length(v) / distance(t0, b0); v = reflect(v, n0); v = refract(v, n0, .9);
     v = faceforward(v, t0, n0); v = fmod(v, 1); v = frac(v); v = floor(v + .5); v = abs(v); v = exp(-v*v);
     v = sqrt(v); v = rsqrt(v); v = log(v); v = v % 1.0; float d1 = dot(v.xy, v.yz) + determinant(M);
     v = cross(v, n0); v = any(v) ? v : -v; v = all(v > 0) && any(v < 1) ? 1 : 0; v = (v > 0) ? v : 0;
     v = isfinite(v) ? v : 0; v = !isnan(v) * v; v = sign(v) * degrees(radians(v)); v = ldexp(v, 2);
     float4 L = lit(1, 2, 3); L = lit(dot(v, v), dot(v, n0), 32).z;
 return a + b + e + f + q.xyzz + q1 + bb + z + v.xyzz + d1 + L + r[0].xyxy + i3.xyzz + s + co + c + d;
}
technique T { pass P { PixelShader = compile ps_3_0 PS(); } }
