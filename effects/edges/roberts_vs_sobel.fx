// SPDX-License-Identifier: Apache-2.0
// Two edge detectors side by side: Roberts cross on the left, Sobel on the right, black on white.
//
// Figure 4 of the paper on the G2-buffer. Both work on the intensity; Sobel's answer to a step is four times a
// difference, so its gradient is divided by four before the common threshold.
//
// Parameters: EdgeThreshold; Split is the fraction of the width that the Roberts cross gets.

float EdgeThreshold <
    string UIName = "Edge threshold";
    float UIMin = 0.0;
    float UIMax = 1.0;
    float UIStep = 0.005;
> = 0.09;

float Split <
    string UIName = "Split";
    float UIMin = 0.0;
    float UIMax = 1.0;
    float UIStep = 0.01;
> = 0.5;

float4 TexelSize;

texture GBAintensity_L8;

sampler Intensity = sampler_state
{
    Texture = <GBAintensity_L8>;
    AddressU = CLAMP;
    AddressV = CLAMP;
    MinFilter = POINT;
    MagFilter = POINT;
};

float Fetch(float2 uv, float x, float y)
{
    return tex2D(Intensity, uv + float2(x, y) * TexelSize.xy).r;
}

float Roberts(float2 uv)
{
    return abs(Fetch(uv, 0, 0) - Fetch(uv, 1, 1)) + abs(Fetch(uv, 1, 0) - Fetch(uv, 0, 1));
}

float Sobel(float2 uv)
{
    float diagonal = Fetch(uv, 1, 1) - Fetch(uv, -1, -1);
    float counter = Fetch(uv, 1, -1) - Fetch(uv, -1, 1);
    float2 gradient;
    gradient.x = diagonal + counter + 2.0 * (Fetch(uv, 1, 0) - Fetch(uv, -1, 0));
    gradient.y = diagonal - counter + 2.0 * (Fetch(uv, 0, 1) - Fetch(uv, 0, -1));
    return length(gradient) / 4.0;
}

float4 Compare(float2 uv : TEXCOORD0) : COLOR
{
    float weight = uv.x < Split ? Roberts(uv) : Sobel(uv);
    float3 color = weight > EdgeThreshold ? 0.0 : 1.0;
    if (Split > 0.0 && Split < 1.0 && abs(uv.x - Split) < TexelSize.x)
    {
        color = float3(0.8, 0.1, 0.1);
    }
    return float4(color, 1.0);
}

technique Comparison
{
    pass P0
    {
        PixelShader = compile ps_2_0 Compare();
    }
}
