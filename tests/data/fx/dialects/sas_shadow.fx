// SPDX-License-Identifier: Apache-2.0
// A shadow map: the first pass sees the scene through RenderPort, the second by the camera.
float Script : STANDARDSGLOBAL <
    string UIWidget = "none";
    string ScriptClass = "sceneorobject";
    string ScriptOrder = "standard";
    string ScriptOutput = "color";
    string Script = "Technique=Main;";
> = 0.8;

float4 ClearColor < string UIWidget = "Color"; > = { 0.1, 0.1, 0.15, 1 };
float4 FarColor = { 1, 1, 1, 1 };
float ClearDepth < string UIWidget = "None"; > = 1.0;
float4x4 WorldXf : World;
float4x4 WorldITXf : WorldInverseTranspose;
float4x4 VpXf : ViewProjection;
float4x4 LampViewXf : View < string Object = "SpotLight0"; >;
float4x4 LampProjXf : Projection < string frustum = "light0"; >;
float3 LampPos : POSITION < string Object = "SpotLight0"; string Space = "World"; > = { -1, 2, 1 };
float3 SurfColor : DIFFUSE = { 0.9, 0.8, 0.6 };
float Bias < float UIMin = 0; float UIMax = 0.1; > = 0.004;

texture ShadMap : RENDERCOLORTARGET < float2 Dimensions = { 512, 512 }; string Format = "R32F"; >;
sampler ShadSampler = sampler_state { texture = <ShadMap>; AddressU = Clamp; AddressV = Clamp; };
texture ShadDepth : RENDERDEPTHSTENCILTARGET < float2 Dimensions = { 512, 512 }; string Format = "D24S8"; >;

struct Cast { float4 p : POSITION; float4 z : TEXCOORD0; };

Cast CastVS(float3 p : POSITION)
{
    Cast o;
    o.p = mul(mul(float4(p, 1), WorldXf), VpXf);
    o.z = o.p;
    return o;
}
float4 CastPS(Cast i) : COLOR { return float4((i.z.z / i.z.w).xxx, 1); }

struct Use { float4 p : POSITION; float3 n : TEXCOORD0; float3 l : TEXCOORD1; float4 lp : TEXCOORD2; };

Use UseVS(float3 p : POSITION, float4 n : NORMAL)
{
    Use o;
    float4 w = mul(float4(p, 1), WorldXf);
    o.p = mul(w, VpXf);
    o.n = mul(n, WorldITXf).xyz;
    o.l = LampPos - w.xyz;
    o.lp = mul(mul(w, LampViewXf), LampProjXf);
    return o;
}
float4 UsePS(Use i) : COLOR
{
    float2 uv = float2(0.5, -0.5) * i.lp.xy / i.lp.w + 0.5;
    float lit = tex2D(ShadSampler, uv).x + Bias > i.lp.z / i.lp.w;
    return float4(SurfColor * (0.15 + lit * saturate(dot(normalize(i.n), normalize(i.l)))), 1);
}

technique Main < string Script = "Pass=MakeShadow; Pass=UseShadow;"; >
{
    pass MakeShadow <
        string Script =
            "RenderColorTarget0=ShadMap;"
            "RenderDepthStencilTarget=ShadDepth;"
            "RenderPort=SpotLight0;"
            "ClearSetColor=FarColor;"
            "ClearSetDepth=ClearDepth;"
            "Clear=Color;"
            "Clear=Depth;"
            "Draw=geometry;";
    >
    {
        VertexShader = compile vs_2_0 CastVS();
        CullMode = None;
        PixelShader = compile ps_2_0 CastPS();
    }
    pass UseShadow <
        string Script =
            "RenderColorTarget0=;"
            "RenderDepthStencilTarget=;"
            "RenderPort=;"
            "ClearSetColor=ClearColor;"
            "ClearSetDepth=ClearDepth;"
            "Clear=Color;"
            "Clear=Depth;"
            "Draw=geometry;";
    >
    {
        VertexShader = compile vs_2_0 UseVS();
        CullMode = None;
        PixelShader = compile ps_2_0 UsePS();
    }
}
