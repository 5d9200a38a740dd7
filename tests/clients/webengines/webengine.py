#!/usr/bin/python3
"""Runs a real web engine on a height map and compares the UV that it fetched at each
pixel with the engine's formula in numpy.

    run.sh ENGINE MATERIAL_FOLDER OUT [options]     ENGINE: babylon, playcanvas, three

MATERIAL_FOLDER holds height.png (8 or 16 bit, red is used) and, for Babylon.js,
normal.png.  Written: OUT.json (report), OUT.N.npy (UVs of shot N: (size, size, 2), NaN off the
plane), OUT.console.txt, with --png OUT.N.png (the difference, 255 is 0.01 of UV).
--pitch is the camera's height over the plane in degrees: 90 is straight down, so 45 is
45 degrees from the vertical and 20 is 70 degrees from it.
"""
# SPDX-FileCopyrightText: The Relievo authors
# SPDX-License-Identifier: GPL-3.0-or-later
import argparse
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

import numpy as np
from PIL import Image

import formulas

HERE = pathlib.Path(__file__).resolve().parent


def numbers(text):
    return [float(x) for x in text.split(",")]


def options():
    a = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    a.add_argument("engine", choices=("babylon", "playcanvas", "three"))
    a.add_argument("material_folder", type=pathlib.Path)
    a.add_argument("out", type=pathlib.Path, help="start of the names of what is written")
    a.add_argument("--pitch", type=numbers, default=[45, 20], help="several: 45,20")
    a.add_argument("--yaw", type=numbers, default=[20], help="several: each with each pitch")
    a.add_argument("--distance", type=float, default=1.6)
    a.add_argument("--fov", type=float, default=40, help="vertical, degrees")
    a.add_argument("--size", type=int, default=512)
    a.add_argument("--mode", default=None,
                   help="off, offset, occlusion (Babylon.js, PlayCanvas); relief, displacement (three.js)")
    a.add_argument("--scale", type=float, default=0.05,
                   help="parallaxScaleBias; heightMapFactor / 10; three.js: depth or displacementScale")
    a.add_argument("--mips", action="store_true", help="mipmaps on the height map (emulation reads level 0, PlayCanvas occlusion excepted)")
    a.add_argument("--tangents", action="store_true", help="give the mesh tangents")
    a.add_argument("--png", action="store_true")
    a.add_argument("--timeout", type=int, default=120)
    g = a.add_argument_group("Babylon.js")
    g.add_argument("--material", choices=("standard", "pbr"), default="standard")
    g.add_argument("--rhs", action="store_true", help="scene.useRightHandedSystem")
    g.add_argument("--v-up", action="store_true", help="mesh with v up, textures with invertY")
    g.add_argument("--unlit", action="store_true", help="disableLighting (drops the mesh's tangents) / PBR unlit")
    g.add_argument("--mirrored", action="store_true", help="left-handed by scaling z by -1, as the glTF loader does")
    g.add_argument("--invert-x", action="store_true", help="invertNormalMapX")
    g.add_argument("--invert-y", action="store_true", help="invertNormalMapY")
    g.add_argument("--search", action="store_true", help="try all signs of V.x, V.y")
    g.add_argument("--level", type=float, default=1, help="bumpTexture.level")
    g = a.add_argument_group("PlayCanvas")
    g.add_argument("--base", type=float, default=0.5, help="heightMapBase")
    g.add_argument("--samples", type=float, default=16, help="parallaxSamples")
    g = a.add_argument_group("three.js")
    g.add_argument("--bias", type=float, default=0, help="displacementBias")
    g.add_argument("--segments", type=int, default=256)
    g.add_argument("--glsl", type=pathlib.Path, help="GLSL ES 3.00 with vec2 relief(sampler2D map, vec2 uv, vec3 V, float depth)")
    o = a.parse_args()
    o.mode = o.mode or ("relief" if o.engine == "three" else "occlusion")
    return o


def prepare(o, folder):
    """The textures as the engine gets them; returns heights in 0..1, top row first."""
    raw = np.asarray(Image.open(o.material_folder / "height.png"))
    raw = raw[..., 0] if raw.ndim == 3 else raw
    exact = raw / (255.0 if raw.dtype == np.uint8 else 65535.0)
    eight = np.round(exact * 255).astype(np.uint8)
    Image.fromarray(eight).save(folder / "height8.png")
    exact.astype("<f4").tofile(folder / "height.f32")
    normal = o.material_folder / "normal.png"
    if normal.exists():
        rgb = np.asarray(Image.open(normal).convert("RGB"))
        if rgb.shape[:2] == eight.shape:
            Image.fromarray(np.dstack([rgb, eight])).save(folder / "bump.png")
    if o.glsl:
        shutil.copy(o.glsl, folder / "relief.glsl")
    return exact if o.engine == "three" and o.mode == "relief" else eight / 255.0


