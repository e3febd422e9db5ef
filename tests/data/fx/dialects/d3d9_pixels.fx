// SPDX-License-Identifier: Apache-2.0
// Shader model 3: VPOS, VFACE, branches and matrix swizzles.
float4x4 Colors = { 1, 0, 0, 1,  0, 1, 0, 1,  0, 0, 1, 1,  1, 1, 1, 1 };

float4 Checks(float2 vpos : VPOS, float face : VFACE, uniform float size) : COLOR0
{
    float2 cell = floor(vpos / size);
    float odd = fmod(cell.x + cell.y, 2);
    float4 color = Colors[(int)fmod(cell.x, 4)];
    [branch] if (odd > 0.5) color.rgb *= 0.5;
    color.rgb += Colors._m03_m13_m23 * 0.1 * (face > 0);
    return saturate(color);
}

technique T { pass { PixelShader = compile ps_3_0 Checks(16.0f); } }
