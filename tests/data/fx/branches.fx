// SPDX-License-Identifier: Apache-2.0
// Look-ups under branches: flattened where both sides only compute, left where they leave or loop.

texture Picture; sampler s = sampler_state { Texture = <Picture>; };
float Threshold;
float4 Look(float2 uv) { return tex2D(s, uv); }
static float4 total = 0;
void Add(float4 v) { total += v; }

float4 PS(float2 uv : TEXCOORD0, uniform bool fixedChoice) : COLOR
{
    float4 c = tex2D(s, uv);
    float list[3] = { 1, 2, 3 };
    if (c.x > Threshold) { c = Look(uv * 2); list[1] = c.y; } else if (c.y > 0.5) c += tex2D(s, uv * 3); else { float4 d = tex2D(s, uv); c.xy = d.zw; }
    if (Threshold > 0) c += tex2D(s, uv * 4);
    if (fixedChoice) c += tex2D(s, uv * 5);
    if (c.z > 0) Add(tex2D(s, uv * 6));
    if (c.w > 0) { for (int i = 0; i < 3; i++) c += tex2D(s, uv * i); }
    if (c.x < 0) { clip(c.x + tex2D(s, uv).x); }
    if (c.y < 0) discard;
    if (c.x < -1) return tex2D(s, uv);
    c = c.x > 0.5 ? tex2D(s, uv * 7) : c;
    bool b = c.x > 0 || tex2D(s, uv * 8).x > 0;
    return c + b + list[1] + total;
}
technique T { pass { PixelShader = compile ps_3_0 PS(true); } }
