# Loads every .tres of the project and compares each line of its [resource] with what the object holds then.
# SPDX-FileCopyrightText: The Relievo authors
# SPDX-License-Identifier: GPL-3.0-or-later
extends SceneTree

var faults = 0
var checked = 0


func fault(text):
	faults += 1
	print("FAULT ", text)


func _init():
	var files = found("res://")
	for path in files:
		check(path)
	print("Godot ", Engine.get_version_info()["string"], ": ", files.size(), " materials, ", checked, " properties read back, ", faults, " faults")
	quit(1 if faults > 0 or files.empty() else 0)


func found(folder):
	var files = []
	var dir = Directory.new()
	dir.open(folder)
	dir.list_dir_begin(true, true)
	var name = dir.get_next()
	while name != "":
		if dir.current_is_dir():
			files += found(folder.plus_file(name))
		elif name.get_extension() == "tres":
			files.append(folder.plus_file(name))
		name = dir.get_next()
	return files


func same(a, b):
	if typeof(a) in [TYPE_REAL, TYPE_INT] and typeof(b) in [TYPE_REAL, TYPE_INT]:
		return is_equal_approx(a, b)
	if typeof(a) == TYPE_COLOR:
		return is_equal_approx(a.r, b.r) and is_equal_approx(a.g, b.g) and is_equal_approx(a.b, b.b) and is_equal_approx(a.a, b.a)
	if typeof(a) == TYPE_VECTOR3:
		return a.is_equal_approx(b)
	return a == b


func check(path):
	var material = load(path)
	if not material is SpatialMaterial:
		fault(path + ": not loaded as a SpatialMaterial")
		return
	var known = {}
	for p in material.get_property_list():
		known[p.name] = true
	var file = File.new()
	file.open(path, File.READ)
	var inside = false
	for line in file.get_as_text().split("\n"):
		if line.begins_with("["):
			inside = line.begins_with("[resource]")
			continue
		var at = line.find(" = ")
		if not inside or at < 0:
			continue
		checked += 1
		var key = line.substr(0, at)
		var text = line.substr(at + 3)
		if not known.has(key):
			fault("%s: no property %s" % [path, key])
			continue
		var now = material.get(key)
		if text.begins_with("ExtResource"):
			if now == null or now.get_width() == 0:
				fault("%s: %s is empty" % [path, key])
		elif not same(str2var(text), now):
			fault("%s: %s = %s reads back as %s" % [path, key, text, now])
