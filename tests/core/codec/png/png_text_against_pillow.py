"""Reads the texts of texts.png with Pillow and compares them with NUMBER.keyword and NUMBER.text."""

import pathlib
import sys

from PIL import Image

folder = pathlib.Path(sys.argv[1])
expected = {path.read_text(encoding="utf-8"): path.with_suffix(".text").read_bytes().decode("utf-8")
            for path in folder.glob("*.keyword")}
with Image.open(folder / "texts.png") as image:
    image.load()
    found = {str(key): str(text) for key, text in image.text.items()}
for key in sorted(expected.keys() | found.keys()):
    if expected.get(key) != found.get(key):
        print(f"{key!r}: expected {expected.get(key, '')[:60]!r}, Pillow reads {found.get(key, '')[:60]!r}")
sys.exit(expected != found or len(expected) < 6)
