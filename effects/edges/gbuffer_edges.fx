// SPDX-License-Identifier: Apache-2.0
// Outlines of a scene from its geometry: where objects, depth or normals change abruptly.
//
// After Saito and Takahashi, "Comprehensible rendering of 3-D shapes" (1990), section 3: silhouettes from discontinuities of
// depth, creases from those of the normal, and the borders between objects from their ids. Of the depth it takes the second
// difference of the reciprocal, which is even over every plane in perspective, so that slanting planes draw no lines near or
// far. Textures and shadows draw none either, which the picture's own edges (sobel.fx) would.
//
// Parameters: DepthThreshold, relative; CreaseAngle in degrees; Thickness in pixels; ColorAmount, from 0 (paper) to 1 (the
// shaded scene); InkColor and PaperColor.

float DepthThreshold <
    string UIName = "Depth threshold";
    float UIMin = 0.0;
    float UIMax = 0.5;
    float UIStep = 0.001;
> = 0.02;

float CreaseAngle <
    string UIName = "Crease angle";
    string units = "degrees";
    float UIMin = 1.0;
    float UIMax = 180.0;
    float UIStep = 1.0;
> = 30.0;

float Thickness <
    string UIName = "Thickness";
    string units = "pixels";
    float UIMin = 1.0;
    float UIMax = 4.0;
    float UIStep = 0.5;
> = 1.0;

float ColorAmount <
    string UIName = "Colour";
    float UIMin = 0.0;
    float UIMax = 1.0;
    float UIStep = 0.05;
> = 0.7;

float3 InkColor <
    string UIName = "Ink";
    string UIWidget = "Color";
> = {0.05, 0.05, 0.1};

float3 PaperColor <
    string UIName = "Paper";
    string UIWidget = "Color";
> = {1.0, 1.0, 1.0};

float4 TexelSize;

texture GBAcolor_A8R8G8B8;
texture GBAdepth_R32F;
texture GBAnormal_A16B16G16R16F;
texture GBAobjectid_R32F;

sampler Color = sampler_state
{
    Texture = <GBAcolor_A8R8G8B8>;
    AddressU = CLAMP;
    AddressV = CLAMP;
};
sampler Depth = sampler_state
{
    Texture = <GBAdepth_R32F>;
    AddressU = CLAMP;
    AddressV = CLAMP;
};
sampler Normal = sampler_state
{
    Texture = <GBAnormal_A16B16G16R16F>;
    AddressU = CLAMP;
    AddressV = CLAMP;
};
sampler ObjectId = sampler_state
{
    Texture = <GBAobjectid_R32F>;
    AddressU = CLAMP;
    AddressV = CLAMP;
};

// One axis through the centre: 1 where a line belongs.
float EdgeAlong(float2 uv, float2 across)
{
    float idBefore = tex2D(ObjectId, uv - across).r;
    float idAfter = tex2D(ObjectId, uv + across).r;
    float border = idBefore != idAfter;

    float centre = tex2D(Depth, uv).r;
    float bend = abs(centre / tex2D(Depth, uv - across).r + centre / tex2D(Depth, uv + across).r - 2.0);
    float silhouette = bend > DepthThreshold;

    float3 normalBefore = tex2D(Normal, uv - across).xyz;
    float3 normalAfter = tex2D(Normal, uv + across).xyz;
    float crease = dot(normalBefore, normalAfter) < cos(radians(CreaseAngle));

    // The background has no normal; its border is the objects' affair. At the picture's own border a neighbour is missing.
    bool drawn = idBefore > 0.0 && idAfter > 0.0;
    bool inside = all(abs(uv - 0.5) + abs(across) < 0.5);
    return max(border, drawn && inside ? max(silhouette, crease) : 0.0);
}

float4 Outline(float2 uv : TEXCOORD0) : COLOR
{
    float2 reach = 0.5 * (Thickness + 1.0) * TexelSize.xy;
    float edge = EdgeAlong(uv, float2(reach.x, 0.0));
    edge = max(edge, EdgeAlong(uv, float2(0.0, reach.y)));
    edge = max(edge, EdgeAlong(uv, reach * 0.70711));
    edge = max(edge, EdgeAlong(uv, float2(reach.x, -reach.y) * 0.70711));

    float4 shaded = tex2D(Color, uv);
    float3 ground = lerp(PaperColor, shaded.rgb, ColorAmount * shaded.a);
    return float4(lerp(ground, InkColor, edge), 1.0);
}

technique Outlines
{
    pass P0
    {
        PixelShader = compile ps_3_0 Outline();
    }
}
