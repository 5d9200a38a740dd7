#!/usr/bin/python3
"""Runs the exported modules of an engine in headless Chromium: check_web.py RELIEVO OUT ENGINE (babylon, playcanvas or three).

OUT/KIND/SET/ENGINE holds one material each, and SET/packed what was promised of it. Every material must be made without a word on the console, with
the promised depth; the UVs of the parallax are compared with `relievo trace` at 45 and 70 degrees, the vertices of three.js with the heights. The
same for each module's second material, which runs our own technique.
"""
# SPDX-FileCopyrightText: The Relievo authors
# SPDX-License-Identifier: GPL-3.0-or-later
import argparse
import json
import os
import pathlib
import re
import subprocess
import sys

import numpy as np
from PIL import Image

HERE = pathlib.Path(__file__).resolve().parent
sys.path += [str(HERE), str(HERE.parent), str(HERE.parent / "webengines")]
import engine_uvs  # noqa: E402
import formulas  # noqa: E402
from promised import promised  # noqa: E402

SHOTS = [{"pitch": 45, "yaw": 20}, {"pitch": 20, "yaw": 20}]  # of the camera: 45 and 70 degrees from the normal
QUIET = ("GPU stall due to ReadPixels", "Babylon.js v", "Powered by PlayCanvas")  # of the harness's own reading, and greetings


def heights_of(folder, engine, out):
    """The picture that holds the heights: Babylon's lie in the alpha of the normal map."""
    if engine != "babylon":
        return next(folder.glob("*_height.png"))
    Image.open(next(folder.glob("*_normal_height.png"))).getchannel("A").save(out / "height.png")
    return out / "height.png"


def uvs(relievo, job, engine, folder, shot, picture, out):
    told = promised(folder)
    uv, eye, inside = formulas.geometry(shot, argparse.Namespace(**job))
    inside &= picture[..., 2] > 0.5
    heights = heights_of(folder, engine, out)
    if engine == "playcanvas":  # takes fewer steps where pixels are wider than texels; `trace` knows no pixels
        texels = told.placed(uv) * Image.open(heights).size
        inside &= np.maximum(*(np.linalg.norm(formulas.quad(texels, axis), axis=-1) for axis in (0, 1))) < 1
        if inside.sum() < 10000:
            return f"{90 - shot['pitch']} degrees, UVs not compared: pixels are wider than texels", True
    rays = told.rays(uv[inside], eye[inside])
    if engine == "playcanvas":  # its midlevel lies on the mesh, the others' white: the ray comes in from above
        rays[:, :2] -= (1 - told.midlevel) * rays[:, 2:4]
    found = engine_uvs.traced_rays(relievo, heights, "as-" + engine, rays)
    error, _ = engine_uvs.difference(picture[inside][:, :2].astype(float), found, 1.5 / 256)
    moved = np.linalg.norm(found - rays[:, :2], axis=-1)
    good = float(np.mean(error < 0.001))
    return (f"{90 - shot['pitch']} degrees, {error.size} pixels, median {np.median(error):.6f}, p99 {np.percentile(error, 99):.6f}, "
            f"{100 * good:.2f} % within 0.001 of UV; relief moves {np.median(moved):.4f}"), good >= 0.99 and error.size > 10000


def own_uvs(relievo, job, module, shot, picture, out):
    """Of the shader that runs our technique: its mesh is pushed out so that the midlevel lies where the mesh was."""
    folder = module.parent
    told = promised(folder)
    technique = re.search(r"behind each pixel by ([a-z0-9-]+)", module.read_text()).group(1)
    uv, eye, inside = formulas.geometry(shot, argparse.Namespace(**{**job, "size": job["own"]}))
    inside &= picture[..., 2] > 0.5
    planes = np.asarray(Image.open(next(folder.glob("*_height_bytes.png")))).astype(np.uint16)
    Image.fromarray(planes[..., 0] * np.uint16(256) + planes[..., 1]).save(out / "heights.png")
    rays = told.rays(uv[inside], eye[inside])
    rays[:, :2] -= (1 - told.midlevel) * rays[:, 2:4]
    found = engine_uvs.traced_rays(relievo, out / "heights.png", technique, rays)
    error, _ = engine_uvs.difference(picture[inside][:, :2].astype(float), found, 0)
    moved = np.linalg.norm(found - rays[:, :2], axis=-1)
    good = float(np.mean(error < 0.001))
    return (f"own {technique}, {90 - shot['pitch']} degrees, {error.size} pixels, median {np.median(error):.7f}, p99 {np.percentile(error, 99):.7f}, "
            f"{100 * good:.2f} % within 0.001 of UV; relief moves {np.median(moved):.4f}"), good >= 0.99 and error.size > 10000


