extends Node
## Renders the shots of res://job.json and hands each picture to the page.
# SPDX-FileCopyrightText: The Relievo authors
# SPDX-License-Identifier: GPL-3.0-or-later
##
## The page (page.html) defines harnessPicture(shot, name, base64png),
## harnessReport(json) and is told the end by the engine's own exit.

const Loader := preload("res://raw_texture_loader.gd")

var loader := Loader.new()
var report := {"messages": [], "shots": []}


func say(kind: String, text: String) -> void:
	report.messages.append({"kind": kind, "text": text})
	print("@", kind, " ", text)


func _ready() -> void:
	report.engine = Engine.get_version_info()["string"]
	report.renderer = RenderingServer.get_video_adapter_name()
	ResourceLoader.add_resource_format_loader(loader, true)
	var job: Dictionary = JSON.parse_string(FileAccess.get_file_as_string("res://job.json"))
	for index in job.shots.size():
		await shoot(index, job.shots[index])
	report.pictures_read = loader.seen
	JavaScriptBridge.eval("harnessReport(%s)" % JSON.stringify(JSON.stringify(report)))
	get_tree().quit()


## ---- the material -----------------------------------------------------------

func load_material(path: String) -> Material:
	# The engine's own text reader, with CACHE_MODE_IGNORE: every shot starts anew.
	var got := ResourceLoader.load(path, "", ResourceLoader.CACHE_MODE_IGNORE)
	if got == null:
		say("error", "%s: the engine cannot load it" % path)
		return null
	if not got is Material:
		say("error", "%s: a %s, not a material" % [path, got.get_class()])
		return null
	if path.get_extension() == "tres":
		check_properties(path, got)
	return got


## The text reader sets unknown names without a word, so they are looked for here:
## each "name = value" of the [resource] section must be a property of the object,
## and must read back as the value that the text gives.
func check_properties(path: String, object: Resource) -> void:
	var known := {}
	for p in object.get_property_list():
		known[p.name] = p
	if object is ShaderMaterial and object.shader != null and \
			object.shader.get_shader_uniform_list().is_empty() and object.shader.code.contains("uniform "):
		say("error", "%s: its shader does not compile (see stderr); its parameters are not checked" % path)
		return
	var checked := 0
	var values := resource_section(FileAccess.get_file_as_string(path))
	for key in values:
		checked += 1
		var text: String = values[key]
		if not known.has(key):
			say("unknown-property", "%s: %s has no property %s" % [path, object.get_class(), key])
			continue
		var now: Variant = object.get(key)
		if text.begins_with("ExtResource(") or text.begins_with("SubResource("):
			if now == null:
				say("lost-resource", "%s: %s = %s is empty after loading" % [path, key, text])
			continue
		var meant: Variant = str_to_var(text)
		if meant == null and text != "null":
			say("unreadable-value", "%s: %s = %s" % [path, key, text])
		elif typeof(meant) != typeof(now) and not (meant is int and now is float):
			say("other-type", "%s: %s = %s is a %s, the property a %s" %
					[path, key, text, type_string(typeof(meant)), type_string(typeof(now))])
		elif not same(meant, now):
			say("other-value", "%s: %s = %s reads back as %s" % [path, key, text, var_to_str(now)])
	report.properties_checked = report.get("properties_checked", 0) + checked


func same(a: Variant, b: Variant) -> bool:
	if (a is float or a is int) and (b is float or b is int):
		return is_equal_approx(float(a), float(b))
	if typeof(a) in [TYPE_COLOR, TYPE_VECTOR2, TYPE_VECTOR3, TYPE_VECTOR4]:
		return a.is_equal_approx(b)
	return a == b


func resource_section(text: String) -> Dictionary:
	var out := {}
	var inside := false
	var key := ""
	for line in text.split("\n"):
		if key == "" and line.begins_with("["):
			inside = line.begins_with("[resource]")
			continue
		if not inside:
			continue
		if key == "":
			var at := line.find(" = ")
			if at > 0:
				key = line.substr(0, at)
				out[key] = line.substr(at + 3).strip_edges()
		else:
			out[key] += "\n" + line
		# A value may run over several lines: it ends when its brackets are closed.
		if key != "" and out[key].count("(") + out[key].count("[") + out[key].count("{") \
				<= out[key].count(")") + out[key].count("]") + out[key].count("}"):
			key = ""
	return out


