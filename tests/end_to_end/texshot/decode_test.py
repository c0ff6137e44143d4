"""texshot decode: a file, or a part of it, as a picture."""

import io
import unittest

from PIL import Image

from texshot import Texshot, bmp, dds, results, texshot


class Decode(Texshot):
    def test_decode_gives_the_pixels_that_went_in(self):
        file = self.path / "ramp.bmp"
        file.write_bytes(bmp(5, 3, lambda x, y: (x * 50, y * 100, 7)))
        self.succeeds("decode", file, self.path / "ramp.png")
        picture = Image.open(self.path / "ramp.png").convert("RGB")
        self.assertEqual(picture.tobytes(), Image.open(file).convert("RGB").tobytes())

    def test_decode_level_is_the_box_average(self):
        file = self.path / "board.bmp"
        file.write_bytes(bmp(4, 4, lambda x, y: (200, 100, 0) if x < 2 else (0, 40, 80)))
        level = Image.open(io.BytesIO(self.succeeds("decode", file, "-", "--level", "2"))).convert("RGB")
        self.assertEqual((level.size, level.getpixel((0, 0))), ((1, 1), (100, 70, 40)))
        self.complains(1, "there is no level 3: its full chain has 0 to 2", "decode", file, "-", "--level", "3")

    def test_decode_chooses_level_and_direction(self):
        file = self.path / "in.dds"
        self.succeeds("compress", self.picture(16, 16), file, "--format", "dxt1")
        upright = Image.open(io.BytesIO(self.succeeds("decode", file, "-"))).convert("RGB")
        self.assertEqual(upright.tobytes(), Image.open(file).convert("RGB").tobytes())
        naive = Image.open(io.BytesIO(self.succeeds("decode", file, "-", "--no-flip"))).convert("RGB")
        self.assertEqual(naive.tobytes(), upright.transpose(Image.Transpose.FLIP_TOP_BOTTOM).tobytes())
        level = Image.open(io.BytesIO(self.succeeds("decode", file, "-", "--level", "3")))
        self.assertEqual(level.size, (2, 2))
        for expected, options in [("has 0 to 4", ["--level", "5"]), ("face 0 alone", ["--face", "1"]),
                                  ("slice 0 alone", ["--slice", "1"])]:
            with self.subTest(options):
                self.complains(1, expected, "decode", file, "-", *options)

    def test_decode_takes_the_part_that_is_chosen(self):
        # Every texel says which of its kind it is.
        array = dds(1, 1, b"".join(bytes((layer, face, 0, 255)) for layer in range(2) for face in range(6)), 28, layers=2, cube=True)
        volume = dds(1, 1, b"".join(bytes((0, 0, slice_, 255)) for slice_ in range(3)), 28, depth=3)
        for name, data, options, pixel in [("array", array, ["--layer", "1", "--face", "4"], (1, 4, 0)),
                                           ("array", array, ["--layer", "0", "--face", "5"], (0, 5, 0)),
                                           ("volume", volume, ["--slice", "2"], (0, 0, 2))]:
            with self.subTest(options):
                file = self.path / (name + ".dds")
                file.write_bytes(data)
                picture = Image.open(io.BytesIO(self.succeeds("decode", file, "-", *options))).convert("RGB")
                self.assertEqual(picture.getpixel((0, 0)), pixel)
                said = self.complains(1, "--lossy", "decode", file, self.path / "out.png", *options[2:])
                self.assertIn(f"({options[0]} chooses one)", said)
                result = texshot("decode", file, self.path / "out.png", "--lossy", "--json")
                (self.path / "out.png").unlink()
                self.assertEqual(result.returncode, 0, result.stderr)
                self.assertIn(options[0][2:] + "s", [loss["what"] for loss in results(result.stdout)[0]["losses"]])
        self.complains(1, "there is no layer 2: the file has 0 to 1", "decode", self.path / "array.dds", "-", "--layer", "2", "--face", "0")

    def test_decode_refuses_to_take_bits(self):
        deep = self.path / "deep.png"
        Image.new("I;16", (2, 2), 257).save(deep)
        self.complains(1, "16 bits a component become 8", "decode", deep, self.path / "out.png")
        self.assertEqual(texshot("decode", deep, self.path / "out.png", "--lossy").returncode, 0)

    def test_wrong_calls(self):
        source = self.picture(4, 4)
        for expected, arguments in [
            ("--level: expected a whole number from 0 to 30, found \"31\"",
             ["decode", source, self.path / "out.png", "--level", "31"]),
        ]:
            with self.subTest(expected):
                self.complains(2, expected, *arguments)


if __name__ == "__main__":
    unittest.main()
