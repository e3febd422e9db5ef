// SPDX-License-Identifier: Apache-2.0
// Conditions, pasted names, macros for textures, functions made by macros.
#define SCALE 1.0
#define LEVEL 2.5f
#if SCALE > 0
float ok1;
#endif
#if LEVEL >= 3
#error no
#elif LEVEL > 2.4
float ok2;
#endif
#ifndef FOO
float ok3;
#endif
#if defined FOO || defined(BAR) || !defined (BAZ)
float ok4;
#else if defined(X)
#error
#endif
#if (FOO + 1) * 2 == 2 && ~0 == -1 && (3 ^ 1) == 2 && 5 % 3 == 2 && 1 << 3 == 8
float ok5;
#endif
#define EMPTY()
#define CALL(f, x) f(x)
#define TWICE(x) x x
#define SEMI ;
#define NEST(a) CALL(SQ, a)
#define SQ(a) ((a)*(a))
#define LIST 1, 2, 3
#define APPLY(m, args) m args
#define STRINGIZE(x) STRINGIZE2(x)
#define STRINGIZE2(x) #x
#define JOIN(a, b) JOIN2(a, b)
#define JOIN2(a, b) a ## b
#define REGISTER(n) : register(s##n)
#define TEXTURE_2D(n, i) texture n##Map; sampler2D n REGISTER(i) = sampler_state { Texture = <n##Map>; }
TEXTURE_2D(Diffuse, 0);
TEXTURE_2D(Normal, 1) SEMI
float3 vv = { LIST };
string str = STRINGIZE(NEST(2)) STRINGIZE( "quoted \n" );
float JOIN(na, me) = NEST(3) EMPTY(); float JOIN(x, 1) = APPLY(SQ, (2)); float JOIN(,y) = 1; float JOIN(z,) = 2;
#undef SQ
#define SQ 3
float SQ2 = SQ;
#define FUNC(name, type) type name(type x) { \
    return x * (type)2;    \
}
FUNC(dbl, float) FUNC(dbl, float3)
#define UNUSED(...)
#define VARARG(fmt, ...) fmt(__VA_ARGS__)
UNUSED(a, b, c)
float4 PS(float2 t : TEXCOORD0) : COLOR { return VARARG(float4, t, 0, 1) * dbl(2) + dbl(vv).xyzz + tex2D(Diffuse,
    t) + tex2D(Normal, t) + name + x1 + y + z; }
technique T { pass P { PixelShader = compile ps_2_0 PS(); } }
#if 0
#bogus directive
#endif
#pragma
#line 5