def vertices(folder, picture):
    told = promised(folder)
    raw = np.asarray(Image.open(next(folder.glob("*_height.png"))))
    heights = (raw if raw.ndim == 2 else raw[..., 0]) / (255.0 if raw.dtype == np.uint8 else 65535.0)
    at = np.arange(len(picture)) / (len(picture) - 1)
    uv = np.stack(np.broadcast_arrays(at[None, :], at[:, None]), -1)
    meant = (formulas.sampler(heights)(told.placed(uv)) - told.midlevel) * told.depth
    inner = (slice(1, -1), slice(1, -1))
    error = np.abs(picture[..., 1] - meant)[inner] / told.depth
    return (f"{error.size} vertices, median {100 * np.median(error):.4f} %, largest {100 * error.max():.3f} % of the depth of {told.depth * 1000:.2f} mm",
            error.max() < 0.01 and np.all(picture[inner][..., 3] > 0.5))


def main():
    relievo, out, engine = sys.argv[1], pathlib.Path(sys.argv[2]).resolve(), sys.argv[3]
    modules = sorted(out.rglob(f"{engine}/*.mjs"))
    work = out / f"run-{engine}"
    work.mkdir()
    job = {"engine": engine, "adapter": str(HERE / f"{engine}.mjs"), "exports": str(out), "size": 257 if engine == "three" else 448, "own": 448, "distance": 1.6,
           "fov": 40, "shots": SHOTS, "materials": [{"folder": str(m.parent.relative_to(out)), "module": m.name} for m in modules]}
    (work / "job.json").write_text(json.dumps(job))
    failed = subprocess.run(["node", HERE.parent / "webengines" / "drive.mjs", os.environ["WEBENGINES_CACHE"], work / "job.json", work, "600"]).returncode
    if not (work / "report.json").exists():
        sys.exit(1)
    said = [line for line in (work / "console.txt").read_text().splitlines() if not any(words in line for words in QUIET)]
    for line in said:
        print(f"console: {line[:300]}")
    report = json.loads((work / "report.json").read_text())
    shots = 1 if engine == "three" else len(SHOTS)
    failed |= bool(said)
    for i, (module, made) in enumerate(zip(modules, report["made"])):
        name = "/".join(module.relative_to(out).parts[:2])
        told = promised(module.parent)
        wanted = told.depth if engine == "three" else told.depth * told.tiling
        if abs(made["depth"] - wanted) > 1e-5 * wanted or made["broken"] or not made["parallax"]:
            print(f"{name}: {made}, {wanted} was promised - WRONG")
            failed = True
        if engine == "three" and abs(made["bias"] + told.midlevel * told.depth) > 1e-5 * told.depth:
            print(f"{name}: bias {made['bias']} - WRONG")
            failed = True
        for j in range(shots):
            picture = np.fromfile(work / f"shot{i * shots + j}.f32", "<f4").reshape(job["size"], job["size"], 4)
            line, good = vertices(module.parent, picture) if engine == "three" else uvs(relievo, job, engine, module.parent, SHOTS[j], picture, work)
            print(f"{name}: {line}{'' if good else ' - WRONG'}")
            failed |= not good
        for j, shot in enumerate(SHOTS):
            picture = np.fromfile(work / f"own{i * len(SHOTS) + j}.f32", "<f4").reshape(job["own"], job["own"], 4)
            line, good = own_uvs(relievo, job, module, shot, picture, work)
            print(f"{name}: {line}{'' if good else ' - WRONG'}")
            failed |= not good
    print(f"{engine} {report['version']}: {len(modules)} materials")
    sys.exit(1 if failed or not modules else 0)


if __name__ == "__main__":
    main()
