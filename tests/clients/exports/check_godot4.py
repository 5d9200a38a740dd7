#!/usr/bin/python3
"""Loads every exported material of OUT/all in Godot 4, and compares UVs: check_godot4.py RELIEVO OUT

OUT/all/KIND/SET/TARGET holds one material each, and SET/packed what was promised of it. UVs of the sample and of a 16-bit set are compared at 45 and
70 degrees with `relievo trace`: those of the StandardMaterial3D with as-godot4, those of the shader with cell cones with the reference. The depth of
a ray is the promised one in metres, laid on the plane's texture as it is placed there: so a wrong number, also with tiling, is seen.
"""
# SPDX-FileCopyrightText: The Relievo authors
# SPDX-License-Identifier: GPL-3.0-or-later
import json
import pathlib
import subprocess
import sys

import numpy as np
from PIL import Image

HERE = pathlib.Path(__file__).resolve().parent
sys.path += [str(HERE), str(HERE.parent), str(HERE.parent / "godot4")]
import engine_uvs  # noqa: E402
import parallax_check  # noqa: E402
from promised import promised  # noqa: E402

PITCHES = (45, 20)  # of the camera: 45 and 70 degrees from the normal
SETS = ("sampleBricks256", "panda_terrain_16bit")
COMPARED = {"standard": "as-godot4", "standard-placed": "as-godot4", "cell-cone": "reference", "cell-cone-placed": "reference", "relief": "relief"}


def materials(folder):
    return sorted(path.relative_to(folder) for path in folder.rglob("*.tres"))


def shots_of(folder):
    """What Godot is asked for: a small lit picture of each material, and UV ramps."""
    shots = []
    for material in materials(folder):
        shots.append({"out": f"lit-{'-'.join(material.parts[:2])}.png", "material": str(material), "uv": False, "size": 96})
        if material.parts[0] in COMPARED and material.parts[1] in SETS:
            shader = "godot4-shader" in material.parts
            shots += [{"out": f"uv-{material.parts[0]}-{material.parts[1]}-{pitch}.png", "material": str(material), "uv": True, "pitch": pitch, "yaw": 20,
                       "size": 448, **({"uv_param": "color_map", "set": {"tint": "Color(1, 1, 1, 1)", "emission_strength": "0.0"}} if shader else {})}
                      for pitch in PITCHES]
    return shots


def heights_of(folder, work):
    """A file that holds the heights that the material reads."""
    pair = next(folder.glob("*_height_bytes.png"), None)
    if pair:  # two bytes, in red and green
        rgb = np.asarray(Image.open(pair).convert("RGB")).astype(np.uint16)
        whole = work / "height16.png"
        Image.fromarray(rgb[..., 0] * np.uint16(256) + rgb[..., 1]).save(whole)
        return whole
    return next(folder.glob("*_height.exr"), None) or next(folder.glob("*_height.png"))


def compare(relievo, out, shot, slack=0.001):
    """A line of figures, and whether 99 % agree."""
    material = out / "all" / shot["material"]
    kind = pathlib.Path(shot["material"]).parts[0]
    told = promised(material.parent)
    picture = out / shot["out"]
    item = json.loads(picture.with_suffix(".json").read_text())["shots"][0]
    ramps = [np.asarray(Image.open(picture.with_suffix(f"{name}.png")).convert("RGB")).astype(float) for name in ("", ".fine", ".fine2")]
    lift = told.depth * (1 - told.midlevel) if "godot4-shader" in shot["material"] else 0
    uv, eye, inside = parallax_check.geometry(item["shot"], item["camera"], lift)
    inside &= ramps[0][..., 2] < 128
    got = parallax_check.decode(*ramps)[inside]
    rays = told.rays(uv[inside], eye[inside])
    found = engine_uvs.traced_rays(relievo, heights_of(material.parent, out), COMPARED[kind], rays)
    error, _ = engine_uvs.difference(got, found, 1.5 / 192)
    moved = np.linalg.norm(found - rays[:, :2], axis=-1)
    good = float(np.mean(error < slack))
    line = (f"{kind} {pathlib.Path(shot['material']).parts[1]}, {90 - shot['pitch']} degrees, against {COMPARED[kind]}: {error.size} pixels, "
            f"median {np.median(error):.6f}, p99 {np.percentile(error, 99):.6f}, {100 * good:.2f} % within {slack} of UV; relief moves {np.median(moved):.4f}")
    return line, good >= 0.99 and error.size > 10000 and np.median(moved) > 0.002


def main():
    relievo, out = sys.argv[1], pathlib.Path(sys.argv[2])
    shots = shots_of(out / "all")
    (out / "shots.json").write_text(json.dumps(shots))
    first = str(materials(out / "all")[0])
    done = subprocess.run([HERE.parent / "godot4" / "run.sh", out / "all", out / "x.png", "--material", first, "--shots", out / "shots.json",
                           "--timeout", "1500"])
    failed = done.returncode != 0
    if done.returncode > 1:
        sys.exit(1)
    for shot in shots:
        if shot["uv"]:
            line, good = compare(relievo, out, shot)
            print(line if good else f"{line} - WRONG")
            failed |= not good
    print(f"{sum(not shot['uv'] for shot in shots)} materials drawn, {sum(shot['uv'] for shot in shots)} pictures of UVs")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
