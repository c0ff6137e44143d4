"""texshot flip: Pillow reads what it writes."""

import random
import struct
import unittest

from PIL import Image, ImageCms
from PIL.PngImagePlugin import PngInfo

from texshot import Texshot, dds, results, texshot


class Flip(Texshot):
    def test_flip_is_its_own_inverse_and_loses_nothing(self):
        plain, flipped, back = (self.path / name for name in ("plain.dds", "flipped.dds", "back.dds"))
        self.succeeds("compress", self.picture(16, 8), plain, "--format", "dxt5")
        for option, turn in [([], Image.Transpose.FLIP_TOP_BOTTOM),
                             (["--horizontal"], Image.Transpose.FLIP_LEFT_RIGHT),
                             (["--half-turn"], Image.Transpose.ROTATE_180)]:
            with self.subTest(option):
                self.succeeds("flip", plain, flipped, *option)
                self.assertEqual(Image.open(flipped).convert("RGBA").tobytes(),
                                 Image.open(plain).convert("RGBA").transpose(turn).tobytes())
                self.succeeds("flip", flipped, back, *option)
                self.assertEqual(back.read_bytes(), plain.read_bytes())

    def test_flip_refuses_what_would_lose(self):
        self.succeeds("compress", self.picture(8, 6), self.path / "odd.dds", "--format", "dxt1", "--mips", "none")
        said = self.complains(1, "level 0", "flip", self.path / "odd.dds", self.path / "out.dds")
        self.assertIn("--lossy", said)

    def test_flip_takes_what_would_lose_when_told_to(self):
        plain, out = self.path / "odd.dds", self.path / "out.dds"
        self.succeeds("compress", self.picture(30, 22), plain, "--format", "dxt1", "--mips", "none")
        for option, turn in [([], Image.Transpose.FLIP_TOP_BOTTOM),
                             (["--horizontal"], Image.Transpose.FLIP_LEFT_RIGHT),
                             (["--half-turn"], Image.Transpose.ROTATE_180)]:
            with self.subTest(option):
                self.succeeds("flip", plain, out, "--lossy", *option)
                self.assertLess(self.distance(Image.open(out), Image.open(plain).transpose(turn)), 8)

    def test_flip_of_three_rows_loses_nothing(self):
        plain, flipped = self.path / "plain.dds", self.path / "flipped.dds"
        self.succeeds("compress", self.picture(12, 6), plain, "--format", "dxt5")  # levels of 6, 3 and 1 rows
        self.complains(1, "1, 2, 3 or a multiple of 4", "flip", plain, flipped)
        self.succeeds("compress", self.picture(12, 3), plain, "--format", "dxt5")
        self.succeeds("flip", plain, flipped)
        self.assertEqual(Image.open(flipped).convert("RGBA").tobytes(),
                         Image.open(plain).convert("RGBA").transpose(Image.Transpose.FLIP_TOP_BOTTOM).tobytes())

    def rows_turned(self, pixels, row, rows):
        """The same with the rows of each picture of so many rows from the last to the first."""
        pictures = [pixels[i:i + row * rows] for i in range(0, len(pixels), row * rows)]
        return b"".join(picture[y * row:(y + 1) * row] for picture in pictures for y in reversed(range(rows)))

    def test_flip_keeps_every_layer_of_an_array(self):
        noise = random.Random(3)
        pixels = noise.randbytes(3 * 4 * 5 * 4)  # three layers of 5 × 4 texels, RGBA
        turned = dds(5, 4, self.rows_turned(pixels, 20, 4), 28, layers=3)
        plain, flipped = self.path / "plain.dds", self.path / "flipped.dds"
        plain.write_bytes(dds(5, 4, pixels, 28, layers=3))
        written, = results(self.succeeds("flip", plain, flipped, "--json"))
        self.assertEqual((written["layers"], written["losses"]), (3, []))
        self.assertEqual(flipped.read_bytes()[148:], turned[148:])
        self.assertEqual(flipped.read_bytes()[128:148], turned[128:148])
        self.succeeds("flip", plain, "--in-place")
        self.assertEqual(plain.read_bytes(), flipped.read_bytes())
        self.succeeds("flip", plain, "--in-place")
        self.assertEqual(plain.read_bytes()[148:], pixels)

    def test_flip_keeps_blocks_of_every_cube_of_an_array(self):
        noise = random.Random(4)
        blocks = noise.randbytes(2 * 6 * (4 * 16 + 16 + 16 + 16))  # two cubes of 8 × 8 texels with all levels, BC3
        plain, flipped, back = (self.path / name for name in ("plain.dds", "flipped.dds", "back.dds"))
        plain.write_bytes(dds(8, 8, blocks, 77, levels=4, layers=2, cube=True))
        self.succeeds("flip", plain, flipped)
        self.succeeds("flip", flipped, back)
        self.assertNotEqual(flipped.read_bytes()[148:], blocks)
        self.assertEqual(back.read_bytes()[148:], blocks)

    def test_flip_refuses_to_take_bits(self):
        deep = self.path / "deep.png"
        Image.new("I;16", (2, 2), 257).save(deep)
        before = deep.read_bytes()
        l16 = struct.pack("<4s7I44x", b"DDS ", 124, 0x1007, 2, 2, 0, 0, 0) + struct.pack("<II4s5I", 32, 0x20000, b"", 16, 0xFFFF, 0, 0, 0)
        for name, data in [("deep.png", before), ("rgb10a2.dds", dds(2, 2, bytes(16), 24)),
                           ("l16.dds", l16 + struct.pack("<5I", 0x1000, 0, 0, 0, 0) + bytes(8))]:
            with self.subTest(name):
                file = self.path / name
                file.write_bytes(data)
                said = self.complains(1, "bits a component become 8", "flip", file, "--in-place")
                self.assertIn("--lossy", said)
                self.assertEqual(file.read_bytes(), data)
                result = texshot("flip", file, self.path / ("out" + name[-4:]), "--lossy", "--json")
                self.assertEqual(result.returncode, 0)
                self.assertIn(b"bits a component become 8", result.stderr)
                losses = results(result.stdout)[0]["losses"]
                self.assertEqual([(loss["what"], loss["ofPixels"]) for loss in losses], [("componentBits", True)])

    def test_flip_keeps_what_a_png_says_of_its_colours(self):
        texts = PngInfo()
        texts.add_text("Title", "kept")
        plain, flipped = self.path / "plain.png", self.path / "flipped.png"
        profile = ImageCms.ImageCmsProfile(ImageCms.createProfile("sRGB")).tobytes()
        Image.new("RGB", (3, 2), (1, 2, 3)).save(plain, pnginfo=texts, icc_profile=profile, dpi=(72, 72))
        self.succeeds("flip", plain, flipped)
        self.assertEqual(Image.open(flipped).info, Image.open(plain).info)
        self.assertEqual(Image.open(flipped).text, {"Title": "kept"})

    def test_wrong_calls(self):
        source = self.picture(4, 4)
        for expected, arguments in [
            ("--half-turn", ["flip", source, self.path / "out.dds", "--half-turn", "--horizontal"]),
        ]:
            with self.subTest(expected):
                self.complains(2, expected, *arguments)


if __name__ == "__main__":
    unittest.main()
