// SPDX-License-Identifier: Apache-2.0
// A print of the picture: more contrast, dilated outlines, and tones by a screen of lines or dots.
//
// Figure 6 of the paper on the G2-buffer. Pass 0 stretches the contrast of the intensity, pass 1 marks the Roberts cross
// edges of the tones and of what covers the paper, pass 2 broadens them and screens the tones so that on average the paper
// keeps each tone. Technique Lines is the default, technique Dots has diamonds.
//
// Parameters: Period and Angle of the screen; Contrast about the middle and Brightness; EdgeThreshold (2: no outlines);
// InkColor and PaperColor.

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
    float2 upperLeft  = float2(tex2D(Tone, uv).r, tex2D(Alpha, uv).a);
    float2 upperRight = float2(tex2D(Tone, uv + TexelSize.xw).r, tex2D(Alpha, uv + TexelSize.xw).a);
    float2 lowerLeft  = float2(tex2D(Tone, uv + TexelSize.wy).r, tex2D(Alpha, uv + TexelSize.wy).a);
    float2 lowerRight = float2(tex2D(Tone, uv + TexelSize.xy).r, tex2D(Alpha, uv + TexelSize.xy).a);
    float2 weight = abs(upperLeft - lowerRight) + abs(upperRight - lowerLeft);
    return max(weight.x, weight.y) > EdgeThreshold ? 0.0 : 1.0;
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

// A pixel covers a stretch of the screen, `width` of its measure, so that paper's share of it is a ramp about the threshold.
float Ramp(float threshold, float place, float width)
{
    return saturate((threshold - place) / width + 0.5);
}

// The thresholds below make the ramp's mean over a period the tone: near black and white, where part of the ramp falls off
// the end of the measure, they differ from what a screen without ramps would need.
float LineThreshold(float tone, float width)
{
    return tone < 0.5 * width ? sqrt(2.0 * width * tone) - 0.5 * width : tone;
}

// Of a diamond, whose area is twice the square of its radius.
float DotThreshold(float tone, float width)
{
    return tone < 0.66667 * width * width ? pow(1.5 * width * tone, 0.33333) - 0.5 * width
                                          : sqrt(0.5 * max(tone - width * width / 6.0, 0.0));
}

float4 Print(float2 uv, float paper)
{
    return float4(lerp(InkColor, PaperColor, min(paper, DarkestAround(uv))), 1.0);
}

float4 ScreenLines(float2 uv : TEXCOORD0) : COLOR
{
    float tone = tex2D(Tone, uv).r;
    float width = 2.0 / Period;
    float threshold = tone < 0.5 ? LineThreshold(tone, width) : 1.0 - LineThreshold(1.0 - tone, width);
    return Print(uv, Ramp(threshold, Triangle(ScreenPlace(uv)).y, width));
}

float4 ScreenDots(float2 uv : TEXCOORD0) : COLOR
{
    // Diamonds of paper up to the middle tone, of ink beyond it; 0 in the middle of the one, 1 in that of the other.
    float2 t = Triangle(ScreenPlace(uv));
    float tone = tex2D(Tone, uv).r;
    float width = 1.41421 / Period;
    float threshold = tone < 0.5 ? DotThreshold(tone, width) : 1.0 - DotThreshold(1.0 - tone, width);
    return Print(uv, Ramp(threshold, 0.5 * (t.x + t.y), width));
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
