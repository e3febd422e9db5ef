// SPDX-License-Identifier: Apache-2.0
// States by name, number, parameter and expression; shader variables and arrays; state blocks.
int iv = 1; bool bv = true; float fv = 0.5; dword col = 0x80ff0000; float4 cv = {1,0,0,1}; texture tx; float4x4 mt;
    VertexShader vs0; PixelShader ps0 = NULL;
float4 V(float4 p : POSITION) : POSITION { return p; } float4 P() : COLOR { return 1; }
PixelShader psA[2] = { compile ps_2_0 P(), compile ps_3_0 P() }; VertexShader vsV = compile vs_2_0 V();
stateblock sb = stateblock_state { ZEnable = true; AlphaBlendEnable = false; VertexShader = compile vs_1_1 V(); };
technique T <string a = "x"; bool b = true; float3 c = {1,2,3}; int i = 3; string d[2] = { "a", "b" };;
    > { pass P <int x = 1;> { VertexShader = compile vs_2_0 V(); PixelShader = (psA[iv]); } }
technique T2 { pass p0 { ZEnable = 1; ZEnable = TRUE; ZEnable = True; ZEnable = USEW; zwriteenable = <bv>;
    ZFUNC = 4; ZFunc = (iv + 1); CullMode = <iv>; CULLMODE = (iv == 1 ? 2 : 3); FillMode = WireFrame;
    AlphaRef = 128; AlphaRef = 0x80; AlphaRef = (fv * 255); AlphaRef = 0.5; BlendFactor = <col>;
    BlendFactor = 0xffffffff; BlendFactor = (cv); BlendFactor = float4(1,1,1,1); TextureFactor = <cv>;
    TextureFactor = 0xff; ColorWriteEnable = 15; ColorWriteEnable = RED|GREEN|BLUE; ColorWriteEnable = Red | 4;
    ColorWriteEnable = 0x7; DepthBias = 0.001f; DepthBias = -1; SlopeScaleDepthBias = <fv>; SrcBlend = SRCALPHA;
    DestBlend = InvSrcAlpha; BlendOp = Add; StencilRef = <iv>; StencilMask = 0xFFFFFFFFu; StencilFail = KEEP;
    Clipping = true; FogColor = 0; FogColor = <cv>; FogStart = 0.0f; PointSize = 2.f; PointSpriteEnable = true;
    ScissorTestEnable = false; MultiSampleMask = 0xffffffff; Wrap0 = Coord0 | Coord1; SpecularEnable = false;
    Lighting = FALSE; Ambient = <col>; ShadeMode = GOURAUD; ClipPlaneEnable = 0; VertexShader = (vsV);
    PixelShader = compile ps_2_0 P(); } pass p1 { VertexShader = <vsV>; PixelShader = <psA[1]>; StateBlock = (sb);
    } pass p2 { VertexShader = vsV; PixelShader = psA[0]; WorldTransform[0] = <mt>; ViewTransform = (mt);
    ProjectionTransform = <mt>; } pass { vertexshader = NULL; PIXELSHADER = null; } pass P4 { VertexShader = 0;
    PixelShader = 0; } pass { } }
technique T3 { pass p0 { VertexShader = compile VS_2_0 V(); PixelShader = compile PS_2_0 P();
    } } TECHNIQUE T4 { PASS p0 { VERTEXSHADER = COMPILE vs_2_0 V(); PIXELSHADER = compile ps_2_sw P();
    } } technique { pass { PixelShader = compile ps_2_b P(); } }
