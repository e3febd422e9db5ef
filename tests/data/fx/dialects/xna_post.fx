// SPDX-License-Identifier: Apache-2.0
// Register 0 is what is drawn.
sampler TextureSampler : register(s0);
float2 HalfPixel;
float Saturation = 0.2;
float4 MainPS(float2 texCoord : TEXCOORD0, float4 color : COLOR0) : COLOR0
{
    float4 c = tex2D(TextureSampler, texCoord);
    float grey = dot(c.rgb, float3(0.3, 0.59, 0.11));
    c.rgb = lerp(grey, c.rgb, Saturation);
    return c * color;
}
technique Desaturate { pass Pass1 { PixelShader = compile ps_2_0 MainPS(); } }
