"""Reads NUMBER_MODE_WxH.png with Pillow and compares it with NUMBER_MODE_WxH.raw, which has the bottom row first."""

import pathlib
import sys

from PIL import Image

compared = 0
failures = 0
for path in sorted(pathlib.Path(sys.argv[1]).glob("*.png")):
    _, mode, size = path.stem.split("_")
    width, height = map(int, size.split("x"))
    expected = Image.frombytes(mode, (width, height), path.with_suffix(".raw").read_bytes())
    expected = expected.transpose(Image.Transpose.FLIP_TOP_BOTTOM)
    with Image.open(path) as image:
        compared += 1
        if image.mode != mode or image.size != (width, height) or image.tobytes() != expected.tobytes():
            print(f"{path.name}: Pillow reads {image.mode} {image.size} or other pixels")
            failures += 1

print(f"{compared} files compared, {failures} differ")
sys.exit(failures != 0 or compared < 23)
