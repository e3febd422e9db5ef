// SPDX-License-Identifier: Apache-2.0
// Roberts cross edges: bright on black, one texel fine.
//
// L. G. Roberts, "Machine perception of three-dimensional solids" (1963): the differences along the two diagonals of each
// 2x2 block. Red, green and blue each for itself; outside the picture its border repeats.
//
// Parameters: Strength multiplies the result.

float Strength <
    string UIName = "Strength";
    float UIMin = 0.0;
    float UIMax = 8.0;
    float UIStep = 0.05;
> = 2.0;

float4 TexelSize;

texture GBAcolor_X8R8G8B8;

sampler Picture = sampler_state
{
    Texture = <GBAcolor_X8R8G8B8>;
    AddressU = CLAMP;
    AddressV = CLAMP;
    MinFilter = POINT;
    MagFilter = POINT;
};

float4 RobertsCross(float2 uv : TEXCOORD0) : COLOR
{
    float3 upperLeft  = tex2D(Picture, uv).rgb;
    float3 upperRight = tex2D(Picture, uv + TexelSize.xw).rgb;
    float3 lowerLeft  = tex2D(Picture, uv + TexelSize.wy).rgb;
    float3 lowerRight = tex2D(Picture, uv + TexelSize.xy).rgb;

    float3 a = upperLeft - lowerRight;
    float3 b = upperRight - lowerLeft;
    return float4(Strength * sqrt(a * a + b * b), 1.0);
}

technique Roberts
{
    pass P0
    {
        PixelShader = compile ps_2_0 RobertsCross();
    }
}
