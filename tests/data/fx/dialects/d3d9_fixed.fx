// SPDX-License-Identifier: Apache-2.0
// The fixed pipeline alone: transforms, a light, a material, a texture.
texture g_MeshTexture;
float4x4 g_mWorld : WORLD;
float4x4 g_mView : VIEW;
float4x4 g_mProj : PROJECTION;
float4 MatDiffuse = { 1, 0.9, 0.8, 1 };
float4 LightDirection = { 0.3, -0.8, -0.6, 0 };
technique T
{
    pass P0
    {
        VertexShader = NULL;
        PixelShader = NULL;
        WorldTransform[0] = <g_mWorld>;
        ViewTransform = <g_mView>;
        ProjectionTransform = <g_mProj>;
        Lighting = TRUE;
        SpecularEnable = TRUE;
        NormalizeNormals = true;
        Ambient = 0xff404040;
        MaterialDiffuse = <MatDiffuse>;
        MaterialAmbient = (MatDiffuse * 0.5);
        MaterialSpecular = float4(1, 1, 1, 1);
        MaterialPower = 24;
        LightEnable[0] = TRUE;
        LightType[0] = DIRECTIONAL;
        LightDirection[0] = <LightDirection>;
        LightDiffuse[0] = float4(1, 1, 1, 1);
        LightSpecular[0] = {0.6, 0.6, 0.6, 1};
        Texture[0] = <g_MeshTexture>;
        MinFilter[0] = Linear; MagFilter[0] = Linear; MipFilter[0] = Linear;
        ColorOp[0] = Modulate; ColorArg1[0] = Texture; ColorArg2[0] = Diffuse;
        AlphaOp[0] = SelectArg1; AlphaArg1[0] = Diffuse;
        ColorOp[1] = Disable;
        AlphaOp[1] = Disable;
    }
}
