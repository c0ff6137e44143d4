"""Reads every .dds file of a folder with Pillow, and those called both… with ImageMagick, and compares level 0 with the
pixels next to it (.rgba, .rgb, .la or .l, top row first)."""

import pathlib
import subprocess
import sys

from PIL import Image

compared = 0
failures = 0


def compare(path, reader, found, expected):
    global compared, failures
    compared += 1
    if found != expected:
        print(f"{path.name}: {reader} reads other pixels")
        failures += 1


for path in sorted(pathlib.Path(sys.argv[1]).glob("*.dds")):
    width, height = map(int, path.stem.split("_")[1].split("x"))
    (raw,) = [other for other in path.parent.glob(path.stem + ".*") if other.suffix != ".dds"]
    expected = Image.frombytes(raw.suffix[1:].upper(), (width, height), raw.read_bytes()).convert("RGBA").tobytes()
    with Image.open(path) as image:
        compare(path, "Pillow", image.convert("RGBA").tobytes(), expected)
    if path.name.startswith("both"):
        call = ["/usr/bin/convert", str(path), "-depth", "8", "rgba:-"]
        compare(path, "ImageMagick", subprocess.run(call, check=True, capture_output=True).stdout, expected)

print(f"{compared} pictures compared, {failures} differ")
sys.exit(failures != 0 or compared != 4 * (5 * 2 + 5))
