// SPDX-License-Identifier: Apache-2.0
// Declarations and techniques that macros make, samplers in an array, a loop whose variable outlives it.
#define TEXTURE(name, file) texture name##Tex < string ResourceName = file; >
#define SAMPLER(name) sampler_state { Texture = <name##Tex>; MinFilter = LINEAR; MagFilter = LINEAR; MipFilter = NONE; }
#define TECHNIQUE(name, n) technique name { pass P0 { ZEnable = FALSE; PixelShader = compile ps_2_0 Weave(n); } }

TEXTURE(First, "default_color.dds");
TEXTURE(Second, "default_gloss.dds");
sampler Samplers[2] = { SAMPLER(First), SAMPLER(Second) };
static const float2 kOffsets[] = { { 0, 0 }, { 0.25, 0 }, { 0, 0.25 }, };

float4 Weave(float2 uv : TEXCOORD0, uniform int count) : COLOR
{
    float4 sum = 0;
    for (int i = 0; i < count; i++) sum += tex2D(Samplers[i % 2], uv + kOffsets[i]) * uv.xyxx;
    for (int i = 0; i < 1; i++) sum.b += 0.25;
    return float4(sum.rgb / (count + i - 1), 1);
}

TECHNIQUE(Three, 3)
TECHNIQUE(Two, 2)
