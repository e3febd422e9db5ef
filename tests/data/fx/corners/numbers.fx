// SPDX-License-Identifier: Apache-2.0
// Every way to write a number.
static const float a = 1.f, b = .5, c = 1e3, d = 1.5e-3f, e = 0x1F, f = 017, g = 1., h = 2.5h, i = 1e3h, j = 10L,
    k = 3u, l = 1.0F, m = 5.H, n = 00.5, o = 1E+2, p = 0.0000001f, q = 123456789012, r = 0xFFFFFFFF, s = 3.0l,
    t = 1.0lf, u = 08.5, v = 1e-45, w = 4294967295, x = -2147483648;
int4 z = { 0xff, 010, 1, -1 }; float big = 1e38;
    float4 PS() : COLOR { return float4(a + b + c + d + e, f + g + h + i + j, k + l + m + n + o,
    p + q + r + s + t + u + v + w + x) + z + big; }
technique T { pass P { PixelShader = compile ps_3_0 PS(); } }
