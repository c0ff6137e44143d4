"""Both programs start, draw a picture and stop."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

from PIL import Image

TEXSHOT = sys.argv.pop(2)
sys.path.insert(0, str(pathlib.Path(__file__).parent / "texplorer"))
from texplorer import Window  # takes the first argument


class Explorer(Window):
    def test_opens_and_closes_a_window(self):  # Window waits for its first picture
        self.display.ask_to_close(self.window)
        self.assertEqual(self.program.wait(60), 0)


class Texshot(unittest.TestCase):
    def test_draws_a_picture(self):
        with tempfile.TemporaryDirectory() as folder:
            for renderer in ("fixed", "shader", "reference"):
                with self.subTest(renderer):
                    file = pathlib.Path(folder) / f"{renderer}.png"
                    subprocess.run([TEXSHOT, "shot", "--renderer", renderer, "--size", "160x120", "-o", file], check=True)
                    self.assertGreater(len(Image.open(file).convert("RGB").getcolors(1 << 16)), 100)


if __name__ == "__main__":
    unittest.main()
