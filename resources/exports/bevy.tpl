{"textures": [
    {"key": "color", "file": "{{name}}_color.png", "channels": ["color_r", "color_g", "color_b", "opacity"], "srgb": true},
    {"key": "normal", "file": "{{name}}_normal.png", "channels": ["normal_x", "normal_y", "normal_z"]},
    {"key": "orm", "file": "{{name}}_orm.png", "channels": ["ao", "roughness", "metallic"]},
    {"key": "emission_map", "file": "{{name}}_emission.png", "channels": ["emission_r", "emission_g", "emission_b"], "srgb": true},
    {"key": "depth", "file": "{{name}}_depth.png", "channels": ["depth"]}
]}
=== {{name}}.rs
// {{{title}}}, written by Relievo {{version}}. Put the pictures into assets/{{name}}/. The mesh needs tangents.
use bevy::image::{ImageAddressMode, ImageLoaderSettings, ImageSampler, ImageSamplerDescriptor};
use bevy::math::{Affine2, Vec2};
use bevy::prelude::*;

pub fn {{identifier}}(asset_server: &AssetServer) -> StandardMaterial {
    // Pictures repeat, and only colours are sRGB.
    let picture = |file: &'static str, is_srgb: bool| -> Handle<Image> {
        asset_server.load_with_settings(format!("{{name}}/{file}"), move |settings: &mut ImageLoaderSettings| {
            settings.is_srgb = is_srgb;
            settings.sampler = ImageSampler::Descriptor(ImageSamplerDescriptor {
                address_mode_u: ImageAddressMode::{{#repeat}}Repeat{{/repeat}}{{^repeat}}ClampToEdge{{/repeat}},
                address_mode_v: ImageAddressMode::{{#repeat}}Repeat{{/repeat}}{{^repeat}}ClampToEdge{{/repeat}},
                ..ImageSamplerDescriptor::linear()
            });
        })
    };
    StandardMaterial {
        base_color: Color::linear_rgb({{colorR}}, {{colorG}}, {{colorB}}),
        {{#color}}
        base_color_texture: Some(picture("{{color.file}}", true)),
        {{/color}}
        {{#opacityMap}}
        alpha_mode: AlphaMode::Mask(0.5),
        {{/opacityMap}}
        perceptual_roughness: {{roughness}},
        metallic: {{metallic}},
        {{#orm}}
        metallic_roughness_texture: Some(picture("{{orm.file}}", false)),
        occlusion_texture: Some(picture("{{orm.file}}", false)),
        {{/orm}}
        {{#normal}}
        normal_map_texture: Some(picture("{{normal.file}}", false)),
        {{/normal}}
        {{#emissive}}
        emissive: LinearRgba::rgb({{emission}}, {{emission}}, {{emission}}),
        emissive_texture: Some(picture("{{emission_map.file}}", true)),
        {{/emissive}}
        {{#depth}}
        depth_map: Some(picture("{{depth.file}}", false)), // white is deep
        parallax_depth_scale: {{number}},
        parallax_mapping_method: ParallaxMappingMethod::Occlusion,
        max_parallax_layer_count: {{maxSteps}} as f32,
        {{/depth}}
        uv_transform: Affine2::from_scale_angle_translation(
            Vec2::splat({{tiling}}),
            {{rotationRadians}},
            Vec2::new({{offsetU}}, {{offsetV}}),
        ),
        ..default()
    }
}