## Turns a material into one that shows the UV at which its colour would be read.
func make_ramp(material: Material, ramp: Texture2D, shot: Dictionary) -> Material:
	if material is BaseMaterial3D:
		material.shading_mode = BaseMaterial3D.SHADING_MODE_UNSHADED
		material.transparency = BaseMaterial3D.TRANSPARENCY_DISABLED
		material.emission_enabled = false
		material.detail_enabled = false
		material.albedo_color = Color.WHITE
		material.albedo_texture = ramp
	elif material is ShaderMaterial:
		var name: String = shot.get("uv_param", "")
		if name == "":
			for u in material.shader.get_shader_uniform_list():
				if name == "" and "albedo" in u.name and u.type == TYPE_OBJECT:
					name = u.name
		if name == "":
			say("error", "no albedo sampler found in the shader: say which one with --uv-param")
		# Averages along the view would mix the turns of the ramps.
		var code: String = material.shader.code.replace("filter_linear_mipmap_anisotropic", "filter_linear")
		if not RegEx.create_from_string("\\bunshaded\\b").search(code):
			if code.contains("render_mode "):
				code = code.replace("render_mode ", "render_mode unshaded, ")
			else:
				code = code.replace("shader_type spatial;", "shader_type spatial; render_mode unshaded;")
		var shader := Shader.new()
		shader.code = code
		material.shader = shader
		material.set_shader_parameter(name, ramp) # last: a shader without it forgets it
	return material


## ---- the picture ------------------------------------------------------------

func shoot(index: int, shot: Dictionary) -> void:
	var size := int(shot.size)
	var view := SubViewport.new()
	view.size = Vector2i(size, size)
	view.own_world_3d = true
	view.render_target_update_mode = SubViewport.UPDATE_DISABLED
	view.msaa_3d = Viewport.MSAA_DISABLED if shot.uv else Viewport.MSAA_4X
	add_child(view)

	var plane := MeshInstance3D.new()
	plane.mesh = PlaneMesh.new()  # Faces +Y; u runs along +X, v along +Z.
	plane.mesh.size = Vector2(shot.mesh_size, shot.mesh_size)
	view.add_child(plane)

	var camera := Camera3D.new()
	camera.fov = shot.fov  # Vertical.
	camera.near = 0.01
	view.add_child(camera)
	var pitch := deg_to_rad(shot.pitch)
	var yaw := deg_to_rad(shot.yaw)
	camera.position = shot.distance * Vector3(cos(pitch) * sin(yaw), sin(pitch), cos(pitch) * cos(yaw))
	camera.look_at(Vector3.ZERO, Vector3.UP if shot.pitch < 89.99 else Vector3(-sin(yaw), 0, -cos(yaw)))
	camera.current = true

	var world := WorldEnvironment.new()
	world.environment = Environment.new()
	world.environment.background_mode = Environment.BG_COLOR
	world.environment.background_color = Color(0.05, 0.05, 0.05) if not shot.uv else Color(0, 0, 1)
	world.environment.ambient_light_source = Environment.AMBIENT_SOURCE_COLOR
	world.environment.ambient_light_color = Color.WHITE
	world.environment.ambient_light_energy = shot.ambient
	world.environment.tonemap_mode = Environment.TONE_MAPPER_LINEAR
	view.add_child(world)

	var light := DirectionalLight3D.new()
	light.rotation_degrees = Vector3(-shot.light_pitch, shot.light_yaw, 0)
	light.light_energy = shot.light
	view.add_child(light)

	var material := load_material(shot.material)
	if material != null:
		for key in shot.get("set", {}):
			var value: Variant = str_to_var(shot.set[key])
			if material is ShaderMaterial and not key in material:
				key = "shader_parameter/" + key
			if not key in material:
				say("unknown-property", "--set: %s has no property %s" % [material.get_class(), key])
			material.set(key, value)
		if shot.uv:
			for ramp in ["coarse", "fine", "fine2"]:
				var path := "res://ramp_%s.png" % ramp
				var image := Image.new()
				image.load_png_from_buffer(FileAccess.get_file_as_bytes(path))
				plane.material_override = make_ramp(material, ImageTexture.create_from_image(image), shot)
				await take(index, ramp, view)
		else:
			plane.material_override = material
			await take(index, "lit", view)
	report.shots.append({"shot": shot, "camera": var_to_str(camera.global_transform)})
	view.queue_free()


func take(index: int, name: String, view: SubViewport) -> void:
	# Twice: the first frame may still be without a shader or a texture.
	for i in 2:
		view.render_target_update_mode = SubViewport.UPDATE_ONCE
		await RenderingServer.frame_post_draw
	var image := view.get_texture().get_image()
	image.convert(Image.FORMAT_RGB8)
	var text := Marshalls.raw_to_base64(image.save_png_to_buffer())
	JavaScriptBridge.eval("harnessPicture(%d,'%s','%s')" % [index, name, text])
