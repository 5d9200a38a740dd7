#!/usr/bin/python3
"""Compares the UVs that Godot fetched with a numpy emulation of its formula.

    parallax_check.py OUT.json HEIGHT.png [--png DIFF.png]

OUT.json, OUT.png, OUT.fine.png and OUT.fine2.png come from `run.sh ... --uv-ramp`; HEIGHT.png is
the height map that the material uses.  The material's numbers are given as
options, because the report does not hold them (see --help).

The formula, per pixel, with V the unit vector from the surface to the eye in the
frame (+u, +v, surface normal), h the height map's red channel:
    p = V.xy * scale * 0.01, where V.x, V.y change sign with the flips
    simple:  uv' = uv - p (1 - h(uv))
    deep:    n = mix(max_layers, min_layers, |V.z|); step uv by -p/n and the layer
             depth by 1/n while layer depth < 1 - h; then the crossing of the last
             two samples by linear interpolation.
Nothing is divided by V.z.
"""
# SPDX-FileCopyrightText: The Relievo authors
# SPDX-License-Identifier: GPL-3.0-or-later
import argparse
import json
import pathlib
import re

import numpy as np
from PIL import Image


def shown(code):
    """What the Compatibility renderer shows (0..255) for a colour texture's code: a
    polynomial for sRGB to linear, and one power without a toe back."""
    s = code / 255
    linear = s * (s * (s * 0.305306011 + 0.682171111) + 0.012522878)
    return 255 * np.maximum(1.055 * linear ** (1 / 2.4) - 0.055, 0)


def decode(coarse, fine, fine2):
    """uv (H, W, 2) of the three ramp pictures (godot.py writes the ramps)."""
    codes = np.linspace(60, 255, 3901)
    coarse, fine, fine2 = (np.interp(x[..., :2], shown(codes), codes) for x in (coarse, fine, fine2))
    rough = (coarse - 64 + 0.5) / 192
    out = np.zeros(rough.shape)
    for picture, shift in ((fine2, 0.25), (fine, 0.0)):
        t = (picture - 64) / 191
        # The monotonic pieces of the triangle wave: the one nearest to the rough value.
        best = np.full(rough.shape, np.inf)
        found = np.zeros(rough.shape)
        for k in range(34):
            u = (k + (t if k % 2 == 0 else 1 - t)) / 32 - shift / 16
            d = np.abs(u - rough)
            found = np.where(d < best, u, found)
            best = np.minimum(best, d)
        straight = (t > 0.15) & (t < 0.85)
        out = np.where(straight, found, out)
    return out


def read_camera(text):
    v = np.array([float(x) for x in re.search(r"\((.*)\)", text).group(1).split(",")])
    return v[:9].reshape(3, 3), v[9:]  # Rows of the basis (columns are the axes), origin.


def geometry(shot, camera, lift=0.0):
    """Per pixel: uv on the plane, V in (+u, +v, normal), inside. lift: m that the plane is moved up by."""
    basis, eye = read_camera(camera)
    eye = eye - [0, lift, 0]
    n = int(shot["size"])
    t = np.tan(np.radians(shot["fov"]) / 2)
    x = ((np.arange(n) + 0.5) / n * 2 - 1) * t
    ray = np.stack([np.broadcast_to(x, (n, n)), np.broadcast_to(-x[:, None], (n, n)),
                    np.full((n, n), -1.0)], -1) @ basis.T
    with np.errstate(divide="ignore", invalid="ignore"):
        s = -eye[1] / ray[..., 1]
    hit = eye + s[..., None] * ray
    uv = hit[..., [0, 2]] / shot["mesh_size"] + 0.5
    v = eye - hit
    v /= np.linalg.norm(v, axis=-1, keepdims=True)
    inside = (s > 0) & np.all((uv > 0) & (uv < 1), -1)
    return uv, np.stack([v[..., 0], v[..., 2], v[..., 1]], -1), inside


def sampler(path):
    """Bilinear, repeating, level 0, as 8 bit (Godot keeps 8 bits of a 16-bit PNG)."""
    image = Image.open(path)
    data = np.asarray(image)
    data = data / (65535.0 if data.dtype != np.uint8 else 255.0)
    if data.ndim == 3:
        data = data[..., 0]
    h, w = data.shape

    def sample(uv):
        x = uv[..., 0] * w - 0.5
        y = uv[..., 1] * h - 0.5
        i, j = np.floor(x).astype(int), np.floor(y).astype(int)
        a, b = x - i, y - j
        i0, i1, j0, j1 = i % w, (i + 1) % w, j % h, (j + 1) % h
        return ((data[j0, i0] * (1 - a) + data[j0, i1] * a) * (1 - b)
                + (data[j1, i0] * (1 - a) + data[j1, i1] * a) * b)
    return sample


