"""Where pictures are written: the extension sets the format; pipes and devices work like files."""

import json
import os
import re
import resource
import signal
import struct
import subprocess
import unittest
from pathlib import Path

from PIL import Image, PngImagePlugin

from texshot import TEXSHOT, Texshot, bmp, texshot


class Outputs(Texshot):
    def setUp(self):
        super().setUp()
        self.bmp = self.path / "in.bmp"
        self.bmp.write_bytes(bmp(16, 8, lambda x, y: (x * 15, y * 30, 60)))
        self.dds = self.path / "in.dds"
        self.succeeds("compress", self.bmp, self.dds, "--format", "dxt1", "--mips", "none")  # every format can store it
        self.writers = {
            "shot": (["shot", "--renderer", "reference", "--size", "16x16", "-o"], []),
            "decode": (["decode", self.dds], []),
            "convert": (["convert", self.bmp], []),
            "flip": (["flip", self.dds], []),
            "compress": (["compress", self.bmp], ["--format", "dxt1"]),
        }

    def test_the_extension_decides_the_format_or_is_refused(self):
        for name in ("shot", "decode", "convert", "flip"):
            before, after = self.writers[name]
            for extension, format in ((".bmp", "BMP"), (".PNG", "PNG"), (".tga", "TGA"), (".dds", "DDS")):
                with self.subTest(name + extension):
                    out = self.path / ("out" + extension)
                    self.succeeds(*before, out, *after)
                    with Image.open(out) as written:
                        self.assertEqual(written.format, format)
                    out.unlink()
            argument = "--out" if name == "shot" else "OUT"
            for wrong in ("out.jpg", "out.jpeg", "out.xyz", "out", "png"):
                self.complains(2, f'texshot: {argument}: expected a name that ends in one of .bmp, .dds, .png, .tga, found "{self.path / wrong}"',
                               *before, self.path / wrong, *after)
        before, after = self.writers["compress"]
        for wrong in ("out.png", "out"):
            self.complains(2, "texshot: OUT: expected a name that ends in .dds, found", *before, self.path / wrong, *after)

    def test_pipes_and_devices_are_written(self):
        magic = {"shot": b"\x89PNG", "decode": b"\x89PNG", "convert": b"\x89PNG", "flip": b"DDS ", "compress": b"DDS "}
        pipe = self.path / "pipe"
        os.mkfifo(pipe)
        for name, (before, after) in self.writers.items():
            with self.subTest(name):
                plain = self.succeeds(*before, "-", *after)
                self.assertTrue(plain.startswith(magic[name]))
                self.assertEqual(self.succeeds(*before, "/dev/stdout", *after), plain)
                self.assertEqual(self.succeeds(*before, "/dev/null", *after), b"")
                writer = subprocess.Popen([TEXSHOT, *map(str, before), pipe, *after])
                self.assertEqual(pipe.read_bytes(), plain)
                self.assertEqual(writer.wait(timeout=60), 0)
                self.complains(1, "/dev/full: can't be written: No space left on device", *before, "/dev/full", *after)
        self.assertTrue(pipe.is_fifo())

    def test_an_output_that_cant_be_written_is_known_before_the_work(self):
        for name, (before, after) in self.writers.items():
            with self.subTest(name):
                lost = self.bmp / "out.dds"  # a path below a file
                missing = [str(argument).replace("in.", "missing.") for argument in before]  # not even checked
                self.complains(1, f"{lost}: can't be written: Not a directory", *missing, lost, *after)
                folder = self.path / "folder.dds"
                folder.mkdir(exist_ok=True)
                self.complains(1, f"{folder}: is a directory, not a file", *missing, folder, *after)

    def test_what_is_printed_is_printed_or_fails(self):
        scene = self.path / "broken.json"
        scene.write_text('{"version": 1, "textures": [{"mipmaps": "none"}], "passes": [{"units": [{"enabled": true}]}]}')
        calls = [["--help"], ["--version"], ["shot", "--help"], ["conform", "--help"], ["params"], ["params", "--json"],
                 ["info", self.bmp], ["info", self.bmp, "--json"], ["check", "--json"], ["conform", "--list"], ["conform", "--list", "--json"],
                 ["check", "--set", "textures[0].mipmaps=none"],
                 ["probe", "--no-gl", "--size", "8x8", "--at", "4,4"], ["probe", "--size", "8x8", "--texel", "0,0,0,0", "--json"],
                 ["compress", self.bmp, self.path / "out.dds", "--format", "dxt1", "--report"]]
        calls += [[*before, "-", *after] for before, after in self.writers.values()]
        for call in calls:
            with self.subTest(call):
                with open("/dev/full", "wb") as full:
                    self.fails_to_print("No space left on device", call, stdout=full)
                reader, writer = os.pipe()
                os.close(reader)
                result = subprocess.run([TEXSHOT, *map(str, call)], stdout=writer, stderr=subprocess.PIPE, timeout=120)
                self.assertEqual((result.returncode, result.stderr), (-signal.SIGPIPE, b""), "as of any filter")
                self.fails_to_print("Broken pipe", call, stdout=writer, restore_signals=False)  # ignored, as Python does
                os.close(writer)
                self.fails_to_print("Bad file descriptor", call, preexec_fn=lambda: os.close(1))

    def fails_to_print(self, expected, call, **options):
        result = subprocess.run([TEXSHOT, *map(str, call)], stderr=subprocess.PIPE, timeout=120, **options)
        self.assertEqual(result.stderr.decode(), f"texshot: standard output: can't be written: {expected}\n")
        self.assertEqual(result.returncode, 1)

    def test_a_full_disk_gets_no_half_of_anything(self):
        def small_disk(limit):
            return {"preexec_fn": lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))}
        for name, (before, after) in self.writers.items():
            with self.subTest(name):
                out = self.path / "out.dds"
                out.write_bytes(b"old")
                names = sorted(os.listdir(self.path))
                result = texshot(*before, out, *after, **small_disk(64))
                self.assertEqual(result.returncode, 1)
                self.assertEqual(result.stderr.decode(), f"texshot: {out}: can't be written: File too large\n")
                self.assertEqual((out.read_bytes(), sorted(os.listdir(self.path))), (b"old", names))
        with open(self.path / "params.txt", "wb") as report:
            result = subprocess.run([TEXSHOT, "params"], stdout=report, stderr=subprocess.PIPE, **small_disk(1000))
        self.assertEqual((result.returncode, (self.path / "params.txt").read_bytes()), (1, b""))
        self.assertIn(b"standard output: can't be written: File too large", result.stderr)
        log = self.path / "log.txt"
        log.write_bytes(b"what was there before")
        with open(log, "ab") as report:
            result = subprocess.run(["sh", "-c", '"$0" params', TEXSHOT], stdout=report, stderr=subprocess.PIPE,
                                    **small_disk(1000))
        self.assertEqual((result.returncode, log.read_bytes()), (1, b"what was there before"))
        call = ("conform", "--feature", "wrap", "--scenes", "2", "-o")
        result = texshot(*call, self.path / "new" / "report", **small_disk(4000))
        self.assertEqual(result.returncode, 1)
        self.assertIn(b"can't be written: File too large", result.stderr)
        self.assertFalse((self.path / "new").exists())

    def test_no_output_takes_the_place_of_what_its_scene_reads(self):
        """Under any name, including the files that key frames name, and every file of a lesson's folder."""
        red = Image.new("RGB", (8, 8), (255, 0, 0))
        files = [self.path / name for name in ("image.png", "2.png", "3.png")]
        for file in files:
            red.save(file)
        link, scene, keyed = self.path / "link.png", self.path / "scene.json", self.path / "keyed.json"
        link.symlink_to(files[0])
        texture = {"source": "file", "file": "image.png", "mipmaps": "none", "minFilter": "GL_LINEAR"}
        scene.write_text(json.dumps({"version": 1, "textures": [texture]}))
        keyed.write_text(json.dumps({"version": 1, "textures": [texture], "timeline": [
            {"time": time, "path": "textures[0].file", "value": value} for time, value in ((0, "image.png"), (1, "2.png"))]}))
        lesson = self.path / "lesson"
        lesson.mkdir()
        (lesson / "lesson.json").write_text(json.dumps({"lesson": 1, "title": "T", "source": "S", "about": "A.", "steps": [
            {"title": "One", "text": "Text.", "scene": "cube"}]}))
        files += [scene, keyed, lesson / "lesson.json"]
        before = {file: file.read_bytes() for file in files}
        small = ("--size", "16x16")
        for call, out, lost in (
                (("emit", scene), files[0], files[0]), (("emit", scene, "--as", "glsl"), link, files[0]),
                (("emit", scene), scene, scene), (("emit", "--lesson", lesson), lesson / "lesson.json", lesson / "lesson.json"),
                (("shot", scene, *small), files[0], files[0]),
                (("shot", keyed, *small, "--time", "2,3"), self.path / "{time}.png", files[1]),
                (("texture", scene), files[0], files[0]),
                (("sweep", scene, *small, "--axis", "view.azimuth=1,2"), files[0], files[0]),
                (("sweep", keyed, *small, "--axis", "view.azimuth=1,2"), self.path / "{azimuth}.png", files[1]),
                (("animate", keyed, *small, "--fps", "2"), files[1], files[1]),
                (("animate", keyed, *small, "--fps", "4"), self.path / "%d.png", files[1])):
            with self.subTest((call, out)):
                self.complains(2, f'--out: expected a file other than "{lost}", which is read', *call, "-o", out)
                self.assertEqual({file: file.read_bytes() for file in files}, before)
        drawn = self.path / "drawn.png"  # contains its scene
        self.succeeds("shot", "--example", "cube", *small, "-o", drawn)
        for call in (("texture", drawn), ("shot", drawn, *small), ("shot", drawn, *small, "--no-metadata")):
            self.complains(2, f'expected a file other than "{drawn}", which is read', *call, "-o", drawn)
        for _ in range(2):  # a written file does not belong to the lesson
            self.succeeds("emit", "--lesson", lesson, "-o", lesson / "one.c")
        self.succeeds("emit", "--lesson", "dds", "--step", "8", "--files", "-o", self.path / "dds.c")
        result = texshot("shot", "--lesson", "dds", "--step", "8", *small, "-o", "dxt1.dds", cwd=self.path)  # the program's own is no file
        self.assertEqual(result.returncode, 0, result.stderr)
        with open(scene, "rb") as text:
            self.assertEqual(texshot("emit", "-", "-o", scene, stdin=text, cwd=self.path).returncode, 2)
        self.succeeds("shot", scene, *small, "-o", self.path / "1.png")
        self.assertEqual({file: file.read_bytes() for file in files}, before)

    def test_a_folder_that_gets_nothing_is_not_made(self):
        call = ("--example", "cube", "--size", "64x64", "--set", "view.azimuth=0..9", "--seconds", "1", "--fps", "3")
        result = texshot("animate", *call, "-o", self.path / "new" / "folder" / "%d.png",
                         preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (64, 64)))
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertFalse((self.path / "new").exists())
        self.succeeds("animate", *call, "-o", self.path / "new" / "folder" / "%d.png")
        self.assertEqual(len(list((self.path / "new" / "folder").iterdir())), 3)

    def test_options_without_effect_are_notes(self):
        """Nothing else depends on it, so that a loop over renderers or formats works."""
        out, small = self.path / "out", ("--size", "16x16")
        shaders = Path(__file__).resolve().parents[3] / "shaders"
        for expected, *call in [
            ("--rle: has no effect here: it applies to TGA files only, OUT is DDS", "convert", self.bmp, f"{out}.dds", "--rle"),
            ("--small: has no effect here: it applies to PNG files only, OUT is BMP", "convert", self.bmp, f"{out}.bmp", "--small"),
            ("--gamma: has no effect here", "compress", self.bmp, f"{out}.dds", "--format", "dxt1", "--gamma", "--mips", "none"),
            ("--shaders: has no effect here", "shot", *small, "--shaders", shaders, "-o", f"{out}.png"),
            ("--context: has no effect here", "shot", *small, "--renderer", "reference", "--context", "auto", "-o", f"{out}.png"),
            ("--anisotropy: has no effect here", "shot", *small, "--anisotropy", "probes", "-o", f"{out}.png"),
            ("--renderer: has no effect here: --compare has the renderers", "shot", "--ui", "--compare", "fixed,shader", "--renderer", "fixed",
             "-o", f"{out}.png"),
            ("--pass: has no effect here", "probe", "--no-gl", *small, "--at", "1,1", "--pass", "0"),
            ("--no-gl: has no effect here", "probe", *small, "--texel", "0,0,0,0", "--no-gl"),
            ("--seed: has no effect here: --list compares nothing", "conform", "--list", "--seed", "1"),
            ("--out: has no effect here: --list compares nothing", "conform", "--list", "-o", self.path / "report"),
        ]:
            with self.subTest(expected):
                self.notes(expected, *call)
                option = expected.split(":")[0]
                i = call.index(option if option in call else "-o")
                plain = [*call[:i], *call[i + (1 if option in ("--rle", "--small", "--gamma", "--no-gl") else 2):]]
                if str(call[-1]).startswith(str(out)):
                    written = Path(call[-1]).read_bytes()
                    self.succeeds(*plain)
                    self.assertEqual(Path(call[-1]).read_bytes(), written)
        self.assertFalse((self.path / "report").exists())
        quiet = texshot("shot", *small, "--renderer", "reference", "--context", "auto", "-o", f"{out}.png", "--quiet")
        self.assertEqual((quiet.returncode, quiet.stderr), (0, b""))

    def test_a_value_that_stands_apart_is_explained(self):
        explained = '--set: expected PATH=VALUE, joined by = without a space, found "view.azimuth"'
        out = self.path / "out.png"
        self.complains(2, explained, "shot", "--set", "view.azimuth", "3", "-o", out)
        self.complains(2, explained, "shot", self.path / "scene.json", "--set", "view.azimuth", "3", "-o", out)
        self.complains(2, explained, "check", "--set", "view.azimuth", "=", "3")
        self.complains(2, explained, "probe", "--at", "1,1", "--set", "view.azimuth")

    STEERING = re.compile("[\0-\x08\x0b-\x1f\x7f-\x9f\u061c\u200e\u200f\u2028-\u202e\u2066-\u2069]")

    def test_nothing_from_outside_steers_a_terminal(self):
        name = "\x1b[31mx\n\x7f\u009b\u202egpj\u2066.tga"
        shown = r"\u001b[31mx\u000a\u007f\u009b\u202egpj\u2066.tga"
        file = self.path / name
        comment = "\x1b]0;title\x07\n\x7f".encode().ljust(324, b"\0")
        author = b"\x9b31m".ljust(41, b"\0")
        pixels = bytes((0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0)) + struct.pack("<HHBB", 1, 1, 24, 0) + b"\1\2\3"
        area = struct.pack("<H", 495) + author + comment + bytes(495 - 2 - 41 - 324)
        file.write_bytes(pixels + area + struct.pack("<II", len(pixels), 0) + b"TRUEVISION-XFILE.\0")
        png = self.path / "text\x1b.png"
        words = PngImagePlugin.PngInfo()
        words.add_text("Author", "\x1b[31m\x9b\u202e")
        Image.new("RGB", (1, 1)).save(png, pnginfo=words)
        latin = self.path / os.fsdecode(b"latin-\xe9.bmp")
        latin.write_bytes(bmp(1, 1, lambda x, y: (1, 2, 3)))
        scene = self.path / "\x1b[2J.json"
        texture = {"source": "file", "file": name + "\x1b[A"}
        scene.write_text(json.dumps({"version": 1, "textures": [texture]}))
        keys = self.path / "keys.json"
        keys.write_text(json.dumps({"version": 1, "\x1b[31m\x7f\x85\u202e": 1}))
        value = self.path / "value.json"
        value.write_text(json.dumps({"version": 1, "models": [{"shape": "\x1b[31m\n\x7f\x85\u202e"}]}))
        for call in (["info", file], ["info", "--json", file], ["info", png], ["info", latin], ["info", "--json", latin],
                     ["info", str(file) + "\x1b[A"], ["check", scene], ["check", "--json", scene], ["check", keys],
                     ["check", value], ["shot", scene, "-o", "-"], ["shot", "--set", "a\x1b[31m=b\n", "-o", "-"],
                     ["shot", "--\x1b[31m\x85"], ["\x1b[31m"], ["decode", file, self.path / "out.\x1b[31m"],
                     ["flip", file, self.path / "out.\x1b[31m"], ["shot", "--tab", "\x1b[31m", "--ui", "-o", "-"]):
            with self.subTest(call):
                result = texshot(*call)
                for said in (result.stdout, result.stderr):
                    self.assertIsNone(self.STEERING.search(said.decode()))  # and it is UTF-8
                if "--json" in call:
                    json.loads(result.stdout)
                self.assertLessEqual(result.stderr.count(b"\n"), 1, "one sentence is one line")
        self.assertIn(shown, self.succeeds("info", file).decode())
        self.assertEqual(self.facts(file)["file"], str(file))


if __name__ == "__main__":
    unittest.main()
