// SPDX-License-Identifier: Apache-2.0
// Another machine's asm inside a function.
sampler2D S;
float4 f(float2 uv)
{
    float4 r;
#ifndef NOASM
    asm { tfetch2D r, uv, S, MagFilter=point, MinFilter=point, OffsetX=-0.5 };
    asm
    {
        tfetch2D r.x___, uv, S
    };
    [isolate] { r += 1; }
#endif
    return r;
}
float4 P(float2 t : TEXCOORD0) : COLOR { return f(t); }
float4 Q(float2 t : TEXCOORD0) : COLOR { return tex2D(S, t); }
technique a { pass p { PixelShader = compile ps_3_0 P(); } }
technique b { pass p { PixelShader = compile ps_3_0 Q(); } }
