"""texshot compare: whether two pictures are alike, and what differs where. Pillow makes the pictures."""

import io
import os
import subprocess
import unittest

import numpy
from PIL import Image

from texshot import TEXSHOT, Texshot, single, texshot, within_memory

ALIKE, DIFFERENT, UNKNOWN = 0, 1, 2


class Compare(Texshot):
    def picture(self, name="a.png", size=(40, 30), color=(100, 100, 100), pixels=(), mode="RGB", **options):
        made = Image.new(mode, size, color)
        for x, y, value in pixels:
            made.putpixel((x, y), value)
        made.save(self.path / name, **options)
        return self.path / name

    def compare(self, *arguments, status, **options):
        result = texshot("compare", *arguments, **options)
        self.assertEqual((result.returncode, result.stderr), (status, b""), result.stdout)
        return result.stdout

    def numbers(self, *arguments, status):
        return single(self.compare(*arguments, "--json", status=status))

    def test_one_line_says_that_they_are_alike(self):
        self.assertEqual(self.compare(self.picture(), self.picture("b.bmp"), status=ALIKE),
                         b"alike: none of 1200 pixels differs\n")

    def test_one_line_says_what_differs_where_and_how_much(self):
        a = self.picture()
        b = self.picture("b.tga", pixels=[(7, 4, (100, 130, 100)), (8, 5, (100, 100, 40)), (30, 20, (102, 100, 100))])
        self.assertEqual(
            self.compare(a, b, "--tolerance", "1", status=DIFFERENT).decode(),
            "3 of 1200 pixels (0.25 %) have a difference above 1/255; the worst, 60/255, is at 8, 5: 100 100 100 255 was "
            "expected, 100 100 40 255 found; 2 regions within 24 × 17 pixels at 7, 4\n")
        self.compare(a, b, "--tolerance", "60", status=ALIKE)
        self.compare(a, b, "--share", "0.25%", status=ALIKE)
        self.compare(a, b, "--share", "0.0024", status=DIFFERENT)

    def test_json_has_all_numbers(self):
        a = self.picture()
        b = self.picture("b.png", pixels=[(7, 4, (100, 130, 100)), (8, 5, (100, 100, 40)), (30, 20, (102, 100, 100))])
        found = self.numbers(a, b, status=DIFFERENT)
        sentence = found.pop("sentence")
        self.assertIsInstance(found.pop("id"), int)
        self.assertIn("3 of 1200 pixels", sentence)
        self.assertAlmostEqual(found.pop("score"), 92 / 4800)
        self.assertAlmostEqual(found["difference"].pop("mean"), 92 / 4800)
        self.assertEqual(found, {
            "alike": False, "expected": str(a), "actual": str(b), "metric": "absolute", "tolerance": 0.0, "share": 0.0,
            "components": "rgba", "expectedSize": {"width": 40, "height": 30}, "actualSize": {"width": 40, "height": 30}, "pixels": 1200, "over": 3,
            "shareOver": 0.0025,
            "worst": {"x": 8, "y": 5, "value": 60.0, "expected": [100, 100, 100, 255], "actual": [100, 100, 40, 255]},
            "bounds": {"x": 7, "y": 4, "width": 24, "height": 17}, "regions": 2,
            "largestRegions": [{"x": 7, "y": 4, "width": 2, "height": 2, "pixels": 2},
                               {"x": 30, "y": 20, "width": 1, "height": 1, "pixels": 1}],
            "difference": {"max": 60}})
        same = self.numbers(a, a, "--metric", "flip", status=ALIKE)
        self.assertEqual((same["score"], same["worst"], same["bounds"], same["pixelsPerDegree"]), (0, None, None, 67))

    def sixteen_bits(self, name, value):
        Image.fromarray(numpy.full((8, 8), value, numpy.uint16)).save(self.path / name)
        return self.path / name

    def test_more_bits_than_are_compared_are_said(self):
        a, b = self.sixteen_bits("a.png", 0x8001), self.sixteen_bits("b.png", 0x8002)
        note = "16 bits a component: they are rounded to 8 for the comparison"
        self.assertEqual(self.compare(a, b, status=ALIKE).decode(), f"alike: none of 64 pixels differs; {note}\n")
        self.assertEqual(self.numbers(a, b, status=ALIKE)["note"], note)
        eight = self.picture("eight.png", size=(8, 8), color=128, mode="L")
        self.assertIn(note, self.compare(eight, a, status=ALIKE).decode())
        self.assertNotIn("note", self.numbers(eight, eight, status=ALIKE))
        told = self.facts(a)
        self.assertEqual((told["pixelFormat"], told["componentBits"]), ("luminance, 8 bits", 16))
        self.assertIn("luminance, 8 bits; the file has 16 bits a component", self.succeeds("info", a).decode())
        self.assertEqual(self.facts(eight)["componentBits"], 8)

    def test_the_difference_is_another_file(self):
        a, b = self.picture("a.png"), self.picture("b.png", color=(1, 2, 3))
        mask = self.picture("mask.png", color=(255, 255, 255))
        before = b.read_bytes()
        os.link(b, self.path / "linked.png")
        for out, named in ((a, a), (b, b), (mask, mask), (self.path / "linked.png", b)):
            self.complains(UNKNOWN, f'--out: expected a file other than "{named}"', "compare", a, b, "--mask", mask,
                           "-o", out)
        self.assertEqual(b.read_bytes(), before)
        self.complains(UNKNOWN, "standard input: can be read only once, but is named twice", "compare", "-", "/dev/stdin")

    def test_two_sizes_are_a_difference(self):
        a, b = self.picture(), self.picture("b.png", size=(40, 31))
        self.assertEqual(self.compare(a, b, status=DIFFERENT),
                         "the sizes differ: 40 × 30 pixels were expected, 40 × 31 found\n".encode())
        found = self.numbers(a, b, status=DIFFERENT)
        self.assertEqual((found["expectedSize"], found["actualSize"], found["alike"]), ({"width": 40, "height": 30}, {"width": 40, "height": 31}, False))
        out = self.path / "map.png"
        self.assertIn(b"no picture of the difference", self.compare(a, b, "-o", out, status=DIFFERENT))
        self.assertFalse(out.exists())

    def test_metrics_judge_differently(self):
        a = self.picture(color=(118, 118, 118))
        b = self.picture("b.png", color=(120, 120, 120))
        self.assertEqual(self.numbers(a, b, status=DIFFERENT)["over"], 1200)
        for metric in "ssim", "flip":
            found = self.numbers(a, b, "--metric", metric, status=ALIKE)
            self.assertEqual((found["metric"], found["over"]), (metric, 0))
            self.assertGreater(found["worst"]["value"], 0)
            self.assertEqual(self.numbers(a, b, "--metric", metric, "--tolerance", "0", status=DIFFERENT)["over"], 1200)
        # (2ab + C1) / (a^2 + b^2 + C1), of even pictures
        c1 = 2.55 ** 2
        self.assertAlmostEqual(self.numbers(a, b, "--metric", "ssim", status=ALIKE)["score"],
                               (2 * 118 * 120 + c1) / (118 ** 2 + 120 ** 2 + c1), places=5)

    def test_flip_depends_on_the_distance(self):
        a = self.picture(size=(60, 60))
        b = self.picture("b.png", size=(60, 60), pixels=[(30, 30, (255, 255, 255))])
        near, far = (self.numbers(a, b, "--metric", "flip", "--pixels-per-degree", each, status=DIFFERENT)["worst"]["value"]
                     for each in (20, 90))
        self.assertGreater(near, far)

    def test_the_map_is_written_even_of_equal_pictures(self):
        a = self.picture()
        b = self.picture("b.png", pixels=[(7, 4, (100, 130, 100))])
        out = self.path / "map.png"
        self.compare(a, a, "-o", out, status=ALIKE)
        self.assertEqual(Image.open(out).convert("RGB").getcolors(), [(1200, (0, 0, 0))])
        for metric in "absolute", "ssim", "flip":
            self.compare(a, b, "-o", out, "--metric", metric, status=DIFFERENT)
            made = Image.open(out).convert("RGB")
            self.assertEqual(made.size, (40, 30))
            brightest = max(((x, y) for x in range(40) for y in range(30)), key=lambda at: sum(made.getpixel(at)))
            self.assertEqual(brightest, (7, 4), metric)
            self.assertEqual(made.getpixel((35, 25)), (0, 0, 0))
        piped = texshot("compare", a, b, "-o", "-")
        self.assertEqual(piped.returncode, DIFFERENT)
        self.assertEqual(Image.open(io.BytesIO(piped.stdout)).size, (40, 30))

    def test_masked_pixels_do_not_count(self):
        a = self.picture()
        b = self.picture("b.png", pixels=[(7, 4, (255, 255, 255))])
        mask = self.picture("mask.png", color=(255, 255, 255), pixels=[(7, 4, (0, 0, 0))])
        clear = self.picture("clear.png", color=(9, 9, 9, 255), mode="RGBA", pixels=[(7, 4, (255, 255, 255, 0))])
        for metric in "absolute", "ssim", "flip":
            self.compare(a, b, "--metric", metric, status=DIFFERENT)
            for each in mask, clear:
                found = self.numbers(a, b, "--metric", metric, "--mask", each, status=ALIKE)
                self.assertEqual((found["pixels"], found["difference"]["max"], found["mask"]), (1199, 0, str(each)))

    def test_alpha_counts_unless_told_not_to(self):
        a = self.picture(mode="RGBA", color=(1, 2, 3, 250))
        b = self.picture("b.png", mode="RGBA", color=(1, 2, 3, 20))
        for metric in "absolute", "ssim", "flip":
            self.compare(a, b, "--metric", metric, status=DIFFERENT)
            self.compare(a, b, "--metric", metric, "--rgb", status=ALIKE)
        self.assertEqual(self.numbers(a, b, "--rgb", status=ALIKE)["components"], "rgb")

    def test_one_of_them_comes_from_standard_input(self):
        a = self.picture()
        b = self.picture("b.png", pixels=[(7, 4, (255, 255, 255))])
        self.compare("-", a, status=ALIKE, input=a.read_bytes())
        self.compare(a, "-", status=DIFFERENT, input=b.read_bytes())
        result = texshot("compare", "-", "-", input=a.read_bytes())
        self.assertEqual((result.returncode, result.stdout), (UNKNOWN, b""))
        for content, expected in (b"", b"standard input"), (b"no picture", b"standard input"):
            result = texshot("compare", a, "-", input=content)
            self.assertEqual((result.returncode, result.stdout), (UNKNOWN, b""))
            self.assertIn(expected, result.stderr)

    def test_what_can_not_be_compared_has_a_status_of_its_own(self):
        a = self.picture()
        short = self.path / "short.png"
        short.write_bytes(a.read_bytes()[:60])
        for wrong in short, self.path, self.path / "missing.png":
            self.complains(UNKNOWN, str(wrong), "compare", a, wrong)
            self.complains(UNKNOWN, str(wrong), "compare", wrong, a)
            self.complains(UNKNOWN, str(wrong), "compare", a, a, "--mask", wrong)
        self.complains(UNKNOWN, "EXPECTED ACTUAL, or --expected FILE --actual FILE", "compare", a)
        self.complains(UNKNOWN, "EXPECTED ACTUAL, or --expected FILE --actual FILE", "compare", a, "--actual", a)
        small = self.picture("small.png", size=(4, 4), color=(255, 255, 255))
        self.complains(UNKNOWN, "expected 40 × 30 pixels, found 4 × 4", "compare", a, a, "--mask", small)
        black = self.picture("black.png", color=(0, 0, 0))
        self.complains(UNKNOWN, "the mask leaves no pixel", "compare", a, a, "--mask", black)
        self.complains(UNKNOWN, "Not a directory", "compare", a, a, "-o", a / "map.png")
        self.complains(UNKNOWN, "map.xyz", "compare", a, a, "-o", self.path / "map.xyz")

    def test_wrong_numbers_are_a_wrong_call(self):
        a = self.picture()
        for option, values in {"--tolerance": ("nan", "-1", "1e999", "256", "", "x", "1 2", "5%", "inf"),
                               "--share": ("2", "-1", "nan", "101%", "1e999", "", "%", "0.5.1"),
                               "--metric": ("", "psnr", "SSIM ")}.items():
            for value in values:
                self.complains(UNKNOWN, option, "compare", a, a, f"{option}={value}")
        self.complains(UNKNOWN, "from 0 to 2", "compare", a, a, "--metric", "ssim", "--tolerance", "3")
        self.complains(UNKNOWN, "absolute, ssim, flip", "compare", a, a, "--metric", "psnr")
        self.notes("--pixels-per-degree: has no effect here", "compare", a, a, "--pixels-per-degree", "50")
        self.complains(UNKNOWN, "--pixels-per-degree", "compare", a, a, "--metric=flip", "--pixels-per-degree", "0")
        self.complains(UNKNOWN, "--json", "compare", a, a, "--json", "-o", "-")

    def test_what_holds_more_than_a_picture_is_refused(self):
        a = self.picture("a.png", size=(8, 8))
        cube = self.path / "cube.dds"
        header = bytearray(128)
        header[0:4] = b"DDS "
        for offset, value in {4: 124, 8: 0x1007, 12: 8, 16: 8, 76: 32, 80: 0x41, 88: 32, 92: 0xFF0000, 96: 0xFF00, 100: 0xFF,
                              104: 0xFF000000, 108: 0x1008, 112: 0xFE00}.items():
            header[offset:offset + 4] = value.to_bytes(4, "little")
        cube.write_bytes(bytes(header) + bytes(6 * 8 * 8 * 4))
        self.complains(UNKNOWN, "6 faces", "compare", a, cube)

    def test_a_difference_of_large_pictures_fits_into_little_memory(self):
        a = self.picture(size=(6000, 6000))
        b = self.picture("b.png", size=(6000, 6000), pixels=[(5999, 5999, (0, 0, 0))])
        result = texshot("compare", a, b, "--metric", "flip", **within_memory(1200))
        self.assertEqual(result.returncode, DIFFERENT, result.stderr)
        self.assertIn(b"at 5999, 5999", result.stdout)

    def test_a_full_disk_leaves_nothing_behind(self):
        a = self.picture()
        result = texshot("compare", a, a, "-o", "/dev/full")
        self.assertEqual(result.returncode, UNKNOWN)
        self.assertRegex(result.stderr.decode(), r"\Atexshot: [^\n]+\n\Z")
        with open("/dev/full", "wb") as full:
            result = subprocess.run([TEXSHOT, "compare", str(a), str(a)], stdout=full, stderr=subprocess.PIPE, timeout=60)
        self.assertEqual(result.returncode, UNKNOWN)

    def test_names_are_printed_harmlessly(self):
        a = self.picture()
        b = self.path / "\x1b[31mb.png"
        os.rename(self.picture("b.png", size=(2, 2)), b)
        self.assertNotIn(b"\x1b", self.compare(a, b, "--json", status=DIFFERENT))


if __name__ == "__main__":
    unittest.main()
