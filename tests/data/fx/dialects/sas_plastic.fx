// SPDX-License-Identifier: Apache-2.0
// An object effect: the scene's geometry with a lamp, a texture of FX Composer's library and a highlight.
float Script : STANDARDSGLOBAL <
    string UIWidget = "none";
    string ScriptClass = "object";
    string ScriptOrder = "standard";
    string ScriptOutput = "color";
    string Script = "Technique=Technique?Main:Main10;";
> = 0.8;

float4x4 WorldITXf : WorldInverseTranspose < string UIWidget = "None"; >;
float4x4 WvpXf : WorldViewProjection < string UIWidget = "None"; >;
float4x4 WorldXf : World < string UIWidget = "None"; >;
float4x4 ViewIXf : ViewInverse < string UIWidget = "None"; >;

float3 Lamp0Pos : POSITION < string Object = "PointLight0"; string UIName = "Lamp 0 Position"; string Space = "World"; >
    = { -0.5f, 2.0f, 1.25f };
float3 Lamp0Color : SPECULAR < string UIName = "Lamp 0"; string Object = "Pointlight0"; string UIWidget = "Color"; >
    = { 1.0f, 1.0f, 1.0f };
float3 AmbiColor : AMBIENT < string UIName = "Ambient Light"; string UIWidget = "Color"; > = { 0.07f, 0.07f, 0.09f };
float3 SurfaceColor : DIFFUSE < string UIName = "Surface"; string UIWidget = "Color"; > = { 0.3f, 0.6f, 0.9f };
float SpecExpon : SpecularPower < string UIWidget = "slider"; float UIMin = 1; float UIMax = 128; float UIStep = 1; > = 40;

texture ColorTexture : DIFFUSE < string ResourceName = "default_color.dds"; string ResourceType = "2D"; >;
sampler2D ColorSampler = sampler_state {
    Texture = <ColorTexture>;
    MinFilter = Linear; MipFilter = Linear; MagFilter = Linear;
    AddressU = Wrap; AddressV = Wrap;
};

struct appdata { float3 Position : POSITION; float4 UV : TEXCOORD0; float4 Normal : NORMAL; };
struct vertexOutput {
    float4 HPosition : POSITION;
    float2 UV : TEXCOORD0;
    float3 LightVec : TEXCOORD1;
    float3 WorldNormal : TEXCOORD2;
    float3 WorldView : TEXCOORD5;
};

vertexOutput std_VS(appdata IN)
{
    vertexOutput OUT = (vertexOutput)0;
    OUT.WorldNormal = mul(IN.Normal, WorldITXf).xyz;
    float4 Po = float4(IN.Position.xyz, 1);
    float3 Pw = mul(Po, WorldXf).xyz;
    OUT.LightVec = Lamp0Pos - Pw;
    OUT.UV = IN.UV.xy;
    OUT.WorldView = normalize(ViewIXf[3].xyz - Pw);
    OUT.HPosition = mul(Po, WvpXf);
    return OUT;
}

float4 std_PS(vertexOutput IN) : COLOR
{
    float3 Nn = normalize(IN.WorldNormal);
    float3 Ln = normalize(IN.LightVec);
    float3 Hn = normalize(Ln + normalize(IN.WorldView));
    float4 litV = lit(dot(Ln, Nn), dot(Hn, Nn), SpecExpon);
    float3 diffuse = AmbiColor + litV.y * Lamp0Color;
    return float4(diffuse * SurfaceColor * tex2D(ColorSampler, IN.UV).rgb + 0.5 * litV.z * Lamp0Color, 1);
}

technique Main < string Script = "Pass=p0;"; > {
    pass p0 < string Script = "Draw=geometry;"; > {
        VertexShader = compile vs_2_0 std_VS();
        ZEnable = true;
        ZWriteEnable = true;
        ZFunc = LessEqual;
        AlphaBlendEnable = false;
        CullMode = None;
        PixelShader = compile ps_2_a std_PS();
    }
}
