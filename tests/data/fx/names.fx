// SPDX-License-Identifier: Apache-2.0
// Names that GLSL has taken, in every place where HLSL lets them stand.

float sample; float4 buffer; float patch = 1; float gl_Position; float texture2; float mix__two; float main;
static float smooth = 2; static const float varying[2] = { 1, 2 };
struct input { float4 output : POSITION; float2 attribute : TEXCOORD0; float highp : TEXCOORD1; };
struct active { float sample; float3 filter; };
active partition;
float4 subroutine(float4 coherent) { return coherent * smooth + varying[1]; }
float4 burin_saturate(float4 vec4x) { return vec4x; }
float4 texture3(float4 common) { return common + partition.filter.xyzz * partition.sample; }
input vec(float4 point : POSITION, float2 line : TEXCOORD0) { input flat = (input)0; flat.output = point; flat.attribute = line; return flat; }
float4 dFdx(input inp) : COLOR
{
    float4 readonly = subroutine(sample) + buffer + patch + gl_Position + texture2 + mix__two + main;
    float restrict = 1, noperspective = 2, sizeof1 = 3;
    active uvec2 = partition;
    return readonly + restrict * noperspective + burin_saturate(readonly) + texture3(readonly) + uvec2.sample + inp.highp;
}
technique technique1 { pass pass0 { VertexShader = compile vs_2_0 vec(); PixelShader = compile ps_2_0 dFdx(); } }
