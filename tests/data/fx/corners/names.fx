// SPDX-License-Identifier: Apache-2.0
// Keywords of the effect framework and of GLSL as names, scopes, leaking loop variables, stray semicolons.
float x = 1; static float y; float t2;
struct line { float point; float sample; };
line mk(float point) { line l; l.point = point; l.sample = 2; return l; }
float4 texture_(float4 texture0, float pass) { return texture0 * pass; }
float input(float input, float output) { return input + output; }
float4 PS(float2 uv : TEXCOORD0, float4 color : COLOR0) : COLOR {
  float line = 1, point = 2, triangle = 3, sample = 4, linear = 5, pass = 6, technique = 7, texture = 8,
      sampler_ = 9, vector_ = 10, matrix_ = 11, compile = 12, buffer = 13, common = 14, filter = 15, active = 16,
      partition = 17, noise = 18, mod = 19, fract = 20, mix = 21, vec4 = 22, mat4 = 23, gl_x = 24, layout = 25,
      main = 26, attribute = 27, varying_ = 28, highp = 29, inverse = 30, dFdx = 31, asfloat_ = 32, smooth = 33,
      flat = 34, subroutine = 35, restrict = 36, varying0 = 1, hvec2 = 3, union_ = 3, register_ = 4, string_ = 5,
      shared_ = 6, decl = 7, state = 8, color0 = 9, lerp_ = 2, half_ = 3, alpha = 4, index = 5, object = 3,
      group = 4, interface = 5, namespace = 6, package = 7, stateblock_ = 8, out_ = 9, in_ = 10, pixelshader_ = 11,
      discard_ = 1, fxgroup = 3, dword_ = 3, precise = 4, snorm = 2, unorm = 3, globallycoherent = 4, groupshared = 5;
  { float x = 2; { float x = 3; y += x; } y += x; }
  for (int i = 0; i < 3; i++) { float x = i; y += x; } y += i; for (int i = 0; i < 2; i++) ; for (i = 0; i < 2;
      ++i) {} for (float i = 0; i < 2; i += 0.5) y++;
  int i; for (i = 0, line = 3; i < 3 && line > 0; i++, line--) ; ;;
  if (x) ; else y = 2; if (x) { } else if (y) { } else { ; }
  float distance = distance(uv, 0.5); float dot_ = dot(uv, uv); float length = length(uv);
      float floor = floor(distance); float max = max(floor, length);
  float a = 1, b = a, c = b + 1, e[2] = { 1, 2 }, g; const float k = 3; static const float ks = 4;
      static float kn = 5; float4 r = (float4)0, r2 = 0.xxxx;

  switch (i) { case 0: y = 1; break; case 1: case 2: y = 2; break; default: y = 3; break; }
  do { y -= 1; } while (y > 4);
  return r + line + point + triangle + sample + linear + pass + technique + texture + compile + a + b + c + e[1] + k + ks + kn + texture_(color, 2) + input(1, 2) + max + dot_ + mod + vec4 + main + gl_x + x + noise + mk(2).point + interface + namespace;
};
technique T { pass P { PixelShader = compile ps_3_0 PS(); }; };;
