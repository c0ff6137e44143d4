"""The window in every layout, size, scale and theme against reviewed pictures.

A golden is the window reduced to a share of its size, so that what counts is where things are and which colour they
have. TEXPLORER_UPDATE_GOLDENS=1 in the environment writes new ones: look at the pictures before you commit.
"""

import os
import pathlib
import unittest

from PIL import Image, ImageChops, ImageStat

from texshot import Texshot

FOLDER = pathlib.Path(__file__).resolve().parents[2] / "golden" / "window"
THEMES = ("dark", "light", "high-contrast")
WINDOWS = (("1024x700", 1), ("1280x800", 1), ("1920x1080", 1.5), ("3840x2160", 2))
PIXELS = {  # of the cube, in each of the windows: what is explained
    "student": ("120,160", "120,160", "200,200", "560,460"),
    "teacher": ("90,300", "150,340", "230,450", "500,960"),
    "minimal": ("250,300", "300,350", "450,460", "900,1000"),
}
WIDTH = 160  # of a golden
MEAN = 1.5  # allowed difference of a channel, in 255ths, over the whole window
WORST = 48  # of a cell that counts as another one
SHARE = 0.005  # of such cells


def reduced(picture):
    height = round(picture.height * WIDTH / picture.width)
    return picture.convert("RGB").resize((WIDTH, height), Image.Resampling.BOX)


class Goldens(Texshot):
    def compare(self, name, picture):
        golden = FOLDER / (name + ".png")
        small = reduced(picture)
        if os.environ.get("TEXPLORER_UPDATE_GOLDENS"):
            FOLDER.mkdir(parents=True, exist_ok=True)
            small.save(golden, optimize=True)
            return
        expected = Image.open(golden).convert("RGB")
        self.assertEqual(small.size, expected.size)
        difference = ImageChops.difference(small, expected)
        mean = max(ImageStat.Stat(difference).mean)
        cells = difference.convert("L").point(lambda value: 255 if value > WORST else 0)
        share = ImageStat.Stat(cells).mean[0] / 255
        if mean > MEAN or share > SHARE:
            folder = pathlib.Path.cwd() / "goldens"
            folder.mkdir(exist_ok=True)
            picture.save(folder / (name + "-actual.png"))
            expected.save(folder / (name + "-expected.png"))
            difference.save(folder / (name + "-difference.png"))
            self.fail(f"differs by {mean:.2f} in the mean ({MEAN} allowed), {share:.2%} of its cells by more than "
                      f"{WORST} ({SHARE:.1%} allowed): see {folder}/{name}-*.png")

    def test_every_window_looks_as_it_did(self):
        """Each layout in each window, and in each theme: twelve pictures."""
        for row, (layout, pixels) in enumerate(PIXELS.items()):
            for column, ((size, scale), pixel) in enumerate(zip(WINDOWS, pixels)):
                self.look(layout, size, scale, THEMES[(row + column) % len(THEMES)], pixel)

    def look(self, layout, size, scale, theme, pixel):
        name = f"{layout}-{size}-{theme}"
        with self.subTest(name):
            self.compare(name, self.shot("--ui", "--size", size, "--scale", str(scale), "--theme", theme,
                                         "--layout", layout, "--set", "textures[0].pattern=uv-template",
                                         "--probe", pixel))


if __name__ == "__main__":
    unittest.main()
