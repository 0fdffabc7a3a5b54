#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Renders scenes small and puts them side by side into one PNG, in the order in which they are named.

    tools/contact_sheet.py -o sheet.png examples/*.toml ring.glb
    tools/contact_sheet.py -o sheet.png --columns 4 --size 320x240 --spp 64 SCENE...
    tools/contact_sheet.py -o sheet.png --variant="--set render.packet=1" --variant="--set render.packet=8" SCENE...

With variants, options of `dewbow render`, each scene is rendered once with each.
"""

import argparse
import pathlib
import shlex
import struct
import subprocess
import sys
import tempfile
import zlib

ROOT = pathlib.Path(__file__).resolve().parent.parent
GAP, GREY = 4, 40  # pixels between pictures, and their colour


def unfiltered(kind, line, above, bpp):
    """One line of a PNG without its filter.                                   [PNG, section 9]"""
    line = bytearray(line)
    for i in range(len(line)):
        left = line[i - bpp] if i >= bpp else 0
        up, corner = above[i], above[i - bpp] if i >= bpp else 0
        if kind == 1:
            line[i] = line[i] + left & 255
        elif kind == 2:
            line[i] = line[i] + up & 255
        elif kind == 3:
            line[i] = line[i] + (left + up) // 2 & 255
        elif kind == 4:
            estimate = left + up - corner
            nearest = min((left, up, corner), key=lambda x: abs(estimate - x))
            line[i] = line[i] + nearest & 255
    return line


def read_png(path):
    """Width, height and lines of an RGB picture with 8 bits a channel, as dewbow writes them."""
    data = path.read_bytes()
    width, height, depth, colour = struct.unpack(">IIBB", data[16:26])
    if (depth, colour) != (8, 2):
        sys.exit(f"{path}: expected 8-bit RGB")
    packed, at = b"", 8
    while at < len(data):
        (length,) = struct.unpack(">I", data[at:at + 4])
        if data[at + 4:at + 8] == b"IDAT":
            packed += data[at + 8:at + 8 + length]
        at += 12 + length
    raw, lines, above = zlib.decompress(packed), [], bytes(3 * width)
    for y in range(height):
        start = y * (3 * width + 1)
        above = unfiltered(raw[start], raw[start + 1:start + 1 + 3 * width], above, 3)
        lines.append(bytes(above))
    return width, height, lines


def write_png(path, width, lines):
    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    raw = b"".join(b"\x02" + bytes(a - b & 255 for a, b in zip(line, above))
                   for line, above in zip(lines, [bytes(3 * width)] + lines))
    head = struct.pack(">IIBBBBB", width, len(lines), 8, 2, 0, 0, 0)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"sRGB", b"\x00") +
                     chunk(b"IDAT", zlib.compress(raw, 9)) + chunk(b"IEND", b""))


def sheet(pictures, columns):
    width, height, _ = pictures[0]
    gap = bytes([GREY] * 3)
    total = columns * width + (columns + 1) * GAP
    lines = [gap * total] * GAP
    for first in range(0, len(pictures), columns):
        row = pictures[first:first + columns]
        for y in range(height):
            line = gap * GAP
            for _, _, picture in row:
                line += picture[y] + gap * GAP
            lines.append(line + gap * (total - len(line) // 3))
        lines += [gap * total] * GAP
    return total, lines


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("scenes", nargs="+", metavar="SCENE")
    parser.add_argument("-o", "--output", required=True, type=pathlib.Path)
    parser.add_argument("--columns", type=int, default=4)
    parser.add_argument("--size", default="320x240")
    parser.add_argument("--spp", default="64")
    parser.add_argument("--variant", action="append", metavar="OPTIONS")
    parser.add_argument("--dewbow", default=ROOT / "build/release/dewbow")
    options = parser.parse_args()

    pictures = []
    with tempfile.TemporaryDirectory() as folder:
        for scene in options.scenes:
            for variant in options.variant or [""]:
                picture = pathlib.Path(folder) / "picture.png"
                subprocess.run([options.dewbow, "render", scene, "-o", picture, "--size", options.size,
                                "--spp", options.spp, *shlex.split(variant)], check=True)
                pictures.append(read_png(picture))
    write_png(options.output, *sheet(pictures, options.columns))


if __name__ == "__main__":
    main()
