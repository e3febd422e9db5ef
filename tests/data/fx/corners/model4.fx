// SPDX-License-Identifier: Apache-2.0
// Textures and samplers of shader model 4 beside those of model 3.
#if OPENGL
    #define SV_POSITION POSITION
    #define VERTEX_MODEL vs_3_0
    #define PIXEL_MODEL ps_3_0
#else
    #define VERTEX_MODEL vs_4_0_level_9_1
    #define PIXEL_MODEL ps_4_0_level_9_1
#endif
Texture2D Picture;
sampler2D PictureSampler = sampler_state { Texture = <Picture>; };
matrix WorldViewProjection;
cbuffer Extra { float2 Size; float3 Pad : packoffset(c1.x); }
SamplerState Lin { Filter = MIN_MAG_LINEAR_MIP_POINT; AddressU = Clamp; };
Texture2D<float4> Other : register(t1);
TextureCube Cube; Texture3D Vol; Texture2DArray Arr; Texture2D<float> Single;
struct Between { float4 Position : SV_POSITION; float4 Color : COLOR0;
    float2 Place : TEXCOORD0; };
Between VS(float4 Position : POSITION0, float4 Color : COLOR0, float2 Place : TEXCOORD0)
{ Between o; o.Position = mul(Position, WorldViewProjection); o.Color = Color;
    o.Place = Place; return o; }
float4 Mixed(Between input) : COLOR
{
    float4 c = tex2D(PictureSampler,input.Place) * input.Color;
    c += Other.Sample(Lin, input.Place) + Other.SampleLevel(Lin, input.Place,
    0) + Other.SampleBias(Lin, input.Place, 1).bgra;
    c.rgb += Cube.Sample(Lin, input.Color.xyz).rgb + Vol.Sample(Lin, input.Color.xyz).xyz;
    c += Single.Sample(Lin, input.Place);
    return c;
}
float4 Unused(Between input) : SV_Target { float w, h; Other.GetDimensions(w, h);
    return Other.Load(int3(input.Place * Size, 0)) + Arr.Sample(Lin, float3(input.Place, w / h)) + Other.Gather(Lin, input.Place); }
technique Pictures { pass P0 { VertexShader = compile VERTEX_MODEL VS();
    PixelShader = compile PIXEL_MODEL Mixed(); } };
