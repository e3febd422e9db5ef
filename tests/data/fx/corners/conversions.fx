// SPDX-License-Identifier: Apache-2.0
// Implicit conversions wherever a value is handed on, and casts of all kinds.
float4 v4; float3 v3; float2 v2; float f; int i; bool b; int4 i4; bool4 b4; half3 h3; float4x4 m; float3x3 m3;
    float4x3 m43; float3x4 m34;
float3 ret3() { return v4; }
float ret1() { return v4; }
bool retb() { return f; }
int reti(float3 x) { return x.x; }
float2 take2(float2 a) { return a; }
float take1(float a) { return a; }
float3x3 take33(float3x3 a) { return a; }
void out3(out float3 o) { o = v4; }
void out4(out float4 o) { o = 1; }
void outf(out float o) { o = 2; }
void outi(out int o) { o = 3.5; }
void io2(inout half2 o) { o *= 2; }
float4 PS(float2 t : TEXCOORD0) : COLOR {
  float3 a = v4; a = v4; a += v4; a = take2(v4).xyy; float s = v3; s += v2.x + v4; s = take1(v4);
  int k = f; k = v4; k += 1.5; k *= f; bool c = v3.x; c = i; c = b4; float4 q = b; q = b4; q = i4 * 0.5; q = i4;
      q.xy = v3; q.xyz = v4;
  float3 p3; out3(p3); float4 p4; out3(p4.xyz); out3(p4.zyx); float3 n3; out4(p4); float g; outf(g); outf(p4.y);
      outi(g); outi(p4.z); io2(v2); io2(p4.xw);
  int gi; outf(gi);
  if (f) a++; if (i) a--; if (v4.x) ++a; if (!f) --a; if (b4.x) a = -a; if (i & 1) a = +a;
      if (v2.x > v2.y && f) a *= 2; if (any(v2)) a /= 2;
  while (f > 3) { f -= 1; if (i) break; }
  q = b ? v4 : 1; q = f ? v4 : v3.xyzz; q = (v4 > 0) ? v4 : 0; q = v4 > v4.wzyx ? 1 : 2; q = i ? 1 : 0.5;
      q = b ? 1 : v4; k = b ? 1 : 2; a = b ? v4 : v3; c = b ? true : i;
  q = v4 == v4.yxwz; q = (v4 != 0) * 2; q = (v3 < v4).xyzz; q = -b; q = !v4; q = ~i4; q = +b; s = v4.x == 1;
      s = (v4.x < 2) + (v4.y > 3); s = i == f; s = b == true; s = b == 1; s = b == f;
  q = v4 + v3.xyzz + v2.xyxy + f + i + b; q.xyz = v4 + v3; q.xy = v3 * v2; q = mul(v4, m); q.xyz = mul(v3, m);
      q.xyz = mul(v4, m43); q = mul(v3, m34); q.xyz = mul(m34, v4); q.xyz = mul(v4, m3); q = mul(m, v3);
      q.xyz = mul(v3, (float3x3)m); q.xyz = mul((float3x3)m43, v3); q.xyz = mul((float4x3)m, v3);
  m3 = m; m43 = m; m34 = m; m3 = take33(m); m = (float4x4)1; m3 = 0; m = float4x4(v4, v4, v4, v4);
      m3 = float3x3(v3, v3, v3); m43 = (float4x3)m; m34 = float3x4(v4, v4, v4);
  m3 = float3x3(v2, 1, v3, 1, 2, 3); m[0] = v4; m[1].xyz = v3; m[2][3] = f; m._m00 = 1; m._11_22 = v2; m3[0] = v4;
      v3 = m[0]; s = m[i][k]; s = m[0]; m[i] = v4; m[i][k] += 1;
  float arr[3] = { 1, 2, 3 }; s = arr[i]; arr[i] = f; s = arr[f]; float4 va[2] = { v4, { 1, 2, 3, 4 } };
      q = va[i][k]; va[1].xy = v2; float3 vb[2] = { v3, 1, 2, 3 };
  q = float4(v2, v2); q = float4(v3, 1); q = float4(1, v3); q = float4(f, i, b, 1.0h); q = float4(v2, f, 1);
      q = (float4)f; q = f; q = (float4)(f); q = float4(0.5.xxx, 1); q = f.xxxx; q = 1.0f.xxxx; q = v4.x.xxxx;
      a = (float3)v4; a = (float3)(v4 * 2); s = (float)v4; k = (int)f; k = (int)v4.x; a = (half3)v4; q = (int4)v4;
      q = (bool4)v4; q = half4(h3, (half)1);
  k++; ++k; k--; s = k++ + ++k; s = k % 3; s = f % 2; q = v4 % 2; q %= 3; k <<= 1; k |= 4; k ^= 3; k &= 7;
      s = k >> 1; s = (k, f); s = i / 2; s = i / 2.0; s = 1 / 3;
  q = clamp(v4, 0, 1); q = max(v4, 0); q = max(0, v4); q = min(f, v4); q = lerp(v4, 1, 0.5); q = lerp(0, v4, v4);
      q = lerp(v3, v4, f).xyzz; q = pow(v4, 2); q = pow(2, v4); q.xyz = pow(v4, v3); q = step(0.5, v4);
      q = smoothstep(0, 1, v4); s = dot(v4, v3); s = dot(v3, 1); s = dot(1, v3); s = length(v4 - v3);
      s = distance(v4, 0); a = cross(v4, v4); a = reflect(v4, v3); a = refract(v3, v3, 1.3); a = normalize(v4);
      s = max(i, f); k = max(i, 2); k = abs(i); k = min(k, 3); s = saturate(i); q = saturate(v4 > 0); s = sqrt(i);
      s = abs(b); s = sin(1); s = pow(2, 3); k = sign(v4.x); q = sign(v4); s = floor(i); k = floor(f);
      s = fmod(i, 2); s = frac(1); q = atan2(v4, 1); q = fmod(v4, 3); q = clamp(i4, 0, 3); s = mad(1, 2, 3);
      s = exp2(i); s = log(2); s = ldexp(f, 2); s = length(f); s = normalize(f);
      q = exp(v4) + exp2(v4) + log2(v4) + log10(v4) + sqrt(v4) + rsqrt(v4) + degrees(v4) + radians(v4) + sinh(v4) + cosh(v4) + tanh(v4) + asin(v4) + acos(v4) + atan(v4) + tan(v4) + ceil(v4) + round(v4) + trunc(v4);
  float4 sn, cs; sincos(v4, sn, cs); sincos(f, s, g); float whole; s = modf(f, whole); q = modf(v4, sn); int ei;
      s = modf(f, ei); s = frexp(f, whole);
  return q + a.xyzz + s + k + c + retb() + reti(v4) + ret1() + ret3().xyzx + p3.xyzz + p4 + g + gi + va[0] + vb[1].xyzz + m[0] + m3[0].xyzz + m43[0].xyzz + m34[0] + sn + cs;
}
technique T { pass P { PixelShader = compile ps_3_0 PS(); } }
