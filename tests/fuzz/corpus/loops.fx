// SPDX-License-Identifier: Apache-2.0
float n = 1e30; float4 PS() : COLOR { return n; }
technique T < string Script = "LoopByCount=n;LoopByCount=n;Pass=P;LoopEnd=;LoopByCount=;LoopGetIndex=n;LoopEnd;LoopEnd"; > { pass P { PixelShader = compile ps_3_0 PS(); } }
