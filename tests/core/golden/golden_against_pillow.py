#!/usr/bin/env python3
"""golden_against_pillow.py FOLDER: what golden_test.cpp has written there is upright."""
import sys
from PIL import Image

white, red, blue = (255, 255, 255, 255), (255, 0, 0, 255), (0, 0, 255, 255)
for name in ("bottom_first.png", "top_first.png"):
    golden = Image.open(f"{sys.argv[1]}/{name}").convert("RGBA")
    found = list(golden.getdata())
    assert golden.size == (2, 3) and found == [red, white, white, white, white, blue], f"{name}: {found}"
