"""texshot convert: Pillow reads what it writes."""

import random
import unittest

from PIL import Image, ImageCms
from PIL.PngImagePlugin import PngInfo

from texshot import Texshot, dds, problem, results, texshot


class Convert(Texshot):
    def test_convert_keeps_every_pixel(self):
        source = self.picture(13, 7)
        wanted = Image.open(source).convert("RGB").tobytes()
        for name, options in [("out.png", []), ("small.PNG", ["--small"]), ("out.tga", []), ("rle.tga", ["--rle"]),
                              ("out.bmp", []), ("out.dds", [])]:
            with self.subTest(name):
                self.succeeds("convert", source, self.path / name, *options)
                self.assertEqual(Image.open(self.path / name).convert("RGB").tobytes(), wanted)

    def test_convert_refuses_what_the_format_can_not_hold(self):
        noise = random.Random(5)
        for name, expected, data in [
            ("layers", "2 of the array's 3 layers", dds(2, 2, noise.randbytes(3 * 16), 28, layers=3)),
            ("faces", "5 of the cube map's 6 faces", dds(2, 2, noise.randbytes(6 * 16), 28, cube=True)),
            ("slices", "3 of the volume's 4 slices", dds(2, 2, noise.randbytes(4 * 16), 28, depth=4)),
            ("levels", "1 of the texture's 2 mip levels", dds(2, 2, noise.randbytes(16 + 4), 28, levels=2)),
            ("componentBits", "10 bits a component become 8", dds(2, 2, noise.randbytes(16), 24)),
        ]:
            file = self.path / (name + ".dds")
            file.write_bytes(data)
            for ending in ("png", "bmp", "tga"):
                with self.subTest(f"{name} {ending}"):
                    out = self.path / f"{name}.{ending}"
                    self.assertIn("--lossy", self.complains(1, expected, "convert", file, out))
                    self.assertIn(expected, problem(texshot("convert", file, out, "--json").stdout))
                    self.assertFalse(out.exists())
                    result = texshot("convert", file, out, "--json", "--lossy")
                    self.assertEqual(result.returncode, 0, result.stderr)
                    self.assertIn(expected, result.stderr.decode())
                    losses = results(result.stdout)[0]["losses"]
                    self.assertEqual([(loss["what"], loss["message"]) for loss in losses], [(name, expected)])
                    with Image.open(out) as picture:
                        self.assertEqual(picture.size, (2, 2))
            if name != "componentBits":  # DDS holds it all
                self.succeeds("convert", file, self.path / "again.dds")
                whole, again = (results(self.succeeds("info", each, "--json"))[0] for each in (file, self.path / "again.dds"))
                for fact in ("layers", "faces", "depth", "levels", "pixelBytes"):
                    self.assertEqual(again[fact], whole[fact])

    def test_convert_says_what_it_can_not_say_of_the_pixels(self):
        source, out = self.path / "photo.jpg", self.path / "photo.bmp"
        profile = ImageCms.ImageCmsProfile(ImageCms.createProfile("sRGB")).tobytes()
        Image.new("RGB", (8, 8), (9, 99, 199)).save(source, icc_profile=profile, comment=b"mine")
        result = texshot("convert", source, out, "--json")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertTrue(result.stderr.endswith(b"lost in BMP: the ICC profile; the comment\n"), result.stderr)
        losses = results(result.stdout)[0]["losses"]
        self.assertEqual([(loss["what"], loss["ofPixels"]) for loss in losses], [("colorProfile", False), ("metadata", False)])

    def test_what_is_lost_is_said_everywhere(self):
        """On standard error, by --report and in the JSON: of what describes the pixels, too."""
        source = self.path / "in.png"
        texts = PngInfo()
        texts.add_text("Title", "a scene")
        texts.add(b"tIME", bytes((7, 234, 1, 2, 3, 4, 5)))
        Image.new("RGB", (4, 4), (1, 2, 3)).save(source, pnginfo=texts)
        for ending, sentences in (("tga", ["the chunks tIME", "its texts"]), ("png", ["the chunks tIME"])):
            with self.subTest(ending):
                out = self.path / f"out.{ending}"
                said = "; ".join(sentences)
                result = texshot("convert", source, out, "--report")
                self.assertEqual((result.returncode, result.stderr.decode()),
                                 (0, f"texshot: {source}: lost in {ending.upper()}: {said}\n"))
                self.assertEqual(result.stdout.decode().splitlines()[1:], [f"lost: {said}"])
                losses = results(texshot("convert", source, out, "--json").stdout)[0]["losses"]
                self.assertEqual([loss["message"] for loss in losses], sentences)
                self.assertEqual(texshot("convert", source, out, "--quiet").stderr, b"")

    def test_convert_keeps_that_colours_are_srgb(self):
        source, out = self.path / "srgb.dds", self.path / "srgb.png"
        source.write_bytes(dds(1, 1, bytes((1, 2, 3, 255)), 29))
        self.succeeds("convert", source, out)
        self.assertEqual(Image.open(out).info["srgb"], 0)

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
