// SPDX-License-Identifier: Apache-2.0
// Entry points and functions specialised by literals, parameters and samplers.

texture Picture; texture Other; texture Sky < string TextureType = "Cube"; >;
sampler PictureSampler = sampler_state { Texture = <Picture>; };
sampler OtherSampler = sampler_state { Texture = <Other>; };
sampler SkySampler = sampler_state { Texture = <Sky>; };
sampler Several[2] = { sampler_state { Texture = <Picture>; }, sampler_state { Texture = <Other>; } };
float Gain = 2;
int Taps = 3;

float4 Fetch(sampler s, float2 uv) { return tex2D(s, uv); }
float4 Both(sampler a, sampler b, float2 uv) { return Fetch(a, uv) + Fetch(b, uv); }
float4 Around(sampler s, float3 d) { return texCUBE(s, d); }
float4 Typed(uniform sampler2D s, float2 uv, const float k) { return tex2D(s, uv) * k; }

float4 PS(float2 uv : TEXCOORD0, uniform sampler s, uniform float gain, uniform int taps, uniform bool sky) : COLOR
{
    float4 sum = 0;
    for (int i = 0; i < taps; i++) sum += Fetch(s, uv + i * 0.01) * gain;
    if (sky) sum += Around(SkySampler, sum.xyz);
    gain *= 2;
    return sum * gain + Both(PictureSampler, s, uv) + Typed(s, uv, 2) + tex2D(Several[1], uv) + Fetch(Several[0], uv);
}

float4 PSDefault(float2 uv : TEXCOORD0, uniform float k = 0.5) : COLOR { return Gain * k + uv.x; }

PixelShader shaders[2] = { compile ps_2_0 PSDefault(), compile ps_2_0 PSDefault(Gain * 2) };

technique T
{
    pass A { PixelShader = compile ps_2_0 PS(PictureSampler, 1, 3, true); }
    pass B { PixelShader = compile ps_2_0 PS(OtherSampler, Gain, Taps, false); }
    pass C { PixelShader = (shaders[1]); }
    pass D { PixelShader = (shaders[0]); }
}
