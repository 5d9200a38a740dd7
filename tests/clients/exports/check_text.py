#!/usr/bin/python3
"""Reads the text files of exported folders: check_text.py FOLDER...

Each by a parser of its format; Unity's, O3DE's and Unreal's must hold the names that the engine knows. Every picture that a text names must lie
beside it.
"""
# SPDX-FileCopyrightText: The Relievo authors
# SPDX-License-Identifier: GPL-3.0-or-later
import collections
import json
import pathlib
import re
import subprocess
import sys
import xml.etree.ElementTree

import yaml

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import unreal_stand_in  # noqa: E402

SHADERS = {
    "unity-builtin": {"fileID": 46, "guid": "0000000000000000f000000000000000", "type": 0},
    "unity-urp": {"fileID": 4800000, "guid": "933532a4fcc9baf4fa0491de14d08ed7", "type": 3},
    "unity-hdrp": {"fileID": 4800000, "guid": "6e4ae4064600d784cac1e41a9e6f2e59", "type": 3},
}
# Of a pipeline: its height map, keywords that go with it, the least and the most of each number that the inspector takes.
HEIGHTS = {
    "unity-builtin": ("_ParallaxMap", {"_PARALLAXMAP"}, {"_Parallax": (0.005, 0.08)}),
    "unity-urp": ("_ParallaxMap", {"_PARALLAXMAP"}, {"_Parallax": (0.005, 0.08)}),
    "unity-hdrp": ("_HeightMap", {"_HEIGHTMAP", "_PIXEL_DISPLACEMENT"},
                   {"_HeightPoMAmplitude": (0, 1e9), "_HeightAmplitude": (0, 1e9), "_HeightCenter": (1, 1), "_DisplacementMode": (2, 2),
                    "_PPDMinSamples": (1, 512), "_PPDMaxSamples": (1, 512), "_PPDLodThreshold": (0, 16), "_PPDPrimitiveLength": (1e-9, 1e9),
                    "_PPDPrimitiveWidth": (1e-9, 1e9), "_DepthOffsetEnable": (0, 1), "_HeightMapParametrization": (0, 1)}),
}
PARALLAX_O3DE = {"textureMap", "factor", "offset", "algorithm", "quality", "pdo", "showClipping"}


def expect(condition, text):
    if not condition:
        raise ValueError(text)


def unity(file):
    # The tag !u!21 is Unity's own: PyYAML knows no such type.
    return yaml.safe_load(re.sub(r"^--- !u!\d+ &\d+$", "---", file.read_text(), flags=re.MULTILINE).replace("%TAG !u! tag:unity3d.com,2011:\n", ""))


def read_meta(file):
    meta = unity(file)
    expect(re.fullmatch("[0-9a-f]{32}", str(meta["guid"])), f"guid {meta['guid']}")
    expect(file.with_suffix("").exists(), f"there is no {file.with_suffix('').name}")
    importer = meta.get("TextureImporter")
    if importer:
        color = re.search("color|emission", file.name) is not None
        expect(importer["mipmaps"]["sRGBTexture"] == (1 if color else 0), "sRGBTexture")
        expect(importer["textureType"] == (1 if "_normal" in file.name else 0), "textureType")


def read_material(file):
    target = file.parent.name
    material = unity(file)["Material"]
    expect(material["m_Shader"] == SHADERS[target], f"shader {material['m_Shader']}")
    saved = material["m_SavedProperties"]
    textures = {name: value["m_Texture"] for entry in saved["m_TexEnvs"] for name, value in entry.items()}
    floats = {name: value for entry in saved["m_Floats"] for name, value in entry.items()}
    guids = {str(unity(meta)["guid"]): meta.with_suffix("").name for meta in file.parent.glob("*.png.meta")}
    used = {name: guids[t["guid"]] for name, t in textures.items() if t["fileID"]}
    expect(len(set(used.values())) == len(guids), f"textures {sorted(set(guids.values()) - set(used.values()))} are not used")
    name, keywords, numbers = HEIGHTS[target]
    expect("_height" in used[name], f"{name} is {used[name]}")
    expect(keywords <= set(material["m_ValidKeywords"]), f"keywords {material['m_ValidKeywords']}")
    for key, (least, most) in numbers.items():
        expect(least - 1e-9 <= floats[key] <= most + 1e-9, f"{key} is {floats[key]}")
    if target == "unity-hdrp":
        expect(abs(floats["_HeightAmplitude"] - floats["_HeightPoMAmplitude"] / 100) < 1e-6, "_HeightAmplitude is not _HeightPoMAmplitude in metres")


def read_o3de(file):
    values = json.loads(file.read_text())["propertyValues"]
    parallax = {key.split(".")[1] for key in values if key.startswith("parallax.")}
    expect(parallax == PARALLAX_O3DE, f"parallax: {sorted(parallax ^ PARALLAX_O3DE)}")


def read_python(file):
    compile(file.read_text(), str(file), "exec")
    if file.parent.name == "unreal":
        unreal_stand_in.run(file)


def read_module(file):
    done = subprocess.run(["node", "--check", file], capture_output=True, text=True)
    expect(done.returncode == 0, done.stderr)


READERS = {".py": read_python, ".meta": read_meta, ".mat": read_material, ".material": read_o3de, ".mjs": read_module,
           ".json": lambda file: json.loads(file.read_text()), ".mtlx": lambda file: xml.etree.ElementTree.parse(file)}
ELSEWHERE = {".tres", ".gdshader", ".import", ".usda", ".vert", ".frag", ".hlsl"}  # by Godot, tinyusdz, glslangValidator
PICTURES = {".png", ".exr"}


def main():
    read, unread, failed = collections.Counter(), collections.Counter(), 0
    for folder in sys.argv[1:]:
        for file in sorted(path for path in pathlib.Path(folder).rglob("*") if path.is_file() and not path.name.startswith(".")):
            if file.suffix in PICTURES:
                continue
            try:
                for picture in re.findall(r"[\"@(](?:[^\"@(\n]*/)?([^\"@(\n/]+\.(?:png|exr))[\"@)]", file.read_text()):
                    expect((file.parent / picture).exists(), f"there is no {picture}")
                if file.suffix in READERS:
                    READERS[file.suffix](file)
                    read[file.suffix] += 1
                elif file.suffix not in ELSEWHERE:
                    unread[file.suffix] += 1
            except Exception as error:  # whatever a parser finds wrong
                print(f"{file}: {type(error).__name__}: {error}")
                failed += 1
    print("read:", ", ".join(f"{n} {suffix}" for suffix, n in sorted(read.items())), f"- {failed} faults")
    if unread:
        print("no parser here for:", ", ".join(f"{n} {suffix}" for suffix, n in sorted(unread.items())))
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
