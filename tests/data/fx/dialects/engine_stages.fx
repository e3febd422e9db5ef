// SPDX-License-Identifier: Apache-2.0
// A vertex shader and texture stages; the last pass puts states back.
float4x4 mWVP;
float4x4 mWorld;
float3 vEye;
float3 vLightDir;
texture tBase;
sampler2D smpBase = sampler_state { Texture = (tBase); MinFilter = Linear; MagFilter = Linear; MipFilter = Linear; AddressU = Wrap; AddressV = Wrap; };
struct SInput { float4 pos : POSITION; float3 normal : NORMAL; float2 uv : TEXCOORD0; };
struct SOutput { float4 pos : POSITION; float2 uv : TEXCOORD0; float4 color : COLOR0; };
SOutput vsMain( SInput i ) { SOutput o; o.pos = mul( i.pos, mWVP ); float3 n = mul( i.normal, (float3x3)mWorld ); o.color = 0.3 + saturate( dot( n, -vLightDir ) ) * 0.7; o.uv = i.uv; return o; }
technique tecPS20 {
	pass P0 {
		VertexShader = compile vs_1_1 vsMain();
		PixelShader = NULL;
		Sampler[0] = (smpBase);
		ColorOp[0] = Modulate2x;
		ColorArg1[0] = Texture;
		ColorArg2[0] = Diffuse;
		AlphaOp[0] = SelectArg1;
		AlphaArg1[0] = Texture;
		ColorOp[1] = Disable;
		AlphaOp[1] = Disable;
		FVF = Xyz | Normal | Tex1;
	}
	pass PLast { 
		FogEnable = False;
		VertexShader = NULL; PixelShader = NULL;
		Sampler[0] = NULL;
	}
}
