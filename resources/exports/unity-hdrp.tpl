{"textures": [
    {"key": "color", "file": "{{name}}_color.png", "channels": ["color_r", "color_g", "color_b", "opacity"], "srgb": true},
    {"key": "normal", "file": "{{name}}_normal.png", "channels": ["normal_x", "normal_y", "normal_z"]},
    {"key": "mask", "file": "{{name}}_mask.png", "channels": ["metallic", "ao", "0.0", "smoothness"]},
    {"key": "emission_map", "file": "{{name}}_emission.png", "channels": ["emission_r", "emission_g", "emission_b"], "srgb": true},
    {"key": "height", "file": "{{name}}_height.png", "channels": ["height"], "bits": 16}
]}
=== {{name}}.mat
%YAML 1.1
%TAG !u! tag:unity3d.com,2011:
--- !u!21 &2100000
Material:
  serializedVersion: 8
  m_ObjectHideFlags: 0
  m_Name: "{{title}}"
  m_Shader: {fileID: 4800000, guid: 6e4ae4064600d784cac1e41a9e6f2e59, type: 3}
  m_ValidKeywords:
{{#opacityMap}}
  - _ALPHATEST_ON
{{/opacityMap}}
{{#emissive}}
  - _EMISSIVE_COLOR_MAP
{{/emissive}}
{{#height}}
  - _HEIGHTMAP
  - _PIXEL_DISPLACEMENT
  - _PIXEL_DISPLACEMENT_LOCK_OBJECT_SCALE
{{/height}}
{{#mask}}
  - _MASKMAP
{{/mask}}
{{#normal}}
  - _NORMALMAP
  - _NORMALMAP_TANGENT_SPACE
{{/normal}}
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
    - _BaseColorMap:
        m_Texture: {{#color}}{fileID: 2800000, guid: {{color.guid}}, type: 3}{{/color}}{{^color}}{fileID: 0}{{/color}}
        m_Scale: {x: {{tiling}}, y: {{tiling}}}
        m_Offset: {x: {{offsetU}}, y: {{offsetVFlipped}}}
    - _EmissiveColorMap:
        m_Texture: {{#emission_map}}{fileID: 2800000, guid: {{emission_map.guid}}, type: 3}{{/emission_map}}{{^emission_map}}{fileID: 0}{{/emission_map}}
        m_Scale: {x: {{tiling}}, y: {{tiling}}}
        m_Offset: {x: {{offsetU}}, y: {{offsetVFlipped}}}
    - _HeightMap:
        m_Texture: {{#height}}{fileID: 2800000, guid: {{height.guid}}, type: 3}{{/height}}{{^height}}{fileID: 0}{{/height}}
        m_Scale: {x: {{tiling}}, y: {{tiling}}}
        m_Offset: {x: {{offsetU}}, y: {{offsetVFlipped}}}
    - _MaskMap:
        m_Texture: {{#mask}}{fileID: 2800000, guid: {{mask.guid}}, type: 3}{{/mask}}{{^mask}}{fileID: 0}{{/mask}}
        m_Scale: {x: {{tiling}}, y: {{tiling}}}
        m_Offset: {x: {{offsetU}}, y: {{offsetVFlipped}}}
    - _NormalMap:
        m_Texture: {{#normal}}{fileID: 2800000, guid: {{normal.guid}}, type: 3}{{/normal}}{{^normal}}{fileID: 0}{{/normal}}
        m_Scale: {x: {{tiling}}, y: {{tiling}}}
        m_Offset: {x: {{offsetU}}, y: {{offsetVFlipped}}}
    m_Ints: []
    m_Floats:
    - _AlphaCutoff: 0.5
    - _AlphaCutoffEnable: {{#opacityMap}}1{{/opacityMap}}{{^opacityMap}}0{{/opacityMap}}
    - _AORemapMax: 1
    - _AORemapMin: 0
    - _DepthOffsetEnable: 1
    - _DisplacementLockObjectScale: 1
    - _DisplacementLockTilingScale: 0
    - _DisplacementMode: {{#height}}2{{/height}}{{^height}}0{{/height}}
    - _HeightAmplitude: {{depthMetres}}
    - _HeightCenter: 1
    - _HeightMapParametrization: 1
    - _HeightOffset: 0
    - _HeightPoMAmplitude: {{number}}
    - _Metallic: {{metallic}}
    - _NormalScale: {{normalStrength}}
    - _PPDLodThreshold: 5
    - _PPDMaxSamples: {{maxSteps}}
    - _PPDMinSamples: {{minSteps}}
    - _PPDPrimitiveLength: {{metresPerUV}}
    - _PPDPrimitiveWidth: {{metresPerUV}}
    - _Smoothness: {{smoothness}}
    - _SmoothnessRemapMax: 1
    - _SmoothnessRemapMin: 0
    m_Colors:
    - _BaseColor: {r: {{srgbColorR}}, g: {{srgbColorG}}, b: {{srgbColorB}}, a: 1}
    - _InvPrimScale: {r: {{perMetre}}, g: {{perMetre}}, b: 0, a: 0}
    - _EmissiveColor: {r: {{#emissive}}{{emission}}{{/emissive}}{{^emissive}}0{{/emissive}}, g: {{#emissive}}{{emission}}{{/emissive}}{{^emissive}}0{{/emissive}}, b: {{#emissive}}{{emission}}{{/emissive}}{{^emissive}}0{{/emissive}}, a: 1}
{{> unity-meta}}
