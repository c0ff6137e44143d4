"""texshot info: what is in a file, and what else is said of files without their pixels."""

import json
import os
import shutil
import struct
import unittest

from texshot import SANITIZED, Texshot, bmp, problem, results, single, texshot, within_memory


class Info(Texshot):
    def test_info(self):
        file = self.path / "small.bmp"
        file.write_bytes(bmp(5, 3, lambda x, y: (1, 2, 3)))
        facts = self.facts(file)
        self.assertEqual((facts["format"], facts["width"], facts["height"], facts["fileBytes"]),
                         ("BMP", 5, 3, file.stat().st_size))
        self.assertIn("5 × 3".encode(), self.succeeds("info", file))

    def large_image(self):
        """A gigabyte of pixels in a small file, and a scene that shows them."""
        file = self.path / "large.tga"
        packets = (16384 * 16384 // 128) * b"\xff\x10\x20\x30\xff"
        file.write_bytes(bytes((0, 0, 10, 0, 0, 0, 0, 0, 0, 0, 0, 0)) + struct.pack("<HHBB", 16384, 16384, 32, 8) + packets)
        scene = self.path / "scene.json"
        scene.write_text(json.dumps({"version": 1, "textures": [{"source": "file", "file": "large.tga", "minFilter": "GL_LINEAR"}],
                                     "passes": [{"depthTest": True, "units": [{"enabled": True}]}]}))
        return file, scene

    # AddressSanitizer's operator new ends the program where others throw.
    @unittest.skipIf(SANITIZED, "under ASan no memory is the end")
    def test_where_pixels_find_no_memory_texshot_says_so(self):
        _, scene = self.large_image()
        drawn = texshot("shot", "--renderer", "reference", scene, "-o", self.path / "out.png", **within_memory(512))
        self.assertEqual(drawn.returncode, 1)
        self.assertRegex(drawn.stderr.decode(), r"\Atexshot: [^\n]*large.tga[^\n]*not enough memory[^\n]*\n\Z")

    def test_info_and_check_decode_no_pixels(self):
        file, scene = self.large_image()
        few = within_memory(512)
        facts = results(texshot("info", "--json", file, **few).stdout)[0]
        self.assertEqual((facts["width"], facts["pixelBytes"]), (16384, 4 * 16384 ** 2))
        checked = texshot("check", scene, **few)
        self.assertEqual((checked.returncode, checked.stdout, checked.stderr), (0, b"", b""))

        # Three of them are one too many; 64 textures of one are none.
        for name in ("second.tga", "third.tga"):
            shutil.copy(file, self.path / name)
        textures = [{"source": "file", "file": name} for name in ["large.tga"] * 61 + ["second.tga", "third.tga"]]
        scene.write_text(json.dumps({"version": 1, "textures": textures}))
        checked = texshot("check", scene, **few)
        self.assertEqual(checked.returncode, 1)
        errors = [line for line in checked.stdout.decode().splitlines() if line.startswith("error")]
        self.assertEqual(errors, [f"error: textures[62].file: {self.path}/third.tga: the image needs 1073741824 bytes, "
                                  "but of the 2147483648 for all images of a scene, 0 are left"])

    def test_info_and_check_say_that_an_array_is_shown_in_part(self):
        file = self.path / "array.dds"
        header = struct.pack("<4s7I44x", b"DDS ", 124, 0x1007, 4, 4, 0, 0, 0) + struct.pack("<II4s5I", 32, 4, b"DX10", 0, 0, 0, 0, 0)
        header += struct.pack("<5I", 0x1000, 0, 0, 0, 0) + struct.pack("<5I", 71, 3, 0, 3, 0)
        file.write_bytes(header + bytes(range(24)))
        sentence = "it is an array of 3 textures; scenes show the first"
        facts = self.facts(file)
        self.assertEqual((facts["layers"], facts["notes"]), (3, []))
        told = self.succeeds("info", file).decode()
        self.assertIn("layers        3; scenes show the first", told)
        self.assertIn(sentence, told)
        self.assertNotIn("not read", told, "decode, convert and flip read all of them")
        self.succeeds("decode", file, "-", "--layer", "2")
        scene = self.path / "scene.json"
        scene.write_text(json.dumps({"version": 1, "textures": [{"source": "file", "file": "array.dds", "minFilter": "GL_LINEAR"}],
                                     "passes": [{"depthTest": True, "units": [{"enabled": True}]}]}))
        self.assertEqual(self.succeeds("check", scene).decode(), f"note: textures[0].file: array.dds: {sentence}\n")
        note = single(self.succeeds("check", "--json", scene))
        self.assertEqual((note["severity"], note["path"], note["message"]),
                         ("note", "textures[0].file", "array.dds: " + sentence))

    def test_files_that_are_no_images(self):
        for name, content in [("empty.bmp", b""), ("text.bmp", b"hello world"), ("short.bmp", b"BM\0\0")]:
            with self.subTest(name):
                file = self.path / name
                file.write_bytes(content)
                self.complains(1, name, "decode", file, self.path / "out.png")
                told = texshot("info", file)
                self.assertEqual(told.returncode, 1)
                self.assertIn(name, told.stderr.decode())
        self.complains(1, "director", "info", self.path)
        self.complains(1, "nowhere", "info", self.path / "nowhere")
        self.complains(1, "/dev/null: is a device, not a file", "info", "/dev/null")

    def test_info_dissects_a_damaged_file_up_to_the_damage(self):
        file = self.path / "cut.bmp"
        file.write_bytes(bmp(8, 8, lambda x, y: (x, y, 0))[:100])
        result = texshot("info", file)
        self.assertEqual(result.returncode, 1)
        self.assertIn(b"biBitCount", result.stdout)
        self.assertIn(b"cut.bmp", result.stderr)
        told = texshot("info", file, "--json").stdout
        self.assertIn("cut.bmp", problem(told))
        damaged = single(told)
        self.assertNotIn("format", damaged)
        self.assertTrue(damaged["anatomy"]["fields"])
        (self.path / "text.bmp").write_bytes(b"hello world")
        for name in ("text.bmp", "nowhere.bmp"):
            result = texshot("info", self.path / name, "--json")
            self.assertEqual(result.returncode, 1)
            self.assertIn(name, problem(result.stdout))


if __name__ == "__main__":
    unittest.main()
