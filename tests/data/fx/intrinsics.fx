// SPDX-License-Identifier: Apache-2.0
// Every intrinsic in every form.

texture Picture;
texture Volume < string ResourceType = "3D"; >;
texture Around < string ResourceType = "Cube"; >;
texture1D Ramp;
sampler1D s1 = sampler_state { Texture = <Ramp>; };
sampler2D s2 = sampler_state { Texture = (Picture); MinFilter = Linear; MagFilter = LINEAR; MipFilter = None; AddressU = Mirror; BorderColor = 0xff8040; };
sampler3D s3 = sampler_state { Texture = <Volume>; Filter = MIN_MAG_LINEAR_MIP_POINT; };
sampler cube = sampler_state { Texture = <Around>; WrapS = ClampToEdge; };
sampler untyped;

float4 Lookups(float4 t)
{
    float4 r = tex1D(s1, t.x) + tex2D(s2, t.xy) + tex3D(s3, t.xyz) + texCUBE(cube, t.xyz) + texCUBE(untyped, t.xyz);
    r += tex1D(s1, t.x, ddx(t.x), ddy(t.x)) + tex2D(s2, t.xy, ddx(t.xy), ddy(t.xy)) + tex3D(s3, t.xyz, t.xyz, t.xyz) + texCUBE(cube, t.xyz, t.xyz, t.xyz);
    r += tex1Dbias(s1, t) + tex2Dbias(s2, t) + tex3Dbias(s3, t) + texCUBEbias(cube, t);
    r += tex1Dlod(s1, t) + tex2Dlod(s2, t) + tex3Dlod(s3, t) + texCUBElod(cube, t);
    r += tex1Dlod(s1, t * 2) + tex2Dlod(s2, t * 2) + tex3Dlod(s3, t * 2) + texCUBElod(cube, t * 2);
    r += tex1Dproj(s1, t) + tex2Dproj(s2, t) + tex3Dproj(s3, t) + texCUBEproj(cube, t);
    r += tex1Dgrad(s1, t.x, 0, 0) + tex2Dgrad(s2, t.xy, 0, 0) + tex3Dgrad(s3, t.xyz, 0, 0) + texCUBEgrad(cube, t.xyz, 0, 0);
    r += tex2D(s2, t);
    return r;
}

float4 Maths(float4 v, float3x3 m)
{
    float s = v.x;
    float2 d2 = v.xy;
    float3 d = v.xyz;
    int3 n = int3(d * 3);
    float4 r = abs(v) + acos(v) + asin(v) + atan(v) + atan2(v, v.yxwz) + ceil(v) + clamp(v, 0, 1) + cos(v) + cosh(v);
    r.x += abs(s) + acos(s) + atan2(s, 2) + clamp(s, s, 1) + pow(s, 2) + log(s) + log2(s) + log10(s) + rsqrt(s) + rcp(s) + sqrt(s);
    r.xyz += abs(n) + max(n, 1) + min(n, n.zyx) + clamp(n, 0, 5) + sign(n) + sign(d);
    r.xyz += cross(d, d.zyx) + normalize(d) + reflect(d, v) + refract(d, d.zyx, 0.9) + faceforward(d, d, d);
    r.xy += normalize(d2);
    r += degrees(v) + radians(v) + exp(v) + exp2(v) + floor(v) + fmod(v, 0.3) + frac(v);
    r += isfinite(v) + isinf(v) + isnan(v) + ldexp(v, 2) + lerp(v, 1, 0.5) + lerp(v, v.yxzw, v) + log(v) + log10(v) + log2(v);
    r += mad(v, 2, 1) + max(v, 0) + min(v, s) + pow(v, 2.2) + pow(abs(v), v) + rcp(v) + round(v) + rsqrt(v) + saturate(v);
    r += sin(v) + sinh(v) + smoothstep(0, 1, v) + sqrt(v) + step(0.5, v) + tan(v) + tanh(v) + trunc(v) + sign(v);
    r.x += smoothstep(0, 1, s) + saturate(s) + round(s) + fmod(s, 2) + ldexp(s, 3) + step(s, 1) + isfinite(s) + sign(s);
    r += distance(v, 1) + distance(s, 2) + dot(v, 1) + dot(s, s) + length(v) + length(d) + length(s) + normalize(s);
    r += lit(s, 0.5, 20) + dst(v, v) + D3DCOLORtoUBYTE4(v) + determinant(m) + transpose(m)[0].xyzx;
    r += noise(s) + noise(d2) + noise(d) + noise(v);
    r += all(v) + any(v) + all(s) + any(d > 0) + all(m) + any(m);
    r.xyz += sin(m)[1] + pow(m, 2)[2] + max(m, 0.5)[0] + sign(m)[1] + isnan(m)[0] + step(m, 1)[2] + fmod(m, 2)[0];
    float3x3 ms, mc;
    r += ddx(v) + ddy(s) + fwidth(d).xyzz;
    clip(s);
    clip(v - 0.5);
    clip(m);
    return r;
}

