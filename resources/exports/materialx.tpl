{"textures": [
    {"key": "color", "file": "{{name}}_color.png", "channels": ["color_r", "color_g", "color_b"], "srgb": true},
    {"key": "normal", "file": "{{name}}_normal.png", "channels": ["normal_x", "normal_y", "normal_z"], "bits": 16},
    {"key": "roughness_map", "file": "{{name}}_roughness.png", "channels": ["roughness"]},
    {"key": "metallic_map", "file": "{{name}}_metallic.png", "channels": ["metallic"]},
    {"key": "emission_map", "file": "{{name}}_emission.png", "channels": ["emission_r", "emission_g", "emission_b"], "srgb": true},
    {"key": "height", "file": "{{name}}_height.png", "channels": ["height"], "bits": 16}
]}
=== {{name}}.mtlx
<?xml version="1.0"?>
<materialx version="1.39" colorspace="lin_rec709">
  <nodegraph name="NG_{{identifier}}">
    <texcoord name="uv" type="vector2" />
    <multiply name="tiled" type="vector2">
      <input name="in1" type="vector2" nodename="uv" />
      <input name="in2" type="vector2" value="{{tiling}}, {{tiling}}" />
    </multiply>
    <rotate2d name="turned" type="vector2">
      <input name="in" type="vector2" nodename="tiled" />
      <input name="amount" type="float" value="{{rotationDegrees}}" />
    </rotate2d>
    <add name="place" type="vector2">
      <input name="in1" type="vector2" nodename="turned" />
      <input name="in2" type="vector2" value="{{offsetUUp}}, {{offsetVUp}}" />
    </add>
    {{#color}}
    <image name="image_color" type="color3">
      <input name="file" type="filename" value="{{color.file}}" colorspace="srgb_texture" />
      <input name="texcoord" type="vector2" nodename="place" />
      <input name="uaddressmode" type="string" value="{{#repeat}}periodic{{/repeat}}{{^repeat}}clamp{{/repeat}}" />
      <input name="vaddressmode" type="string" value="{{#repeat}}periodic{{/repeat}}{{^repeat}}clamp{{/repeat}}" />
    </image>
    <multiply name="tinted" type="color3">
      <input name="in1" type="color3" nodename="image_color" />
      <input name="in2" type="color3" value="{{tintR}}, {{tintG}}, {{tintB}}" />
    </multiply>
    {{/color}}
    {{#roughness_map}}
    <image name="image_roughness" type="float">
      <input name="file" type="filename" value="{{roughness_map.file}}" />
      <input name="texcoord" type="vector2" nodename="place" />
      <input name="uaddressmode" type="string" value="{{#repeat}}periodic{{/repeat}}{{^repeat}}clamp{{/repeat}}" />
      <input name="vaddressmode" type="string" value="{{#repeat}}periodic{{/repeat}}{{^repeat}}clamp{{/repeat}}" />
    </image>
    <multiply name="rough" type="float">
      <input name="in1" type="float" nodename="image_roughness" />
      <input name="in2" type="float" value="{{roughness}}" />
    </multiply>
    {{/roughness_map}}
    {{#metallic_map}}
    <image name="image_metallic" type="float">
      <input name="file" type="filename" value="{{metallic_map.file}}" />
      <input name="texcoord" type="vector2" nodename="place" />
      <input name="uaddressmode" type="string" value="{{#repeat}}periodic{{/repeat}}{{^repeat}}clamp{{/repeat}}" />
      <input name="vaddressmode" type="string" value="{{#repeat}}periodic{{/repeat}}{{^repeat}}clamp{{/repeat}}" />
    </image>
    <multiply name="metal" type="float">
      <input name="in1" type="float" nodename="image_metallic" />
      <input name="in2" type="float" value="{{metallic}}" />
    </multiply>
    {{/metallic_map}}
    {{#normal}}
    <image name="image_normal" type="vector3">
      <input name="file" type="filename" value="{{normal.file}}" />
      <input name="texcoord" type="vector2" nodename="place" />
      <input name="uaddressmode" type="string" value="{{#repeat}}periodic{{/repeat}}{{^repeat}}clamp{{/repeat}}" />
      <input name="vaddressmode" type="string" value="{{#repeat}}periodic{{/repeat}}{{^repeat}}clamp{{/repeat}}" />
    </image>
    <normalmap name="bend" type="vector3">
      <input name="in" type="vector3" nodename="image_normal" />
      <input name="scale" type="float" value="{{normalStrength}}" />
    </normalmap>
    {{/normal}}
    {{#emissive}}
    {{#emission_map}}
    <image name="image_emission" type="color3">
      <input name="file" type="filename" value="{{emission_map.file}}" colorspace="srgb_texture" />
      <input name="texcoord" type="vector2" nodename="place" />
      <input name="uaddressmode" type="string" value="{{#repeat}}periodic{{/repeat}}{{^repeat}}clamp{{/repeat}}" />
      <input name="vaddressmode" type="string" value="{{#repeat}}periodic{{/repeat}}{{^repeat}}clamp{{/repeat}}" />
    </image>
    {{/emission_map}}
    {{/emissive}}
    {{#height}}
    <image name="image_height" type="float">
      <input name="file" type="filename" value="{{height.file}}" />
      <input name="texcoord" type="vector2" nodename="place" />
      <input name="uaddressmode" type="string" value="{{#repeat}}periodic{{/repeat}}{{^repeat}}clamp{{/repeat}}" />
      <input name="vaddressmode" type="string" value="{{#repeat}}periodic{{/repeat}}{{^repeat}}clamp{{/repeat}}" />
    </image>
    <subtract name="centred" type="float">
      <input name="in1" type="float" nodename="image_height" />
      <input name="in2" type="float" value="{{midlevel}}" />
    </subtract>
    {{/height}}
    {{#color}}
    <output name="out_color" type="color3" nodename="tinted" />
    {{/color}}
    {{#roughness_map}}
    <output name="out_roughness" type="float" nodename="rough" />
    {{/roughness_map}}
    {{#metallic_map}}
    <output name="out_metallic" type="float" nodename="metal" />
    {{/metallic_map}}
    {{#normal}}
    <output name="out_normal" type="vector3" nodename="bend" />
    {{/normal}}
    {{#emissive}}
    <output name="out_emission" type="color3" nodename="image_emission" />
    {{/emissive}}
    {{#height}}
    <output name="out_height" type="float" nodename="centred" />
    {{/height}}
  </nodegraph>
  <standard_surface name="SR_{{identifier}}" type="surfaceshader">
    {{#color}}
    <input name="base_color" type="color3" nodegraph="NG_{{identifier}}" output="out_color" />
    {{/color}}
    {{^color}}
    <input name="base_color" type="color3" value="{{colorR}}, {{colorG}}, {{colorB}}" />
    {{/color}}
    {{#roughness_map}}
    <input name="specular_roughness" type="float" nodegraph="NG_{{identifier}}" output="out_roughness" />
    {{/roughness_map}}
    {{^roughness_map}}
    <input name="specular_roughness" type="float" value="{{roughness}}" />
    {{/roughness_map}}
    {{#metallic_map}}
    <input name="metalness" type="float" nodegraph="NG_{{identifier}}" output="out_metallic" />
    {{/metallic_map}}
    {{#normal}}
    <input name="normal" type="vector3" nodegraph="NG_{{identifier}}" output="out_normal" />
    {{/normal}}
    {{#emissive}}
    <input name="emission" type="float" value="{{emission}}" />
    <input name="emission_color" type="color3" nodegraph="NG_{{identifier}}" output="out_emission" />
    {{/emissive}}
  </standard_surface>
  {{#height}}
  <displacement name="D_{{identifier}}" type="displacementshader">
    <input name="displacement" type="float" nodegraph="NG_{{identifier}}" output="out_height" />
    <input name="scale" type="float" value="{{number}}" unittype="distance" unit="meter" />
  </displacement>
  {{/height}}
  <surfacematerial name="M_{{identifier}}" type="material">
    <input name="surfaceshader" type="surfaceshader" nodename="SR_{{identifier}}" />
    {{#height}}
    <input name="displacementshader" type="displacementshader" nodename="D_{{identifier}}" />
    {{/height}}
  </surfacematerial>
</materialx>
=== {{name}}_1_38.mtlx
<?xml version="1.0"?>
<materialx version="1.38" colorspace="lin_rec709">
  <nodegraph name="NG_{{identifier}}">
    <texcoord name="uv" type="vector2" />
    <multiply name="tiled" type="vector2">
      <input name="in1" type="vector2" nodename="uv" />
      <input name="in2" type="vector2" value="{{tiling}}, {{tiling}}" />
    </multiply>
    <rotate2d name="turned" type="vector2">
      <input name="in" type="vector2" nodename="tiled" />
      <input name="amount" type="float" value="{{rotationDegrees}}" />
    </rotate2d>
    <add name="place" type="vector2">
      <input name="in1" type="vector2" nodename="turned" />
      <input name="in2" type="vector2" value="{{offsetUUp}}, {{offsetVUp}}" />
    </add>
    {{#color}}
    <image name="image_color" type="color3">
      <input name="file" type="filename" value="{{color.file}}" colorspace="srgb_texture" />
      <input name="texcoord" type="vector2" nodename="place" />
      <input name="uaddressmode" type="string" value="{{#repeat}}periodic{{/repeat}}{{^repeat}}clamp{{/repeat}}" />
      <input name="vaddressmode" type="string" value="{{#repeat}}periodic{{/repeat}}{{^repeat}}clamp{{/repeat}}" />
    </image>
    <multiply name="tinted" type="color3">
      <input name="in1" type="color3" nodename="image_color" />
      <input name="in2" type="color3" value="{{tintR}}, {{tintG}}, {{tintB}}" />
    </multiply>
    {{/color}}
    {{#roughness_map}}
    <image name="image_roughness" type="float">
      <input name="file" type="filename" value="{{roughness_map.file}}" />
      <input name="texcoord" type="vector2" nodename="place" />
      <input name="uaddressmode" type="string" value="{{#repeat}}periodic{{/repeat}}{{^repeat}}clamp{{/repeat}}" />
      <input name="vaddressmode" type="string" value="{{#repeat}}periodic{{/repeat}}{{^repeat}}clamp{{/repeat}}" />
    </image>
    <multiply name="rough" type="float">
      <input name="in1" type="float" nodename="image_roughness" />
      <input name="in2" type="float" value="{{roughness}}" />
    </multiply>
    {{/roughness_map}}
    {{#metallic_map}}
    <image name="image_metallic" type="float">
      <input name="file" type="filename" value="{{metallic_map.file}}" />
      <input name="texcoord" type="vector2" nodename="place" />
      <input name="uaddressmode" type="string" value="{{#repeat}}periodic{{/repeat}}{{^repeat}}clamp{{/repeat}}" />
      <input name="vaddressmode" type="string" value="{{#repeat}}periodic{{/repeat}}{{^repeat}}clamp{{/repeat}}" />
    </image>
    <multiply name="metal" type="float">
      <input name="in1" type="float" nodename="image_metallic" />
      <input name="in2" type="float" value="{{metallic}}" />
    </multiply>
    {{/metallic_map}}
    {{#normal}}
    <image name="image_normal" type="vector3">
      <input name="file" type="filename" value="{{normal.file}}" />
      <input name="texcoord" type="vector2" nodename="place" />
      <input name="uaddressmode" type="string" value="{{#repeat}}periodic{{/repeat}}{{^repeat}}clamp{{/repeat}}" />
      <input name="vaddressmode" type="string" value="{{#repeat}}periodic{{/repeat}}{{^repeat}}clamp{{/repeat}}" />
    </image>
    <normalmap name="bend" type="vector3">
      <input name="in" type="vector3" nodename="image_normal" />
      <input name="scale" type="float" value="{{normalStrength}}" />
    </normalmap>
    {{/normal}}
    {{#emissive}}
    {{#emission_map}}
    <image name="image_emission" type="color3">
      <input name="file" type="filename" value="{{emission_map.file}}" colorspace="srgb_texture" />
      <input name="texcoord" type="vector2" nodename="place" />
      <input name="uaddressmode" type="string" value="{{#repeat}}periodic{{/repeat}}{{^repeat}}clamp{{/repeat}}" />
      <input name="vaddressmode" type="string" value="{{#repeat}}periodic{{/repeat}}{{^repeat}}clamp{{/repeat}}" />
    </image>
    {{/emission_map}}
    {{/emissive}}
    {{#height}}
    <image name="image_height" type="float">
      <input name="file" type="filename" value="{{height.file}}" />
      <input name="texcoord" type="vector2" nodename="place" />
      <input name="uaddressmode" type="string" value="{{#repeat}}periodic{{/repeat}}{{^repeat}}clamp{{/repeat}}" />
      <input name="vaddressmode" type="string" value="{{#repeat}}periodic{{/repeat}}{{^repeat}}clamp{{/repeat}}" />
    </image>
    <subtract name="centred" type="float">
      <input name="in1" type="float" nodename="image_height" />
      <input name="in2" type="float" value="{{midlevel}}" />
    </subtract>
    {{/height}}
    {{#color}}
    <output name="out_color" type="color3" nodename="tinted" />
    {{/color}}
    {{#roughness_map}}
    <output name="out_roughness" type="float" nodename="rough" />
    {{/roughness_map}}
    {{#metallic_map}}
    <output name="out_metallic" type="float" nodename="metal" />
    {{/metallic_map}}
    {{#normal}}
    <output name="out_normal" type="vector3" nodename="bend" />
    {{/normal}}
    {{#emissive}}
    <output name="out_emission" type="color3" nodename="image_emission" />
    {{/emissive}}
    {{#height}}
    <output name="out_height" type="float" nodename="centred" />
    {{/height}}
  </nodegraph>
  <standard_surface name="SR_{{identifier}}" type="surfaceshader">
    {{#color}}
    <input name="base_color" type="color3" nodegraph="NG_{{identifier}}" output="out_color" />
    {{/color}}
    {{^color}}
    <input name="base_color" type="color3" value="{{colorR}}, {{colorG}}, {{colorB}}" />
    {{/color}}
    {{#roughness_map}}
    <input name="specular_roughness" type="float" nodegraph="NG_{{identifier}}" output="out_roughness" />
    {{/roughness_map}}
    {{^roughness_map}}
    <input name="specular_roughness" type="float" value="{{roughness}}" />
    {{/roughness_map}}
    {{#metallic_map}}
    <input name="metalness" type="float" nodegraph="NG_{{identifier}}" output="out_metallic" />
    {{/metallic_map}}
    {{#normal}}
    <input name="normal" type="vector3" nodegraph="NG_{{identifier}}" output="out_normal" />
    {{/normal}}
    {{#emissive}}
    <input name="emission" type="float" value="{{emission}}" />
    <input name="emission_color" type="color3" nodegraph="NG_{{identifier}}" output="out_emission" />
    {{/emissive}}
  </standard_surface>
  {{#height}}
  <displacement name="D_{{identifier}}" type="displacementshader">
    <input name="displacement" type="float" nodegraph="NG_{{identifier}}" output="out_height" />
    <input name="scale" type="float" value="{{number}}" unittype="distance" unit="meter" />
  </displacement>
  {{/height}}
  <surfacematerial name="M_{{identifier}}" type="material">
    <input name="surfaceshader" type="surfaceshader" nodename="SR_{{identifier}}" />
    {{#height}}
    <input name="displacementshader" type="displacementshader" nodename="D_{{identifier}}" />
    {{/height}}
  </surfacematerial>
</materialx>
=== {{name}}_without_displacement.mtlx
<?xml version="1.0"?>
<materialx version="1.39" colorspace="lin_rec709">
  <nodegraph name="NG_{{identifier}}">
    <texcoord name="uv" type="vector2" />
    <multiply name="tiled" type="vector2">
      <input name="in1" type="vector2" nodename="uv" />
      <input name="in2" type="vector2" value="{{tiling}}, {{tiling}}" />
    </multiply>
    <rotate2d name="turned" type="vector2">
      <input name="in" type="vector2" nodename="tiled" />
      <input name="amount" type="float" value="{{rotationDegrees}}" />
    </rotate2d>
    <add name="place" type="vector2">
      <input name="in1" type="vector2" nodename="turned" />
      <input name="in2" type="vector2" value="{{offsetUUp}}, {{offsetVUp}}" />
    </add>
    {{#color}}
    <image name="image_color" type="color3">
      <input name="file" type="filename" value="{{color.file}}" colorspace="srgb_texture" />
      <input name="texcoord" type="vector2" nodename="place" />
      <input name="uaddressmode" type="string" value="{{#repeat}}periodic{{/repeat}}{{^repeat}}clamp{{/repeat}}" />
      <input name="vaddressmode" type="string" value="{{#repeat}}periodic{{/repeat}}{{^repeat}}clamp{{/repeat}}" />
    </image>
    <multiply name="tinted" type="color3">
      <input name="in1" type="color3" nodename="image_color" />
      <input name="in2" type="color3" value="{{tintR}}, {{tintG}}, {{tintB}}" />
    </multiply>
    {{/color}}
    {{#roughness_map}}
    <image name="image_roughness" type="float">
      <input name="file" type="filename" value="{{roughness_map.file}}" />
      <input name="texcoord" type="vector2" nodename="place" />
      <input name="uaddressmode" type="string" value="{{#repeat}}periodic{{/repeat}}{{^repeat}}clamp{{/repeat}}" />
      <input name="vaddressmode" type="string" value="{{#repeat}}periodic{{/repeat}}{{^repeat}}clamp{{/repeat}}" />
    </image>
    <multiply name="rough" type="float">
      <input name="in1" type="float" nodename="image_roughness" />
      <input name="in2" type="float" value="{{roughness}}" />
    </multiply>
    {{/roughness_map}}
    {{#metallic_map}}
    <image name="image_metallic" type="float">
      <input name="file" type="filename" value="{{metallic_map.file}}" />
      <input name="texcoord" type="vector2" nodename="place" />
      <input name="uaddressmode" type="string" value="{{#repeat}}periodic{{/repeat}}{{^repeat}}clamp{{/repeat}}" />
      <input name="vaddressmode" type="string" value="{{#repeat}}periodic{{/repeat}}{{^repeat}}clamp{{/repeat}}" />
    </image>
    <multiply name="metal" type="float">
      <input name="in1" type="float" nodename="image_metallic" />
      <input name="in2" type="float" value="{{metallic}}" />
    </multiply>
    {{/metallic_map}}
    {{#normal}}
    <image name="image_normal" type="vector3">
      <input name="file" type="filename" value="{{normal.file}}" />
      <input name="texcoord" type="vector2" nodename="place" />
      <input name="uaddressmode" type="string" value="{{#repeat}}periodic{{/repeat}}{{^repeat}}clamp{{/repeat}}" />
      <input name="vaddressmode" type="string" value="{{#repeat}}periodic{{/repeat}}{{^repeat}}clamp{{/repeat}}" />
    </image>
    <normalmap name="bend" type="vector3">
      <input name="in" type="vector3" nodename="image_normal" />
      <input name="scale" type="float" value="{{normalStrength}}" />
    </normalmap>
    {{/normal}}
    {{#emissive}}
    {{#emission_map}}
    <image name="image_emission" type="color3">
      <input name="file" type="filename" value="{{emission_map.file}}" colorspace="srgb_texture" />
      <input name="texcoord" type="vector2" nodename="place" />
      <input name="uaddressmode" type="string" value="{{#repeat}}periodic{{/repeat}}{{^repeat}}clamp{{/repeat}}" />
      <input name="vaddressmode" type="string" value="{{#repeat}}periodic{{/repeat}}{{^repeat}}clamp{{/repeat}}" />
    </image>
    {{/emission_map}}
    {{/emissive}}
    {{#color}}
    <output name="out_color" type="color3" nodename="tinted" />
    {{/color}}
    {{#roughness_map}}
    <output name="out_roughness" type="float" nodename="rough" />
    {{/roughness_map}}
    {{#metallic_map}}
    <output name="out_metallic" type="float" nodename="metal" />
    {{/metallic_map}}
    {{#normal}}
    <output name="out_normal" type="vector3" nodename="bend" />
    {{/normal}}
    {{#emissive}}
    <output name="out_emission" type="color3" nodename="image_emission" />
    {{/emissive}}
  </nodegraph>
  <standard_surface name="SR_{{identifier}}" type="surfaceshader">
    {{#color}}
    <input name="base_color" type="color3" nodegraph="NG_{{identifier}}" output="out_color" />
    {{/color}}
    {{^color}}
    <input name="base_color" type="color3" value="{{colorR}}, {{colorG}}, {{colorB}}" />
    {{/color}}
    {{#roughness_map}}
    <input name="specular_roughness" type="float" nodegraph="NG_{{identifier}}" output="out_roughness" />
    {{/roughness_map}}
    {{^roughness_map}}
    <input name="specular_roughness" type="float" value="{{roughness}}" />
    {{/roughness_map}}
    {{#metallic_map}}
    <input name="metalness" type="float" nodegraph="NG_{{identifier}}" output="out_metallic" />
    {{/metallic_map}}
    {{#normal}}
    <input name="normal" type="vector3" nodegraph="NG_{{identifier}}" output="out_normal" />
    {{/normal}}
    {{#emissive}}
    <input name="emission" type="float" value="{{emission}}" />
    <input name="emission_color" type="color3" nodegraph="NG_{{identifier}}" output="out_emission" />
    {{/emissive}}
  </standard_surface>
  <surfacematerial name="M_{{identifier}}" type="material">
    <input name="surfaceshader" type="surfaceshader" nodename="SR_{{identifier}}" />
  </surfacematerial>
</materialx>
