"""A small EXR reader for what material exports write: one part, scan lines, half or
float, no, ZIPS or ZIP compression.

It stands in for the engine's own, which ends the single-threaded web build ("thread
constructor failed").  So an EXR's contents are checked here, not its reading by Godot.
"""
# SPDX-FileCopyrightText: The Relievo authors
# SPDX-License-Identifier: GPL-3.0-or-later
import itertools
import struct
import zlib

# Godot's Image.Format by (channels, bytes a sample).
FORMATS = {(1, 4): 8, (2, 4): 9, (3, 4): 10, (4, 4): 11, (1, 2): 12, (2, 2): 13, (3, 2): 14, (4, 2): 15}


def text(data, at):
    end = data.index(b"\0", at)
    return data[at:end].decode(), end + 1


def to_raw(data):
    """The bytes that raw_texture_loader.gd takes: "RAWI", width, height, Godot's
    image format, interleaved samples."""
    magic, version = struct.unpack_from("<II", data)
    if magic != 20000630 or version & ~0xFF & ~0x400:
        raise ValueError("not a one-part scan-line EXR")
    at, header = 8, {}
    while data[at]:
        name, at = text(data, at)
        _, at = text(data, at)
        size, = struct.unpack_from("<I", data, at)
        header[name] = data[at + 4:at + 4 + size]
        at += 4 + size
    at += 1
    left, top, right, bottom = struct.unpack("<4i", header["dataWindow"])
    width, height = right - left + 1, bottom - top + 1
    compression = header["compression"][0]
    if compression not in (0, 2, 3):
        raise ValueError(f"EXR compression {compression} is not read here (only none, ZIPS, ZIP)")
    block = 16 if compression == 3 else 1

    channels, c = [], 0
    while header["channels"][c]:
        name, c = text(header["channels"], c)
        kind, = struct.unpack_from("<I", header["channels"], c)
        channels.append((name, kind))
        c += 16
    kinds = {k for _, k in channels}
    if kinds not in ({1}, {2}):
        raise ValueError("EXR channels that are not all half or all float")
    sample = 2 if kinds == {1} else 4
    names = [n for n, _ in channels]
    order = names if len(names) == 1 else [n for n in "RGBA" if n in names]
    if len(order) != len(names):
        raise ValueError(f"EXR channels {names}")

    pixel = sample * len(order)
    out = bytearray(width * height * pixel)
    line = width * sample
    for offset in struct.unpack_from(f"<{-(-height // block)}Q", data, at):
        y, size = struct.unpack_from("<iI", data, offset)
        y -= top
        rows = min(block, height - y)
        body = data[offset + 8:offset + 8 + size]
        if compression and size < rows * line * len(names):
            body = zlib.decompress(body)
            body = bytes(itertools.accumulate(body, lambda a, b: (a + b - 128) & 255))
            half = (len(body) + 1) // 2
            joined = bytearray(len(body))
            joined[0::2], joined[1::2] = body[:half], body[half:]
            body = joined
        for r in range(rows):
            start = (y + r) * width * pixel
            for i, name in enumerate(names):
                source = body[(r * len(names) + i) * line:][:line]
                place = order.index(name) * sample
                for b in range(sample):
                    out[start + place + b:start + width * pixel:pixel] = source[b::sample]
    return b"RAWI" + struct.pack("<3I", width, height, FORMATS[len(order), sample]) + bytes(out)
