"""Reads the TGA files NAME_FORMAT_WxH.tga that our writer made with Pillow and ImageMagick and compares them with
NAME_FORMAT_WxH.raw (bottom row first; FORMAT is l, la, rgb or rgba). Checks the packets and version 2's tail."""

import pathlib
import struct
import subprocess
import sys

from PIL import Image

folder = pathlib.Path(sys.argv[1])
files = sorted(folder.glob("*.tga"))
assert files
subprocess.run(["mogrify", "-auto-orient", "-depth", "8", "-format", "rgba", *files], check=True)


def check_packets(data, width, height, size):
    """Exactly the picture, no packet across the end of a row; returns the bytes that the packets take."""
    at = 0
    for _ in range(height):
        column = 0
        while column < width:
            count = (data[at] & 127) + 1
            at += 1 + size * (1 if data[at] & 128 else count)
            column += count
        assert column == width
    return at


for path in files:
    _, letters, extents = path.stem.split("_")
    width, height = map(int, extents.split("x"))
    mode = {"l": "L", "la": "LA", "rgb": "RGB", "rgba": "RGBA"}[letters]
    size = len(mode)
    raw = path.with_suffix(".raw").read_bytes()
    rows = [raw[y * width * size:(y + 1) * width * size] for y in reversed(range(height))]
    expected = Image.frombytes(mode, (width, height), b"".join(rows))
    with Image.open(path) as image:
        assert image.mode == mode and image.tobytes() == expected.tobytes(), path
    if mode != "LA":  # ImageMagick takes it for colours of 16 bits
        assert path.with_suffix(".rgba").read_bytes() == expected.convert("RGBA").tobytes(), path

    data = path.read_bytes()
    assert data[-18:] == b"TRUEVISION-XFILE.\0", path
    extension, developer = struct.unpack("<II", data[-26:-18])
    assert extension == len(data) - 26 - 495 and developer == 0, path
    assert struct.unpack("<H", data[extension:extension + 2]) == (495,), path
    assert data[extension + 494] == (3 if mode in ("LA", "RGBA") else 0), path
    pixels = data[18:extension]
    assert len(pixels) == (check_packets(pixels, width, height, size) if data[2] >= 8 else len(raw)), path
