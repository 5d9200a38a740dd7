{"textures": [
    {"key": "color", "file": "{{name}}_color.png", "channels": ["color_r", "color_g", "color_b", "opacity"], "srgb": true},
    {"key": "normal", "file": "{{name}}_normal.png", "channels": ["normal_x", "normal_y", "normal_z"]},
    {"key": "metal_smooth", "file": "{{name}}_metallic_smoothness.png", "channels": ["metallic", "metallic", "metallic", "smoothness"]},
    {"key": "occlusion", "file": "{{name}}_occlusion.png", "channels": ["ao"]},
    {"key": "emission_map", "file": "{{name}}_emission.png", "channels": ["emission_r", "emission_g", "emission_b"], "srgb": true},
    {"key": "height", "file": "{{name}}_height.png", "channels": ["height"]}
]}
=== {{name}}.mat
%YAML 1.1
%TAG !u! tag:unity3d.com,2011:
--- !u!21 &2100000
Material:
  serializedVersion: 8
  m_ObjectHideFlags: 0
  m_Name: "{{title}}"
  m_Shader: {fileID: 4800000, guid: 933532a4fcc9baf4fa0491de14d08ed7, type: 3}
  m_ValidKeywords:
{{#opacityMap}}
  - _ALPHATEST_ON
{{/opacityMap}}
{{#emissive}}
  - _EMISSION
{{/emissive}}
{{#metal_smooth}}
  - _METALLICSPECGLOSSMAP
{{/metal_smooth}}
{{#normal}}
  - _NORMALMAP
{{/normal}}
{{#height}}
  - _PARALLAXMAP
{{/height}}
{{#occlusion}}
  - _OCCLUSIONMAP
{{/occlusion}}
  m_InvalidKeywords: []
  m_LightmapFlags: 4
  m_EnableInstancingVariants: 0
  m_DoubleSidedGI: 0
  m_CustomRenderQueue: -1
  stringTagMap: {}
  disabledShaderPasses: []
  m_SavedProperties:
    serializedVersion: 3
    m_TexEnvs:
    - _BaseMap:
        m_Texture: {{#color}}{fileID: 2800000, guid: {{color.guid}}, type: 3}{{/color}}{{^color}}{fileID: 0}{{/color}}
        m_Scale: {x: {{tiling}}, y: {{tiling}}}
        m_Offset: {x: {{offsetU}}, y: {{offsetVFlipped}}}
    - _BumpMap:
        m_Texture: {{#normal}}{fileID: 2800000, guid: {{normal.guid}}, type: 3}{{/normal}}{{^normal}}{fileID: 0}{{/normal}}
        m_Scale: {x: {{tiling}}, y: {{tiling}}}
        m_Offset: {x: {{offsetU}}, y: {{offsetVFlipped}}}
    - _EmissionMap:
        m_Texture: {{#emission_map}}{fileID: 2800000, guid: {{emission_map.guid}}, type: 3}{{/emission_map}}{{^emission_map}}{fileID: 0}{{/emission_map}}
        m_Scale: {x: {{tiling}}, y: {{tiling}}}
        m_Offset: {x: {{offsetU}}, y: {{offsetVFlipped}}}
    - _MetallicGlossMap:
        m_Texture: {{#metal_smooth}}{fileID: 2800000, guid: {{metal_smooth.guid}}, type: 3}{{/metal_smooth}}{{^metal_smooth}}{fileID: 0}{{/metal_smooth}}
        m_Scale: {x: {{tiling}}, y: {{tiling}}}
        m_Offset: {x: {{offsetU}}, y: {{offsetVFlipped}}}
    - _OcclusionMap:
        m_Texture: {{#occlusion}}{fileID: 2800000, guid: {{occlusion.guid}}, type: 3}{{/occlusion}}{{^occlusion}}{fileID: 0}{{/occlusion}}
        m_Scale: {x: {{tiling}}, y: {{tiling}}}
        m_Offset: {x: {{offsetU}}, y: {{offsetVFlipped}}}
    - _ParallaxMap:
        m_Texture: {{#height}}{fileID: 2800000, guid: {{height.guid}}, type: 3}{{/height}}{{^height}}{fileID: 0}{{/height}}
        m_Scale: {x: {{tiling}}, y: {{tiling}}}
        m_Offset: {x: {{offsetU}}, y: {{offsetVFlipped}}}
    m_Ints: []
    m_Floats:
    - _AlphaClip: {{#opacityMap}}1{{/opacityMap}}{{^opacityMap}}0{{/opacityMap}}
    - _BumpScale: {{normalStrength}}
    - _Cutoff: 0.5
    - _Metallic: {{metallic}}
    - _OcclusionStrength: {{aoStrength}}
    - _Parallax: {{number}}
    - _Smoothness: {{#metal_smooth}}1{{/metal_smooth}}{{^metal_smooth}}{{smoothness}}{{/metal_smooth}}
    - _WorkflowMode: 1
    m_Colors:
    - _BaseColor: {r: {{srgbColorR}}, g: {{srgbColorG}}, b: {{srgbColorB}}, a: 1}
    - _EmissionColor: {r: {{#emissive}}{{emission}}{{/emissive}}{{^emissive}}0{{/emissive}}, g: {{#emissive}}{{emission}}{{/emissive}}{{^emissive}}0{{/emissive}}, b: {{#emissive}}{{emission}}{{/emissive}}{{^emissive}}0{{/emissive}}, a: 1}
{{> unity-meta}}
