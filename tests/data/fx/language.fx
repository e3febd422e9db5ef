// SPDX-License-Identifier: Apache-2.0
// Statements, expressions, conversions and declarations, for their GLSL to be validated.

float4x4 WorldViewProjection : WorldViewProjection;
float4x4 World : World;
float3x3 Rotation = { 1, 0, 0, 0, 1, 0, 0, 0, 1 };
float4x3 Bones[4];
float2x4 Wide;
int2x2 Whole = { 1, 2, 3, 4 };
bool Switch = true;
bool4 Switches = { true, false, true, false };
int Count = 3;
half4 Tint = half4(1, 0.5h, 0.25, 1);
float weights[5] = { 0.1, 0.2, 0.4, 0.2, 0.1 };
float written;                       // a parameter that a shader writes to
const float kConst = 2.5;
static const float kTable[4] = { 0.25f, 0.5f, 0.75f, 1.f };
static const float3 kLuma = float3(0.299, 0.587, 0.114);
static float counter = 1;
static float derived = sqrt(kConst) * counter;
typedef float4 Vec;
typedef struct { float3 a; float b; } Pair;

struct Light
{
    float3 position;
    float3 sample;                   // a word that GLSL reserves
    float range;
    bool on;
};
Light Lights[2] = { { 1, 2, 3, 0, 0, 0, 10, true }, { 4, 5, 6, 0, 0, 0, 20, false } };

struct Empty { };

struct VSIn  { float4 position : POSITION; float3 normal : NORMAL; float2 uv : TEXCOORD0; int4 bones : BLENDINDICES; };
struct VSOut { float4 position : POSITION0; float4 color : COLOR0; float2 uv : TEXCOORD0; float3 normal : TEXCOORD1; float3x3 frame : TEXCOORD2; };

void Twice(inout float x, out float2 both, in float y) { x *= 2; both.x = x; both.y = y; }
void WriteInt(out int i) { i = 7; }
float Pick(float a) { return a; }
float Pick(float2 a) { return a.x + a.y; }
float Pick(int a) { return a * 0.5; }
float Later(float x, float scale = 2.0);
float2 Nested(float2 v) { return Pick(v).xx + Later(v.x); }
float Later(float x, float scale) { return x * scale; }

VSOut VS(VSIn input, uniform float bias, uniform bool flip)
{
    VSOut o = (VSOut)0;
    o.position = mul(input.position, WorldViewProjection);
    o.normal = mul(input.normal, (float3x3)World);
    o.color.rgb = mul(float4(input.normal, 1), Bones[input.bones.x]);
    o.color.a = bias;
    o.uv = input.uv;
    if (flip) o.uv.y = 1 - o.uv.y;
    o.frame = Rotation;
    return o;
}

float4 Operators(float4 v, float2 uv)
{
    float4 r = 0;
    r += v * 2 - v / 3 + v % 0.5;
    r -= -v + +v;
    r *= 2;
    r /= v.x;
    r.xy += uv;
    r.zw = uv.yx;
    r = r.wzyx;
    r.x++; ++r.y; r.z--; --r.w;
    int i = 7 / 2;
    i += 1; i %= 3; i <<= 1; i |= 4; i ^= 1; i = ~i & 0xff;
    uint u = 5u;
    i = i > 2 && r.x < 1 || !Switch ? i : -i;
    bool4 less = v < r;
    bool both = any(less) && all(v == r);
    r = less ? v : r;
    r = (v > 0.5 && r < 0.5) ? 1 : r;
    r = Switches ? r : v;
    r.x = both + i;
    r.y = true;
    r *= !less;
    float s = v;                     // truncation
    r = s;
    r.xyz = s.xxx;
    float t = (s, 2.0);
    int2 n = int2(uv * 3);
    n = n / int2(2, 0) + n % 2;
    r.xy += n;
    float one = 1.0, two = one.x;
    float1 lone = two;
    r.x += lone.x + lone;
    return r + float4(i, u, t, two);
}

