"""Compares mip chains with Pillow's: MODE_LEVEL_WxH.raw against Image.reduce(2) of the level before it."""

import pathlib
import sys

from PIL import Image

chains = {}
for path in sorted(pathlib.Path(sys.argv[1]).glob("*.raw")):
    mode, level, size = path.stem.split("_")
    width, height = map(int, size.split("x"))
    chains.setdefault(mode, {})[int(level)] = Image.frombytes(mode, (width, height), path.read_bytes())

failures = 0
compared = 0
for mode, levels in chains.items():
    # Band by band, because Pillow weights colours by alpha where it can; OpenGL doesn't.
    for level in range(1, len(levels)):
        above = levels[level - 1]
        factor = (min(2, above.width), min(2, above.height))
        expected = Image.merge(mode, [band.reduce(factor) for band in above.split()])
        compared += 1
        if expected.tobytes() != levels[level].tobytes():
            print(f"{mode} level {level}: differs from Pillow's reduce{factor}")
            failures += 1

print(f"{compared} levels compared, {failures} differ")
sys.exit(failures != 0 or compared < 18)
