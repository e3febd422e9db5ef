// SPDX-License-Identifier: Apache-2.0
// The source's picture, unchanged: a bit-exact copy.
//
// Technique Display (the default) copies display-encoded pictures of 8 or 16 bits; technique Linear copies scene-linear
// ones (OpenEXR, Radiance HDR) in 32-bit floats.

texture GBAcolor_A16B16G16R16;
texture GBAcolor_A32B32G32R32F;

sampler DisplayPicture = sampler_state
{
    Texture = <GBAcolor_A16B16G16R16>;
    AddressU = CLAMP;
    AddressV = CLAMP;
    MinFilter = POINT;
    MagFilter = POINT;
};

sampler LinearPicture = sampler_state
{
    Texture = <GBAcolor_A32B32G32R32F>;
    AddressU = CLAMP;
    AddressV = CLAMP;
    MinFilter = POINT;
    MagFilter = POINT;
};

float4 Copy(float2 uv : TEXCOORD0, uniform sampler picture) : COLOR
{
    return tex2D(picture, uv);
}

technique Display
{
    pass P0
    {
        PixelShader = compile ps_2_0 Copy(DisplayPicture);
    }
}

technique Linear
{
    pass P0
    {
        PixelShader = compile ps_2_0 Copy(LinearPicture);
    }
}
