"""texshot compress: Pillow reads its output."""

import io
import math
import os
import pty
import signal
import struct
import subprocess
import time
import unittest

from PIL import Image

from texshot import TEXSHOT, Texshot, bmp, dds, results, texshot


class Compress(Texshot):
    def test_compress_writes_what_pillow_reads(self):
        source = self.picture(32, 16)
        for name, quality in [("dxt1", "fast"), ("dxt1", "best"), ("dxt3", "normal"), ("dxt5", "normal")]:
            with self.subTest(name + " " + quality):
                out = self.path / (name + ".dds")
                self.succeeds("compress", source, out, "--format", name, "--quality", quality)
                self.assertLess(self.distance(Image.open(out), Image.open(source)), 8)
                self.assertEqual(len(self.facts(out)["levels"]), 6)
        self.succeeds("compress", source, out, "--format", "dxt1", "--mips", "none")
        self.assertEqual(out.stat().st_size, 128 + 32 * 16 // 2)

    def test_formats_have_the_names_that_others_gave_them(self):
        source = self.path / "grey.bmp"  # of which every format keeps all components
        source.write_bytes(bmp(16, 16, lambda x, y: (x * y, x * y, x * y)))
        for name, others in (("dxt1", ["bc1", "BC1", "DXT1"]), ("dxt1a", ["bc1a"]), ("dxt3", ["BC2"]), ("dxt5", ["bc3", "Dxt5"]),
                             ("bc4", ["ATI1", "rgtc1", "BC4"]), ("bc5", ["ati2", "RGTC2"])):
            out = self.path / f"{name}.dds"
            self.succeeds("compress", source, out, "--format", name)
            for other in others:
                with self.subTest(other):
                    self.succeeds("compress", source, self.path / "other.dds", "--format", other)
                    self.assertEqual((self.path / "other.dds").read_bytes(), out.read_bytes())
        self.complains(2, '--format: expected one of dxt1, dxt1a, dxt3, dxt5, bc4, bc5, bc1', "compress", source,
                       self.path / "no.dds", "--format", "bc6h")

    def test_compress_prepares_the_picture(self):
        """In blocks of one colour, which lose nothing that 5 and 6 bits hold."""
        source, out = self.path / "in.png", self.path / "out.dds"
        picture = Image.new("RGBA", (16, 16), (255, 0, 0, 255))
        picture.paste((0, 0, 0, 0), (8, 0, 16, 16))
        picture.save(source)

        def made(*options, level=0):
            self.succeeds("compress", source, out, "--format", "dxt5", *options)
            data = texshot("decode", out, "-", "--level", str(level)).stdout  # and a note where it is premultiplied
            return Image.open(io.BytesIO(data)).convert("RGBA")

        self.assertEqual(made().getpixel((15, 8)), (0, 0, 0, 0))
        self.assertEqual(made("--spread").getpixel((15, 8)), (255, 0, 0, 0))
        self.assertEqual(made("--swizzle", "alpha,zero,red,one").getpixel((0, 0)), (255, 0, 255, 255))
        self.assertEqual(made("--size", "32x8").size, (32, 8))
        self.assertEqual(made("--scale", "0.5").size, (8, 8))
        self.assertEqual(made("--normals", "1", level=0).getpixel((4, 4))[2], 255)
        picture.putalpha(128)
        picture.save(source)
        self.assertLessEqual(abs(made("--premultiply").getpixel((0, 0))[0] - 128), 4)
        self.assertEqual(self.facts(out)["alpha"], "premultiplied")
        again = texshot("compress", out, self.path / "again.dds", "--format", "dxt5", "--premultiply")
        self.assertEqual(again.returncode, 1)
        self.assertIn(b"--premultiply: its colours are already multiplied", again.stderr)
        self.complains(2, "--swizzle: expected 4 components with commas between them, found 3", "compress", source, out,
                       "--format", "dxt5", "--swizzle", "red,green,blue")
        self.complains(2, "--swizzle: expected one of red, green, blue, alpha, luminance, zero, one, found", "compress", source, out, "--format", "dxt5",
                       "--swizzle", "other-red,green,blue,alpha")
        self.complains(2, "--scale: expected a number from 0 to 1, found", "compress", source, out, "--format", "dxt5",
                       "--scale", "2")
        self.complains(2, "--coverage: expected a number from 0 to 1", "compress", source, out, "--format", "dxt5",
                       "--coverage", "x")

    def test_compress_keeps_the_coverage_of_an_alpha_test(self):
        source, out = self.path / "in.png", self.path / "out.dds"
        picture = Image.new("RGBA", (64, 64), (40, 140, 40, 0))
        for x in range(0, 64, 8):
            for y in range(0, 64, 8):
                picture.paste((40, 140, 40, 255), (x, y, x + 2, y + 2))
        picture.save(source)

        def passed(level, *options):
            self.succeeds("compress", source, out, "--format", "dxt5", *options)
            data = self.succeeds("decode", out, "-", "--level", level)
            return sum(Image.open(io.BytesIO(data)).convert("RGBA").getchannel("A").histogram()[128:])

        self.assertEqual(passed(2), 0)  # 2 x 2 of 4 x 4 texels became one of 64
        self.assertEqual(passed(2, "--coverage", "0.5"), 8 * 8)
        asked = ("compress", source, out, "--coverage", "0.5")
        without = texshot(*asked, "--format", "dxt1")
        self.assertIn("--coverage: has no effect here: DXT1 has no alpha\n", without.stderr.decode())
        self.notes("it applies only to mip levels, and there are none", *asked, "--format", "dxt5", "--mips", "none")
        picture.convert("RGB").save(source)
        self.notes("the picture has no alpha", *asked, "--format", "dxt5")

    CORNERS = [(255, 0, 0), (0, 255, 0), (0, 0, 255), (255, 255, 0), (0, 255, 255), (255, 0, 255)]

    def test_compress_keeps_the_faces_of_a_cube_map(self):
        strip, cube, out = (self.path / name for name in ("strip.bmp", "cube.dds", "out.dds"))
        # Six faces of one colour each; their upper left quarter is black.
        strip.write_bytes(bmp(48, 8, lambda x, y: (0, 0, 0) if x % 8 < 4 and y < 4 else self.CORNERS[x // 8]))
        self.succeeds("compress", strip, cube, "--format", "dxt1", "--cube", "--mips", "none")
        report = self.succeeds("compress", cube, out, "--format", "dxt5", "--report").decode()
        self.assertRegex(report, r"level  0  8 × 8, 6 faces +384 bytes")
        for file, levels in ((cube, 1), (out, 4)):
            facts = self.facts(file)
            self.assertEqual((facts["faces"], len(facts["levels"])), (6, levels))
            self.assertEqual(facts["notes"], [])
            for face, color in enumerate(self.CORNERS):
                data = self.succeeds("decode", file, "-", "--face", face)
                picture = Image.open(io.BytesIO(data)).convert("RGB")
                self.assertEqual(picture.getpixel((0, 0)), (0, 0, 0), "the upper left stays there")
                for corner in ((7, 0), (0, 7), (7, 7)):
                    self.assertEqual(picture.getpixel(corner), color)
        self.complains(1, "6:1, 1:6, 4:3 or 3:4, found 32 × 16", "compress", self.picture(32, 16), self.path / "no.dds",
                       "--format", "dxt1", "--cube")

    def test_compress_keeps_the_levels_of_a_file(self):
        """Levels of 8 × 8, 4 × 4, 2 × 2 and 1 × 1 texels, each of a colour that 5, 6 and 5 bits hold exactly."""
        colors = [(255, 0, 0), (0, 255, 0), (0, 0, 255), (255, 255, 0)]
        for cube in (False, True):
            own, out = self.path / "own.dds", self.path / "out.dds"
            pixels = b"".join(bytes((*colors[level], 255)) * ((8 >> level) ** 2) for level in range(4)) * (6 if cube else 1)
            own.write_bytes(dds(8, 8, pixels, 28, levels=4, cube=cube))

            def decoded(face):
                face = ["--face", face] if cube else []
                pictures = (Image.open(io.BytesIO(self.succeeds("decode", out, "-", "--level", level, *face))).convert("RGB")
                            for level in range(len(self.facts(out)["levels"])))
                return [(picture.size[0], picture.getcolors()) for picture in pictures]

            for name in ("dxt1", "dxt5"):
                with self.subTest(f"{name}, cube map: {cube}"):
                    written, = results(self.succeeds("compress", own, out, "--format", name, "--json"))
                    self.assertEqual((written["levelCount"], written["losses"]), (4, []))
                    for face in (0, 5):
                        self.assertEqual(decoded(face), [(8 >> i, [((8 >> i) ** 2, color)]) for i, color in enumerate(colors)])
            for mips, levels, said in (("box", 4, "3 of its 4 mip levels (generated from the base)"), ("none", 1, "3 of its 4 mip levels")):
                with self.subTest(f"--mips {mips}, cube map: {cube}"):
                    result = texshot("compress", own, out, "--format", "dxt1", "--mips", mips, "--json")
                    self.assertEqual((result.returncode, result.stderr.decode()), (0, f"texshot: {own}: lost in DDS: {said}\n"))
                    loss, = results(result.stdout)[0]["losses"]
                    self.assertEqual((loss["what"], loss["message"]), ("levels", said))
                    self.assertEqual(decoded(0), [(8 >> i, [((8 >> i) ** 2, colors[0])]) for i in range(levels)])
        self.assertIn(b"--gamma: has no effect here", texshot("compress", own, out, "--format", "dxt1", "--gamma").stderr)

    def test_compress_says_which_components_are_lost(self):
        picture, out = self.path / "ramp.png", self.path / "out.dds"
        ramp = Image.linear_gradient("L").resize((16, 16))
        Image.merge("RGBA", (ramp, ramp.rotate(90), ramp.rotate(180), ramp)).save(picture)
        for name, components, sentence in (("dxt1", "RGB", "alpha (DXT1 keeps only red, green and blue)"),
                                           ("bc4", "R", "green, blue and alpha (BC4 keeps only red)"),
                                           ("bc5", "RG", "blue and alpha (BC5 keeps only red and green)"),
                                           ("dxt5", "RGBA", None)):
            with self.subTest(name):
                told = texshot("compress", picture, out, "--format", name, "--json")
                said = f"texshot: {picture}: lost in DDS: {sentence}\n" if sentence else ""
                self.assertEqual((told.returncode, told.stderr.decode()), (0, said))
                written, = results(told.stdout)
                self.assertEqual([loss["message"] for loss in written["losses"]], [sentence] if sentence else [])
                self.assertEqual({level["components"] for level in written["report"]["levels"]}, {components})
                report = texshot("compress", picture, out, "--format", name, "--report").stdout.decode()
                self.assertRegex(report, rf"level  0  16 × 16 +\d+ bytes  [^\n]* in {components}\n")
                self.assertEqual(report.splitlines()[-1] == f"lost: {sentence}", sentence is not None)

    def test_an_alpha_that_says_nothing_does_not_count(self):
        """The colours of DXT1 are those of DXT3."""
        picture, out = self.path / "opaque.png", self.path / "out.dds"
        Image.merge("RGBA", (*Image.open(self.picture(16, 16)).split(), Image.new("L", (16, 16), 255))).save(picture)
        found = []
        for name in ("dxt1", "dxt3"):
            written, = results(self.succeeds("compress", picture, out, "--format", name, "--mips", "none", "--json"))
            level, = written["report"]["levels"]
            decoded = Image.open(io.BytesIO(self.succeeds("decode", out, "-"))).convert("RGB")
            squares = self.distance(decoded, Image.open(picture).convert("RGB")) ** 2
            self.assertAlmostEqual(level["psnr"], 10 * math.log10(255 ** 2 / squares), places=6)
            found.append(level["components"])
        self.assertEqual(found, ["RGB", "RGB"])

    def test_compress_keeps_that_colours_are_multiplied_by_alpha(self):
        source, out = self.path / "in.dds", self.path / "out.dds"
        header = bytearray(dds(4, 4, bytes((10, 20, 30, 40)) * 16, 28))
        header[144:148] = struct.pack("<I", 2)  # DDS_ALPHA_MODE_PREMULTIPLIED
        source.write_bytes(header)
        self.succeeds("compress", source, out, "--format", "dxt5")
        self.assertEqual(self.facts(out)["alpha"], "premultiplied")

    def test_compress_refuses_a_volume(self):
        volume = self.path / "volume.dds"
        header = struct.pack("<4s7I44x", b"DDS ", 124, 0x801007, 4, 4, 0, 3, 0) + struct.pack("<II4s5I", 32, 0x20000, b"", 8, 255, 0, 0, 0)
        volume.write_bytes(header + struct.pack("<5I", 0x1000, 0x200000, 0, 0, 0) + bytes(48))
        self.complains(1, "found a volume of 3 slices", "compress", volume, self.path / "out.dds", "--format", "dxt1")

    def test_compress_refuses_an_array(self):
        array = self.path / "array.dds"
        array.write_bytes(dds(4, 4, bytes(2 * 64), 28, layers=2))
        self.complains(1, "found an array of 2 layers", "compress", array, self.path / "out.dds", "--format", "dxt1")

    def test_compress_reports_what_it_cost(self):
        source, out = self.picture(16, 16), self.path / "out.dds"
        report = self.succeeds("compress", source, out, "--format", "dxt1", "--report").decode()
        # 4 x 4 blocks of 8 bytes, then 2 x 2, then one each for 4 x 4, 2 x 2 and 1 x 1: 184 bytes for 341 texels.
        self.assertEqual(len(report.splitlines()), 6)
        self.assertRegex(report, r"level  0  16 × 16 +128 bytes +\d+\.\d dB")
        self.assertRegex(report, r"sum +184 bytes, 1\.438 times the base; 13\.5 % of RGBA8, 18\.0 % of RGB8")
        facts = self.facts(out)
        self.assertAlmostEqual(facts["ratioToBase"], 184 / 128)
        self.assertAlmostEqual(facts["shareOfRgba8"], 184 / (4 * 341))
        self.assertIn(b"1.438 times the base; 13.5 % of RGBA8", self.succeeds("info", out))

    def test_compress_offers_every_way_to_make_levels(self):
        source, out = self.picture(24, 20), self.path / "out.dds"
        files = set()
        for options in [[], ["--mips", "triangle"], ["--mips", "cubic"], ["--mips", "catmull-rom"],
                        ["--mips", "mitchell"], ["--gamma"], ["--power-of-two"], ["--mips", "none"]]:
            self.succeeds("compress", source, out, "--format", "dxt1", *options)
            files.add(out.read_bytes())
        self.assertEqual(len(files), 8, "each makes levels of its own")
        self.succeeds("compress", source, out, "--format", "dxt1", "--power-of-two")
        facts = self.facts(out)
        self.assertEqual((facts["width"], facts["height"]), (32, 16), "24 and 20 to the nearest powers of two, as GLU does it")
        self.complains(2, "mitchel2", "compress", source, out, "--format", "dxt1", "--mips", "mitchel2")

    def test_a_terminal_is_told_how_far_long_work_is(self):
        source = self.path / "large.bmp"
        source.write_bytes(bmp(4096, 1, lambda x, y: (0, 0, 0))[:22] + struct.pack("<i", 4096) + b"\1\0\x18\0" +
                           bytes(24) + os.urandom(4096 * 4096 * 3))
        terminal, other_end = pty.openpty()
        work = subprocess.Popen([TEXSHOT, "compress", source, self.path / "out.dds", "--format", "dxt5", "--quality",
                                 "best"], stderr=other_end)
        os.close(other_end)
        said = b""
        while b"%" not in said:
            said += os.read(terminal, 1000)
        work.send_signal(signal.SIGINT)
        try:
            while more := os.read(terminal, 1000):
                said += more
        except OSError:  # Linux reports in this way that the other end is closed
            pass
        self.assertEqual(work.wait(timeout=60), 130)
        self.assertRegex(said.decode(), r"\rtexshot: compressing: \d+ %")
        self.assertIn("\r\033[Ktexshot: interrupted; nothing was written", said.decode())
        self.assertFalse((self.path / "out.dds").exists())

    def test_an_interrupt_leaves_no_file(self):
        source = self.path / "large.bmp"
        source.write_bytes(bmp(1024, 1024, lambda x, y: (x * y & 255, x & 255, y & 255)))
        before = sorted(os.listdir(self.path))
        work = subprocess.Popen([TEXSHOT, "compress", source, self.path / "out.dds", "--format", "dxt5", "--quality",
                                 "best"], stderr=subprocess.PIPE)
        time.sleep(0.3)
        work.send_signal(signal.SIGINT)
        said = work.communicate(timeout=60)[1].decode()
        self.assertEqual(sorted(os.listdir(self.path)), before)
        self.assertEqual(work.returncode, 130)
        self.assertIn("interrupted", said)

    def test_wrong_calls(self):
        source = self.picture(4, 4)
        for expected, arguments in [
            ("--format", ["compress", source, self.path / "out.dds"]),
            ("dxt9", ["compress", source, self.path / "out.dds", "--format", "dxt9"]),
            ("--format: expected one of dxt1, dxt1a, dxt3, dxt5, bc4, bc5, bc1, bc1a, bc2, bc3, ati1, ati2, rgtc1, rgtc2, found \"foo\"",
             ["compress", source, self.path / "out.dds", "--format", "foo"]),
            ("--quality: expected one of fast, normal, best, found \"fine\"",
             ["compress", source, self.path / "out.dds", "--format", "dxt1", "--quality", "fine"]),
            ("--mips: expected one of none, box, ",
             ["compress", source, self.path / "out.dds", "--format", "dxt1", "--mips", "many"]),
        ]:
            with self.subTest(expected):
                self.complains(2, expected, *arguments)


if __name__ == "__main__":
    unittest.main()
