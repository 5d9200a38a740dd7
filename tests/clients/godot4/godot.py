#!/usr/bin/env python3
"""Renders an exported material with the real Godot 4.6 (see README.md)."""
# SPDX-FileCopyrightText: The Relievo authors
# SPDX-License-Identifier: GPL-3.0-or-later
import argparse
import json
import os
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile
import zlib

import exr
from pck import write_pck

HERE = pathlib.Path(__file__).resolve().parent

# Report kinds that mean the export is wrong.
FAULTS = ("error", "unknown-property", "lost-resource", "unreadable-value",
          "other-type", "other-value")


def png(width, height, rows):
    """An 8-bit RGB PNG of rows of bytes."""
    def chunk(kind, data):
        body = kind + data
        return struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))
    raw = b"".join(b"\0" + row for row in rows)
    return (b"\x89PNG\r\n\x1a\n"
            + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0))
            + chunk(b"IDAT", zlib.compress(raw, 6)) + chunk(b"IEND", b""))


def ramp(values):
    """A square picture: red is values[column], green values[row]."""
    n = len(values)
    red = bytearray(3 * n)
    red[0::3] = bytes(values)
    rows = []
    for v in values:
        red[1::3] = bytes([v]) * n
        rows.append(bytes(red))
    return png(n, n, rows)


def ramps():
    """Codes 64 to 255 only, for the Compatibility renderer crushes dark ones (README).
    Coarse: 192 texels, so u = (code - 64 + 0.5) / 192.  Fine: a triangle wave of 16
    periods over 2048 texels, which the coarse one unfolds; fine2 is the same a quarter
    of a period later, for where fine has its turns (parallax_check.py)."""
    def wave(shift):
        t = [((i + 0.5) / 2048 * 16 + shift) % 1 for i in range(2048)]
        return [64 + round(191 * (2 * x if x < 0.5 else 2 - 2 * x)) for x in t]
    return {"ramp_coarse.png": ramp(range(64, 256)), "ramp_fine.png": ramp(wave(0)),
            "ramp_fine2.png": ramp(wave(0.25))}


def find_material(folder, name):
    if name:
        return name
    found = sorted(p.relative_to(folder).as_posix() for p in folder.rglob("*.tres")
                   if 'Material' in p.read_text(errors="replace").split("]", 1)[0])
    if len(found) != 1:
        sys.exit(f"{folder}: {len(found)} material .tres files; say which with --material: {found}")
    return found[0]


def arguments():
    a = argparse.ArgumentParser(description=__doc__)
    a.add_argument("folder", type=pathlib.Path, help="the exported folder (.tres, pictures, .gdshader)")
    a.add_argument("out", type=pathlib.Path, help="the picture, OUT.png")
    a.add_argument("--material", help="the .tres inside the folder (default: the only one)")
    a.add_argument("--mount", default="material", help="the folder's place below res:// (default: material; "
                   "'.' for the root, where the paths in the .tres are res://file.png)")
    a.add_argument("--pitch", type=float, default=60, help="camera's height above the plane, degrees (90: from above)")
    a.add_argument("--yaw", type=float, default=0, help="camera's turn about the up axis; 0 looks along -Z, so v points at the viewer")
    a.add_argument("--fov", type=float, default=35, help="vertical, degrees")
    a.add_argument("--distance", type=float, default=1.8, help="camera to the plane's middle, metres")
    a.add_argument("--mesh-size", type=float, default=1.0, help="side of the plane, metres")
    a.add_argument("--size", type=int, default=512, help="side of the picture, pixels")
    a.add_argument("--light", type=float, default=1.0)
    a.add_argument("--light-pitch", type=float, default=45)
    a.add_argument("--light-yaw", type=float, default=-60)
    a.add_argument("--ambient", type=float, default=0.25)
    a.add_argument("--uv-ramp", action="store_true", dest="uv",
                   help="show the UV that the colour is read at (OUT.png coarse, OUT.fine.png, OUT.fine2.png)")
    a.add_argument("--uv-param", default="", help="with --uv-ramp and a ShaderMaterial: its colour sampler")
    a.add_argument("--set", action="append", default=[], metavar="NAME=VALUE",
                   help="a property set after loading, in Godot's text form; may be repeated")
    a.add_argument("--shots", type=pathlib.Path, help="a JSON list of {out, <any option above>}: many pictures in one start")
    a.add_argument("--timeout", type=float, default=300)
    a.add_argument("--cache", type=pathlib.Path, default=os.environ.get("GODOT_CACHE", HERE.parent / "cache"))
    a.add_argument("--keep", type=pathlib.Path, help="keep the working folder here")
    return a.parse_args()


