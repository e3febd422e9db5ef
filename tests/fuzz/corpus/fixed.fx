// SPDX-License-Identifier: Apache-2.0
texture t; texture c < string ResourceType = "Cube"; >; sampler s = sampler_state { Texture = <t>; };
samplerCUBE e = sampler_state { Texture = <c>; }; sampler r : register(s2); int i = 1; float4 k = { 1, 0, 0, 1 };
float4x4 m; float3 g_LightDir[3]; float4 A(float4 p : POSITION) : POSITION { return p; }
float4 P() : COLOR { return tex2D(r, 0.5) + dot(-g_LightDir[0], 1); }
PixelShader ps[2] = { compile ps_2_0 P(), NULL }; VertexShader vs[2] = { NULL, compile vs_2_0 A() };
technique T < string MMDPass = "object"; string Subset = "0-2,5-"; >
{
    pass { VertexShader = (vs[i]); PixelShader = (ps[1 - i]); }
    pass { WorldTransform[0] = <m>; WorldTransform[3] = <m>; Lighting = (i); LightEnable[7] = true; LightType[7] = Spot;
           LightDirection[7] = { 1, 2, 3 }; LightTheta[7] = 0.3; MaterialDiffuse = (k * 0.5); MaterialPower = <i>;
           Ambient = 0xff102030; TextureFactor = <k>; ColorOp[0] = Lerp; ColorArg0[0] = TFactor | Complement;
           ColorArg1[0] = Texture; ColorArg2[0] = Diffuse | AlphaReplicate; AlphaOp[0] = DotProduct3; ResultArg[0] = Temp;
           Sampler[0] = (s); Texture[1] = <c>; TexCoordIndex[1] = CameraSpaceReflectionVector | 1; ColorOp[1] = AddSmooth;
           TextureTransformFlags[1] = Count3 | Projected; TextureTransform[1] = <m>; MinFilter[1] = <i>; ColorOp[8] = Add;
           DiffuseMaterialSource = Color1; FogEnable = true; BumpEnvMat00[0] = 1; ColorOp[2] = Disable; }
    pass { Sampler[2] = (s); MinFilter[2] = Linear; PixelShader = compile ps_2_0 P(); }
}
