"""texshot convert: Pillow reads what it writes."""

import unittest

from PIL import Image

from texshot import Texshot


class Convert(Texshot):
    def test_convert_keeps_every_pixel(self):
        source = self.picture(13, 7)
        wanted = Image.open(source).convert("RGB").tobytes()
        for name, options in [("out.png", []), ("small.PNG", ["--small"]), ("out.tga", []), ("rle.tga", ["--rle"]),
                              ("out.bmp", []), ("out.dds", [])]:
            with self.subTest(name):
                self.succeeds("convert", source, self.path / name, *options)
                self.assertEqual(Image.open(self.path / name).convert("RGB").tobytes(), wanted)

    def test_wrong_calls(self):
        source = self.picture(4, 4)
        for expected, arguments in [
            (".dds", ["convert", source, self.path / "out.xyz"]),
            (".dds", ["convert", source, self.path / "out"]),
        ]:
            with self.subTest(expected):
                self.complains(2, expected, *arguments)


if __name__ == "__main__":
    unittest.main()
