// SPDX-License-Identifier: Apache-2.0
// Black outlines on white: Roberts cross edges of the intensity, broadened by dilation.
//
// Figure 3 of the paper on the G2-buffer. Pass 0 marks a texel black where the Roberts cross exceeds EdgeThreshold; pass 1
// draws black wherever at least one of the 3x3 texels around is black. Unlike the paper's listing (roberts_paper.fx), this
// takes both diagonals of the 2x2 block, and edges do not wrap round the picture's border.
//
// Parameters: EdgeThreshold is the smallest difference of intensity that counts as an edge; InkColor and PaperColor.

float EdgeThreshold <
    string UIName = "Edge threshold";
    float UIMin = 0.0;
    float UIMax = 1.0;
    float UIStep = 0.005;
> = 0.09;

float3 InkColor <
    string UIName = "Ink";
    string UIWidget = "Color";
> = {0.0, 0.0, 0.0};

float3 PaperColor <
    string UIName = "Paper";
    string UIWidget = "Color";
> = {1.0, 1.0, 1.0};

float4 TexelSize;

texture GBAintensity_L8;
texture PASS0_L8;

sampler Intensity = sampler_state
{
    Texture = <GBAintensity_L8>;
    AddressU = CLAMP;
    AddressV = CLAMP;
    MinFilter = POINT;
    MagFilter = POINT;
};

sampler Edges = sampler_state
{
    Texture = <PASS0_L8>;
    AddressU = CLAMP;
    AddressV = CLAMP;
    MinFilter = POINT;
    MagFilter = POINT;
};

float4 MarkEdges(float2 uv : TEXCOORD0) : COLOR
{
    float upperLeft  = tex2D(Intensity, uv).r;
    float upperRight = tex2D(Intensity, uv + TexelSize.xw).r;
    float lowerLeft  = tex2D(Intensity, uv + TexelSize.wy).r;
    float lowerRight = tex2D(Intensity, uv + TexelSize.xy).r;
    float weight = abs(upperLeft - lowerRight) + abs(upperRight - lowerLeft);
    return weight > EdgeThreshold ? 0.0 : 1.0;
}

float4 Dilate(float2 uv : TEXCOORD0) : COLOR
{
    float darkest = 1.0;
    for (int y = -1; y <= 1; ++y)
    {
        for (int x = -1; x <= 1; ++x)
        {
            darkest = min(darkest, tex2D(Edges, uv + float2(x, y) * TexelSize.xy).r);
        }
    }
    return float4(lerp(InkColor, PaperColor, darkest), 1.0);
}

technique DilatedEdges
{
    pass Mark
    {
        PixelShader = compile ps_2_0 MarkEdges();
    }
    pass Dilate
    {
        PixelShader = compile ps_2_0 Dilate();
    }
}
