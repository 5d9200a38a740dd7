"""Writes a Godot resource pack (.pck) of format 3, the one of Godot 4.5 and later.

Layout, all little endian: "GDPC", format, engine major, minor, patch, flags
(2: file offsets count from the pack's start), the files' base, the directory's
place, 16 reserved words; the files, each at a multiple of 16; the directory: a
count, then for each file its path (zero-padded to a multiple of 4, no "res://"),
offset, size, MD5 and flags.
"""
# SPDX-FileCopyrightText: The Relievo authors
# SPDX-License-Identifier: GPL-3.0-or-later
import hashlib
import struct

ALIGN = 16


def write_pck(path, files, engine=(4, 6, 0)):
    """files: {path inside res://: bytes}."""
    base = 112  # The 104 bytes of the header, rounded up to ALIGN.
    body = bytearray()
    directory = bytearray(struct.pack("<I", len(files)))
    for name, data in sorted(files.items()):
        body += bytes(-len(body) % ALIGN)
        text = name.encode()
        text += bytes(-len(text) % 4)
        directory += struct.pack("<I", len(text)) + text
        directory += struct.pack("<QQ", len(body), len(data))
        directory += hashlib.md5(data).digest() + struct.pack("<I", 0)
        body += data
    body += bytes(-len(body) % ALIGN)
    header = b"GDPC" + struct.pack("<5I", 3, *engine, 2)
    header += struct.pack("<QQ", base, base + len(body))
    with open(path, "wb") as out:
        out.write(header.ljust(base, b"\0") + body + directory)
