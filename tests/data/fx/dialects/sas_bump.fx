// SPDX-License-Identifier: Apache-2.0
// Bumps and reflections, with the textures that FX Composer puts in for all that the user has not chosen.
float Script : STANDARDSGLOBAL <
    string ScriptClass = "object";
    string ScriptOrder = "standard";
    string ScriptOutput = "color";
    string Script = "Technique=Bumps;";
> = 0.8;

float4x4 WorldITXf : WorldInverseTranspose < string UIWidget = "None"; >;
float4x4 WvpXf : WorldViewProjection < string UIWidget = "None"; >;
float4x4 WorldXf : World < string UIWidget = "None"; >;
float4x4 ViewIXf : ViewInverse < string UIWidget = "None"; >;
float3 LampPos : POSITION < string Object = "PointLight0"; string Space = "World"; > = { -0.5, 2, 1.25 };
float Height < string UIWidget = "slider"; float UIMin = 0; float UIMax = 3; float UIStep = 0.01; > = 1;
float Gloss < string UIWidget = "slider"; float UIMin = 0; float UIMax = 1; float UIStep = 0.01; > = 0.4;

texture ColorTexture : DIFFUSE < string ResourceName = "default_color.dds"; string ResourceType = "2D"; >;
texture BumpTexture < string ResourceName = "default_bump_normal.dds"; string ResourceType = "2D"; >;
texture EnvTexture : ENVIRONMENT < string ResourceName = "default_reflection.dds"; string ResourceType = "Cube"; >;
sampler2D ColorSampler = sampler_state { Texture = <ColorTexture>; MinFilter = Linear; MipFilter = Linear; MagFilter = Linear; };
sampler2D BumpSampler = sampler_state { Texture = <BumpTexture>; MinFilter = Linear; MipFilter = Linear; MagFilter = Linear; };
samplerCUBE EnvSampler = sampler_state { Texture = <EnvTexture>; MinFilter = Linear; MipFilter = Linear; MagFilter = Linear; };

struct Corner
{
    float3 Position : POSITION;
    float4 UV : TEXCOORD0;
    float4 Normal : NORMAL;
    float4 Tangent : TANGENT0;
    float4 Binormal : BINORMAL0;
};
struct Point
{
    float4 HPosition : POSITION;
    float2 UV : TEXCOORD0;
    float3 ToLamp : TEXCOORD1;
    float3 Normal : TEXCOORD2;
    float3 Tangent : TEXCOORD3;
    float3 Binormal : TEXCOORD4;
    float3 ToEye : TEXCOORD5;
};

Point BumpVS(Corner c)
{
    Point o = (Point)0;
    float4 place = float4(c.Position, 1);
    float3 world = mul(place, WorldXf).xyz;
    o.HPosition = mul(place, WvpXf);
    o.UV = c.UV.xy;
    o.Normal = mul(c.Normal, WorldITXf).xyz;
    o.Tangent = mul(c.Tangent, WorldITXf).xyz;
    o.Binormal = mul(c.Binormal, WorldITXf).xyz;
    o.ToLamp = LampPos - world;
    o.ToEye = ViewIXf[3].xyz - world;
    return o;
}

float4 BumpPS(Point i) : COLOR
{
    float2 slope = Height * (tex2D(BumpSampler, i.UV).xy - 0.5);
    float3 n = normalize(normalize(i.Normal) + slope.x * normalize(i.Tangent) + slope.y * normalize(i.Binormal));
    float3 v = normalize(i.ToEye);
    float light = saturate(dot(n, normalize(i.ToLamp)));
    float3 mirrored = texCUBE(EnvSampler, reflect(-v, n)).rgb;
    return float4(tex2D(ColorSampler, i.UV).rgb * (0.1 + light) + Gloss * mirrored * pow(1 - saturate(dot(n, v)), 2), 1);
}

technique Bumps < string Script = "Pass=p0;"; >
{
    pass p0 < string Script = "Draw=geometry;"; >
    {
        VertexShader = compile vs_2_0 BumpVS();
        ZEnable = true;
        ZWriteEnable = true;
        ZFunc = LessEqual;
        AlphaBlendEnable = false;
        CullMode = None;
        PixelShader = compile ps_2_a BumpPS();
    }
}