def main():
    a = arguments()
    first = {k: getattr(a, k) for k in ("pitch", "yaw", "fov", "distance", "mesh_size", "size", "light",
                                        "light_pitch", "light_yaw", "ambient", "uv", "uv_param")}
    first["set"] = dict(s.split("=", 1) for s in a.set)
    first["material"] = find_material(a.folder, a.material)
    shots = []
    for more in json.loads(a.shots.read_text()) if a.shots else [{"out": str(a.out)}]:
        shot = {**first, **more, "set": {**first["set"], **more.get("set", {})}}
        mount = "" if a.mount == "." else a.mount.strip("/") + "/"
        shot["material"] = f"res://{mount}{shot['material']}"
        shots.append(shot)

    files = {p.name: p.read_bytes() for p in (HERE / "project").iterdir()}
    files.update(ramps())
    for p in a.folder.rglob("*"):
        if p.is_file():
            data = p.read_bytes()
            if p.suffix.lower() == ".exr":
                try:
                    data = exr.to_raw(data)
                except (ValueError, IndexError, struct.error, zlib.error) as error:
                    print(f"  {p}: {error}", file=sys.stderr)
            files[mount + p.relative_to(a.folder).as_posix()] = data
    # Without this list of class names (here: none) the engine prints an error.
    files[".godot/global_script_class_cache.cfg"] = b"list=[]\n"
    files["job.json"] = json.dumps({"shots": shots}).encode()

    work = a.keep or pathlib.Path(tempfile.mkdtemp(prefix="godot."))
    work.mkdir(parents=True, exist_ok=True)
    try:
        write_pck(work / "job.pck", files)
        rc = subprocess.call(["node", str(HERE / "drive.mjs"), str(a.cache), str(work / "job.pck"), str(work),
                              str(a.timeout)])
        if rc != 0:
            print((work / "console.txt").read_text(), file=sys.stderr)
            return 2
        report = json.loads((work / "report.json").read_text())
        for i, shot in enumerate(shots):
            out = a.out.parent / shot["out"] if a.shots else a.out
            for name, to in (("lit", out), ("coarse", out), ("fine", out.with_suffix(".fine.png")),
                             ("fine2", out.with_suffix(".fine2.png"))):
                if (work / f"{i}.{name}.png").exists():
                    shutil.copy(work / f"{i}.{name}.png", to)
            out.with_suffix(".json").write_text(json.dumps(
                {**report, "shots": report["shots"][i:i + 1]}, indent=1))
    finally:
        if not a.keep:
            shutil.rmtree(work)
    faults = [m for m in report["messages"] if m["kind"] in FAULTS]
    print(f"Godot {report['engine']}, {report.get('properties_checked', 0)} properties checked, "
          f"{len(faults)} faults, {len(report['stderr'])} lines on stderr")
    for m in report["messages"]:
        print(f"  {m['kind']}: {m['text']}")
    for line in report["stderr"]:
        print(f"  stderr: {line}")
    return 1 if faults or any("ERROR" in line for line in report["stderr"]) else 0


if __name__ == "__main__":
    sys.exit(main())
