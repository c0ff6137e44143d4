"""texshot validate: strict checks of images and scenes."""

import io
import json
import struct
import unittest

from PIL import Image

from texshot import Texshot, bmp, dds, place, problem, results, single, texshot


class Validate(Texshot):
    def make(self, name, content):
        path = self.path / name
        path.write_bytes(content)
        return path

    def valid(self, kind, file):
        self.assertEqual(self.succeeds("validate", file).decode(), f"{file}: {kind}, valid\n")

    def faulty(self, expected, file):
        result = texshot("validate", file)
        self.assertEqual((result.returncode, result.stderr), (1, b""))
        said = result.stdout.decode()
        self.assertEqual(said.count("\n"), 1, said)
        self.assertIn(expected, said)
        self.assertIn(" not valid: ", said)

    def test_what_others_write_is_valid(self):
        picture = Image.new("RGB", (5, 3), (10, 200, 30))
        for name in ("a.png", "a.bmp", "a.jpg", "a.tga"):
            picture.save(self.path / name)
            self.valid({"jpg": "JPEG"}.get(name[2:], name[2:].upper()), self.path / name)
        self.valid("BMP", self.make("ours.bmp", bmp(4, 4, lambda x, y: (x, y, 0))))
        self.succeeds("compress", self.path / "ours.bmp", self.path / "ours.dds", "--format", "dxt5")
        self.valid("DDS", self.path / "ours.dds")

    def test_what_is_valid_and_not_drawn_is_valid(self):
        for name, data in [("bc7", dds(4, 4, bytes(16), 98)), ("float", dds(1, 1, bytes(16), 2)),
                           ("bc6h", dds(8, 8, bytes(64 + 16 + 16 + 16), 95, levels=4))]:
            with self.subTest(name):
                file = self.make(name + ".dds", data)
                self.assertIn("DDS, valid, but not drawn: DDS: DXGI_FORMAT_", self.succeeds("validate", file).decode())
                self.faulty("level 0 needs", self.make("cut.dds", data[:148 + 3]))
        one, = results(self.succeeds("validate", file, "--json"))
        self.assertEqual((one["valid"], one["drawn"], one["faults"], len(one["remarks"])), (True, False, [], 1))
        self.faulty("DXGI formats are 1 to 191, dxgiFormat is 500", self.make("none.dds", dds(1, 1, bytes(4), 500)))

    def test_brackets_in_brackets_are_a_fault(self):
        deep = b'{"version":1,"x":1,"y":' + b'{"a":' * 150000 + b"1" + b"}" * 150000 + b"}"
        self.faulty("/x: unknown key", self.make("deep.json", deep))

    def test_what_is_larger_than_all_that_is_drawn_is_valid(self):
        # A line of 20000 pixels of one bit, which every reader may accept; and a header that only claims such a line.
        out = io.BytesIO()
        Image.new("1", (20000, 1)).save(out, "PNG")
        self.assertIn("valid, but not drawn: PNG: at most", self.succeeds("validate", self.make("long.png", out.getvalue())).decode())
        claim = bytearray(bmp(4, 4, lambda x, y: (0, 0, 0)))
        struct.pack_into("<i", claim, 18, 20000)
        self.faulty("pixel data needs", self.make("claim.bmp", bytes(claim)))

    def test_what_is_too_large_to_be_looked_at_is_told_the_limit_of_all_commands(self):
        claim = bytearray(bmp(4, 4, lambda x, y: (0, 0, 0)))
        struct.pack_into("<ii", claim, 18, 0x7FFFFFFF, 0x7FFFFFFF)
        self.faulty("at most 16384 × 16384 pixels are read, the file has 2147483647 × 2147483647 pixels",
                    self.make("huge.bmp", bytes(claim)))

    def test_a_fault_of_a_field_is_said_once(self):
        file = bytearray(dds(4, 4, bytes(64), 28, levels=2))  # with DDSD_MIPMAPCOUNT
        struct.pack_into("<I", file, 28, 0)  # dwMipMapCount
        self.faulty(": DDS, not valid: dwMipMapCount at 28: dwMipMapCount is 0 although DDSD_MIPMAPCOUNT is set; one level "
                    "is read\n", self.make("levels.dds", bytes(file)))

    def test_what_is_right_and_not_followed_is_said_of_a_valid_file(self):
        file = self.path / "turned.jpg"
        exif = Image.Exif()
        exif[0x112] = 6
        Image.new("RGB", (8, 8)).save(file, exif=exif)
        self.assertIn(": JPEG, valid: Exif says that the camera was turned (orientation 6)", self.succeeds("validate", file).decode())
        file = self.path / "moves.png"
        Image.new("RGB", (2, 2)).save(file, save_all=True, append_images=[Image.new("RGB", (2, 2), (9, 9, 9))])
        self.assertIn(": PNG, valid: the file is an animation", self.succeeds("validate", file).decode())
        self.valid("DDS", self.make("array.dds", dds(1, 1, bytes(12), 28, layers=3)))
        self.faulty("an array of 4294967295 textures needs", self.make("claims.dds", dds(1, 1, bytes(12), 28, layers=0xFFFFFFFF)))

    def test_what_is_survived_elsewhere_is_a_fault(self):
        out = io.BytesIO()
        Image.new("RGB", (4, 4), (1, 2, 3)).save(out, "PNG")
        png = out.getvalue()
        wrong_sum = bytearray(png)
        wrong_sum[-1] ^= 1  # the checksum of IEND
        wide = bytearray(bmp(4, 4, lambda x, y: (1, 2, 3)))
        struct.pack_into("<H", wide, 26, 7)  # biPlanes
        for name, content in (("sum.png", bytes(wrong_sum)), ("planes.bmp", bytes(wide))):
            with self.subTest(name):
                self.faulty(name.rsplit(".")[-1].upper(), self.make(name, content))

    def test_damage_is_a_fault(self):
        out = io.BytesIO()
        Image.effect_noise((32, 32), 90).save(out, "PNG")
        png = out.getvalue()
        for cut in (9, 40, len(png) // 2, len(png) - 13):
            self.faulty("PNG", self.make("cut.png", png[:cut]))
        self.faulty("file has", self.make("cut.bmp", bmp(8, 8, lambda x, y: (x, y, 0))[:100]))
        self.faulty("the file is empty", self.make("empty", b""))
        self.faulty("expected a scene or an image (BMP, DDS, JPEG, PNG, TGA), the file begins with 68 65 6c 6c",
                    self.make("text.txt", b"hello"))

    def test_scenes(self):
        self.valid("scene", self.make("a.json", b'{"version": 1}'))
        self.valid("scene", self.make("no-extension", b'\n {"version": 1, "$schema": "x"}'))
        for expected, text in [
            ('/view/distanc: unknown key; did you mean "distance"?', '{"version": 1, "view": {"distanc": 1}}'),
            ("/view/distance: ", '{"version": 1, "view": {"distance": 1e9}}'),
            ("/textures/0/wrapS: ", '{"version": 1, "textures": [{"wrapS": "GL_CLAMPED"}]}'),
            ("/version: ", '{"version": 99}'),
            ("expected each key once", '{"version": 1, "version": 1}'),
            ("line 1", '{"version": 1'),
            ("/passes/0/units/0", '{"version": 1, "textures": [], "passes": [{"units": [{"enabled": true}]}]}'),
        ]:
            with self.subTest(expected):
                self.faulty(expected, self.make("wrong.json", text.encode()))
        self.faulty("expected an object, found an array", self.make("list.json", b"[]"))
        self.faulty("empty", self.make("empty.json", b""))
        # The drawn picture and the images of a scene are not checked.
        self.valid("scene", self.make("lost.json", b'{"version": 1, "textures": [{"source": "file", "file": "no.png"}]}'))

    def test_meshes(self):
        square = b"mtllib gone.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n"
        file = self.make("square.obj", square)
        self.assertIn(": OBJ, valid: the material library gone.mtl can't be read: drawn without its materials",
                      self.succeeds("validate", file).decode())
        self.assertIn("standard input: OBJ, valid", texshot("validate", "-", input=square).stdout.decode())
        self.faulty("OBJ, not valid: line 1: expected v ", self.make("wrong.obj", b"f 1 2 3\n"))

    def test_all_faults_of_a_scene_are_told(self):
        wrong = self.make("wrong.json", json.dumps({
            "version": 1, "view": {"distanc": 1, "target": [0, "x", 0]}, "textures": [{"wrapS": "GL_CLAMPED", "wrapT": 3}, {}],
            "passes": [{"units": [{"textur": 0}]}]}).encode())
        told = results(texshot("validate", "--json", wrong).stdout)[0]
        self.assertEqual([each["where"][0]["pointer"] for each in sorted(told["faults"], key=place)],
                         ["/passes/0/units/0/textur", "/textures/0/wrapS", "/textures/0/wrapT", "/view/distanc",
                          "/view/target/1"])

    def test_suites_and_runs(self):
        suite = self.make("a.suite.json", b'{"suite": 1, "cases": [{"size": "8x8"}]}')
        self.valid("suite", suite)
        self.valid("suite", self.make("plain", suite.read_bytes()))
        self.succeeds("test", suite, "--update", "--json", self.path / "run.json")
        self.valid("run", self.path / "run.json")
        self.faulty('suite, not valid: /cases/0/sise: unknown key; did you mean "size"?',
                    self.make("b.suite.json", b'{"suite": 1, "cases": [{"sise": "8x8"}]}'))
        self.faulty("suite, not valid: line 1", self.make("c.suite.json", b'{"suite": 1'))
        self.faulty("two cases are called", self.make("d.suite.json", b'{"suite": 1, "cases": [{}, {}]}'))
        self.faulty("run, not valid: ", self.make("e.json", b'{"run": 1, "cases": 3}'))
        for call in (("check", "--json"), ("test", "--list", suite, "--json", "-")):
            self.faulty(f"output, not valid: expected the run of texshot test, found a document of texshot {call[0]} without it",
                        self.make("f.json", self.succeeds(*call)))
        self.faulty("scene, not valid: /results: unknown key", self.make("g.json", b'{"results": []}'))

    def test_all_of_them_are_told_and_one_decides(self):
        good = self.make("good.bmp", bmp(2, 2, lambda x, y: (0, 0, 0)))
        bad = self.make("bad.json", b"{}x")
        result = texshot("validate", good, bad, self.path / "missing.png", self.path)
        self.assertEqual(result.returncode, 1)
        lines = result.stdout.decode().splitlines()
        self.assertEqual((lines[0], len(lines)), (f"{good}: BMP, valid", 2))
        self.assertEqual(result.stderr.decode().splitlines(),
                         [f"texshot: {self.path}/missing.png: can't be opened: No such file or directory",
                          f"texshot: {self.path}: is a directory, not a file"])
        result = texshot("validate", "--json", self.path / "missing.png", good)
        self.assertEqual(result.stderr.decode(), f"texshot: {problem(result.stdout)}\n")
        self.assertEqual([[fault["message"] for fault in each["faults"]] for each in results(result.stdout)],
                         [["can't be opened: No such file or directory"], []])
        told = results(texshot("validate", "--json", good, bad).stdout)
        self.assertEqual([(each["file"], each["kind"], each["valid"]) for each in told],
                         [(str(good), "BMP", True), (str(bad), "scene", False)])
        self.assertEqual(told[0]["faults"], [])
        self.assertEqual(len(told[1]["faults"]), 1)
        self.assertTrue(single(self.succeeds("validate", "--json", good))["valid"])

    def test_names_are_printed_harmlessly(self):
        file = self.make("\x1b[31m\n.json", b"{}")
        result = texshot("validate", file)
        self.assertNotIn(b"\x1b", result.stdout)
        self.assertEqual(result.stdout.count(b"\n"), 1)

    def test_wrong_calls(self):
        self.complains(2, "FILE is missing; see texshot validate --help", "validate")
        self.complains(2, "there is no option --jsn; did you mean --json?", "validate", "a.png", "--jsn")


if __name__ == "__main__":
    unittest.main()
