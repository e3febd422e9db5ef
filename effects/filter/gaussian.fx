// SPDX-License-Identifier: Apache-2.0
// Gaussian blur of a picture, a video or a rendered scene.
//
// Separable: pass 0 along the rows, pass 1 along the columns, out to three sigmas. The weights come from forward
// differences, after Turkowski, "Incremental Computation of the Gaussian" (GPU Gems 3, chapter 40). Colours are weighted by
// their alpha, so that what is transparent does not bleed in. Outside the picture its border repeats.
//
// Parameters: Sigma, in pixels; 0 leaves the picture as it is.

float Sigma <
    string UIName = "Sigma";
    string units = "pixels";
    float UIMin = 0.0;
    float UIMax = 20.0;
    float UIStep = 0.1;
> = 2.0;

float4 TexelSize;

texture GBAcolor_A8R8G8B8;
texture PASS0_A16B16G16R16;

sampler Picture = sampler_state
{
    Texture = <GBAcolor_A8R8G8B8>;
    AddressU = CLAMP;
    AddressV = CLAMP;
    MinFilter = POINT;
    MagFilter = POINT;
};

sampler Rows = sampler_state
{
    Texture = <PASS0_A16B16G16R16>;
    AddressU = CLAMP;
    AddressV = CLAMP;
    MinFilter = POINT;
    MagFilter = POINT;
};

float4 Fetch(sampler source, float2 uv, bool associate)
{
    float4 color = tex2Dlod(source, float4(uv, 0.0, 0.0));
    if (associate)
        color.rgb *= color.a;
    return color;
}

// The weighted mean along `direction`, of colours with associated alpha.
float4 Blur(sampler source, float2 uv, float2 direction, bool associate)
{
    float4 sum = Fetch(source, uv, associate);
    if (Sigma <= 0.0)
        return sum;
    // weight.x is the Gaussian at the tap, relative to the centre's; y and z are its quotients from tap to tap.
    float3 weight;
    weight.x = 1.0;
    weight.y = exp(-0.5 / (Sigma * Sigma));
    weight.z = weight.y * weight.y;
    float total = 1.0;
    int radius = (int)min(ceil(3.0 * Sigma), 60.0);
    for (int i = 1; i <= radius; ++i)
    {
        weight.xy *= weight.yz;
        float2 offset = direction * i;
        sum += weight.x * (Fetch(source, uv - offset, associate) + Fetch(source, uv + offset, associate));
        total += 2.0 * weight.x;
    }
    return sum / total;
}

float4 AlongRows(float2 uv : TEXCOORD0) : COLOR
{
    return Blur(Picture, uv, TexelSize.xw, true);
}

float4 AlongColumns(float2 uv : TEXCOORD0) : COLOR
{
    float4 color = Blur(Rows, uv, TexelSize.wy, false);
    if (color.a > 0.0)
        color.rgb /= color.a;
    return color;
}

technique Gaussian
{
    pass Rows
    {
        ZEnable = false;
        PixelShader = compile ps_3_0 AlongRows();
    }
    pass Columns
    {
        ZEnable = false;
        PixelShader = compile ps_3_0 AlongColumns();
    }
}
