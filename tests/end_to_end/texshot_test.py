"""Drives the real texshot as a user would: exit codes, sentences, pictures. Pillow reads what it writes."""

import io
import json
import os
import pty
import random
import re
import resource
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

from PIL import Image, ImageChops, PngImagePlugin

TEXSHOT = sys.argv.pop(1)


def texshot(*arguments, **options):
    return subprocess.run([TEXSHOT, *map(str, arguments)], capture_output=True, timeout=120, **options)


def bmp(width, height, pixel):
    """A 24-bit BMP whose pixel (x, y), y from the top, is pixel(x, y) as (r, g, b)."""
    rows = b""
    for y in reversed(range(height)):
        row = b"".join(bytes(reversed(pixel(x, y))) for x in range(width))
        rows += row + b"\0" * (-len(row) % 4)
    header = struct.pack("<2sIHHI", b"BM", 54 + len(rows), 0, 0, 54)
    header += struct.pack("<IiiHHIIiiII", 40, width, height, 1, 24, 0, len(rows), 2835, 2835, 0, 0)
    return header + rows


class Texshot(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path = Path(self.folder.name)
        self.addCleanup(self.folder.cleanup)

    def succeeds(self, *arguments):
        result = texshot(*arguments)
        self.assertEqual((result.returncode, result.stderr), (0, b""), arguments)
        return result.stdout

    def complains(self, code, expected, *arguments):
        """Fails with this code and one sentence that holds `expected`, and leaves no file behind."""
        before = sorted(os.listdir(self.path))
        result = texshot(*arguments)
        said = result.stderr.decode()
        self.assertEqual(result.returncode, code, said)
        self.assertRegex(said, r"\Atexshot: [^\n]+\n\Z", "one sentence, and who says it")
        self.assertIn(expected, said)
        self.assertEqual(result.stdout, b"")
        self.assertEqual(sorted(os.listdir(self.path)), before)
        return said

    def difference(self, a, b):
        """Where two opaque pictures differ, or None. Of RGBA Pillow would look at alpha alone."""
        return ImageChops.difference(a.convert("RGB"), b.convert("RGB")).getbbox()

    def shot(self, *arguments):
        return Image.open(io.BytesIO(self.succeeds("shot", *arguments, "-o", "-"))).convert("RGBA")


class Shot(Texshot):
    def test_two_runs_give_the_same_bytes(self):
        for window in ([], ["--ui"]):
            first = self.succeeds("shot", "--size", "640x400", *window, "-o", "-")
            second = self.succeeds("shot", "--size", "640x400", *window, "-o", "-")
            self.assertEqual(first, second)

    def test_the_default_scene_shows_a_cube_and_a_sphere(self):
        picture = self.shot("--size", "320x200")
        self.assertEqual(picture.size, (320, 200))
        background = picture.getpixel((2, 2))
        self.assertNotEqual(picture.getpixel((95, 100)), background, "left of the middle there is the cube")
        self.assertNotEqual(picture.getpixel((225, 100)), background, "right of the middle there is the sphere")
        self.assertEqual(picture.getpixel((160, 10)), background)

    def test_a_flat_square_shows_its_texture_upright(self):
        file = self.path / "corners.bmp"
        colours = {(0, 0): (255, 0, 0), (1, 0): (0, 255, 0), (0, 1): (0, 0, 255), (1, 1): (255, 255, 0)}
        file.write_bytes(bmp(2, 2, lambda x, y: colours[x, y]))
        scene = self.path / "scene.json"
        scene.write_text(json.dumps({
            "version": 1,
            "view": {"projection": "orthographic", "azimuth": 0, "elevation": 0, "distance": 5, "fieldOfView": 22.6},
            "models": [{"shape": "quad"}],
            "textures": [{"source": "file", "file": "corners.bmp", "magFilter": "GL_NEAREST",
                          "minFilter": "GL_NEAREST"}],
            "passes": [{"units": [{"enabled": True, "envMode": "GL_REPLACE"}]}],
        }))
        picture = self.shot(scene, "--size", "100x100")
        for (x, y), colour in colours.items():
            self.assertEqual(picture.getpixel((25 + 50 * x, 25 + 50 * y))[:3], colour, (x, y))

    def test_set_changes_one_parameter(self):
        plain = self.shot("--size", "200x120")
        tinted = self.shot("--size", "200x120", "--set", "material.color=1,0,0,1", "--set", "view.background=0,0,1,1")
        self.assertEqual(tinted.getpixel((1, 1)), (0, 0, 255, 255))
        self.assertNotEqual(plain.tobytes(), tinted.tobytes())

    def test_time_moves_what_is_animated(self):
        scene = self.path / "spin.json"
        scene.write_text('{"version": 1, "models": [{"shape": "cube", "spin": [0, 45, 0]}]}')
        self.assertEqual(self.shot(scene, "--size", "99x99").tobytes(),
                         self.shot(scene, "--size", "99x99", "--time", "0").tobytes())
        self.assertNotEqual(self.shot(scene, "--size", "99x99").tobytes(),
                            self.shot(scene, "--size", "99x99", "--time", "0.5").tobytes())

    def test_the_window_is_drawn_with_its_panels(self):
        picture = self.shot("--ui", "--size", "1280x800").convert("RGB")
        self.assertEqual(picture.size, (1280, 800))
        left = picture.crop((0, 40, 300, 760))
        self.assertGreater(len(left.getcolors(300 * 720)), 20, "the left panel holds text, so it has many greys")

    def test_each_tab_can_be_shown(self):
        size = (1280, 800)
        corner = (910, 440, 1280, 770)  # the tabs
        plain = self.shot("--ui", "--size", "%dx%d" % size)
        seen = {plain.crop(corner).tobytes()}
        for tab in ("commands", "glsl", "file", "memory"):
            with self.subTest(tab):
                picture = self.shot("--ui", "--size", "%dx%d" % size, "--tab", tab)
                self.assertEqual(picture.crop((0, 0, 900, 800)).tobytes(), plain.crop((0, 0, 900, 800)).tobytes())
                seen.add(picture.crop(corner).tobytes())
        self.assertEqual(len(seen), 5)
        self.assertEqual(self.shot("--ui", "--tab", "vertices").tobytes(), plain.tobytes())

    def test_the_window_shows_the_section_that_is_asked_for(self):
        rest = (316, 0, 1280, 800)
        plain = self.shot("--ui", "--size", "1280x800")
        seen = {plain.tobytes()}
        for section in ("coordinates", "matrix", "light"):
            with self.subTest(section):
                picture = self.shot("--ui", "--size", "1280x800", "--section", section)
                self.assertEqual(picture.crop(rest).tobytes(), plain.crop(rest).tobytes())
                seen.add(picture.tobytes())
        self.assertEqual(len(seen), 4)

    def test_an_existing_picture_survives_a_failure(self):
        out = self.path / "out.png"
        self.succeeds("shot", "--size", "16x16", "-o", out)
        before = out.read_bytes()
        (self.path / "broken.json").write_text('{"version": 1, "view": ')
        self.complains(1, "broken.json", "shot", self.path / "broken.json", "-o", out)
        self.assertEqual(out.read_bytes(), before)

    def test_bad_calls(self):
        out = self.path / "out.png"
        for expected, arguments in [
            ("from 1x1 to 16384x16384, found \"0x10\"", ["--size", "0x10"]),
            ("from 1x1 to 16384x16384", ["--size", "100000x100000"]),
            ("from 320x200 to 16384x16384, found \"1x1\"", ["--ui", "--size", "1x1"]),
            ("from 320x200", ["--ui", "--size", "320x199"]),
            ("WIDTHxHEIGHT", ["--size", "12"]),
            ("WIDTHxHEIGHT", ["--size", "12x-3"]),
            ("WIDTHxHEIGHT", ["--size", "99999999999999999999x3"]),
            ("finite number of seconds, found \"nan\"", ["--time", "nan"]),
            ("finite number of seconds, found \"1e999\"", ["--time", "1e999"]),
            ("finite number of seconds, found \"soon\"", ["--time", "soon"]),
            ("PATH=VALUE", ["--set", "view.azimuth"]),
            ("minFilter", ["--set", "textures[0].minFliter=GL_NEAREST"]),
            ("GL_NEAREST", ["--set", "textures[0].minFilter=GL_NERAEST"]),
            ("textures[7]", ["--set", "textures[7].minFilter=GL_NEAREST"]),
            ("one of vertices, commands, glsl, explain, file, memory, found \"bytes\"", ["--ui", "--tab", "bytes"]),
            ("--ui", ["--tab", "file"]),
            ("one of texture, unit, combine, coordinates, matrix, model, pass, light, material, view, found \"lod\"",
             ["--ui", "--section", "lod"]),
            ("--ui", ["--section", "matrix"]),
            ("there is no option --nonsense; see texshot shot --help", ["--nonsense"]),
            ("expected no further argument, found \"b.json\"; see texshot shot --help", ["a.json", "b.json"]),
        ]:
            with self.subTest(arguments):
                self.complains(2, expected, "shot", *arguments, "-o", out)
        self.complains(2, "--out", "shot")
        self.complains(2, "--size: expected a value, found none", "shot", "-o", out, "--size")
        self.complains(2, "expected one of shot, probe, check, conform, params, decode, info")
        for unknown in ["paint", "--paint", "-x", ""]:
            self.complains(2, f'there is no command "{unknown}"', unknown)

    def test_bad_scenes(self):
        for name, content, expected in [
            ("empty.json", b"", "empty.json"),
            ("binary.json", bytes(range(256)), "binary.json"),
            ("list.json", b"[]", "object"),
            ("deep.json", b"[" * 100000, "deep.json"),
            ("huge.json", b'{"version": 1, "view": {"azimuth": 1e999}}', "huge.json"),
            ("sphere.json", b'{"version": 1, "models": [{"shape": "sphere", "slices": 1000000000}]}',
             "/models/0/slices"),
            ("typo.json", b'{"version": 1, "textures": [{"minFliter": 3}]}', "/textures/0"),
            ("future.json", b'{"version": 99}', "99"),
        ]:
            with self.subTest(name):
                file = self.path / name
                file.write_bytes(content)
                said = self.complains(1, expected, "shot", file, "-o", self.path / "out.png")
                self.assertIn(name, said)
                self.assertLess(len(said), 600, "one sentence, not a dump")

    def test_a_scene_beyond_the_limit_is_not_read(self):
        file = self.path / "huge.json"
        with open(file, "wb") as huge:
            huge.truncate(17 << 20)
        self.complains(1, "at most 16777216 bytes are read", "shot", file, "-o", self.path / "out.png")

    def test_the_smallest_window_is_drawn(self):
        self.assertEqual(self.shot("--ui", "--size", "320x200").size, (320, 200))

    def test_missing_files(self):
        out = self.path / "out.png"
        self.complains(1, "nowhere.json", "shot", self.path / "nowhere.json", "-o", out)
        self.complains(1, "director", "shot", self.path, "-o", out)
        self.complains(1, "nowhere.bmp", "shot", "--set", "textures[0].source=file", "--set",
                       "textures[0].file=nowhere.bmp", "-o", out)
        self.complains(1, "no/such", "shot", "--size", "8x8", "-o", self.path / "no/such/out.png")


    def test_the_reference_draws_what_opengl_draws(self):
        fixed = self.shot("--size", "320x200")
        reference = self.shot("--size", "320x200", "--renderer", "reference")
        difference = ImageChops.difference(fixed, reference).convert("L")
        far = sum(count for level, count in enumerate(difference.histogram()) if level > 16)
        self.assertLess(far, 320 * 200 / 100)
        self.assertEqual(difference.getpixel((95, 100)), 0)

    def test_the_reference_needs_no_opengl(self):
        alone = self.path / "bin" / "texshot"  # without the module that holds OpenGL beside it
        alone.parent.mkdir()
        shutil.copy(TEXSHOT, alone)
        shoot = [alone, "shot", "--size", "16x16", "-o", "-"]
        self.assertEqual(subprocess.run(shoot, capture_output=True).returncode, 1)
        drawn = subprocess.run([*shoot, "--renderer", "reference"], capture_output=True)
        self.assertEqual((drawn.returncode, drawn.stderr), (0, b""))
        self.assertEqual(Image.open(io.BytesIO(drawn.stdout)).size, (16, 16))

    def test_the_window_shows_the_picture_of_each_renderer(self):
        scene = self.path / "scene.json"
        scene.write_text('{"version": 1, "view": {"azimuth": 33}}')  # a camera that the window need not fit
        place = (321, 64, 321 + 583, 64 + 682)
        for renderer in ("fixed", "shader", "reference"):
            with self.subTest(renderer):
                window = self.shot(scene, "--ui", "--renderer", renderer, "--size", "1280x800")
                alone = self.shot(scene, "--renderer", renderer, "--size", "583x682")
                self.assertIsNone(self.difference(window.crop(place), alone))

    def test_the_reference_knows_two_ways_of_anisotropy(self):
        floor = ["--size", "64x48", "--renderer", "reference", "--set", "models[0].shape=floor",
                 "--set", "textures[0].maxAnisotropy=8"]
        probes = self.shot(*floor)
        self.assertEqual(self.shot(*floor, "--anisotropy", "probes").tobytes(), probes.tobytes())
        self.assertNotEqual(self.shot(*floor, "--anisotropy", "ellipse").tobytes(), probes.tobytes())
        scene = self.path / "floor.json"
        scene.write_text('{"version": 1, "view": {"azimuth": 33}, "textures": [{"maxAnisotropy": 8,'
                         ' "minFilter": "GL_LINEAR_MIPMAP_LINEAR", "mipmaps": "generated"}],'
                         ' "passes": [{"depthTest": true, "units": [{"enabled": true}]}]}')
        window = self.shot(scene, "--ui", "--renderer", "reference", "--anisotropy", "ellipse",
                           "--size", "1280x800")
        alone = self.shot(scene, "--renderer", "reference", "--anisotropy", "ellipse", "--size", "583x682")
        self.assertIsNone(self.difference(window.crop((321, 64, 321 + 583, 64 + 682)), alone))
        otherwise = self.shot(scene, "--renderer", "reference", "--size", "583x682")
        self.assertIsNotNone(self.difference(otherwise, alone))
        out = self.path / "out.png"
        self.complains(2, 'expected one of probes, ellipse, found "fast"',
                       "shot", "--renderer", "reference", "--anisotropy", "fast", "-o", out)
        self.complains(2, "only the reference has a choice", "shot", "--anisotropy", "ellipse", "-o", out)

    def test_a_cross_is_cut_into_the_faces_of_a_cube_map(self):
        cross = Image.new("RGB", (64, 48))
        colours = {"+x": (255, 0, 0), "-x": (0, 255, 255), "+y": (0, 255, 0), "-y": (255, 0, 255),
                   "+z": (0, 0, 255), "-z": (255, 255, 0)}
        places = {"+x": (2, 1), "-x": (0, 1), "+y": (1, 0), "-y": (1, 2), "+z": (1, 1), "-z": (3, 1)}
        for name, (column, row) in places.items():
            cross.paste(colours[name], (16 * column, 16 * row, 16 * column + 16, 16 * row + 16))
        cross.save(self.path / "cross.png")
        (self.path / "cube.json").write_text("""{"version": 1, "models": [{"shape": "cube"}],
            "textures": [{"source": "file", "file": "cross.png", "magFilter": "GL_NEAREST",
                          "minFilter": "GL_NEAREST"}],
            "passes": [{"depthTest": true, "units": [{"enabled": true, "target": "GL_TEXTURE_CUBE_MAP",
              "envMode": "GL_REPLACE", "texGenS": {"enabled": true, "mode": "GL_OBJECT_LINEAR"},
              "texGenT": {"enabled": true, "mode": "GL_OBJECT_LINEAR"},
              "texGenR": {"enabled": true, "mode": "GL_OBJECT_LINEAR", "objectPlane": [0, 0, 1, 0]}}]}]}""")
        views = {"+z": (0, 0), "+x": (90, 0), "-z": (180, 0), "-x": (270, 0), "+y": (0, 89), "-y": (0, -89)}
        for renderer in ("fixed", "shader", "reference"):
            for name, (azimuth, elevation) in views.items():
                seen = self.shot(self.path / "cube.json", "--size", "33x33", "--renderer", renderer,
                                 "--set", f"view.azimuth={azimuth}", "--set", f"view.elevation={elevation}")
                self.assertEqual(seen.getpixel((16, 16))[:3], colours[name], f"{renderer} {name}")

    def test_the_window_compares_renderers(self):
        scene = self.path / "scene.json"
        scene.write_text('{"version": 1, "view": {"azimuth": 33}}')
        window = self.shot(scene, "--ui", "--compare", "shader,reference", "--size", "1280x800")
        for renderer, place in [("shader", (330, 110, 600, 700)), ("reference", (630, 110, 900, 700))]:
            alone = self.shot(scene, "--renderer", renderer, "--size", "583x650")
            inside = tuple(value - (321, 64)[i % 2] for i, value in enumerate(place))
            left, top, right, bottom = self.difference(window.crop(place), alone.crop(inside)) or (0, 0, 0, 0)
            self.assertLess(max(right - left, bottom - top), 20, "no more than the ring around the worst pixel")
        three = self.shot(scene, "--ui", "--compare", "fixed,reference,shader", "--size", "1280x800")
        self.assertNotEqual(three.tobytes(), window.tobytes())

    def test_bad_comparisons_are_refused(self):
        for expected, value in [("expected one of fixed, shader, reference, found \"metal\"", "fixed,metal"),
                                ("two renderers or more, found one", "fixed"),
                                ("expected one of fixed, shader, reference, found \"\"", "fixed,shader,"),
                                ("expected one of fixed, shader, reference, found \"\"", ",fixed"),
                                ("found \"shader\" twice", "shader,shader")]:
            with self.subTest(value):
                self.complains(2, expected, "shot", "--ui", "--compare", value, "-o", self.path / "out.png")
        self.complains(2, "--compare", "shot", "--compare", "fixed,shader", "-o", self.path / "out.png")

    def test_shaders_that_cannot_be_read_are_refused(self):
        out = self.path / "x.png"
        for arguments in [("--renderer", "shader"), ("--ui",), ("--ui", "--compare", "fixed,shader")]:
            with self.subTest(" ".join(arguments)):
                self.complains(1, "nowhere/", "shot", *arguments, "--shaders", self.path / "nowhere", "-o", out)
                self.assertFalse(out.exists())
        nobody = texshot("shot", "--size", "8x8", "-o", out, env={**os.environ, "TEXPLORER_SHADERS": "nowhere"})
        self.assertEqual((nobody.returncode, nobody.stderr), (0, b""), "nobody asks for what the environment names")

    def test_a_renderer_that_does_not_exist_is_refused(self):
        self.complains(2, 'expected one of fixed, shader, reference, found "metal"',
                       "shot", "--renderer", "metal", "-o", self.path / "out.png")


class Files(Texshot):
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
        self.complains(1, "levels 0 to 2", "decode", file, "-", "--level", "3")

    def test_info(self):
        file = self.path / "small.bmp"
        file.write_bytes(bmp(5, 3, lambda x, y: (1, 2, 3)))
        facts = json.loads(self.succeeds("info", file, "--json"))
        self.assertEqual((facts["format"], facts["width"], facts["height"], facts["fileBytes"]),
                         ("BMP", 5, 3, file.stat().st_size))
        self.assertIn(b"5 x 3", self.succeeds("info", file))

    def test_info_and_check_decode_no_pixels(self):
        file = self.path / "large.tga"
        packets = (16384 * 16384 // 128) * b"\xff\x10\x20\x30\xff"  # a gigabyte of pixels
        file.write_bytes(bytes((0, 0, 10, 0, 0, 0, 0, 0, 0, 0, 0, 0)) + struct.pack("<HHBB", 16384, 16384, 32, 8) + packets)

        def few():
            resource.setrlimit(resource.RLIMIT_AS, (512 << 20, 512 << 20))

        facts = json.loads(texshot("info", "--json", file, preexec_fn=few).stdout)
        self.assertEqual((facts["width"], facts["pixelBytes"]), (16384, 4 * 16384 ** 2))
        scene = self.path / "scene.json"
        scene.write_text(json.dumps({"version": 1, "textures": [{"source": "file", "file": "large.tga", "minFilter": "GL_LINEAR"}],
                                     "passes": [{"depthTest": True, "units": [{"enabled": True}]}]}))
        checked = texshot("check", scene, preexec_fn=few)
        self.assertEqual((checked.returncode, checked.stdout, checked.stderr), (0, b"", b""))
        drawn = texshot("shot", "--renderer", "reference", scene, "-o", self.path / "out.png", preexec_fn=few)
        self.assertEqual(drawn.returncode, 1)
        self.assertRegex(drawn.stderr.decode(), r"\Atexshot: [^\n]*large.tga[^\n]*no memory[^\n]*\n\Z")

        # Three of them are one too many; 64 textures of one are none.
        for name in ("second.tga", "third.tga"):
            shutil.copy(file, self.path / name)
        textures = [{"source": "file", "file": name} for name in ["large.tga"] * 61 + ["second.tga", "third.tga"]]
        scene.write_text(json.dumps({"version": 1, "textures": textures}))
        checked = texshot("check", scene, preexec_fn=few)
        self.assertEqual(checked.returncode, 1)
        errors = [line for line in checked.stdout.decode().splitlines() if line.startswith("error")]
        self.assertEqual(errors, [f"error: textures[62].file: {self.path}/third.tga: the image needs 1073741824 bytes, "
                                  "and of the 2147483648 that a scene's images may take together, 0 are left"])

    def test_info_and_check_say_that_an_array_is_read_in_part(self):
        file = self.path / "array.dds"
        header = struct.pack("<4s7I44x", b"DDS ", 124, 0x1007, 4, 4, 0, 0, 0) + struct.pack("<II4s5I", 32, 4, b"DX10", 0, 0, 0, 0, 0)
        header += struct.pack("<5I", 0x1000, 0, 0, 0, 0) + struct.pack("<5I", 71, 3, 0, 3, 0)
        file.write_bytes(header + bytes(range(24)))
        sentence = "it is an array of 3 textures; the first is read"
        self.assertEqual(json.loads(self.succeeds("info", "--json", file))["notes"], [sentence])
        scene = self.path / "scene.json"
        scene.write_text(json.dumps({"version": 1, "textures": [{"source": "file", "file": "array.dds", "minFilter": "GL_LINEAR"}],
                                     "passes": [{"depthTest": True, "units": [{"enabled": True}]}]}))
        self.assertEqual(self.succeeds("check", scene).decode(), f"note: textures[0].file: array.dds: {sentence}\n")
        self.assertEqual(json.loads(self.succeeds("check", "--json", scene))["notes"],
                         [{"path": "textures[0].file", "sentence": "array.dds: " + sentence}])
        for command in (["flip", file, "out.dds"], ["convert", file, "out.tga"], ["decode", file, "out.png"],
                        ["compress", file, "small.dds", "--format", "dxt1"]):
            result = texshot(*command[:2], self.path / command[2], *command[3:])
            self.assertEqual((result.returncode, result.stderr.decode()), (0, f"texshot: {file}: {sentence}\n"), command)

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
        self.assertEqual(json.loads(self.succeeds("info", "--json", file))["file"], str(file))

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
        os.mkfifo(self.path / "pipe")
        self.complains(1, "pipe", "info", self.path / "pipe")


class Textures(Texshot):
    """Flip, compress and convert; Pillow reads what they write."""

    def picture(self, width, height):
        file = self.path / "in.bmp"
        file.write_bytes(bmp(width, height, lambda x, y: (x * 255 // width, y * 255 // height, 60)))
        return file

    def difference(self, a, b):
        """The root of the mean square over all channels."""
        squares = [(p - q) ** 2 for p, q in zip(a.convert("RGB").tobytes(), b.convert("RGB").tobytes())]
        return (sum(squares) / len(squares)) ** 0.5

    def test_convert_keeps_every_pixel(self):
        source = self.picture(13, 7)
        wanted = Image.open(source).convert("RGB").tobytes()
        for name, options in [("out.png", []), ("small.PNG", ["--small"]), ("out.tga", []), ("rle.tga", ["--rle"]),
                              ("out.bmp", []), ("out.dds", [])]:
            with self.subTest(name):
                self.succeeds("convert", source, self.path / name, *options)
                self.assertEqual(Image.open(self.path / name).convert("RGB").tobytes(), wanted)

    def test_compress_writes_what_pillow_reads(self):
        source = self.picture(32, 16)
        for name, quality in [("dxt1", "fast"), ("dxt1", "best"), ("dxt3", "normal"), ("dxt5", "normal")]:
            with self.subTest(name + " " + quality):
                out = self.path / (name + ".dds")
                self.succeeds("compress", source, out, "--format", name, "--quality", quality)
                self.assertLess(self.difference(Image.open(out), Image.open(source)), 8)
                self.assertEqual(len(json.loads(self.succeeds("info", out, "--json"))["levels"]), 6)
        self.succeeds("compress", source, out, "--format", "dxt1", "--mips", "none")
        self.assertEqual(out.stat().st_size, 128 + 32 * 16 // 2)

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
                self.assertLess(self.difference(Image.open(out), Image.open(plain).transpose(turn)), 8)

    CORNERS = [(255, 0, 0), (0, 255, 0), (0, 0, 255), (255, 255, 0), (0, 255, 255), (255, 0, 255)]

    def test_compress_keeps_the_faces_of_a_cube_map(self):
        strip, cube, out = (self.path / name for name in ("strip.bmp", "cube.dds", "out.dds"))
        # Six faces of one colour each, whose upper left quarter is black.
        strip.write_bytes(bmp(48, 8, lambda x, y: (0, 0, 0) if x % 8 < 4 and y < 4 else self.CORNERS[x // 8]))
        self.succeeds("compress", strip, cube, "--format", "dxt1", "--cube", "--mips", "none")
        report = self.succeeds("compress", cube, out, "--format", "dxt5", "--report").decode()
        self.assertRegex(report, r"level  0  8 x 8, 6 faces +384 bytes")
        for file, levels in ((cube, 1), (out, 4)):
            facts = json.loads(self.succeeds("info", file, "--json"))
            self.assertEqual((facts["faces"], len(facts["levels"])), (6, levels))
            self.assertEqual(facts["notes"], [])
            for face, color in enumerate(self.CORNERS):
                data = self.succeeds("decode", file, "-", "--face", face)
                picture = Image.open(io.BytesIO(data)).convert("RGB")
                self.assertEqual(picture.getpixel((0, 0)), (0, 0, 0), "the upper left stays there")
                for corner in ((7, 0), (0, 7), (7, 7)):
                    self.assertEqual(picture.getpixel(corner), color)
        self.complains(1, "6:1, 1:6, 4:3 or 3:4, found 32 x 16", "compress", self.picture(32, 16), self.path / "no.dds",
                       "--format", "dxt1", "--cube")

    def test_compress_refuses_a_volume(self):
        volume = self.path / "volume.dds"
        header = struct.pack("<4s7I44x", b"DDS ", 124, 0x801007, 4, 4, 0, 3, 0) + struct.pack("<II4s5I", 32, 0x20000, b"", 8, 255, 0, 0, 0)
        volume.write_bytes(header + struct.pack("<5I", 0x1000, 0x200000, 0, 0, 0) + bytes(48))
        self.complains(1, "found a volume of 3 slices", "compress", volume, self.path / "out.dds", "--format", "dxt1")

    def test_flip_of_three_rows_loses_nothing(self):
        plain, flipped = self.path / "plain.dds", self.path / "flipped.dds"
        self.succeeds("compress", self.picture(12, 6), plain, "--format", "dxt5")  # levels of 6, 3 and 1 rows
        self.complains(1, "1, 2, 3 or a multiple of 4", "flip", plain, flipped)
        self.succeeds("compress", self.picture(12, 3), plain, "--format", "dxt5")
        self.succeeds("flip", plain, flipped)
        self.assertEqual(Image.open(flipped).convert("RGBA").tobytes(),
                         Image.open(plain).convert("RGBA").transpose(Image.Transpose.FLIP_TOP_BOTTOM).tobytes())

    def test_compress_reports_what_it_cost(self):
        source, out = self.picture(16, 16), self.path / "out.dds"
        report = self.succeeds("compress", source, out, "--format", "dxt1", "--report").decode()
        # 4 x 4 blocks of 8 bytes, then 2 x 2, then one each for 4 x 4, 2 x 2 and 1 x 1: 184 bytes for 341 texels.
        self.assertEqual(len(report.splitlines()), 6)
        self.assertRegex(report, r"level  0  16 x 16 +128 bytes +\d+\.\d dB")
        self.assertRegex(report, r"sum +184 bytes, 1\.438 times the base; 13\.5 % of RGBA8, 18\.0 % of RGB8")
        facts = json.loads(self.succeeds("info", out, "--json"))
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
        facts = json.loads(self.succeeds("info", out, "--json"))
        self.assertEqual((facts["width"], facts["height"]), (32, 16), "24 and 20 to the nearest powers of two, as GLU does it")
        self.complains(2, "mitchel2", "compress", source, out, "--format", "dxt1", "--mips", "mitchel2")

    def test_shot_compresses_once_and_keeps_the_blocks(self):
        cache = self.path / "cache"
        environment = {**os.environ, "XDG_CACHE_HOME": str(cache)}
        call = ["shot", "--size", "64x64", "--set", "textures[0].compression=cached", "-o", "-"]
        first = texshot(*call, env=environment)
        self.assertEqual((first.returncode, first.stderr), (0, b""))
        entries = list((cache / "texplorer/blocks").iterdir())
        self.assertEqual(len(entries), 1)
        self.assertTrue(entries[0].read_bytes().startswith(b"DDS "))
        self.assertEqual(texshot(*call, env=environment).stdout, first.stdout)
        kept = entries[0].read_bytes()
        os.utime(entries[0], (0, 0))
        self.assertEqual(texshot(*call, env=environment).stdout, first.stdout)
        self.assertGreater(entries[0].stat().st_mtime, 1e9, "it is read from there, so it is young again")
        for damaged in (kept[:200], kept[:128] + b"\0" * (len(kept) - 128)):  # a black picture
            entries[0].write_bytes(damaged)
            self.assertEqual(texshot(*call, env=environment).stdout, first.stdout)
            self.assertEqual(entries[0].read_bytes(), kept)
        homeless = {key: value for key, value in environment.items() if key not in ("XDG_CACHE_HOME", "HOME")}
        told = texshot(*call, env=homeless)
        self.assertEqual((told.returncode, told.stdout), (0, first.stdout))
        self.assertIn(b"no cache directory", told.stderr)

    def test_no_bit_that_flips_in_the_cache_is_seen(self):
        cache = self.path / "cache"
        environment = {**os.environ, "XDG_CACHE_HOME": str(cache)}
        call = ["shot", "--renderer", "reference", "--size", "48x32", "--set", "textures[0].compression=cached", "-o", "-"]
        wanted = texshot(*call, env=environment).stdout
        (entry,) = (cache / "texplorer/blocks").iterdir()
        kept = entry.read_bytes()
        dice = random.Random(9)
        places = list(range(0, 128, 4)) + [dice.randrange(128, len(kept)) for _ in range(32)]
        for place in places:
            flipped = bytearray(kept)
            flipped[place] ^= 1 << dice.randrange(8)
            entry.write_bytes(flipped)
            seen = texshot(*call, env=environment)
            self.assertEqual((seen.returncode, seen.stderr), (0, b""))
            self.assertEqual(seen.stdout, wanted, f"a bit of byte {place}")
            self.assertEqual(entry.read_bytes(), kept)

    def begun(self, *arguments):
        """A program that handles Ctrl+C by now: it has a thread for that."""
        work = subprocess.Popen([TEXSHOT, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                env={**os.environ, "XDG_CACHE_HOME": str(self.path / "cache")})
        while work.poll() is None and len(os.listdir(f"/proc/{work.pid}/task")) < 2:
            time.sleep(0.01)
        return work

    def test_an_interrupt_stops_the_reference_where_nothing_is_left_to_compress(self):
        call = ["shot", "--renderer", "reference", "--set", "textures[0].compression=cached", "-o", "-"]
        self.begun(*call, "--size", "8x8").communicate(timeout=60)  # the blocks are in the cache now
        work = self.begun(*call, "--size", "6000x6000", "--anisotropy", "ellipse",
                          "--set", "textures[0].maxAnisotropy=16")
        time.sleep(0.2)
        work.send_signal(signal.SIGINT)
        out, said = work.communicate(timeout=60)
        self.assertEqual((work.returncode, len(out)), (130, 0))
        self.assertIn(b"interrupted; nothing was written", said)

    def test_an_interrupt_ends_what_follows_the_long_work(self):
        work = self.begun("shot", "--renderer", "reference", "--set", "textures[0].compression=cached", "--size",
                          "2048x2048", "-o", "-")
        work.stdout.read(1)  # the rest waits for a reader
        work.send_signal(signal.SIGINT)
        self.assertEqual(work.wait(timeout=60), 130)
        self.assertEqual(work.communicate()[1], b"texshot: interrupted\n")

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
        except OSError:  # how Linux says that nobody holds the other end any more
            pass
        self.assertEqual(work.wait(timeout=60), 130)
        self.assertRegex(said.decode(), r"\rtexshot: compressing: \d+ %")
        self.assertIn("\r\033[Ktexshot: interrupted; nothing was written", said.decode())
        self.assertFalse((self.path / "out.dds").exists())

    def test_decode_chooses_level_and_direction(self):
        file = self.path / "in.dds"
        self.succeeds("compress", self.picture(16, 16), file, "--format", "dxt1")
        upright = Image.open(io.BytesIO(self.succeeds("decode", file, "-"))).convert("RGB")
        self.assertEqual(upright.tobytes(), Image.open(file).convert("RGB").tobytes())
        naive = Image.open(io.BytesIO(self.succeeds("decode", file, "-", "--no-flip"))).convert("RGB")
        self.assertEqual(naive.tobytes(), upright.transpose(Image.Transpose.FLIP_TOP_BOTTOM).tobytes())
        level = Image.open(io.BytesIO(self.succeeds("decode", file, "-", "--level", "3")))
        self.assertEqual(level.size, (2, 2))
        for expected, options in [("levels 0 to 4", ["--level", "5"]), ("face 0 alone", ["--face", "1"]),
                                  ("slice 0 alone", ["--slice", "1"])]:
            with self.subTest(options):
                self.complains(1, expected, "decode", file, "-", *options)

    def test_info_dissects_a_damaged_file_up_to_the_damage(self):
        file = self.path / "cut.bmp"
        file.write_bytes(bmp(8, 8, lambda x, y: (x, y, 0))[:100])
        result = texshot("info", file)
        self.assertEqual(result.returncode, 1)
        self.assertIn(b"biBitCount", result.stdout)
        self.assertIn(b"cut.bmp", result.stderr)
        document = json.loads(texshot("info", file, "--json").stdout)
        self.assertTrue(document["error"])
        self.assertTrue(document["anatomy"]["fields"])
        (self.path / "text.bmp").write_bytes(b"hello world")
        for name in ("text.bmp", "nowhere.bmp"):
            result = texshot("info", self.path / name, "--json")
            self.assertEqual(result.returncode, 1)
            self.assertTrue(json.loads(result.stdout)["error"])

    def test_wrong_calls(self):
        source = self.picture(4, 4)
        for expected, arguments in [
            (".dds", ["convert", source, self.path / "out.xyz"]),
            (".dds", ["convert", source, self.path / "out"]),
            ("--format", ["compress", source, self.path / "out.dds"]),
            ("dxt9", ["compress", source, self.path / "out.dds", "--format", "dxt9"]),
            ("--format: expected one of dxt1, dxt1a, dxt3, dxt5, bc4, bc5, found \"foo\"",
             ["compress", source, self.path / "out.dds", "--format", "foo"]),
            ("--quality: expected one of fast, normal, best, found \"fine\"",
             ["compress", source, self.path / "out.dds", "--format", "dxt1", "--quality", "fine"]),
            ("--mips: expected one of none, box, ",
             ["compress", source, self.path / "out.dds", "--format", "dxt1", "--mips", "many"]),
            ("--level: expected a whole number from 0 to 30, found \"31\"",
             ["decode", source, self.path / "out.png", "--level", "31"]),
            ("--half-turn", ["flip", source, self.path / "out.dds", "--half-turn", "--horizontal"]),
        ]:
            with self.subTest(arguments[0] + expected):
                self.complains(2, expected, *arguments)

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


class Outputs(Texshot):
    """Where a picture goes: its extension decides what it is; pipes and devices are places like any other."""

    def setUp(self):
        super().setUp()
        self.bmp = self.path / "in.bmp"
        self.bmp.write_bytes(bmp(16, 8, lambda x, y: (x * 15, y * 30, 60)))
        self.dds = self.path / "in.dds"
        self.succeeds("compress", self.bmp, self.dds, "--format", "dxt1")
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
            for wrong in ("out.jpg", "out.jpeg", "out.xyz", "out", "png"):
                self.complains(2, f'expected a name that ends in one of .bmp, .dds, .png, .tga, found "{self.path / wrong}"',
                               *before, self.path / wrong, *after)
        before, after = self.writers["compress"]
        for wrong in ("out.png", "out"):
            self.complains(2, "expected a name that ends in .dds, found", *before, self.path / wrong, *after)

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
                lost = self.path / "no" / "out.dds"
                missing = [str(argument).replace("in.", "missing.") for argument in before]  # not even looked at
                self.complains(1, f"{lost}: can't be written: No such file or directory", *missing, lost, *after)
                folder = self.path / "folder.dds"
                folder.mkdir(exist_ok=True)
                self.complains(1, f"{folder}: is a directory, not a file", *missing, folder, *after)

    def test_what_is_printed_is_printed_or_fails(self):
        scene = self.path / "broken.json"
        scene.write_text('{"version": 1, "textures": [{"mipmaps": "none"}], "passes": [{"units": [{"enabled": true}]}]}')
        calls = [["--help"], ["--version"], ["shot", "--help"], ["conform", "--help"], ["params"], ["params", "--json"],
                 ["info", self.bmp], ["info", self.bmp, "--json"], ["check", "--json"], ["conform", "--list"],
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
                self.fails_to_print("Broken pipe", call, stdout=writer)
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

    def test_options_without_effect_are_refused(self):
        out = self.path / "out"
        for expected, *call in [
            ("--rle: has no effect here: it is for TGA files, OUT is DDS", "convert", self.bmp, f"{out}.dds", "--rle"),
            ("--small: has no effect here: it is for PNG files, OUT is BMP", "convert", self.bmp, f"{out}.bmp", "--small"),
            ("--gamma: has no effect here", "compress", self.bmp, f"{out}.dds", "--format", "dxt1", "--gamma", "--mips", "none"),
            ("--shaders: has no effect here", "shot", "--shaders", self.path, "-o", f"{out}.png"),
            ("--shaders: has no effect here", "shot", "--renderer", "reference", "--shaders", self.path, "-o", f"{out}.png"),
            ("--anisotropy: has no effect here", "shot", "--anisotropy", "probes", "-o", f"{out}.png"),
            ("--renderer: has no effect here: --compare names", "shot", "--ui", "--compare", "fixed,shader", "--renderer", "fixed",
             "-o", f"{out}.png"),
            ("--pass: has no effect here", "probe", "--at", "1,1", "--pass", "0"),
            ("--no-gl: has no effect here", "probe", "--texel", "0,0,0,0", "--no-gl"),
            ("--seed: has no effect here: --list compares nothing", "conform", "--list", "--seed", "1"),
            ("--json: has no effect here: --list compares nothing", "conform", "--list", "--json"),
            ("--out: has no effect here: --list compares nothing", "conform", "--list", "-o", self.path / "report"),
            ("--shaders: has no effect here", "conform", "--renderer", "reference", "--shaders", self.path),
        ]:
            with self.subTest(expected):
                self.complains(2, expected, *call)

    def test_a_value_that_stands_apart_is_explained(self):
        explained = '--set: expected PATH=VALUE, joined by = without a space, found "view.azimuth"'
        out = self.path / "out.png"
        self.complains(2, explained, "shot", "--set", "view.azimuth", "3", "-o", out)
        self.complains(2, explained, "shot", self.path / "scene.json", "--set", "view.azimuth", "3", "-o", out)
        self.complains(2, explained, "check", "--set", "view.azimuth", "=", "3")
        self.complains(2, explained, "probe", "--at", "1,1", "--set", "view.azimuth")


class Signals(Texshot):
    """However a program ends, no half of a file and none of another name stays behind."""

    KILLS = int(os.environ.get("TEXSHOT_KILLS", "8"))  # of each command by each signal

    def setUp(self):
        super().setUp()
        source, plain = self.path / "in.bmp", self.path / "in.dds"
        source.write_bytes(bmp(256, 256, lambda x, y: (x, y, x * y & 255)))
        self.succeeds("compress", source, plain, "--format", "dxt1")
        self.out = self.path / "out"
        self.commands = [
            ["flip", plain, self.out / "flip.dds"],
            ["compress", source, self.out / "compress.dds", "--format", "dxt5", "--quality", "fast"],
            ["decode", plain, self.out / "decode.png"],
            ["convert", source, self.out / "convert.tga"],
            ["shot", "--renderer", "reference", "--size", "64x64", "-o", self.out / "shot.png"],
            ["conform", "--feature", "wrap", "--scenes", "2", "--renderer", "reference", "-o", self.out / "report"],
        ]

    def content(self):
        """The files with their bytes, but for the hour and the seconds that a report names."""
        clock = re.compile(rb"\d{4}-\d\d-\d\d \d\d:\d\d UTC|in [\d.]+ s\b|\"seconds\": ?[\d.e-]+")
        return {str(path.relative_to(self.out)): clock.sub(b"", path.read_bytes())
                for path in self.out.rglob("*") if path.is_file()}

    def test_kills_at_any_moment_leave_nothing(self):
        dice = random.Random(9)
        for command in self.commands:
            for fresh in (True, False):  # where nothing is yet, and where something is replaced
                shutil.rmtree(self.out, ignore_errors=True)
                self.out.mkdir()
                start = time.monotonic()
                self.succeeds(*command)
                duration = time.monotonic() - start
                wanted = self.content()
                for kill in (signal.SIGKILL, signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
                    for _ in range((self.KILLS + 1) // 2):
                        if fresh:
                            shutil.rmtree(self.out)
                            self.out.mkdir()
                        self.kill(command, kill, dice.uniform(0, duration), wanted, {} if fresh else wanted)

    def kill(self, command, kill, delay, wanted, before):
        work = subprocess.Popen([TEXSHOT, *map(str, command)], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        time.sleep(delay)
        work.send_signal(kill)
        said = work.communicate(timeout=60)[1].decode()
        # As a shell says it; before texshot has begun to watch for signals, they end it themselves.
        code = work.returncode if work.returncode >= 0 else 128 - work.returncode
        self.assertIn(code, (0, 128 + kill), said)
        found = self.content()
        if kill == signal.SIGKILL:
            if any(name.endswith(".tmp") for name in found):
                self.succeeds(*command)
                self.assertEqual(self.content(), wanted)
            return
        if work.returncode == 128 + kill:
            self.assertIn(said, ("texshot: interrupted; nothing was written\n", "texshot: interrupted\n"))
        self.assertIn(found, (before, wanted), "all of it or nothing")
        if code == 0:
            self.assertEqual(found, wanted)

    def test_every_signal_has_its_exit_status(self):
        pipe = self.path / "pipe"
        os.mkfifo(pipe)
        for kill, code in ((signal.SIGINT, 130), (signal.SIGTERM, 143), (signal.SIGHUP, 129)):
            for command in (["decode", self.path / "in.dds", pipe], ["shot", "--size", "8x8", "-o", pipe]):
                work = subprocess.Popen([TEXSHOT, *map(str, command)], stderr=subprocess.PIPE)
                while work.poll() is None and len(os.listdir(f"/proc/{work.pid}/task")) < 2:
                    time.sleep(0.01)  # until it watches; then it waits for a reader of the pipe
                work.send_signal(kill)
                self.assertEqual(work.communicate(timeout=60)[1], b"texshot: interrupted; nothing was written\n")
                self.assertEqual(work.returncode, code)

    def test_a_signal_that_is_ignored_stays_so(self):
        pipe = self.path / "pipe"
        os.mkfifo(pipe)
        work = subprocess.Popen([TEXSHOT, "decode", self.path / "in.dds", pipe],
                                preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))  # as nohup does
        while work.poll() is None and len(os.listdir(f"/proc/{work.pid}/task")) < 2:
            time.sleep(0.01)
        work.send_signal(signal.SIGHUP)
        self.assertTrue(pipe.read_bytes().startswith(b"\x89PNG"))
        self.assertEqual(work.wait(timeout=60), 0)


class Check(Texshot):
    INCOMPLETE = "textures[0].mipmaps=none"

    def test_a_scene_without_a_mistake(self):
        self.assertEqual(self.succeeds("check"), b"")
        self.assertEqual(json.loads(self.succeeds("check", "--json")), {"findings": [], "notes": []})

    def test_a_warning_is_said_with_what_mends_it(self):
        result = texshot("check", "--set", self.INCOMPLETE)
        self.assertEqual((result.returncode, result.stderr), (1, b""))
        said = result.stdout.decode()
        self.assertIn("warning: textures[0].minFilter: the texture is incomplete", said)
        fixes = [line.split("--set ")[1].strip() for line in said.splitlines() if "--set " in line]
        self.assertEqual(fixes, ["textures[0].mipmaps=generated", "textures[0].maxLevel=0",
                                 "textures[0].minFilter=GL_LINEAR"])
        for fix in fixes:
            self.assertEqual(texshot("check", "--set", self.INCOMPLETE, "--set", fix).returncode, 0, fix)
        listed = json.loads(texshot("check", "--json", "--set", self.INCOMPLETE).stdout)["findings"]
        self.assertEqual([each["path"] for each in listed], ["textures[0].minFilter"])
        self.assertEqual([fix["set"] for fix in listed[0]["fixes"]],
                         [{"textures[0].mipmaps": "generated"}, {"textures[0].maxLevel": "0"},
                          {"textures[0].minFilter": "GL_LINEAR"}])

    def test_a_setting_without_effect_is_named_and_no_failure(self):
        said = self.succeeds("check", "--set", "textures[0].wrapR=GL_CLAMP").decode()
        self.assertIn("hint: textures[0].wrapR: no effect: only a 3D texture has r", said)

    def said_of(self, **members):
        scene = self.path / "scene.json"
        scene.write_text(json.dumps({"version": 1, **members}))
        result = texshot("check", "--json", scene)
        self.assertEqual(result.stderr, b"")
        return {(each["severity"], each["path"]): each["sentence"] for each in json.loads(result.stdout)["findings"]}

    def test_what_nobody_wrote_is_not_named(self):
        passes = [{"depthTest": True, "units": [{"enabled": True}]}]
        self.assertEqual(self.said_of(passes=passes), {})
        self.assertEqual(self.said_of(material={"shininess": 9}, passes=passes),
                         {("hint", "material.shininess"): "no pass has lighting"})

    def test_a_unit_that_is_off_is_named_and_so_is_its_texture(self):
        said = self.said_of(passes=[{"depthTest": True, "units": [{"texture": 0, "envMode": "GL_REPLACE"}]}])
        self.assertEqual(said, {("hint", "passes[0].units[0]"): "the unit is off",
                                ("hint", "textures[0]"): "no unit that is on shows this texture"})
        said = self.said_of(passes=[{"depthTest": True, "units": [{"enabled": True, "combine": {"rgb": "GL_ADD"}}]}])
        self.assertEqual(said, {("unused", "passes[0].units[0].combine"): "the mode is GL_MODULATE, not GL_COMBINE"})

    def test_a_pass_without_depth_test_is_named(self):
        passes = [{"units": [{"enabled": True}]}]
        self.assertEqual(list(self.said_of(passes=passes)), [("warning", "passes[0].depthTest")])
        self.assertEqual(self.said_of(models=[{"shape": "quad"}], passes=passes), {})

    def test_every_file_that_cannot_be_read_is_named(self):
        (self.path / "broken.bmp").write_bytes(b"BM")
        scene = self.path / "scene.json"
        scene.write_text(json.dumps({"version": 1, "textures": [
            {"source": "file", "file": "nowhere.bmp", "minFilter": "GL_LINEAR"},
            {"source": "file", "file": "broken.bmp", "minFilter": "GL_LINEAR"}]}))
        result = texshot("check", scene)
        self.assertEqual(result.returncode, 1)
        for name in (b"error: textures[0].file: ", b"nowhere.bmp", b"error: textures[1].file: ", b"broken.bmp"):
            self.assertIn(name, result.stdout)

    def test_bad_calls(self):
        self.complains(1, "nowhere.json", "check", self.path / "nowhere.json")
        (self.path / "broken.json").write_text('{"version": 1, "view": {"azimuth": "north"}}')
        for name, expected in (("broken.json", "/view/azimuth: expected a number"), ("nowhere.json", "can't be opened")):
            result = texshot("check", "--json", self.path / name)
            self.assertEqual(result.returncode, 1)
            told = json.loads(result.stdout)
            self.assertEqual(told["findings"], [])
            self.assertIn(expected, told["error"])
            self.assertEqual(result.stderr.decode(), f"texshot: {told['error']}\n")
        self.complains(2, "minFliter", "check", "--set", "textures[0].minFliter=GL_NEAREST")

    def test_a_shot_names_the_scene_and_the_texture_whose_file_is_missing(self):
        scene = self.path / "lesson.json"
        scene.write_text(json.dumps({"version": 1, "textures": [{"source": "file", "file": "nowhere.bmp"}]}))
        for command in (["shot", scene, "-o", self.path / "out.png"], ["probe", scene, "--at", "1,1"]):
            self.complains(1, f"texshot: {scene}: textures[0].file: {self.path}/nowhere.bmp: ", *command)
        checked = texshot("check", scene).stdout.decode()
        self.assertIn(f"error: textures[0].file: {self.path}/nowhere.bmp: ", checked)

    def test_a_shot_says_it_too_and_is_drawn(self):
        result = texshot("shot", "--size", "32x32", "--set", self.INCOMPLETE, "-o", "-")
        self.assertEqual(result.returncode, 0)
        self.assertRegex(result.stderr.decode(), r"\Atexshot: textures\[0\]\.minFilter: the texture is incomplete[^\n]+\n\Z")
        self.assertEqual(Image.open(io.BytesIO(result.stdout)).size, (32, 32))


class Conform(Texshot):
    FEW = ("conform", "--feature", "wrap", "--feature", "environment", "--scenes", "16")

    def test_the_three_renderers_agree(self):
        said = self.succeeds(*self.FEW).decode()
        self.assertRegex(said, r"shader against fixed\nfeature +scenes")
        self.assertRegex(said, r"reference against fixed\nfeature +scenes")
        self.assertEqual(len([line for line in said.splitlines() if " agree " in line]), 4)
        self.assertIn("with GALLIVM_PERF=no_rho_approx", said)
        self.assertIn("\n16 scenes of 64 x 64 pixels, seed 1, in ", said)

    def test_the_command_that_a_report_gives_makes_it_again(self):
        report = self.succeeds(*self.FEW, "--json", "--seed", "7", "--renderer", "shader")
        command = json.loads(report)["command"]
        self.assertRegex(command, r"\AGALLIVM_PERF=\S+ texshot conform --seed 7 --scenes 16 --feature wrap --feature environment --renderer shader\Z")
        path = f"{Path(TEXSHOT).parent}:{os.environ['PATH']}"
        again = subprocess.run(f"{command} --json", shell=True, stdout=subprocess.PIPE, env=os.environ | {"PATH": path})
        self.assertEqual((again.returncode, again.stdout), (0, report))

    def test_one_pair_as_json(self):
        report = json.loads(self.succeeds(*self.FEW, "--json", "--renderer", "shader", "--against", "reference"))
        self.assertTrue(report["agrees"])
        self.assertEqual([(pair["renderer"], pair["against"]) for pair in report["pairs"]], [("shader", "reference")])
        for feature in report["pairs"][0]["features"]:
            self.assertEqual(feature["all"]["over"], 0)
            self.assertEqual(feature["all"]["pixels"], 64 * 64 * feature["all"]["scenes"])

    def test_the_same_seed_gives_the_same_report(self):
        self.assertEqual(self.succeeds(*self.FEW, "--json"), self.succeeds(*self.FEW, "--json"))
        self.assertNotEqual(self.succeeds(*self.FEW, "--json"), self.succeeds(*self.FEW, "--json", "--seed", "2"))

    def test_the_folder_holds_worst_scenes_that_can_be_drawn_again(self):
        folder = self.path / "new" / "report"
        self.succeeds(*self.FEW, "-o", folder)
        self.assertEqual(json.loads((folder / "report.json").read_text())["scenes"], 16)
        page = (folder / "index.html").read_text()
        self.assertIn("wrap-reference-fixed.json", page)
        self.assertRegex(page, r"Made by texshot [0-9.]+ on \d{4}-\d\d-\d\d \d\d:\d\d UTC in [0-9.]+ s; again: <code>GALLIVM_PERF=")
        for renderer in ("reference", "fixed"):
            kept = Image.open(folder / f"wrap-reference-fixed-{renderer}.png").convert("RGB")
            again = self.shot(folder / "wrap-reference-fixed.json", "--renderer", renderer, "--size", "64x64")
            self.assertIsNone(self.difference(kept, again))

    def test_shaders_that_are_wrong_are_found(self):
        shaders = self.path / "shaders"
        shutil.copytree(Path(__file__).parents[2] / "shaders", shaders)
        environment = shaders / "environment.glsl"
        text = environment.read_text()
        self.assertIn("color.rgb = min(color.rgb + texelUNIT.rgb, 1.0);", text)
        environment.write_text(text.replace("color.rgb = min(color.rgb + texelUNIT.rgb, 1.0);", "color.rgb = texelUNIT.rgb;"))
        result = texshot("conform", "--feature", "environment", "--renderer", "shader", "--shaders", shaders)
        self.assertEqual((result.returncode, result.stderr), (1, b""))
        self.assertRegex(result.stdout.decode(), r"environment .* DIFFER")

    def test_shaders_that_cannot_be_read_are_refused(self):
        nowhere = self.path / "nowhere"
        self.complains(1, "nowhere/", "conform", "--feature", "wrap", "--shaders", nowhere, "-o", self.path / "report")
        self.assertFalse((self.path / "report").exists())
        self.complains(2, "--shaders: has no effect here", "conform", "--renderer", "reference", "--shaders", nowhere)

    def test_the_list_gives_features_and_reasons(self):
        said = self.succeeds("conform", "--list").decode()
        for expected in ("trilinear", "dEQP", "undefined-decal", "3.8.13"):
            self.assertIn(expected, said)

    def test_wrong_calls(self):
        for expected, *arguments in (
            ("--feature: expected one of coverage, depth, ", "--feature", "none"),
            ("--renderer: expected one of fixed, shader, reference, found \"gpu\"", "--renderer", "gpu"),
            ("expected two different renderers, found \"fixed\" twice", "--renderer", "fixed", "--against", "fixed"),
            ("--renderer: expected another renderer than fixed, which --against is unless it is given", "--renderer", "fixed"),
            ("--against: expected another renderer than fixed, which --renderer is", "--against", "fixed"),
            ("--scenes: expected a whole number from 1 to 100000, found \"0\"", "--scenes", "0"),
            ("--seed: expected a whole number from 0 to 4294967295, found \"-1\"", "--seed", "-1"),
            ("--seed: expected a whole number from 0 to 4294967295, found \"some\"", "--seed", "some"),
        ):
            with self.subTest(expected=expected):
                self.complains(2, expected, "conform", *arguments)

    def test_an_interrupt_writes_nothing(self):
        work = subprocess.Popen([TEXSHOT, "conform", "--scenes", "100000", "-o", self.path / "report"],
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        time.sleep(3)
        work.send_signal(signal.SIGINT)
        out, said = work.communicate(timeout=60)
        self.assertEqual((work.returncode, out), (130, b""))
        self.assertIn(b"interrupted", said)
        self.assertEqual(os.listdir(self.path), [])


class Probe(Texshot):
    """A square of 2 x 2 texels that fills a picture of 4 x 4 pixels exactly."""

    def setUp(self):
        super().setUp()
        # From the bottom left: 0, 51, 102, 255.
        texels = {(0, 1): 0, (1, 1): 51, (0, 0): 102, (1, 0): 255}
        (self.path / "four.bmp").write_bytes(bmp(2, 2, lambda x, y: (texels[x, y],) * 3))
        self.scene = self.path / "flat.json"
        self.scene.write_text(json.dumps({
            "version": 1,
            "view": {"projection": "orthographic", "fieldOfView": 90, "distance": 1, "azimuth": 0, "elevation": 0},
            "models": [{"shape": "quad"}],
            "textures": [{"source": "file", "file": "four.bmp", "minFilter": "GL_LINEAR"}],
            "passes": [{"units": [{"enabled": True, "envMode": "GL_REPLACE"}]}],
        }))

    def probe(self, *arguments):
        return json.loads(self.succeeds("probe", self.scene, "--size", "4x4", "--json", *arguments))

    def test_the_pixel_is_counted_from_the_top_left_and_its_texels_are_those_of_the_specification(self):
        found = self.probe("--at", "0,3", "--no-gl")
        self.assertEqual(found["window"], [0, 0])
        # 9/16 * 0 + 3/16 * 51 + 3/16 * 102 + 1/16 * 255 = 44.6
        self.assertEqual(found["reference"], [45, 45, 45, 255])
        sample = found["fragments"][0]["units"][0]["sample"]
        weights = {tuple(tap["index"][:2]): tap["weight"] * 16 for tap in sample["taps"]}
        self.assertEqual(weights, {(0, 0): 9, (1, 0): 3, (0, 1): 3, (1, 1): 1})
        self.assertEqual((sample["lod"]["rho"], sample["lod"]["lambda"], sample["lod"]["magnified"]), (0.5, -1, True))
        self.assertEqual(self.probe("--at", "0,0", "--no-gl")["window"], [0, 3])

    def test_it_gives_the_bytes_of_the_pictures_of_all_three_renderers(self):
        pictures = {
            renderer: self.shot(self.scene, "--size", "4x4", "--renderer", renderer)
            for renderer in ("fixed", "shader", "reference")
        }
        for at in ((0, 0), (3, 0), (1, 2), (3, 3)):
            found = self.probe("--at", f"{at[0]},{at[1]}")
            for renderer, picture in pictures.items():
                self.assertEqual(tuple(found[renderer][:3]), picture.getpixel(at)[:3], (renderer, at))

    def test_the_text_says_what_the_json_says(self):
        said = self.succeeds("probe", self.scene, "--size", "4x4", "--at", "0,3").decode()
        for expected in ("pixel 0, 3 of 4 x 4, from the top left", "reference  45 45 45 255", "fixed      ", "shader     ",
                         "(0, 0)", "0.5625", "GL_REPLACE", "rho = the longer", "lambda is not above 0"):
            self.assertIn(expected, said)

    def test_without_the_part_that_draws_it_says_so_and_goes_on(self):
        alone = self.path / "bin" / "texshot"
        alone.parent.mkdir()
        shutil.copy(TEXSHOT, alone)
        result = subprocess.run([alone, "probe", self.scene, "--size", "4x4", "--at", "0,3"], capture_output=True)
        self.assertEqual((result.returncode, result.stderr), (0, b""))
        self.assertIn(b"can't load the part that draws", result.stdout)
        self.assertIn(b"reference  45 45 45 255", result.stdout)

    def test_where_nothing_is_drawn_it_says_so(self):
        said = self.succeeds("probe", self.scene, "--size", "8x8", "--at", "0,0", "--no-gl",
                             "--set", "models[0].size=0.5", "--set", "view.background=0,0.5,1,1")
        self.assertIn(b"No triangle covers it: it shows the background", said)
        self.assertIn(b"reference  0 128 255", said)

    def test_a_texel_is_found_in_the_pixels_that_read_it(self):
        found = self.probe("--texel", "0,0,0,0")
        # Along each axis the texel's share is 3/4, 3/4, 1/4, 1/4 from the left and from the bottom.
        share = [3, 3, 1, 1]
        self.assertEqual({(x, y): weight * 16 for x, y, weight in found["pixels"]},
                         {(x, y): share[x] * share[3 - y] for x in range(4) for y in range(4)})
        said = self.succeeds("probe", self.scene, "--size", "4x4", "--texel", "0,0,0,0").decode()
        self.assertIn("16 pixels read it, x from 0 to 3, y from 0 to 3", said)
        self.assertIn("4 pixels' worth of colour", said)
        # The heaviest first; of equal ones, row by row from below.
        self.assertRegex(said, r"colour in all\n  0, 3 +0.5625\n  1, 3 +0.5625\n  0, 2 +0.5625\n  1, 2 +0.5625\n"
                               r"  2, 3 +0.1875\n")
        self.scene.write_text(self.scene.read_text().replace('"quad"', '"quad", "visible": false'))
        self.assertEqual(self.probe("--texel", "0,0,0,0")["pixels"], [])

    def test_the_list_of_a_large_picture_is_written_as_it_is_found(self):
        probe = subprocess.Popen([TEXSHOT, "probe", self.scene, "--size", "1500x1500", "--json", "--texel", "0,0,0,0"],
                                 stdout=subprocess.PIPE)
        found = json.loads(probe.stdout.read())
        probe.stdout.close()
        _, code, used = os.wait4(probe.pid, 0)
        probe.returncode = code
        self.assertEqual(code, 0)
        self.assertEqual(len(found["pixels"]), 1500 * 1500)  # only at the others' very centres it has no share
        self.assertLess(used.ru_maxrss, 150 * 1024)  # KiB

    def test_the_window_explains_the_pixel_that_it_is_asked_for(self):
        window = ("--ui", "--size", "800x500", "--tab", "explain")
        without = self.shot(*window)
        probed = self.shot(*window, "--probe", "120,180")
        self.assertIsNotNone(self.difference(without, probed))
        self.assertEqual(probed.tobytes(), self.shot(*window, "--probe", "120,180").tobytes())
        out = self.path / "out.png"
        self.complains(1, "and none at 5000,10", "shot", *window, "--probe", "5000,10", "-o", out)
        self.complains(2, "--probe: expected X,Y, found \"here\"", "shot", *window, "--probe", "here", "-o", out)
        self.complains(2, "--probe", "shot", "--probe", "1,1", "-o", out)

    def test_what_it_does_not_have_is_refused(self):
        for code, expected, *arguments in (
            (2, "expected either --at or --texel"),
            (2, "expected either --at or --texel", "--at", "1,1", "--texel", "0,0,0,0"),
            (2, "--at: expected X,Y, found \"middle\"", "--at", "middle"),
            (2, "--at: expected X,Y, found \"1,2,3\"", "--at", "1,2,3"),
            (2, "expected a pixel from 0,0 to 3,3, found 4,0", "--at", "4,0"),
            (2, "expected a pixel from 0,0 to 3,3, found -1,0", "--at=-1,0"),
            (2, "--at: expected X,Y, found \"99999999999,0\"", "--at", "99999999999,0"),
            (2, "--texel: expected UNIT,LEVEL,I,J, found \"0\"", "--texel", "0"),
            (2, "without a level 5", "--texel", "0,5,0,0"),
            (2, "expected i from -1 to 2 in level 0, its border included, found 3", "--texel", "0,0,3,0"),
            (2, "expected a unit from 0 to 3, found 9", "--texel", "9,0,0,0"),
            (2, "there is no pass 3", "--texel", "0,0,0,0", "--pass", "3"),
            (1, "units[2] samples nothing", "--texel", "2,0,0,0"),
            (2, "--size: expected WIDTHxHEIGHT", "--at", "0,0", "--size", "0x4"),
        ):
            size = () if "--size" in arguments else ("--size", "4x4")
            self.complains(code, expected, "probe", self.scene, *size, *arguments)


class Params(Texshot):
    def test_every_parameter_is_listed_with_what_it_accepts(self):
        text = self.succeeds("params").decode()
        for expected in ["textures[].minFilter", "GL_LINEAR_MIPMAP_LINEAR", "passes[].units[].envColor"]:
            self.assertIn(expected, text)
        listed = json.loads(self.succeeds("params", "--json"))
        self.assertTrue(listed)

    def test_it_does_not_load_gl(self):
        trace = subprocess.run([TEXSHOT, "params"], capture_output=True, env={**os.environ, "LD_DEBUG": "libs"})
        self.assertEqual(trace.returncode, 0)
        self.assertNotIn(b"OSMesa", trace.stderr)

    def test_help_and_version(self):
        self.assertIn(b"shot", self.succeeds("--help"))
        self.assertIn(b"--set", self.succeeds("shot", "--help"))
        for command in ("shot", "probe"):
            text = self.succeeds(command, "--help").decode()
            self.assertRegex(text, r"--size WIDTHxHEIGHT +Of the picture, in pixels. Default: 1280x800.\n")
        for command in ([], ["shot"], ["probe"], ["check"], ["conform"], ["params"], ["decode"], ["info"], ["convert"],
                        ["flip"], ["compress"]):
            with self.subTest(command=command):
                text = self.succeeds(*command, "--help").decode()
                self.assertNotRegex(text, r"\b(TEXT|INT|Needs:|Env:)")
                self.assertIn("Exit status: 0", text)
                self.assertLessEqual(max(map(len, text.splitlines())), 80)
        self.assertRegex(self.succeeds("decode", "--help").decode(), r"From 0 to\s+30\.")
        self.assertRegex(self.succeeds("--version").decode(), r"^texshot \d+\.\d+\.\d+\n$")


if __name__ == "__main__":
    unittest.main()
