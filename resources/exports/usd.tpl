{"textures": [
    {"key": "color", "file": "{{name}}_color.png", "channels": ["color_r", "color_g", "color_b", "opacity"], "srgb": true},
    {"key": "normal", "file": "{{name}}_normal.png", "channels": ["normal_x", "normal_y", "normal_z"]},
    {"key": "roughness_map", "file": "{{name}}_roughness.png", "channels": ["roughness"]},
    {"key": "metallic_map", "file": "{{name}}_metallic.png", "channels": ["metallic"]},
    {"key": "occlusion", "file": "{{name}}_occlusion.png", "channels": ["ao"]},
    {"key": "emission_map", "file": "{{name}}_emission.png", "channels": ["emission_r", "emission_g", "emission_b"], "srgb": true},
    {"key": "height", "file": "{{name}}_height.png", "channels": ["height"], "bits": 16}
]}
=== {{name}}.usda
#usda 1.0
(
    defaultPrim = "{{identifier}}"
    doc = "{{title}}, written by Relievo {{version}}"
    metersPerUnit = 1
    upAxis = "Y"
)

def Material "{{identifier}}"
{
    token outputs:surface.connect = </{{identifier}}/Surface.outputs:surface>
    {{#height}}
    token outputs:displacement.connect = </{{identifier}}/Surface.outputs:displacement>
    {{/height}}

    def Shader "Surface"
    {
        uniform token info:id = "UsdPreviewSurface"
        {{#color}}
        color3f inputs:diffuseColor.connect = </{{identifier}}/Color.outputs:rgb>
        {{/color}}
        {{^color}}
        color3f inputs:diffuseColor = ({{colorR}}, {{colorG}}, {{colorB}})
        {{/color}}
        {{#opacityMap}}
        float inputs:opacity.connect = </{{identifier}}/Color.outputs:a>
        float inputs:opacityThreshold = 0.5
        {{/opacityMap}}
        {{#roughness_map}}
        float inputs:roughness.connect = </{{identifier}}/Roughness.outputs:r>
        {{/roughness_map}}
        {{^roughness_map}}
        float inputs:roughness = {{roughness}}
        {{/roughness_map}}
        {{#metallic_map}}
        float inputs:metallic.connect = </{{identifier}}/Metallic.outputs:r>
        {{/metallic_map}}
        {{^metallic_map}}
        float inputs:metallic = {{metallic}}
        {{/metallic_map}}
        {{#occlusion}}
        float inputs:occlusion.connect = </{{identifier}}/Occlusion.outputs:r>
        {{/occlusion}}
        {{#normal}}
        normal3f inputs:normal.connect = </{{identifier}}/Normal.outputs:rgb>
        {{/normal}}
        {{#emissive}}
        color3f inputs:emissiveColor.connect = </{{identifier}}/Emission.outputs:rgb>
        {{/emissive}}
        {{#height}}
        float inputs:displacement.connect = </{{identifier}}/Height.outputs:r>
        {{/height}}
        token outputs:surface
        token outputs:displacement
    }

    def Shader "Uv"
    {
        uniform token info:id = "UsdPrimvarReader_float2"
        string inputs:varname = "st"
        float2 outputs:result
    }

    def Shader "Place"
    {
        uniform token info:id = "UsdTransform2d"
        float2 inputs:in.connect = </{{identifier}}/Uv.outputs:result>
        float2 inputs:scale = ({{tiling}}, {{tiling}})
        float inputs:rotation = {{rotationDegreesUp}}
        float2 inputs:translation = ({{offsetUUp}}, {{offsetVUp}})
        float2 outputs:result
    }

        {{#color}}
        def Shader "Color"
        {
            uniform token info:id = "UsdUVTexture"
            asset inputs:file = @{{color.file}}@
            float2 inputs:st.connect = </{{identifier}}/Place.outputs:result>
            token inputs:wrapS = "{{#repeat}}repeat{{/repeat}}{{^repeat}}clamp{{/repeat}}"
            token inputs:wrapT = "{{#repeat}}repeat{{/repeat}}{{^repeat}}clamp{{/repeat}}"
            token inputs:sourceColorSpace = "sRGB"
            float4 inputs:scale = ({{tintR}}, {{tintG}}, {{tintB}}, 1)
            float outputs:a
            float3 outputs:rgb
        }
        {{/color}}

        {{#normal}}
        def Shader "Normal"
        {
            uniform token info:id = "UsdUVTexture"
            asset inputs:file = @{{normal.file}}@
            float2 inputs:st.connect = </{{identifier}}/Place.outputs:result>
            token inputs:wrapS = "{{#repeat}}repeat{{/repeat}}{{^repeat}}clamp{{/repeat}}"
            token inputs:wrapT = "{{#repeat}}repeat{{/repeat}}{{^repeat}}clamp{{/repeat}}"
            token inputs:sourceColorSpace = "raw"
            float4 inputs:scale = (2, 2, 2, 1)
            float4 inputs:bias = (-1, -1, -1, 0)
            float3 outputs:rgb
        }
        {{/normal}}

        {{#roughness_map}}
        def Shader "Roughness"
        {
            uniform token info:id = "UsdUVTexture"
            asset inputs:file = @{{roughness_map.file}}@
            float2 inputs:st.connect = </{{identifier}}/Place.outputs:result>
            token inputs:wrapS = "{{#repeat}}repeat{{/repeat}}{{^repeat}}clamp{{/repeat}}"
            token inputs:wrapT = "{{#repeat}}repeat{{/repeat}}{{^repeat}}clamp{{/repeat}}"
            token inputs:sourceColorSpace = "raw"
            float4 inputs:scale = ({{roughness}}, {{roughness}}, {{roughness}}, 1)
            float outputs:r
        }
        {{/roughness_map}}

        {{#metallic_map}}
        def Shader "Metallic"
        {
            uniform token info:id = "UsdUVTexture"
            asset inputs:file = @{{metallic_map.file}}@
            float2 inputs:st.connect = </{{identifier}}/Place.outputs:result>
            token inputs:wrapS = "{{#repeat}}repeat{{/repeat}}{{^repeat}}clamp{{/repeat}}"
            token inputs:wrapT = "{{#repeat}}repeat{{/repeat}}{{^repeat}}clamp{{/repeat}}"
            token inputs:sourceColorSpace = "raw"
            float4 inputs:scale = ({{metallic}}, {{metallic}}, {{metallic}}, 1)
            float outputs:r
        }
        {{/metallic_map}}

        {{#occlusion}}
        def Shader "Occlusion"
        {
            uniform token info:id = "UsdUVTexture"
            asset inputs:file = @{{occlusion.file}}@
            float2 inputs:st.connect = </{{identifier}}/Place.outputs:result>
            token inputs:wrapS = "{{#repeat}}repeat{{/repeat}}{{^repeat}}clamp{{/repeat}}"
            token inputs:wrapT = "{{#repeat}}repeat{{/repeat}}{{^repeat}}clamp{{/repeat}}"
            token inputs:sourceColorSpace = "raw"
            float outputs:r
        }
        {{/occlusion}}

        {{#emission_map}}
        def Shader "Emission"
        {
            uniform token info:id = "UsdUVTexture"
            asset inputs:file = @{{emission_map.file}}@
            float2 inputs:st.connect = </{{identifier}}/Place.outputs:result>
            token inputs:wrapS = "{{#repeat}}repeat{{/repeat}}{{^repeat}}clamp{{/repeat}}"
            token inputs:wrapT = "{{#repeat}}repeat{{/repeat}}{{^repeat}}clamp{{/repeat}}"
            token inputs:sourceColorSpace = "sRGB"
            float4 inputs:scale = ({{emission}}, {{emission}}, {{emission}}, 1)
            float3 outputs:rgb
        }
        {{/emission_map}}

        {{#height}}
        def Shader "Height"
        {
            uniform token info:id = "UsdUVTexture"
            asset inputs:file = @{{height.file}}@
            float2 inputs:st.connect = </{{identifier}}/Place.outputs:result>
            token inputs:wrapS = "{{#repeat}}repeat{{/repeat}}{{^repeat}}clamp{{/repeat}}"
            token inputs:wrapT = "{{#repeat}}repeat{{/repeat}}{{^repeat}}clamp{{/repeat}}"
            token inputs:sourceColorSpace = "raw"
            float4 inputs:scale = ({{number}}, {{number}}, {{number}}, 1)
            float4 inputs:bias = ({{biasMetres}}, {{biasMetres}}, {{biasMetres}}, 0)
            float outputs:r
        }
        {{/height}}
}
