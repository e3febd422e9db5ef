// SPDX-License-Identifier: Apache-2.0
// Intrinsics and operators over ints, bools, halves, doubles and matrices.
int2 i2; uint3 u3; bool3 b3; int i; half4 h; double d; float4x4 m; int3x3 im;
float4 PS(float2 t : TEXCOORD0) : COLOR {
  float s = dot(i2, i2) + dot(b3, 1) + length(i2) + max(i, t.x) + min(u3, 2).x + abs(i2).y + clamp(i, 0,
      1.5) + lerp(i, 2, 0.5) + mul(i2, i2) + mul(i, 2) + pow(i, 2) + step(i,
      1) + sign(i) + all(i2) + any(b3) + normalize(i2).x + cross(u3, u3).z + d + sqrt(d) + (float)d;
  int k = i * 2 + u3.x; int2 q = i2 * 0.5; uint w = u3.x & 1; w = -1; k = 1u; k = w >> 1u;
  float4x4 n = sin(m) + abs(m) + m * 2 + max(m, 0) + saturate(m) + lerp(m, m,
      0.5) + frac(m) + (m > 0) + m / 2 + -m + pow(m, 2) + floor(m) + step(0, m); im = im * 2; im = m; im = im / 2;
  if (all(m == m)) s += determinant(m) + determinant((float3x3)m); s += transpose((float2x3)m)[2][1];
  m++; m *= m; m += 1; bool4x4 bm = m; bm = !m; float2x2 z = float2x2(h); z = (float2x2)h; h = z; h = (half4)z;
      float4 r = z; h = half4(z);
  return s + k + q.xyxy + w + n[1] + im[1].xyzz + bm[2] + z[0].xyxy + h + r;
}
technique T { pass P { PixelShader = compile ps_3_0 PS(); } }
