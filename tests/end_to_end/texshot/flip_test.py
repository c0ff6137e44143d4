"""texshot flip: Pillow reads what it writes."""

import unittest

from PIL import Image

from texshot import Texshot


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

    def test_wrong_calls(self):
        source = self.picture(4, 4)
        for expected, arguments in [
            ("--half-turn", ["flip", source, self.path / "out.dds", "--half-turn", "--horizontal"]),
        ]:
            with self.subTest(expected):
                self.complains(2, expected, *arguments)


if __name__ == "__main__":
    unittest.main()
