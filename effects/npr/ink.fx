// SPDX-License-Identifier: Apache-2.0
// Pen and wash: object-space outlines and creases in ink over a few soft tones of colour.
//
// The lines come from the scene's own edges (attributes edgedist and edges), not from differences between pixels: they are
// exact to a fraction of a pixel and hold still while things move. Pass 0: where an edge is near, the distance's gradient
// leads to its nearest point, and the classes there say how wide the line is. Outlines grow outwards, and more on the side
// that is turned from the light; creases and the borders of materials keep one width. Pass 1 draws.
//
// Parameters: OutlineWidth, CreaseWidth and MaterialWidth in pixels, 0: none; Weight, how much heavier outlines get away
// from LightAngle; Tones and Wash, how strong they are; InkColor and PaperColor.

float OutlineWidth <
    string UIName = "Outlines";
    string units = "pixels";
    float UIMin = 0.0;
    float UIMax = 12.0;
    float UIStep = 0.1;
> = 3.0;

float CreaseWidth <
    string UIName = "Creases";
    string units = "pixels";
    float UIMin = 0.0;
    float UIMax = 12.0;
    float UIStep = 0.1;
> = 1.2;

float MaterialWidth <
    string UIName = "Borders of materials";
    string units = "pixels";
    float UIMin = 0.0;
    float UIMax = 12.0;
    float UIStep = 0.1;
> = 1.2;

float Weight <
    string UIName = "Heavier in the shade";
    float UIMin = 0.0;
    float UIMax = 1.0;
    float UIStep = 0.05;
> = 0.4;

float LightAngle <
    string UIName = "Light comes from";
    string units = "degrees, 0: the right, 90: above";
    float UIMin = -180.0;
    float UIMax = 180.0;
    float UIStep = 5.0;
> = 120.0;

float Tones <
    string UIName = "Tones";
    float UIMin = 1.0;
    float UIMax = 16.0;
    float UIStep = 1.0;
> = 4.0;

float Wash <
    string UIName = "Wash";
    float UIMin = 0.0;
    float UIMax = 1.0;
    float UIStep = 0.05;
> = 0.65;

float3 InkColor <
    string UIName = "Ink";
    string UIWidget = "Color";
> = {0.1, 0.09, 0.13};

float3 PaperColor <
    string UIName = "Paper";
    string UIWidget = "Color";
> = {0.98, 0.96, 0.91};

float4 TexelSize;

texture GBAcolor_A8R8G8B8;
texture GBAedgedist_R32F;
texture GBAedges_A8R8G8B8;
texture PASS0_A16B16G16R16F;

sampler Picture = sampler_state
{
    Texture = <GBAcolor_A8R8G8B8>;
    AddressU = CLAMP;
    AddressV = CLAMP;
};
sampler Distance = sampler_state
{
    Texture = <GBAedgedist_R32F>;
    AddressU = CLAMP;
    AddressV = CLAMP;
};
sampler Classes = sampler_state
{
    Texture = <GBAedges_A8R8G8B8>;
    AddressU = CLAMP;
    AddressV = CLAMP;
    MinFilter = LINEAR;
    MagFilter = LINEAR;
};
sampler Lines = sampler_state
{
    Texture = <PASS0_A16B16G16R16F>;
    AddressU = CLAMP;
    AddressV = CLAMP;
};

// In steps of equal height with soft risers.
float Step(float tone)
{
    float place = saturate(tone) * Tones;
    float below = min(floor(place), Tones - 1.0);
    return (below + smoothstep(0.3, 0.7, place - below)) / Tones;
}

float3 Tone(float2 uv)
{
    float4 picture = tex2D(Picture, uv);
    float tone = dot(picture.rgb, float3(0.2126, 0.7152, 0.0722));
    float3 stepped = picture.rgb * (Step(tone) / max(tone, 0.01));
    return PaperColor * lerp(1.0, saturate(stepped), Wash * picture.a);
}

float DistanceAt(float2 uv)
{
    return clamp(tex2D(Distance, uv).r, -16.0, 16.0);
}

