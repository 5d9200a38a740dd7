#!/usr/bin/python3
"""Whether a technique fetches the texture that its engine was seen to fetch.

    engine_uvs.py RELIEVO HEIGHT TECHNIQUE SCALE REPORT.json [UVS.npy SHOT]

REPORT.json: of godot4/run.sh --uv-ramp (its pictures beside it), or of webengines/run.sh, then with the UVs of shot SHOT. Each pixel of the
plane becomes a ray of `relievo trace`: V, the unit vector to the eye in (+u, +v, normal), and the depth SCALE in UV give duv = -V.xy / V.z SCALE
and cosView = V.z. Fails when fewer than 99 % of the pixels agree within 0.001 of UV.
"""
# SPDX-FileCopyrightText: The Relievo authors
# SPDX-License-Identifier: GPL-3.0-or-later
import argparse
import json
import os
import pathlib
import subprocess
import sys
import tempfile

import numpy as np
from PIL import Image

HERE = pathlib.Path(__file__).resolve().parent
sys.path += [str(HERE / "godot4"), str(HERE / "webengines")]
import formulas  # noqa: E402
import parallax_check  # noqa: E402


def godot(report):
    """uv on the plane, V, the UVs fetched, which pixels count."""
    item = json.loads(report.read_text())["shots"][0]
    picture = report.with_suffix(".png")
    ramps = [np.asarray(Image.open(picture.with_suffix(f"{kind}.png")).convert("RGB")).astype(float) for kind in ("", ".fine", ".fine2")]
    uv, v, inside = parallax_check.geometry(item["shot"], item["camera"])
    return uv, v, parallax_check.decode(*ramps), inside & (ramps[0][..., 2] < 128), 1.5 / 192


def web(report, uvs, shot):
    job = json.loads(report.read_text())["job"]
    got = np.load(uvs)
    uv, v, inside = formulas.geometry(job["shots"][shot], argparse.Namespace(**job))
    return uv, v, got, inside & np.isfinite(got).all(-1), 1.5 / 256


def traced_rays(relievo, height, technique, rays):
    """The UVs that the technique fetches, one a ray of u, v, du, dv, cosView."""
    with tempfile.TemporaryDirectory() as name:
        rays_file, hits_file = os.path.join(name, "rays.csv"), os.path.join(name, "hits.csv")
        np.savetxt(rays_file, rays, delimiter=",", header="u,v,du,dv,cosView", comments="", fmt="%.9g")
        subprocess.run([relievo, "trace", height, "--technique", technique, "--rays", rays_file, "-o", hits_file, "--quiet"], check=True)
        return np.loadtxt(hits_file, delimiter=",", skiprows=1)[:, 2:4]


def traced(relievo, height, technique, uv, v, scale):
    """The same, one a pixel: uv, V and the depth in UV."""
    return traced_rays(relievo, height, technique, np.concatenate([uv, -v[:, :2] / v[:, 2:] * scale, v[:, 2:]], -1))


def difference(got, found, border):
    """Lengths of the differences in UV and which pixels they are of: not those where a ramp wraps within a texel."""
    away = got - found
    away -= np.round(away)
    clear = np.all(np.abs(found - np.round(found)) > border, -1)
    return np.linalg.norm(away, axis=-1)[clear], clear


def main():
    relievo, height, technique, scale, report = sys.argv[1:6]
    report = pathlib.Path(report)
    uv, v, got, seen, border = web(report, sys.argv[6], int(sys.argv[7])) if len(sys.argv) > 6 else godot(report)
    found = traced(relievo, height, technique, uv[seen], v[seen], float(scale))
    error, clear = difference(got[seen], found, border)
    moved = np.linalg.norm(found - uv[seen], axis=-1)[clear]
    good = np.mean(error < 0.001)
    print(f"{technique}: {error.size} pixels, median {np.median(error):.6f}, p99 {np.percentile(error, 99):.6f}, largest {error.max():.4f}, "
          f"{100 * good:.2f} % within 0.001 of UV; parallax itself {np.median(moved):.4f}")
    sys.exit(0 if good >= 0.99 and error.size > 10000 and np.median(moved) > 0.005 else 1)


if __name__ == "__main__":
    main()
