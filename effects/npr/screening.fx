// SPDX-License-Identifier: Apache-2.0
// A print of the picture: more contrast, dilated outlines, and tones by a screen of lines or dots.
//
// Figure 6 of the paper on the G2-buffer. Pass 0 stretches the contrast of the intensity, pass 1 marks its Roberts cross
// edges, pass 2 broadens them and screens the tones. Each screen's threshold is spread evenly over 0 to 1, so that the ink's
// share of the paper is the tone's. Technique Lines is the default, technique Dots has diamonds.
//
// Parameters: Period and Angle of the screen; Contrast about the middle and Brightness; EdgeThreshold (1 or more: no
// outlines); InkColor and PaperColor.

float Period <
    string UIName = "Period";
    string units = "pixels";
    float UIMin = 2.0;
    float UIMax = 64.0;
    float UIStep = 0.5;
> = 7.0;

float Angle <
    string UIName = "Angle";
    string units = "degrees";
    float UIMin = -180.0;
    float UIMax = 180.0;
    float UIStep = 1.0;
> = 45.0;

float Contrast <
    string UIName = "Contrast";
    float UIMin = 0.0;
    float UIMax = 8.0;
    float UIStep = 0.05;
> = 1.5;

float Brightness <
    string UIName = "Brightness";
    float UIMin = -1.0;
    float UIMax = 1.0;
    float UIStep = 0.01;
> = 0.1;

float EdgeThreshold <
    string UIName = "Edge threshold";
    float UIMin = 0.0;
    float UIMax = 2.0;
    float UIStep = 0.005;
> = 0.2;

float3 InkColor <
    string UIName = "Ink";
    string UIWidget = "Color";
> = {0.0, 0.0, 0.0};

float3 PaperColor <
    string UIName = "Paper";
    string UIWidget = "Color";
> = {1.0, 1.0, 1.0};

float4 TexelSize;
float2 FrameSize;

texture GBAintensity_L16;
texture GBAalpha_A8;
texture PASS0_L16;
texture PASS1_L8;

sampler Intensity = sampler_state
{
    Texture = <GBAintensity_L16>;
    AddressU = CLAMP;
    AddressV = CLAMP;
};
sampler Alpha = sampler_state
{
    Texture = <GBAalpha_A8>;
    AddressU = CLAMP;
    AddressV = CLAMP;
};
sampler Tone = sampler_state
{
    Texture = <PASS0_L16>;
    AddressU = CLAMP;
    AddressV = CLAMP;
};
sampler Edges = sampler_state
{
    Texture = <PASS1_L8>;
    AddressU = CLAMP;
    AddressV = CLAMP;
};

float4 StretchContrast(float2 uv : TEXCOORD0) : COLOR
{
    float tone = saturate((tex2D(Intensity, uv).r - 0.5) * Contrast + 0.5 + Brightness);
    // What no object covers is bare paper.
    return lerp(1.0, tone, tex2D(Alpha, uv).a);
}

float4 MarkEdges(float2 uv : TEXCOORD0) : COLOR
{
    float weight = abs(tex2D(Tone, uv).r - tex2D(Tone, uv + TexelSize.xy).r)
                 + abs(tex2D(Tone, uv + TexelSize.xw).r - tex2D(Tone, uv + TexelSize.wy).r);
    return weight > EdgeThreshold ? 0.0 : 1.0;
}

float DarkestAround(float2 uv)
{
    float darkest = 1.0;
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x)
            darkest = min(darkest, tex2D(Edges, uv + float2(x, y) * TexelSize.xy).r);
    return darkest;
}

// The place in the screen, in periods.
float2 ScreenPlace(float2 uv)
{
    float s, c;
    sincos(radians(Angle), s, c);
    float2 pixel = uv * FrameSize;
    return float2(c * pixel.x + s * pixel.y, c * pixel.y - s * pixel.x) / Period;
}

// 0 in the middle of a period, 1 at its borders, and every value between equally often.
float2 Triangle(float2 place)
{
    return abs(2.0 * frac(place) - 1.0);
}

// Paper's share of a pixel where the screen's threshold is `threshold` and changes by `slope` from pixel to pixel.
float Screen(float tone, float threshold, float slope)
{
    // Past both ends by half a pixel's change, so that black and white stay pure.
    float stretched = lerp(-0.5 * slope, 1.0 + 0.5 * slope, tone);
    return saturate((stretched - threshold) / slope + 0.5);
}

float4 Print(float2 uv, float paper)
{
    return float4(lerp(InkColor, PaperColor, min(paper, DarkestAround(uv))), 1.0);
}

float4 ScreenLines(float2 uv : TEXCOORD0) : COLOR
{
    float threshold = Triangle(ScreenPlace(uv)).y;
    return Print(uv, Screen(tex2D(Tone, uv).r, threshold, 2.0 / Period));
}

float4 ScreenDots(float2 uv : TEXCOORD0) : COLOR
{
    // The distance from the dot's middle, measured as diamonds, and its cumulative distribution over the period.
    float2 t = Triangle(ScreenPlace(uv));
    float d = 0.5 * (t.x + t.y);
    float threshold = d < 0.5 ? 2.0 * d * d : 1.0 - 2.0 * (1.0 - d) * (1.0 - d);
    float slope = 4.0 * min(d, 1.0 - d) * 1.41421 / Period;
    return Print(uv, Screen(tex2D(Tone, uv).r, threshold, max(slope, 0.01)));
}

technique Lines
{
    pass Contrast { PixelShader = compile ps_2_0 StretchContrast(); }
    pass Edges    { PixelShader = compile ps_2_0 MarkEdges(); }
    pass Screen   { PixelShader = compile ps_3_0 ScreenLines(); }
}

technique Dots
{
    pass Contrast { PixelShader = compile ps_2_0 StretchContrast(); }
    pass Edges    { PixelShader = compile ps_2_0 MarkEdges(); }
    pass Screen   { PixelShader = compile ps_3_0 ScreenDots(); }
}