// How much of a pixel a line covers whose border is `beyond` pixels nearer to the edge than the pixel's centre.
float Covered(float beyond, float width)
{
    return saturate(min(0.5 - beyond, width));
}

// Off the surface an outline has all of its width but what it takes on it, which is as much as a crease takes: so creases
// run into outlines without a step.
float CoveredByOutline(float signedDistance, float2 outwards)
{
    float s, c;
    sincos(radians(LightAngle), s, c);
    float width = OutlineWidth * (1.0 - Weight * dot(outwards, float2(c, -s)));
    float onSurface = 0.5 * min(CreaseWidth > 0.0 ? CreaseWidth : 1.0, width);
    return Covered(signedDistance < 0.0 ? -signedDistance - onSurface : signedDistance - (width - onSurface), width);
}

float Reach()
{
    return 0.5 + max(OutlineWidth * (1.0 + Weight), 0.5 * max(CreaseWidth, MaterialWidth));
}

// xy: the direction off the surface of the outline that is nearest, 0 without one; z: signed distance; w: coverage by the
// nearest edge's line.
float4 FindLines(float2 uv : TEXCOORD0) : COLOR
{
    float nearest = DistanceAt(uv);
    if (abs(nearest) > Reach())
        return float4(0.0, 0.0, nearest, 0.0);

    float2 horizontal = float2(DistanceAt(uv - TexelSize.xw), DistanceAt(uv + TexelSize.xw));
    float2 vertical = float2(DistanceAt(uv - TexelSize.wy), DistanceAt(uv + TexelSize.wy));
    float2 slope = 0.5 * float2(abs(horizontal.y) - abs(horizontal.x), abs(vertical.y) - abs(vertical.x));
    float2 away = dot(slope, slope) > 0.01 ? normalize(slope) : 0.0;
    float4 classes = tex2D(Classes, uv - abs(nearest) * away * TexelSize.xy);
    // Creases that all but touch an outline are part of it.
    if (max(classes.r, classes.b) < 0.5 * max(classes.g, classes.a))
    {
        float width = classes.g >= classes.a ? CreaseWidth : MaterialWidth;
        return float4(0.0, 0.0, nearest, Covered(abs(nearest) - 0.5 * width, width));
    }

    // On the edge itself the distance has a kink, the signed distance none.
    if (abs(nearest) < 1.0)
        slope = 0.5 * float2(horizontal.y - horizontal.x, vertical.y - vertical.x);
    else if (nearest < 0.0)
        slope = -slope;
    float steepness = length(slope);
    float2 outwards = steepness > 0.1 ? slope / steepness : 0.0;
    float coverage = CoveredByOutline(nearest, outwards);
    // Distances change by a pixel a pixel, unless several edges mix.
    return float4(abs(steepness - 1.0) < 0.15 ? outwards : 0.0, nearest, coverage);
}

// Where two lines meet, each pixel has the nearer one, which cuts notches into the broader: the outlines of the pixels
// around are followed to here.
float Ink(float2 uv)
{
    float4 here = tex2D(Lines, uv);
    float ink = here.w;
    if (abs(here.z) > Reach())
        return ink;
    for (int y = -1; y <= 1; ++y)
    {
        for (int x = -1; x <= 1; ++x)
        {
            float2 offset = float2(x, y);
            float4 there = tex2D(Lines, uv + offset * TexelSize.xy);
            float aside = abs(offset.x * there.y - offset.y * there.x);
            float followed = CoveredByOutline(there.z - dot(offset, there.xy), there.xy) * saturate(1.5 - aside);
            ink = max(ink, dot(there.xy, there.xy) > 0.5 ? followed : 0.0);
        }
    }
    return ink;
}

float4 Draw(float2 uv : TEXCOORD0) : COLOR
{
    return float4(lerp(Tone(uv), InkColor, Ink(uv)), 1.0);
}

technique PenAndWash
{
    pass Lines
    {
        PixelShader = compile ps_3_0 FindLines();
    }
    pass Draw
    {
        PixelShader = compile ps_3_0 Draw();
    }
}
