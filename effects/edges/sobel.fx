// SPDX-License-Identifier: Apache-2.0
// Sobel edges: bright on black, strong where the picture changes fast.
//
// The length of the gradient that Sobel's two 3x3 kernels measure, without any scale: a step from black to white gives 4,
// shown as white. Technique Color (the default) takes red, green and blue each for itself, as ffmpeg's filter of the same
// name does on RGB; technique Luma takes the BT.709 luma and draws grey edges. Outside the picture its border repeats.
//
// Parameters: Strength multiplies the gradient.

float Strength <
    string UIName = "Strength";
    float UIMin = 0.0;
    float UIMax = 8.0;
    float UIStep = 0.05;
> = 1.0;

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

float3 Gradient(float2 uv)
{
    float2 before = uv - TexelSize.xy;
    float2 after = uv + TexelSize.xy;
    float3 upperLeft  = tex2D(Picture, before).rgb;
    float3 upper      = tex2D(Picture, float2(uv.x, before.y)).rgb;
    float3 upperRight = tex2D(Picture, float2(after.x, before.y)).rgb;
    float3 left       = tex2D(Picture, float2(before.x, uv.y)).rgb;
    float3 right      = tex2D(Picture, float2(after.x, uv.y)).rgb;
    float3 lowerLeft  = tex2D(Picture, float2(before.x, after.y)).rgb;
    float3 lower      = tex2D(Picture, float2(uv.x, after.y)).rgb;
    float3 lowerRight = tex2D(Picture, after).rgb;

    float3 diagonal = lowerRight - upperLeft;
    float3 counter  = upperRight - lowerLeft;
    float3 x = diagonal + counter + 2.0 * (right - left);
    float3 y = diagonal - counter + 2.0 * (lower - upper);
    return sqrt(x * x + y * y);
}

float LumaAt(float2 uv)
{
    return dot(tex2D(Picture, uv).rgb, float3(0.2126, 0.7152, 0.0722));
}

float3 LumaGradient(float2 uv)
{
    float2 before = uv - TexelSize.xy;
    float2 after = uv + TexelSize.xy;
    float diagonal = LumaAt(after) - LumaAt(before);
    float counter  = LumaAt(float2(after.x, before.y)) - LumaAt(float2(before.x, after.y));
    float across   = LumaAt(float2(after.x, uv.y)) - LumaAt(float2(before.x, uv.y));
    float down     = LumaAt(float2(uv.x, after.y)) - LumaAt(float2(uv.x, before.y));
    float x = diagonal + counter + 2.0 * across;
    float y = diagonal - counter + 2.0 * down;
    return sqrt(x * x + y * y);
}

float4 ColorEdges(float2 uv : TEXCOORD0) : COLOR
{
    return float4(Gradient(uv) * Strength, 1.0);
}

float4 LumaEdges(float2 uv : TEXCOORD0) : COLOR
{
    return float4(LumaGradient(uv) * Strength, 1.0);
}

technique Color
{
    pass P0
    {
        PixelShader = compile ps_2_0 ColorEdges();
    }
}

technique Luma
{
    pass P0
    {
        PixelShader = compile ps_2_0 LumaEdges();
    }
}
