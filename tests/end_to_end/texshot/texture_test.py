"""texshot texture: the preparation of a texture's image, step by step, and its levels; Pillow is the oracle."""

import io
import json
import unittest

from PIL import Image, ImageChops, ImageOps

from texshot import Texshot, bmp, results


class TexturePictures(Texshot):
    def scene(self, **texture):
        file = self.path / "scene.json"
        file.write_text(json.dumps({"textures": [{"source": "file", "file": "in.bmp", **texture}]}))
        return file

    def picture_of(self, scene, *options):
        return Image.open(io.BytesIO(self.succeeds("texture", scene, "-o", "-", *options)))

    def setUp(self):
        super().setUp()
        (self.path / "in.bmp").write_bytes(bmp(16, 8, lambda x, y: (x * 16, y * 32, (x * y * 7) % 256)))
        self.original = Image.open(self.path / "in.bmp").convert("RGB")

    def assert_near(self, one, other, most):
        self.assertLessEqual(ImageChops.difference(one, other).getextrema()[1], most)

    def test_each_step_is_what_pillow_makes_of_the_one_before(self):
        scene = self.scene(preparation=[{"op": "invert"}, {"op": "luminance"}, {"op": "luminance-to-alpha"}])
        self.assertEqual(self.picture_of(scene, "--step", "0").convert("RGB").tobytes(), self.original.tobytes())
        inverted = ImageOps.invert(self.original)
        self.assertEqual(self.picture_of(scene, "--step", "1").convert("RGB").tobytes(), inverted.tobytes())
        grey = inverted.convert("L")  # rounds at another step
        self.assert_near(self.picture_of(scene, "--step", "2").convert("L"), grey, 1)
        self.assert_near(self.picture_of(scene, "--step", "3").getchannel("A"), grey, 1)
        self.complains(2, "--step: there is no step 4: textures[0] has 3 steps", "texture", scene, "-o", "-", "--step", "4")

    def test_alpha_comes_from_another_file(self):
        (self.path / "mask.bmp").write_bytes(bmp(32, 16, lambda x, y: (y * 16, y * 16, y * 16)))
        scene = self.scene(preparation=[{"op": "alpha-from", "source": "file", "file": "mask.bmp"}])
        mask = Image.open(self.path / "mask.bmp").convert("L").resize((16, 8), Image.Resampling.BOX)
        found = self.picture_of(scene)
        self.assertEqual(found.convert("RGB").tobytes(), self.original.tobytes())
        self.assert_near(found.getchannel("A"), mask, 1)

    def test_levels_are_pictures_of_their_own(self):
        (self.path / "half.bmp").write_bytes(bmp(8, 4, lambda x, y: (x, y, 0)))
        scene = self.scene(mipmaps="given", levels=[{"source": "file", "file": "half.bmp"}, {"pattern": "brick"}])
        half = Image.open(self.path / "half.bmp").convert("RGB")
        self.assertEqual(self.picture_of(scene, "--level", "1").convert("RGB").tobytes(), half.tobytes())
        self.assertEqual(self.picture_of(scene, "--level", "2").size, (4, 2))
        self.complains(2, "--level: there is no level 3", "texture", scene, "-o", "-", "--level", "3")

    def test_all_levels_are_a_file_of_a_tool(self):
        (self.path / "half.bmp").write_bytes(bmp(8, 4, lambda x, y: (x, y, 0)))
        (self.path / "quarter.bmp").write_bytes(bmp(4, 2, lambda x, y: (200, 10 * x, y)))
        levels = [{"source": "file", "file": "half.bmp"}, {"source": "file", "file": "quarter.bmp"}]
        scene = self.scene(mipmaps="given", levels=levels)
        out = self.path / "out.dds"
        told = results(self.succeeds("texture", scene, "-o", out, "--all-levels", "--json"))
        self.assertEqual(told[0]["levelCount"], 3)
        self.assertEqual(Image.open(out).convert("RGB").tobytes(), self.original.tobytes())
        pixels = out.read_bytes()[128:]  # a header of 128 bytes, then 24 bits a texel: blue, green, red
        sizes = [16 * 8 * 3, 8 * 4 * 3, 4 * 2 * 3]
        self.assertEqual(len(pixels), sum(sizes))
        for name, start, size in [("half.bmp", sizes[0], (8, 4)), ("quarter.bmp", sum(sizes[:2]), (4, 2))]:
            level = Image.frombytes("RGB", size, pixels[start:], "raw", "BGR")
            self.assertEqual(level.tobytes(), Image.open(self.path / name).convert("RGB").tobytes(), name)
        self.complains(2, ".dds", "texture", scene, "-o", self.path / "out.png", "--all-levels")
        self.complains(2, "--all-levels", "texture", scene, "-o", out, "--all-levels", "--step", "0")

    def test_all_levels_stay_compressed(self):
        self.succeeds("compress", self.path / "in.bmp", self.path / "in.dds", "--format", "dxt1")
        for flip in ("blocks", "coordinates", "none"):
            scene = self.scene(file="in.dds", mipmaps="file", flip=flip)
            out = self.path / "out.dds"
            self.succeeds("texture", scene, "-o", out, "--all-levels")
            expected = Image.open(self.path / "in.dds").convert("RGB")
            if flip == "none":  # what OpenGL looks up is upside down
                expected = ImageOps.flip(expected)
            else:
                self.assertEqual(out.read_bytes()[128:], (self.path / "in.dds").read_bytes()[128:])
            self.assertEqual(Image.open(out).convert("RGB").tobytes(), expected.tobytes(), flip)

    def test_what_the_light_sees_is_drawn(self):
        file = self.path / "light.json"
        texture = {"source": "light-depth", "depthSize": 8, "internalFormat": "GL_DEPTH_COMPONENT24"}
        projector = {"target": [0, 0, -6], "fieldOfView": 90, "nearest": 1, "farthest": 20}
        light = {"position": [0, 0, 0, 1], "projector": projector}
        view = {"distance": 6, "azimuth": 0, "elevation": 0}
        models = [{"shape": "quad"}]
        file.write_text(json.dumps({"view": view, "light": light, "models": models, "textures": [texture]}))
        for options in ([], ["--step", "0"]):
            seen = self.picture_of(file, *options)
            self.assertEqual(seen.mode, "L")
            self.assertEqual(seen.getpixel((0, 0)), 255)  # outside the quad
            self.assertAlmostEqual(seen.getpixel((4, 4)), 255 * 20 / 19 * (1 - 1 / 6), delta=1)

    def shown(self, **texture):
        file = self.scene(**texture)
        scene = json.loads(file.read_text())
        file.write_text(json.dumps({**scene, "passes": [{"units": [{"enabled": True}]}]}))
        return file

    def from_driver(self, *options, **texture):
        answer = json.loads(
            self.succeeds(
                "texture", self.shown(**texture), "--from-driver", "--json", "-o", self.path / "out.png", *options
            )
        )
        with Image.open(self.path / "out.png") as picture:
            return picture.copy(), answer["results"][0]["driver"]

    def test_what_the_driver_stores(self):
        picture, driver = self.from_driver(internalFormat="GL_RGBA4")
        rounded = self.original.point(lambda byte: round(byte * 15 / 255) * 17)
        self.assertEqual(picture.convert("RGB").tobytes(), rounded.tobytes())
        self.assertEqual([level["number"] for level in driver["levels"]], [0])
        base = driver["levels"][0]
        self.assertEqual((base["width"], base["height"], base["internalFormat"]), (16, 8, "GL_RGBA4"))
        self.assertTrue(all(base["bits"][name] >= 4 for name in ("red", "green", "blue", "alpha")))
        self.assertGreaterEqual(driver["largest"], 64)
        self.assertIn(driver["resident"], (True, False))

    def test_floats_are_limited_in_files(self):
        upload = {"custom": True, "memory": "layout", "scale": [2, 2, 2, 1], "bias": [-0.5, 0, 0, 0]}
        scene = self.scene(internalFormat="GL_RGB32F_ARB", upload=upload)
        limited = [min(max(round(c * 2 - 127.5 * (i % 3 == 0)), 0), 255) for i, c in enumerate(self.original.tobytes())]
        expected = Image.frombytes("RGB", self.original.size, bytes(limited))
        def check(picture):
            for name in "RGB":
                self.assert_near(picture.convert("RGB").getchannel(name), expected.getchannel(name), 1)

        for kind in ("png", "tga", "bmp", "dds"):
            self.succeeds("texture", scene, "-o", self.path / f"out.{kind}")
            with Image.open(self.path / f"out.{kind}") as picture:
                check(picture)
        picture, driver = self.from_driver(internalFormat="GL_RGB32F_ARB", upload=upload)
        check(picture)
        self.assertEqual(driver["levels"][0]["bits"]["red"], 32)

    def test_luminance_is_returned_as_red(self):  # OpenGL 2.1, section 6.1.4
        picture, driver = self.from_driver(internalFormat="1")
        self.assertEqual(picture.getchannel("R").tobytes(), self.original.getchannel("R").tobytes())
        self.assertEqual(picture.getchannel("G").getextrema(), (0, 0))
        self.assertGreaterEqual(driver["levels"][0]["bits"]["luminance"], 8)

    def test_levels_of_the_driver(self):
        picture, driver = self.from_driver("--level", "2", mipmaps="glGenerateMipmap", internalFormat="GL_RGB")
        self.assertEqual(picture.size, (4, 2))
        self.assertEqual([level["width"] for level in driver["levels"]], [16, 8, 4, 2, 1])
        self.complains(2, "--level: there is no level 9", "texture", self.shown(), "--from-driver", "-o", "-", "--level", "9")

    def test_wrong_calls(self):
        idle = self.path / "idle.json"
        idle.write_text(json.dumps({"textures": [{}], "passes": [{}]}))
        self.complains(1, "no enabled unit shows textures[0]", "texture", idle, "--from-driver", "-o", "-")
        refused = self.shown(internalFormat="GL_BGR")
        self.complains(1, "GL_INVALID_VALUE", "texture", refused, "--from-driver", "-o", "-")
        scene = self.scene(mipmaps="given", levels=[{"source": "file", "file": "gone.png"}])
        self.complains(1, "textures[0].levels[0].file", "texture", scene, "-o", "-")
        self.complains(2, "--texture: there is no textures[1]", "texture", self.scene(), "-o", "-", "--texture", "1")
        self.complains(2, "--level", "texture", self.scene(), "-o", "-", "--step", "0", "--level", "0")
        self.complains(2, "--out", "texture", self.scene())


if __name__ == "__main__":
    unittest.main()