float4 VS(float4 p : POSITION, out float4 t : TEXCOORD0) : POSITION
{
    t = tex2D(s2, p.xy) + tex2Dbias(s2, p) + tex2Dproj(s2, p) + tex2Dlod(s2, p) + noise(p.xyz);
    return p;
}

float4 CgLookups(float4 t)
{
    float4 r = texRECT(s2, t.xy) + texRECTproj(s2, t);
    r += f4tex1D(s1, t.x) + f4tex2D(s2, t.xy) + f4tex2Dproj(s2, t) + f4tex3D(s3, t.xyz) + f4texCUBE(cube, t.xyz) + f4texRECT(s2, t.xy);
    r.xyz += f3tex1D(s1, t.x) + f3tex2D(s2, t.xy) + f3tex2Dproj(s2, t) + f3tex3D(s3, t.xyz) + f3texCUBE(cube, t.xyz) + f3texRECT(s2, t.xy);
    r.xy += f2tex1D(s1, t.x) + f2tex2D(s2, t.xy) + f2tex2Dproj(s2, t) + f2tex3D(s3, t.xyz) + f2texCUBE(cube, t.xyz) + f2texRECT(s2, t.xy);
    r.x += f1tex1D(s1, t.x) + f1tex2D(s2, t.xy) + f1tex2Dproj(s2, t) + f1tex3D(s3, t.xyz) + f1texCUBE(cube, t.xyz) + f1texRECT(s2, t.xy);
    r += h4tex1D(s1, t.x) + h4tex2D(s2, t.xy) + h4tex2Dproj(s2, t) + h4tex3D(s3, t.xyz) + h4texCUBE(cube, t.xyz) + h4texRECT(s2, t.xy);
    r.xyz += h3tex1D(s1, t.x) + h3tex2D(s2, t.xy) + h3tex2Dproj(s2, t) + h3tex3D(s3, t.xyz) + h3texCUBE(cube, t.xyz) + h3texRECT(s2, t.xy);
    r.xy += h2tex1D(s1, t.x) + h2tex2D(s2, t.xy) + h2tex2Dproj(s2, t) + h2tex3D(s3, t.xyz) + h2texCUBE(cube, t.xyz) + h2texRECT(s2, t.xy);
    r.x += h1tex1D(s1, t.x) + h1tex2D(s2, t.xy) + h1tex2Dproj(s2, t) + h1tex3D(s3, t.xyz) + h1texCUBE(cube, t.xyz) + h1texRECT(s2, t.xy);
    return r;
}

float4 Bits(float4 t)
{
    int4 i = asint(t);
    uint4 u = asuint(t) + asuint(i);
    return asfloat(i) + asfloat(u) + asfloat(t) + ddx_coarse(t) + ddx_fine(t) + ddy_coarse(t) + ddy_fine(t);
}

float4 PS(float4 t : TEXCOORD0) : COLOR { return CgLookups(t) + Bits(t) + Lookups(t) + Maths(t, float3x3(t.xyz, t.yzw, t.zwx)); }

technique T { pass { VertexShader = compile vs_3_0 VS(); PixelShader = compile ps_3_0 PS(); } }
