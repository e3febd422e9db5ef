// SPDX-License-Identifier: Apache-2.0
float g : STANDARDSGLOBAL < string Script = "Technique=?::T:;"; string ScriptClass = "scene"; > = 0.8;
texture a : RENDERCOLORTARGET < float2 ViewPortRatio = { -1, 1e30 }; int2 Dimensions = { 0, -5 }; string Format = ""; >;
texture b : RENDERCOLORTARGET < int Width = 2147483647; int Height = 1; >;
float4 PS() : COLOR { return g; }
technique T < string Script = "=;==;Pass;Pass=;RenderColorTarget=a;RenderColorTarget7=b;RenderColorTarget8=b;Draw;Clear;ClearSetColor;"; >
{ pass P < string Script = "Draw=;Draw=Buffer;LoopEnd=;"; > { PixelShader = compile ps_3_0 PS(); } pass { } }
technique U < string Script = ""; > { }