float4 Matrices(float4 v)
{
    float4x4 m = World;
    m[1] = v;
    m[2][3] = 5;
    m._m00 = 1;
    m._m01_m10 = v.xy;
    m._11_22_33 = 1;
    m._m02_m12 += v.zw;
    m[0].yz = v.xy;
    m *= 2;
    m = m * World;
    m = m + 1;
    m /= World;
    float3x3 r = (float3x3)m;
    float3 d = r._m00_m11_m22;
    r = transpose(r);
    float2x4 w = Wide;
    float4x2 tw = transpose(w);
    float2 p = mul(w, v);
    float4 q = mul(p, w);
    q += mul(mul(w, tw), p).xyxy;
    float2x2 sq = mul(w, tw);
    q.x += determinant(sq) + determinant(r);
    float4 all4 = (float4)sq;
    float2x2 back = float2x2(all4);
    sq = float2x2(1, 2, 3, 4);
    sq = float2x2(p, q.xy);
    float4x4 rows = float4x4(v, q, v, q);
    float1x4 row = float1x4(1, 2, 3, 4);
    float4x1 column = float4x1(1, 2, 3, 4);
    q += mul(row, rows);
    q += mul(rows, column);
    q.x += mul(row, column);
    rows = mul(column, row);
    row[0] = v;
    column[2] = 3;
    row._m03 = 2;
    column._m20 = 4;
    int2x2 whole = Whole;
    whole[0][1] = 9.7;
    whole = whole / 2;
    whole._m00_m11 = int2(3, 4);
    int element = whole[1][0];
    q += whole[0].xyxy * element;
    bool2x2 compared = sq > 1;
    if (all(compared) || any(sq)) q += 1;
    q += abs(sq)[0].xyxy + saturate(rows)[2] + lerp(m, rows, 0.5)[1] + min(m, 1)[0];
    q += d.xyzx + mul(2, m)[1] + mul(v, 0.5);
    for (int i = 0; i < 4; i++) q += m[i] * rows[i][i];
    float3 truncated = mul(v, r);
    return q + truncated.xyzz + rows._m00_m01_m02_m03;
}

float4 Flow(float4 v)
{
    float4 r = v;
    for (int i = 0; i < Count; ++i) { if (i == 2) continue; r += kTable[i] * weights[i]; }
    for (int i = 0; i < 4; i++) r.x += i;
    r.y += i;                        // the loop's variable outlives it
    [unroll] for (int j = 0, k = 3; j < k; j++, k--) r[j] += k;
    int n = 0;
    while (n < 3) { n++; if (n == 2) break; }
    do { n--; } while (n > 0);
    [branch] if (r.x > 1) r = 1; else if (r.y > 1) { r = 2; } else r = 3;
    switch (n) { case 0: r.x = 1; break; case 1: case 2: r.x = 2; break; default: r.x = 3; }
    { float r2 = 1; { float r2 = 2; r.z += r2; } r.w += r2; }
    float scratch[3];
    scratch[n] = 1;
    float grid[2][3] = { 1, 2, 3, 4, 5, 6 };
    grid[1][n] += 1;
    float undefined;
    r.x += undefined + scratch[1] + grid[0][2];
    if (r.w < 0) discard;
    counter += 1;
    written = written + 1;
    return r * counter + derived + written;
}

float4 Structs(float4 v)
{
    Pair p = { v.xyz, 1 };
    Pair z = (Pair)0;
    Pair c = p;
    c.a.xy = z.a.yz;
    Pair list[2] = { { 1, 2, 3, 4 }, { v.xyz, v.w } };
    list[1].a = p.a;
    list[(int)v.x].b += 2;
    Light l = Lights[1];
    l.sample = Lights[0].position;
    Empty e;
    Vec total = float4(l.sample, l.on ? l.range : 0);
    float4 flat = { v.xy, 1, 2 };
    float4 asVector = (float4)p;
    float numbers[4] = (float[4])v;
    return total + flat + asVector + c.b + list[0].b + numbers[3];
}

float4 Calls(float4 v)
{
    float x = v.x;
    float2 both;
    Twice(x, both, 3);
    Twice(v.y, v.zw, x);
    Twice(v[1], v.xy, 1);
    int i = 3;
    Twice(v.x, both, i);
    float f;
    WriteInt(f);
    WriteInt(v.z);
    float4x4 m = World;
    Twice(m._m00, m._m01_m10, 1);
    Twice(m[1][2], both, 1);
    float s, c;
    sincos(v.x, s, c);
    float3 s3, c3;
    sincos(v.xyz, s3, c3);
    float whole;
    float part = modf(v.x, whole);
    float e;
    float man = frexp(v.y, e);
    int ie;
    man += frexp(v.y, ie);
    return v + Pick(x) + Pick(v.xy) + Pick(2) + Nested(v.xy).xyxy + s + c + s3.x + part + whole + man * e + f + m[0] + Later(1);
}

float4 PS(VSOut input, float2 vpos : VPOS, float face : VFACE, uniform int mode) : COLOR0
{
    float4 r = Operators(input.color, input.uv) + Matrices(input.color);
    r += Flow(r) + Structs(r) + Calls(r) + Tint;
    r.xyz = mul(r.xyz, input.frame);
    return mode > 1 ? r * face : r + vpos.xyxy * dot(r.rgb, kLuma);
}

technique Main
{
    pass P0
    {
        VertexShader = compile vs_3_0 VS(0.5, true);
        PixelShader = compile ps_3_0 PS(2);
        AlphaTestEnable = true;
        AlphaFunc = Greater;
        AlphaRef = 0x80;
        AlphaBlendEnable = TRUE;
        SrcBlend = SrcAlpha;
        DestBlend = InvSrcAlpha;
        CullMode = None;
        ColorWriteEnable = RED | GREEN | blue;
        ZEnable = <Switch>;
        StencilRef = (Count + 1);
        DepthBias = 0.5;
    }
}
