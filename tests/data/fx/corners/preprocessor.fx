// SPDX-License-Identifier: Apache-2.0
// Directives, macros over macros, techniques made by macros, an include named by a macro.
#define CAT(a,b) a##b
#define CAT2(a,b) CAT(a,b)
#define STR(x) #x
#define EMPTY
#define F(x) ((x)*(x))
#define G(x, y) F(x) + \
   F(y)
#define H() 3
#define ID(x) x
#define MULTI(a, b, c) float a = b; \
  /* comment */ float c = b; // trailing
#define DECL(type, name, ...) type name __VA_ARGS__
#if UNDEF
#error no
#endif
#if UNDEF == 0 && !defined(UNDEF) && !defined UNDEF && (1 ? 2 : 0) && 0x10 == 16 && 1L && (2 > 1) != 0
#else
#error no
#endif
#if defined ( CAT ) && defined CAT
#else
#error no
#endif
#ifndef CAT // comment
#error no
#endif /* c */
#ifdef CAT junk
#endif junk
#if 0
 it's an "unterminated here ' and #error
 #if 1
 #else
 #endif
#elif 1 /* multi
line comment */
float CAT(va,lue) = H();
#endif
#define VERSION 3
#if VERSION < 2
#elif VERSION < 4
 float ok;
#elif BROKEN(((
#endif
#undef NOTDEFINED
#undef H
#define H 4
#pragma warning(disable : 3206)
#pragma once
#pragma comment(lib)
#pragma def(vs_1_1, c0, 0, 0, 0, 0)
# define SPACED 1
  #  define SPACED2 2
#line 100 "other.fx"
#line 50
#
MULTI(aa, 2, cc)
DECL(float, dd, = 3);
DECL(float4, ee, [2] = { {1,2,3,4}, {5,6,7,8} });
string s = STR(hello world) " and " STR("q") "a" ("b") "c";
#define REC REC + 1
#define TEC(n) technique CAT2(T_, n) { pass P { PixelShader = compile ps_2_0 PS(n); } }
float4 PS(float2 t : TEXCOORD0, uniform int n) : COLOR {
  float q = F(
     t.x
     + 1
  ) EMPTY; q += G(1, 2); q += ID(F(ID(2))); q += CAT2(ID(va), lue); q += F((1,2)); q += CAT(1,2); q += H;
      q += SPACED + SPACED2;
  q += \
    3; q += ID ( 2 ); q += -ID(-1); float ID = 3; q += ID;
  return q + aa + cc + dd + ee[1] + n + __LINE__; }
TEC(1) TEC(2);
#define PASS(name, vs, ps) pass name { ps PixelShader = compile ps_2_0 vs; }
technique T3 { PASS(A, PS(3), ZEnable = FALSE; CullMode = NONE;) PASS(B, PS(4), ) }
#define INC "inner.fxh"
#include INC
#include "inner.fxh"
#include "INNER.FXH" // comment
