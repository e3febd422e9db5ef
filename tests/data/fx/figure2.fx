// SPDX-License-Identifier: Apache-2.0
// The G2-buffer paper's figure 2 written out: edge detection, then dilation.

// texel size, set by the framework
float4 TexelSize;

// constants
float edgeThreshold = 0.09f;
float dilateThreshold = 9.0f;

// declaration of a G-buffer "intensity"
Texture GBAintensity_A8R8G8B8;
// pass-result texture for pass 0
Texture PASS0_A8R8G8B8;

struct VS_EDGE_OUT
{
    float4 Pos  : POSITION;
    float2 Tex0 : TEXCOORD0;
    float2 Tex1 : TEXCOORD1;
    float2 Tex2 : TEXCOORD2;
};

VS_EDGE_OUT VSEdgeFilter(
    float3 Pos  : POSITION,
    float2 Tex0 : TEXCOORD0,
    float2 Tex1 : TEXCOORD1)
{
    VS_EDGE_OUT Out;
    Out.Pos.xyz = Pos;
    Out.Pos.w = 1.0f;
    Out.Tex0 = Tex0;
    float2 lowerTexels = Tex0 - TexelSize.wy;
    Out.Tex1 = lowerTexels - TexelSize.xw;
    Out.Tex2 = lowerTexels + TexelSize.xw;
    return Out;
}

sampler objInt = sampler_state
{
    texture = <GBAintensity_A8R8G8B8>;
    AddressU = WRAP;
    AddressV = WRAP;
    MIPFILTER = POINT;
    MINFILTER = POINT;
};

float4 PSEdgeFilter(VS_EDGE_OUT In) : COLOR
{
    float4 centerTexel = tex2D(objInt, In.Tex0);
    float4 lowLeftTexel = tex2D(objInt, In.Tex1);
    float4 lowRightTexel = tex2D(objInt, In.Tex2);
    float4 objColor;
    float edgeWeight = abs(centerTexel.x - lowLeftTexel.x)
                     + abs(centerTexel.x - lowRightTexel.x);
    float4 edgeColor = 1.0f;
    if (edgeWeight > edgeThreshold)
        edgeColor = 0.0f;
    return edgeColor;
}

struct VS_DILATE_OUT
{
    float4 Pos  : POSITION;
    float2 Tex0 : TEXCOORD0;
    float4 Tex1 : TEXCOORD1;
    float4 Tex2 : TEXCOORD2;
    float4 Tex3 : TEXCOORD3;
    float4 Tex4 : TEXCOORD4;
};

VS_DILATE_OUT VSDilate(
    float3 Pos  : POSITION,
    float2 Tex0 : TEXCOORD0,
    float2 Tex1 : TEXCOORD1)
{
    VS_DILATE_OUT Out;
    Out.Pos.xyz = Pos;
    Out.Pos.w = 1.0f;
    Out.Tex0 = Tex0;
    Out.Tex1.xy = Tex0 + TexelSize.xw;
    Out.Tex1.zw = Tex0 - TexelSize.xw;
    Out.Tex2.xy = Tex0 + TexelSize.wy;
    Out.Tex2.zw = Tex0 - TexelSize.wy;
    Out.Tex3.xy = Tex0 + TexelSize.xy;
    Out.Tex3.zw = Tex0 - TexelSize.xy;
    Out.Tex4.xy = Tex0 - TexelSize.xw + TexelSize.wy;
    Out.Tex4.zw = Tex0 + TexelSize.xw - TexelSize.wy;
    return Out;
}

sampler edge = sampler_state
{
    texture = <PASS0_A8R8G8B8>;
    AddressU = CLAMP;
    AddressV = CLAMP;
    MIPFILTER = POINT;
    MINFILTER = POINT;
};

float4 PSDilate(VS_DILATE_OUT In) : COLOR
{
    // the 3x3 block of texels
    float4 centerTexel = tex2D(edge, In.Tex0);
    float4 leftTexel = tex2D(edge, In.Tex1.xy);
    float4 rightTexel = tex2D(edge, In.Tex1.zw);
    float4 upperTexel = tex2D(edge, In.Tex2.xy);
    float4 lowerTexel = tex2D(edge, In.Tex2.zw);
    float4 upperLeftTexel = tex2D(edge, In.Tex3.xy);
    float4 upperRightTexel = tex2D(edge, In.Tex3.zw);
    float4 lowerLeftTexel = tex2D(edge, In.Tex4.xy);
    float4 lowerRightTexel = tex2D(edge, In.Tex4.zw);
    float dilateWeight = centerTexel + leftTexel
        + rightTexel + upperTexel + lowerTexel
        + upperLeftTexel + upperRightTexel
        + lowerLeftTexel + lowerRightTexel;
    float dilateEdgeColor = 1.0f;
    if (dilateWeight < dilateThreshold)
        dilateEdgeColor = 0.0f;
    return dilateEdgeColor;
}

technique T0
{
    pass P0
    {
        VertexShader = compile vs_1_1 VSEdgeFilter();
        PixelShader = compile ps_2_0 PSEdgeFilter();
    }
    pass P1
    {
        VertexShader = compile vs_1_1 VSDilate();
        PixelShader = compile ps_2_0 PSDilate();
    }
}
