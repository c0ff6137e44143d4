"""texshot shot: the picture of a scene."""

import hashlib
import io
import json
import os
import shutil
import subprocess
import unittest
from pathlib import Path

from PIL import Image, ImageChops

from texshot import TEXSHOT, Texshot, bmp, dds, texshot


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
            ("one of lesson, vertices, levels, commands, glsl, explain, file, memory, a-b, history, figures, timeline, found \"bytes\"", ["--ui", "--tab", "bytes"]),
            ("--ui", ["--tab", "file"]),
            ("one of environments, sheet, block, flip, objects, emboss, edge, upload, cost, found \"bytes\"", ["--ui", "--figure", "bytes"]),
            ("--ui", ["--figure", "edge"]),
            ("one of essentials, texture, unit, combine, coordinates, matrix, pass, light, material, model, view, found \"lod\"",
             ["--ui", "--section", "lod"]),
            ("--ui", ["--section", "matrix"]),
            ("there is no option --nonsense; see texshot shot --help", ["--nonsense"]),
            ("expected a name that differs for each picture", ["a.json", "b.json"]),
        ]:
            with self.subTest(arguments):
                self.complains(2, expected, "shot", *arguments, "-o", out)
        self.complains(2, "--out", "shot")
        self.complains(2, "--size: expected a value, found none", "shot", "-o", out, "--size")
        self.complains(2, "a command is missing; see texshot --help")
        for unknown in ["paint", ""]:
            self.complains(2, f'there is no command "{unknown}"', unknown)
        for unknown in ["--paint", "-x"]:
            self.complains(2, f'expected a command, found "{unknown}"', unknown)

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

    def test_missing_files(self):
        out = self.path / "out.png"
        self.complains(1, "nowhere.json", "shot", self.path / "nowhere.json", "-o", out)
        self.complains(1, "director", "shot", self.path, "-o", out)
        self.complains(1, "nowhere.bmp", "shot", "--set", "textures[0].source=file", "--set",
                       "textures[0].file=nowhere.bmp", "-o", out)
        (self.path / "file").write_text("")
        self.complains(1, "file/such", "shot", "--size", "8x8", "-o", self.path / "file/such/out.png")

    def test_the_reference_draws_what_opengl_draws(self):
        fixed = self.shot("--size", "320x200")
        reference = self.shot("--size", "320x200", "--renderer", "reference")
        difference = ImageChops.difference(fixed, reference).convert("L")
        far = sum(count for level, count in enumerate(difference.histogram()) if level > 16)
        self.assertLess(far, 320 * 200 / 100)
        self.assertEqual(difference.getpixel((95, 100)), 0)

    def test_the_reference_draws_the_same_everywhere(self):
        """Red, green and blue of all pixels; tests/web/page_test.py compares a browser's with the same numbers."""
        same = json.loads((Path(__file__).parents[2] / "support/reference_picture.json").read_text())
        size = "x".join(str(each) for each in same["size"])
        picture = self.shot("--example", same["example"], "--size", size, "--renderer", "reference")
        self.assertEqual(hashlib.sha256(picture.convert("RGB").tobytes()).hexdigest(), same["sha256"])

    def test_the_reference_needs_no_opengl(self):
        alone = self.path / "bin" / "texshot"  # without the module that contains OpenGL next to it
        alone.parent.mkdir()
        shutil.copy(TEXSHOT, alone)
        shoot = [alone, "shot", "--size", "16x16", "-o", "-"]
        self.assertEqual(subprocess.run(shoot, capture_output=True).returncode, 1)
        drawn = subprocess.run([*shoot, "--renderer", "reference"], capture_output=True)
        self.assertEqual((drawn.returncode, drawn.stderr), (0, b""))
        self.assertEqual(Image.open(io.BytesIO(drawn.stdout)).size, (16, 16))

    def flat(self, high=0.5):
        """A square that fills a square picture, in which s runs from 0 to 2 and t from 0 to `high`."""
        scene = self.path / f"flat {high}.json"
        scene.write_text(json.dumps({
            "version": 1,
            "view": {"projection": "orthographic", "azimuth": 0, "elevation": 0, "distance": 1, "fieldOfView": 90},
            "models": [{"shape": "mesh", "mesh": {"primitive": "GL_QUADS",
                        "positions": [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]],
                        "texCoords": [[0, 0], [2, 0], [2, high], [0, high]]}}],
            "textures": [{"pattern": "checker", "mipmaps": "generated"}],
            "passes": [{"units": [{"enabled": True}]}],
        }))
        return scene

    def test_false_colours_say_the_level_of_detail_and_the_anisotropy(self):
        first, last = (0x44, 0x01, 0x54), (0xFD, 0xE7, 0x25)  # of viridis
        scene = self.flat()
        seen = self.shot(scene, "--size", "16x16", "--renderer", "reference", "--show", "anisotropy")
        # 4 is half-way from 1 to 16 in steps of doubling; viridis has #21918c there.
        for component, expected in zip(seen.getpixel((8, 8)), (0x21, 0x91, 0x8C, 255)):
            self.assertAlmostEqual(component, expected, delta=4)
        square = self.shot(self.flat(2), "--size", "16x16", "--renderer", "reference", "--show", "anisotropy")
        self.assertEqual(square.getpixel((8, 8)), (*first, 255))
        whole = self.shot(scene, "--size", "16x16", "--renderer", "reference", "--show", "lambda",
                          "--set", "textures[0].minLod=500")
        self.assertEqual(whole.getpixel((8, 8)), (*last, 255), "beyond the last level")
        none = self.shot(scene, "--size", "16x16", "--renderer", "reference", "--show", "lambda",
                         "--set", "textures[0].maxLod=-1")
        self.assertEqual(none.getpixel((8, 8)), (0, 0, 0, 255), "magnified")
        half = self.shot(scene, "--size", "32x16", "--renderer", "reference", "--show", "lambda")
        self.assertEqual(half.getpixel((1, 8)), (0, 0, 0, 0), "nothing is drawn there")

    def test_false_colours_are_refused_where_there_are_none(self):
        scene = self.flat()
        out = self.path / "a.png"
        for code, expected, arguments in [
            (2, "--show: requires --renderer reference or --ui", ["--show", "lambda"]),
            (2, "expected one of picture, lambda, anisotropy", ["--renderer", "reference", "--show", "lod"]),
            (2, "--show", ["--renderer", "reference", "--unit", "1"]),
            (1, "passes[0].units[1] samples nothing", ["--renderer", "reference", "--show", "lambda", "--unit", "1"]),
            (2, "--pass: there is no pass 2, the scene has 1", ["--renderer", "reference", "--show", "lambda", "--pass", "2"]),
        ]:
            with self.subTest(arguments):
                self.complains(code, expected, "shot", scene, *arguments, "-o", out)

    def test_the_reference_knows_three_ways_of_anisotropy(self):
        floor = ["--size", "64x48", "--renderer", "reference", "--set", "models[0].shape=floor",
                 "--set", "textures[0].maxAnisotropy=8"]
        probes = self.shot(*floor)
        self.assertEqual(self.shot(*floor, "--anisotropy", "probes").tobytes(), probes.tobytes())
        others = [self.shot(*floor, "--anisotropy", method).tobytes() for method in ("ellipse", "line")]
        self.assertEqual(len({probes.tobytes(), *others}), 3)
        scene = self.path / "floor.json"
        scene.write_text('{"version": 1, "view": {"azimuth": 33}, "textures": [{"maxAnisotropy": 8,'
                         ' "minFilter": "GL_LINEAR_MIPMAP_LINEAR", "mipmaps": "generated"}],'
                         ' "passes": [{"depthTest": true, "units": [{"enabled": true}]}]}')
        window = self.shot(scene, "--ui", "--renderer", "reference", "--anisotropy", "ellipse",
                           "--size", "1280x800")
        alone = self.shot(scene, "--renderer", "reference", "--anisotropy", "ellipse", "--size", "583x402")
        self.assertIsNone(self.difference(window.crop((321, 64, 321 + 583, 64 + 402)), alone))
        otherwise = self.shot(scene, "--renderer", "reference", "--size", "583x402")
        self.assertIsNotNone(self.difference(otherwise, alone))
        out = self.path / "out.png"
        self.complains(2, 'expected one of probes, ellipse, line, found "fast"',
                       "shot", "--renderer", "reference", "--anisotropy", "fast", "-o", out)
        self.notes("only the reference has a choice", "shot", "--size", "8x8", "--anisotropy", "ellipse", "-o", out)

    def test_the_reference_knows_both_ends_of_rho(self):
        cube = ["--size", "64x48", "--renderer", "reference"]
        drawn = {rho: self.shot(*cube, "--rho", rho).tobytes() for rho in ("ideal", "lower", "upper")}
        self.assertEqual(drawn["ideal"], self.shot(*cube).tobytes())
        self.assertEqual(len(set(drawn.values())), 3)
        out = self.path / "out.png"
        self.complains(2, 'expected one of ideal, lower, upper, found "least"',
                       "shot", "--renderer", "reference", "--rho", "least", "-o", out)
        self.notes("--rho: has no effect here", "shot", "--size", "8x8", "--rho", "lower", "-o", out)

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

    def test_shaders_that_do_not_compile_draw_no_picture(self):
        shaders = self.path / "shaders"
        shutil.copytree(Path(__file__).parents[3] / "shaders", shaders)
        with open(shaders / "vertex.glsl", "a", encoding="utf-8") as file:
            file.write("syntax error here\n")
        out = self.path / "out.png"
        said = self.complains(1, "vertex.glsl", "shot", "--renderer", "shader", "--shaders", shaders, "--size", "32x32", "-o", out)
        self.assertIn("syntax error", said)
        self.assertFalse(out.exists())
        suite = self.path / "a.suite.json"
        suite.write_text('{"suite": 1, "cases": [{"name": "a", "size": "32x32", "renderer": "shader", "golden": "a.png", "scene": {"inline": {"version": 1}}}]}')
        result = texshot("test", suite, "--shaders", shaders, "--update")
        self.assertEqual(result.returncode, 2, result)
        self.assertIn(b"syntax error", result.stdout + result.stderr)
        self.assertFalse((self.path / "a.png").exists())

    def test_shaders_that_cannot_be_read_are_refused(self):
        out = self.path / "x.png"
        for arguments in [("--renderer", "shader"), ("--ui",), ("--ui", "--compare", "fixed,shader")]:
            with self.subTest(" ".join(arguments)):
                self.complains(1, "nowhere/", "shot", *arguments, "--shaders", self.path / "nowhere", "-o", out)
                self.assertFalse(out.exists())
        unused = texshot("shot", "--size", "8x8", "-o", out, env={**os.environ, "TEXPLORER_SHADERS": "nowhere"})
        self.assertEqual((unused.returncode, unused.stderr), (0, b""), "the unused variable is not an error")

    def test_a_driver_can_be_treated_as_lacking_something(self):
        scene = self.path / "units.json"
        unit = {"enabled": True, "envMode": "GL_MODULATE"}
        scene.write_text(json.dumps({"version": 1, "passes": [{"depthTest": True, "units": [unit, unit]}]}))
        whole = self.shot(scene, "--size", "64x64")
        out = self.path / "out.png"
        said = ("passes[0].units[1]: the driver has 1 texture unit; drawn without this one",
                "textures[0]: an anisotropy of 8 exceeds the driver's 1; drawn with that")
        for renderer in ("fixed", "shader"):
            done = texshot("shot", scene, "--size", "64x64", "--renderer", renderer, "--pretend", "no-multitexture",
                           "--pretend", "no-anisotropy", "--set", "textures[0].maxAnisotropy=8", "-o", out)
            self.assertEqual(done.returncode, 0)
            for sentence in said:
                self.assertIn(f"texshot: {sentence}\n", done.stderr.decode())
            self.assertNotEqual(Image.open(out).convert("RGBA").tobytes(), whole.convert("RGBA").tobytes())
        self.assertEqual(self.shot(scene, "--size", "64x64", "--pretend", "units=2").tobytes(), whole.tobytes())

    def test_an_image_that_is_too_large_is_drawn_from_smaller_levels(self):
        colors = [(255, 0, 0), (0, 255, 0), (0, 0, 255)]
        scene = self.path / "levels.json"
        pixels = b"".join(bytes(color) + b"\xff" for k, color in enumerate(colors) for _ in range((64 >> k) ** 2))
        (self.path / "levels.dds").write_bytes(dds(64, 64, pixels, 28, levels=3))
        texture = {"source": "file", "file": "levels.dds", "mipmaps": "file", "minFilter": "GL_LINEAR", "oversize": "smaller"}
        unit = {"enabled": True, "envMode": "GL_REPLACE"}
        scene.write_text(json.dumps({"version": 1, "models": [{"shape": "quad"}], "textures": [texture], "passes": [{"units": [unit]}],
                                     "view": {"distance": 1}}))
        limit = ("--pretend", "max-texture-size=20")
        said = ("textures[0]{}: 64 × 64 texels exceed the driver's 20 for GL_TEXTURE_2D: drawn from level 2, which has "
                "16 × 16\n")
        out = self.path / "out.png"
        for renderer in ("fixed", "shader", "reference"):
            with self.subTest(renderer):
                done = texshot("shot", scene, "--size", "8x8", "--renderer", renderer, *limit, "-o", out)
                self.assertEqual((done.returncode, done.stderr.decode()), (0, "texshot: " + said.format("")))
                self.assertEqual(Image.open(out).convert("RGB").getcolors(), [(64, colors[2])])
        self.assertEqual(self.shot(scene, "--size", "8x8").convert("RGB").getcolors(), [(64, colors[0])])
        self.assertEqual(self.succeeds("check", scene, *limit).decode(), "note: " + said.format(".oversize"))
        program = self.succeeds("emit", scene, *limit).decode()
        self.assertIn("16, 16, 0, ", program)
        self.assertNotIn("64, 64, 0, ", program)
        explained = texshot("probe", scene, "--size", "8x8", "--at", "4,4", "--no-gl", "--json", *limit)
        self.assertEqual(json.loads(explained.stdout)["results"][0]["reference"], [*colors[2], 255])

    def test_what_no_driver_lacks_is_refused(self):
        out = self.path / "out.png"
        for command in (("shot", "-o", out), ("shot", "--ui", "-o", out), ("probe", "--at", "1,1"), ("conform",)):
            self.complains(2, '--pretend: "no-s3ct" cannot be taken away; did you mean "no-s3tc"?', *command, "--pretend", "no-s3ct")
            self.complains(2, '--pretend: expected units= and a whole number from 1 to 4, found "units=9"',
                           *command, "--pretend", "no-rgtc,units=9")
        small = ("--size", "16x16")
        self.notes("--pretend: has no effect here", "shot", *small, "--renderer", "reference", "--pretend", "no-s3tc", "-o", "-")
        self.notes("--pretend: has no effect here", "probe", *small, "--at", "1,1", "--no-gl", "--pretend", "no-s3tc")
        self.notes("--pretend: has no effect here", "probe", *small, "--texel", "0,0,1,1", "--pretend", "no-s3tc")
        self.complains(1, "which --pretend disables", "shot", "--renderer", "shader", "--pretend", "no-shaders", "-o", out)
        help = self.succeeds("shot", "--help").decode()
        for word in ("no-multitexture", "units=N", "max-texture-size=N", "no-npot", "no-seamless-cube-maps"):
            self.assertIn(word, help)

    def test_a_renderer_that_does_not_exist_is_refused(self):
        self.complains(2, 'expected one of fixed, shader, reference, found "metal"',
                       "shot", "--renderer", "metal", "-o", self.path / "out.png")

    def test_a_shot_names_the_scene_and_the_texture_whose_file_is_missing(self):
        scene = self.path / "lesson.json"
        scene.write_text(json.dumps({"version": 1, "textures": [{"source": "file", "file": "nowhere.bmp"}]}))
        for command in (["shot", scene, "-o", self.path / "out.png"], ["probe", scene, "--at", "1,1"]):
            self.complains(1, f"texshot: {scene}: textures[0].file: {self.path}/nowhere.bmp: ", *command)
        checked = texshot("check", scene).stdout.decode()
        self.assertIn(f"error: textures[0].file: {self.path}/nowhere.bmp: ", checked)

    def test_a_shot_says_it_too_and_is_drawn(self):
        result = texshot("shot", "--size", "32x32", "--set", "textures[0].mipmaps=none", "-o", "-")
        self.assertEqual(result.returncode, 0)
        self.assertRegex(result.stderr.decode(), r"\Atexshot: textures\[0\]\.minFilter: the texture is incomplete[^\n]+\n\Z")
        self.assertEqual(Image.open(io.BytesIO(result.stdout)).size, (32, 32))


if __name__ == "__main__":
    unittest.main()
