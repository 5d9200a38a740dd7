extends ResourceFormatLoader
## Loads a picture file that no editor has imported, so that the engine's own
## .tres / .tscn reader can follow its ext_resource lines to plain PNG files.
# SPDX-FileCopyrightText: The Relievo authors
# SPDX-License-Identifier: GPL-3.0-or-later
##
## Of a "<file>.import" next to the picture only mipmaps/generate is honoured:
## everything else an import does (VRAM compression, normal map packing, size
## limits) does not happen here.

const KINDS := ["png", "jpg", "jpeg", "webp", "bmp", "tga", "exr", "hdr"]

## path -> "WxH format" of every picture read, for the report.
var seen := {}


func _get_recognized_extensions() -> PackedStringArray:
	return PackedStringArray(KINDS)


func _handles_type(type: StringName) -> bool:
	return type == &"Texture2D" or type == &"Texture" or type == &"ImageTexture"


func _get_resource_type(path: String) -> String:
	return "ImageTexture" if path.get_extension().to_lower() in KINDS else ""


func _load(path: String, _original: String, _threads: bool, _cache: int) -> Variant:
	var bytes := FileAccess.get_file_as_bytes(path)
	if bytes.is_empty():
		return ERR_FILE_CANT_OPEN
	var image := Image.new()
	var err := FAILED
	match path.get_extension().to_lower():
		"png": err = image.load_png_from_buffer(bytes)
		"jpg", "jpeg": err = image.load_jpg_from_buffer(bytes)
		"webp": err = image.load_webp_from_buffer(bytes)
		"bmp": err = image.load_bmp_from_buffer(bytes)
		"tga": err = image.load_tga_from_buffer(bytes)
		"exr":  # Already decoded by exr.py: the engine's reader would end the web build.
			if bytes.slice(0, 4).get_string_from_ascii() == "RAWI":
				image = Image.create_from_data(bytes.decode_u32(4), bytes.decode_u32(8), false,
						bytes.decode_u32(12), bytes.slice(16))
				err = OK if image != null and not image.is_empty() else FAILED
		"hdr": err = image.load(path)
	if err != OK:
		push_error("%s: the engine cannot read this picture (error %d)" % [path, err])
		return err
	seen[path] = "%dx%d format %d" % [image.get_width(), image.get_height(), image.get_format()]
	var mipmaps := true
	var settings := ConfigFile.new()
	if settings.load(path + ".import") == OK:
		mipmaps = settings.get_value("params", "mipmaps/generate", true)
	if mipmaps:
		image.generate_mipmaps()
	return ImageTexture.create_from_image(image)
