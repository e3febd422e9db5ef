// SPDX-License-Identifier: Apache-2.0
// The picture with the histogram of its intensities below: how much of it is how bright, dark on the left.
//
// Pixels count by their alpha, so that the empty background of a scene counts for nothing. Intensity is the luminance of
// Rec. 709 of the encoded colours, which is what an image file's histogram shows. A bin is eight pixels wide; pass 0 counts
// strips of eight rows, pass 1 adds them up, pass 2 divides by the fullest bin, pass 3 draws.
//
// Parameters: Height, of the picture's, that the histogram covers; BarColor and PaperColor.

float Height <
    string UIName = "Height";
    float UIMin = 0.05;
    float UIMax = 1.0;
    float UIStep = 0.05;
> = 0.2;
float3 BarColor < string UIName = "Bars"; string UIWidget = "Color"; > = {0.15, 0.15, 0.15};
float3 PaperColor < string UIName = "Paper"; string UIWidget = "Color"; > = {0.9, 0.9, 0.9};

float2 FrameSize;
float4 TexelSize_PASS0_R32F_S0_125;

texture GBAcolor_A8R8G8B8;
texture PASS0_R32F_S0_125;
texture PASS1_R32F_S0_125;
texture PASS2_R32F_S0_125;

sampler Picture = sampler_state
{
    Texture = <GBAcolor_A8R8G8B8>;
    AddressU = CLAMP;
    AddressV = CLAMP;
    MinFilter = POINT;
    MagFilter = POINT;
};
sampler Strips = sampler_state
{
    Texture = <PASS0_R32F_S0_125>;
    AddressU = CLAMP;
    AddressV = CLAMP;
    MinFilter = POINT;
    MagFilter = POINT;
};
sampler Counts = sampler_state
{
    Texture = <PASS1_R32F_S0_125>;
    AddressU = CLAMP;
    AddressV = CLAMP;
    MinFilter = POINT;
    MagFilter = POINT;
};
sampler Bars = sampler_state
{
    Texture = <PASS2_R32F_S0_125>;
    AddressU = CLAMP;
    AddressV = CLAMP;
    MinFilter = POINT;
    MagFilter = POINT;
};

// Bins and strips.
float2 Cells()
{
    return floor(1.0 / TexelSize_PASS0_R32F_S0_125.xy + 0.5);
}

float4 CountStrip(float2 uv : TEXCOORD0) : COLOR
{
    float2 cells = Cells();
    float bin = floor(uv.x * cells.x);
    float strip = floor(uv.y * cells.y);
    float first = floor(strip * FrameSize.y / cells.y + 0.5);
    float last = floor((strip + 1.0) * FrameSize.y / cells.y + 0.5);
    float sum = 0.0;
    for (float y = first; y < last; y += 1.0)
    {
        for (float x = 0.0; x < FrameSize.x; x += 1.0)
        {
            float4 color = tex2Dlod(Picture, float4((float2(x, y) + 0.5) / FrameSize, 0.0, 0.0));
            float intensity = dot(color.rgb, float3(0.2126, 0.7152, 0.0722));
            float place = min(floor(intensity * cells.x), cells.x - 1.0);
            sum += place == bin ? color.a : 0.0;
        }
    }
    return sum;
}

float4 AddStrips(float2 uv : TEXCOORD0) : COLOR
{
    float strips = Cells().y;
    float sum = 0.0;
    for (float i = 0.0; i < strips; i += 1.0)
        sum += tex2Dlod(Strips, float4(uv.x, (i + 0.5) / strips, 0.0, 0.0)).r;
    return sum;
}

float4 DivideByFullest(float2 uv : TEXCOORD0) : COLOR
{
    float bins = Cells().x;
    float most = 0.0;
    for (float i = 0.0; i < bins; i += 1.0)
        most = max(most, tex2Dlod(Counts, float4((i + 0.5) / bins, uv.y, 0.0, 0.0)).r);
    return most > 0.0 ? tex2D(Counts, uv).r / most : 0.0;
}

float4 Draw(float2 uv : TEXCOORD0) : COLOR
{
    float4 picture = tex2D(Picture, uv);
    float height = (1.0 - uv.y) / Height;
    bool is_bar = height < tex2D(Bars, uv).r;
    float4 histogram = float4(is_bar ? BarColor : PaperColor, 1.0);
    return height < 1.0 ? histogram : picture;
}

technique Histogram
{
    pass Strips
    {
        ZEnable = false;
        PixelShader = compile ps_3_0 CountStrip();
    }
    pass Counts
    {
        ZEnable = false;
        PixelShader = compile ps_3_0 AddStrips();
    }
    pass Bars
    {
        ZEnable = false;
        PixelShader = compile ps_3_0 DivideByFullest();
    }
    pass Picture
    {
        ZEnable = false;
        PixelShader = compile ps_3_0 Draw();
    }
}