def main():
    o = options()
    shots = [{"pitch": p, "yaw": y} for p in o.pitch for y in o.yaw]
    with tempfile.TemporaryDirectory(prefix="webengines-") as name:
        folder = pathlib.Path(name)
        height = prepare(o, folder)
        job = {"engine": o.engine, "size": o.size, "distance": o.distance, "fov": o.fov, "shots": shots,
               "mode": o.mode, "scale": o.scale, "factor": o.scale * 10, "mips": o.mips, "tangents": o.tangents,
               "material": o.material, "rhs": o.rhs, "vUp": o.v_up, "level": o.level, "unlit": o.unlit,
               "mirrored": o.mirrored, "invertX": o.invert_x, "invertY": o.invert_y, "base": o.base,
               "samples": o.samples, "bias": o.bias, "segments": o.segments, "glsl": bool(o.glsl),
               "heightSize": [height.shape[1], height.shape[0]]}
        (folder / "job.json").write_text(json.dumps(job))
        status = subprocess.run(["node", HERE / "drive.mjs", os.environ["WEBENGINES_CACHE"], folder / "job.json", folder,
                                 str(o.timeout)]).returncode
        if (folder / "console.txt").exists():
            shutil.copy(folder / "console.txt", f"{o.out}.console.txt")
        if not (folder / "report.json").exists():
            sys.exit(2)
        report = json.loads((folder / "report.json").read_text())
        pictures = [np.fromfile(f, "<f4") for f in sorted(folder.glob("shot*.f32"), key=lambda f: int(f.stem[4:]))]
    print(f"{o.engine} {report['version']} {o.mode}: {report['seconds']:.1f} s")

    results = []
    if o.mode == "displacement":
        results.append(formulas.displacement(pictures[0].reshape(o.segments + 1, -1, 4), height, o))
        print(results[-1])
    else:
        for i, (shot, picture) in enumerate(zip(shots, pictures)):
            picture = picture.reshape(o.size, o.size, 4).astype(float)
            seen = picture[..., 2] > 0.5
            uv, v, inside = formulas.geometry(shot, o)
            got = picture[..., :2]
            meant = formulas.emulate(o, height, uv, v)
            if o.search:
                best = None
                for flips in ((1, 1, 1), (-1, 1, 1), (1, -1, 1), (-1, -1, 1)):
                    m = formulas.emulate(o, height, uv, v * flips)
                    e = np.median(np.linalg.norm((got - m) - np.round(got - m), axis=-1)[seen & inside])
                    if best is None or e < best[0]:
                        best = e, flips, m
                meant = best[2]
                print(f"signs of V.x, V.y that fit best: {best[1][:2]}")
            np.save(f"{o.out}.{i}.npy", np.where(seen[..., None], got, np.nan))
            d = got - meant
            d -= np.round(d)
            # The ramp wraps within a texel: leave those pixels out.
            clear = seen & inside & np.all(np.abs(meant - np.round(meant)) > 1.5 / 256, -1)
            e = np.linalg.norm(d, axis=-1)[clear]
            if not e.size:
                print("the plane is not in the picture")
                status = status or 1
                continue
            moved = np.linalg.norm(meant - uv, axis=-1)[clear]
            results.append({"shot": shot, "pixels": int(e.size), "median": float(np.median(e)),
                            "p99": float(np.percentile(e, 99)), "max": float(e.max()),
                            "over_0.001": float(np.mean(e > 0.001)), "moved_median": float(np.median(moved))})
            r = results[-1]
            print(f"pitch {shot['pitch']:g} ({90 - shot['pitch']:g} from the vertical) yaw {shot['yaw']:g}: {r['pixels']} pixels, "
                  f"|duv| median {r['median']:.7f} p99 {r['p99']:.6f} max {r['max']:.5f}, over 0.001: "
                  f"{100 * r['over_0.001']:.2f} %; parallax itself median {r['moved_median']:.5f} p99 {np.percentile(moved, 99):.5f}")
            if o.png:
                full = np.where(clear, np.linalg.norm(d, axis=-1), 0)
                Image.fromarray(np.clip(full / 0.01 * 255, 0, 255).astype(np.uint8)).save(f"{o.out}.{i}.png")
    pathlib.Path(f"{o.out}.json").write_text(json.dumps({"job": job, **report, "results": results}, indent=1))
    sys.exit(status)


if __name__ == "__main__":
    main()
