"""Reads every .jpg file of a folder with Pillow and compares it with the pixels next to it (.rgb, bottom row first),
and both with the slopes that were compressed."""

import pathlib
import sys

from PIL import Image

files = sorted(pathlib.Path(sys.argv[1]).glob("*.jpg"))
failures = 0
for path in files:
    with Image.open(path) as image:
        width, height = image.size
        found = image.convert("RGB").transpose(Image.Transpose.FLIP_TOP_BOTTOM).tobytes()
    if found != path.with_suffix(".rgb").read_bytes():
        print(f"{path.name}: Pillow reads other pixels")
        failures += 1
    sloped = bytes(value for y in reversed(range(height)) for x in range(width)
                   for value in (255 * x // width, 255 * y // height, 128))
    if width > 8 and max(abs(a - b) for a, b in zip(found, sloped)) > 24:
        print(f"{path.name}: this is another picture")
        failures += 1
print(f"{len(files)} files, {failures} failures")
sys.exit(failures != 0 or not files)