def emulate(uv, v, height, scale, deep, least, most, flip_u, flip_v, invert=False):
    p = v[..., :2] * scale * 0.01 * np.array([-1 if flip_u else 1, -1 if flip_v else 1])
    if invert:
        depth_at = height
    else:
        def depth_at(q):
            return 1 - height(q)
    if not deep:
        return uv - p * depth_at(uv)[..., None], np.ones(uv.shape[:2])
    n = most + (least - most) * np.abs(v[..., 2])
    delta = p / n[..., None]
    at, layer, depth = uv.copy(), np.zeros(n.shape), depth_at(uv)
    fetches = np.ones(n.shape)
    while True:
        go = layer < depth
        if not go.any():
            break
        at = np.where(go[..., None], at - delta, at)
        depth = np.where(go, depth_at(at), depth)
        layer = np.where(go, layer + 1 / n, layer)
        fetches += go
    before = depth_at(at + delta) - layer + 1 / n
    after = depth - layer
    with np.errstate(divide="ignore", invalid="ignore"):
        w = after / (after - before)
    return at * (1 - w[..., None]) + (at + delta) * w[..., None], fetches + 1


def main():
    a = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    a.add_argument("report", type=pathlib.Path)
    a.add_argument("height", type=pathlib.Path)
    a.add_argument("--scale", type=float, default=5.0)
    a.add_argument("--off", action="store_true", help="height mapping off: the floor of the method")
    a.add_argument("--deep", action="store_true")
    a.add_argument("--min-layers", type=float, default=8)
    a.add_argument("--max-layers", type=float, default=32)
    a.add_argument("--flip-tangent", action="store_true")
    a.add_argument("--flip-binormal", action="store_true")
    a.add_argument("--invert", action="store_true", help="heightmap_flip_texture")
    a.add_argument("--search", action="store_true", help="try all signs of V.x and V.y")
    a.add_argument("--png", type=pathlib.Path, help="the difference: 255 is 0.01 of UV")
    a.add_argument("--npy", type=pathlib.Path, help="write the UVs that Godot fetched: (size, size, 2), NaN off the plane")
    a = a.parse_args()

    item = json.loads(a.report.read_text())["shots"][0]
    picture = a.report.with_suffix(".png")
    coarse = np.asarray(Image.open(picture).convert("RGB")).astype(float)
    fine = [np.asarray(Image.open(picture.with_suffix(f".{n}.png")).convert("RGB")).astype(float)
            for n in ("fine", "fine2")]
    got = decode(coarse, *fine)
    uv, v, inside = geometry(item["shot"], item["camera"])
    seen = inside & (coarse[..., 2] < 128)  # Not the blue background.
    if a.npy:
        np.save(a.npy, np.where(seen[..., None], got, np.nan))
    for fu in ((False, True) if a.search else (a.flip_tangent,)):
        for fv in ((False, True) if a.search else (a.flip_binormal,)):
            meant = uv if a.off else emulate(uv, v, sampler(a.height), 0 if a.off else a.scale, a.deep,
                                             a.min_layers, a.max_layers, fu, fv, a.invert)[0]
            d = got - meant
            d -= np.round(d)
            # At the wrap the coarse ramp runs from its end back to its start within a
            # texel: pixels that should be there are left out.
            clear = seen & np.all(np.abs(meant - np.round(meant)) > 1.5 / 192, -1)
            e = np.linalg.norm(d, axis=-1)[clear]
            print(f"{a.report.stem}: flips u {int(fu)} v {int(fv)}: {e.size} pixels, |duv| median {np.median(e):.6f} "
                  f"p99 {np.percentile(e, 99):.6f} p99.9 {np.percentile(e, 99.9):.6f} max {e.max():.5f}, "
                  f"over 0.001: {100 * np.mean(e > 0.001):.2f} %; "
                  f"mean du {d[..., 0][clear].mean():+.6f} dv {d[..., 1][clear].mean():+.6f}; "
                  f"parallax itself median {np.median(np.linalg.norm(meant - uv, axis=-1)[clear]):.5f}")
            if a.png and not a.search:
                full = np.where(clear, np.linalg.norm(d, axis=-1), 0)
                Image.fromarray(np.clip(full / 0.01 * 255, 0, 255).astype(np.uint8)).save(a.png)


if __name__ == "__main__":
    main()
