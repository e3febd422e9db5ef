// SPDX-License-Identifier: Apache-2.0
// DXSAS 1.0: everything by SasBindAddress, lights as structs in an array.
int Global : SasGlobal < int3 SasVersion = { 1, 1, 0 }; >;
float4x4 World < string SasBindAddress = "Sas.Skeleton.MeshToJointToWorld[0]"; >;
float4x4 View < string SasBindAddress = "Sas.Camera.WorldToView"; >;
float4x4 Projection < string SasBindAddress = "Sas.Camera.Projection"; >;
int Count < string SasBindAddress = "Sas.NumDirectionalLights"; > = 0;

struct DirectionalLight { float3 Color; float3 Direction; };
DirectionalLight Lights[3] < string SasBindAddress = "Sas.DirectionalLight[*]"; >;
struct AmbientLight { float3 Color; };
AmbientLight Around < string SasBindAddress = "Sas.AmbientLight[0]"; >;

texture Skin < string SasUiLabel = "Skin"; >;
sampler SkinSampler = sampler_state { Texture = <Skin>; MinFilter = Linear; MagFilter = Linear; MipFilter = Linear; };

struct V { float4 p : POSITION; float2 uv : TEXCOORD0; float3 n : TEXCOORD1; };

V LightVS(float4 p : POSITION, float3 n : NORMAL, float2 uv : TEXCOORD0)
{
    V o;
    o.p = mul(mul(mul(p, World), View), Projection);
    o.n = mul(n, (float3x3)World);
    o.uv = uv;
    return o;
}

float4 LightPS(V i) : COLOR
{
    float3 sum = Around.Color;
    for (int k = 0; k < 3; k++)
    {
        if (k < Count) sum += 0.5 * Lights[k].Color * saturate(dot(normalize(i.n), -Lights[k].Direction));
    }
    return float4(sum * tex2D(SkinSampler, i.uv).rgb, 1);
}

technique Lit
{
    pass P0
    {
        VertexShader = compile vs_3_0 LightVS();
        PixelShader = compile ps_3_0 LightPS();
    }
}
