{"textures": [
    {"key": "color", "file": "{{name}}_color.png", "channels": ["color_r", "color_g", "color_b", "opacity"], "srgb": true},
    {"key": "normal", "file": "{{name}}_normal.png", "channels": ["normal_x", "normal_y", "normal_z"], "bits": 16},
    {"key": "roughness_map", "file": "{{name}}_roughness.png", "channels": ["roughness"]},
    {"key": "metallic_map", "file": "{{name}}_metallic.png", "channels": ["metallic"]},
    {"key": "emission_map", "file": "{{name}}_emission.png", "channels": ["emission_r", "emission_g", "emission_b"], "srgb": true},
    {"key": "height", "file": "{{name}}_height.png", "channels": ["height"], "bits": 16}
]}
=== {{name}}.py
"""{{{title}}}, written by Relievo {{version}}.

Run it in Blender's text editor, or: blender --python {{name}}.py
It makes the material "{{title}}" with real displacement: give the mesh a Subdivision modifier, or adaptive subdivision in Cycles.
"""
import os

import bpy

FOLDER = os.path.dirname(os.path.abspath(__file__)) if "__file__" in globals() else os.path.dirname(bpy.context.space_data.text.filepath)


def relief_material(name="{{title}}"):
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    output = nodes.new("ShaderNodeOutputMaterial")
    output.location = (600, 0)
    shader = nodes.new("ShaderNodeBsdfPrincipled")
    shader.location = (250, 0)
    links.new(shader.outputs["BSDF"], output.inputs["Surface"])
    uv = nodes.new("ShaderNodeTexCoord")
    uv.location = (-1000, 0)
    place = nodes.new("ShaderNodeMapping")
    place.location = (-800, 0)
    place.inputs["Scale"].default_value = ({{tiling}}, {{tiling}}, 1)
    place.inputs["Rotation"].default_value = (0, 0, {{rotationRadiansUp}})
    place.inputs["Location"].default_value = ({{offsetUUp}}, {{offsetVUp}}, 0)  # v goes up in Blender
    links.new(uv.outputs["UV"], place.inputs["Vector"])

    def picture(file, row, color=False):
        node = nodes.new("ShaderNodeTexImage")
        node.location = (-500, 600 - 300 * row)
        node.image = bpy.data.images.load(os.path.join(FOLDER, file), check_existing=True)
        node.image.colorspace_settings.name = "sRGB" if color else "Non-Color"
        node.extension = "{{#repeat}}REPEAT{{/repeat}}{{^repeat}}EXTEND{{/repeat}}"
        links.new(place.outputs["Vector"], node.inputs["Vector"])
        return node

    shader.inputs["Base Color"].default_value = ({{colorR}}, {{colorG}}, {{colorB}}, 1)
    shader.inputs["Roughness"].default_value = {{roughness}}
    shader.inputs["Metallic"].default_value = {{metallic}}
    {{#color}}
    color = picture("{{color.file}}", 0, True)
    links.new(color.outputs["Color"], shader.inputs["Base Color"])
    {{/color}}
    {{#opacityMap}}
    links.new(color.outputs["Alpha"], shader.inputs["Alpha"])
    material.blend_method = "CLIP"
    {{/opacityMap}}
    {{#roughness_map}}
    links.new(picture("{{roughness_map.file}}", 1).outputs["Color"], shader.inputs["Roughness"])
    {{/roughness_map}}
    {{#metallic_map}}
    links.new(picture("{{metallic_map.file}}", 2).outputs["Color"], shader.inputs["Metallic"])
    {{/metallic_map}}
    {{#emissive}}
    light = picture("{{emission_map.file}}", 5, True)
    links.new(light.outputs["Color"], shader.inputs["Emission Color" if "Emission Color" in shader.inputs else "Emission"])
    shader.inputs["Emission Strength"].default_value = {{emission}}
    {{/emissive}}
    {{#normal}}
    bend = nodes.new("ShaderNodeNormalMap")
    bend.location = (0, -400)
    bend.inputs["Strength"].default_value = {{normalStrength}}
    links.new(picture("{{normal.file}}", 3).outputs["Color"], bend.inputs["Color"])
    # True displacement bends the normals by itself; where only bumps are drawn, link it to the shader's Normal.
    {{/normal}}
    {{#height}}
    displace = nodes.new("ShaderNodeDisplacement")
    displace.location = (250, -500)
    displace.inputs["Midlevel"].default_value = {{midlevel}}
    displace.inputs["Scale"].default_value = {{number}}  # metres from black to white
    links.new(picture("{{height.file}}", 4).outputs["Color"], displace.inputs["Height"])
    links.new(displace.outputs["Displacement"], output.inputs["Displacement"])
    # The switch moved from Cycles to the material in later versions.
    if hasattr(material, "displacement_method"):
        material.displacement_method = "DISPLACEMENT"
    else:
        material.cycles.displacement_method = "DISPLACEMENT"
    {{/height}}
    return material


if __name__ == "__main__":
    made = relief_material()
    if bpy.context.object and bpy.context.object.type == "MESH":
        bpy.context.object.active_material = made
