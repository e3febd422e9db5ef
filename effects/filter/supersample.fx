// SPDX-License-Identifier: Apache-2.0
// Antialiasing: the scene at three times the size, every 3x3 block filtered to one pixel by a Gaussian.
//
// Figure 5 of the paper on the G2-buffer. Works on scene-linear light with associated alpha, so that borders against a
// transparent background come out right. With the default Sigma the weights are close to 1 2 1; a large one gives the plain
// average.
//
// Parameters: Sigma, in texels of the large picture; Split is the fraction of the width, from the left, that shows the
// picture unfiltered, for comparison (0.5 as in the figure).

float Sigma <
    string UIName = "Sigma";
    string units = "texels";
    float UIMin = 0.2;
    float UIMax = 10.0;
    float UIStep = 0.05;
> = 0.85;

float Split <
    string UIName = "Split";
    float UIMin = 0.0;
    float UIMax = 1.0;
    float UIStep = 0.01;
> = 0.0;

float4 TexelSize_GBAcolor_A16B16G16R16F_S3;

texture GBAcolor_A16B16G16R16F_S3;

sampler Large = sampler_state
{
    Texture = <GBAcolor_A16B16G16R16F_S3>;
    AddressU = CLAMP;
    AddressV = CLAMP;
    MinFilter = POINT;
    MagFilter = POINT;
};

float4 Fetch(float2 uv, float x, float y)
{
    return tex2D(Large, uv + float2(x, y) * TexelSize_GBAcolor_A16B16G16R16F_S3.xy);
}

float4 Filter(float2 uv : TEXCOORD0) : COLOR
{
    // A pixel's centre is the centre of its block's middle texel.
    float4 centre = Fetch(uv, 0, 0);
    float side = exp(-0.5 / (Sigma * Sigma));
    float corner = side * side;
    float4 sides = Fetch(uv, -1, 0) + Fetch(uv, 1, 0) + Fetch(uv, 0, -1) + Fetch(uv, 0, 1);
    float4 corners = Fetch(uv, -1, -1) + Fetch(uv, 1, -1) + Fetch(uv, -1, 1) + Fetch(uv, 1, 1);
    float4 filtered = (centre + side * sides + corner * corners) / (1.0 + 4.0 * side + 4.0 * corner);
    return uv.x < Split ? centre : filtered;
}

technique Supersample
{
    pass P0
    {
        PixelShader = compile ps_2_0 Filter();
    }
}
