"""What filters and mip levels do to alpha: fringes, and leaves that vanish; Pillow and NumPy are the oracles."""

import io
import json
import unittest

import numpy
from PIL import Image

from texshot import Texshot, results


class Alpha(Texshot):
    def scene(self, name, picture, **members):
        Image.fromarray(picture).save(self.path / f"{name}.png")
        texture = {"source": "file", "file": f"{name}.png", **members.pop("texture", {})}
        scene = self.path / f"{name}.json"
        scene.write_text(json.dumps({"models": [{"shape": "quad"}], "textures": [texture], **members}))
        return scene

    def halo(self):
        """A white disc; what is outside is black and invisible."""
        y, x = numpy.mgrid[0:16, 0:16]
        disc = ((x - 7.5) ** 2 + (y - 7.5) ** 2 < 36).astype(numpy.uint8) * 255
        unit = {"enabled": True, "envMode": "GL_REPLACE"}
        return self.scene("disc", numpy.dstack([disc] * 4),
                          view={"projection": "orthographic", "distance": 5, "azimuth": 0, "elevation": 0,
                                "background": [1, 1, 1, 1]},
                          texture={"minFilter": "GL_LINEAR", "wrapS": "GL_CLAMP_TO_EDGE", "wrapT": "GL_CLAMP_TO_EDGE"},
                          passes=[{"blend": True, "blendSrc": "GL_SRC_ALPHA", "blendDst": "GL_ONE_MINUS_SRC_ALPHA",
                                   "units": [unit]}])

    def leaves(self):
        """Small ones, as a box filter makes of larger ones."""
        random = numpy.random.default_rng(7)
        picture = numpy.zeros((256, 256, 4), numpy.uint8)
        picture[...] = (40, 140, 40, 0)
        for x, y in random.integers(0, 252, (130, 2)):
            picture[y:y + 4, x:x + 15, 3] = 255
        unit = {"enabled": True, "envMode": "GL_REPLACE"}
        return picture[..., 3] > 127, self.scene(
            "leaves", picture,
            view={"projection": "orthographic", "distance": 5, "azimuth": 0, "elevation": 0,
                  "background": [0.1, 0.1, 0.1, 1]},
            texture={"mipmaps": "generated", "minFilter": "GL_LINEAR_MIPMAP_LINEAR"},
            passes=[{"depthTest": True, "alphaTest": True, "alphaFunc": "GL_GREATER", "alphaRef": 0.5, "units": [unit]}])

    def drawn(self, scene, *options):
        data = self.succeeds("shot", scene, "-o", "-", "--size", "480x480", *options)
        return numpy.asarray(Image.open(io.BytesIO(data)).convert("RGB"))

    def findings(self, scene, rule):
        return [each for each in results(self.succeeds("check", "--json", scene)) if each["rule"] == rule]

    def test_a_fringe_is_foreseen_and_its_fixes_remove_it(self):
        scene = self.halo()
        self.assertLess(self.drawn(scene).min(), 200)
        finding, = self.findings(scene, "fringe")
        self.assertEqual(finding["path"], "textures[0].preparation")
        self.assertEqual(len(finding["fixes"]), 2)
        for fix in finding["fixes"]:
            settings = [word for path, value in fix["set"].items() for word in ("--set", f"{path}={value}")]
            for renderer in ("fixed", "shader", "reference"):
                with self.subTest(settings, renderer=renderer):
                    self.assertGreaterEqual(self.drawn(scene, "--renderer", renderer, *settings).min(), 254)

    def test_levels_keep_their_share(self):
        picture, scene = self.leaves()
        share = picture.mean()
        finding, = self.findings(scene, "lost-coverage")
        self.assertEqual(finding["fixes"][0]["set"], {"textures[0].mipCoverage": "0.5"})
        for distance in (3, 6, 12, 24):
            side = 2 * 480 / (2 * distance * numpy.tan(numpy.radians(20)))
            options = ("--set", f"view.distance={distance}")
            kept = self.drawn(scene, "--set", "textures[0].mipCoverage=0.5", *options)
            self.assertAlmostEqual((kept[..., 1] > 100).sum() / side ** 2, share, delta=0.012, msg=distance)
        self.assertLess((self.drawn(scene, *options)[..., 1] > 100).sum() / side ** 2, share * 2 / 3)

    def test_steps_are_what_numpy_makes(self):
        random = numpy.random.default_rng(3)
        picture = random.integers(0, 256, (12, 10, 4)).astype(numpy.uint8)

        def step(**members):
            scene = self.scene("noise", picture, texture={"preparation": [members]})
            return numpy.asarray(Image.open(io.BytesIO(self.succeeds("texture", scene, "-o", "-"))).convert("RGBA"))

        color, alpha = picture[..., :3].astype(int), picture[..., 3:].astype(int)
        self.assertTrue((step(op="premultiply") == numpy.dstack([(color * alpha + 127) // 255, alpha])).all())
        swizzled = step(op="swizzle", red="blue", green="alpha", blue="one", alpha="red")
        expected = numpy.dstack([picture[..., 2], picture[..., 3], numpy.full((12, 10), 255), picture[..., 0]])
        self.assertTrue((swizzled == expected).all())
        self.assertEqual(step(op="resize", share=0.5).shape, (6, 5, 4))
        box = numpy.asarray(Image.fromarray(picture[..., :3]).resize((5, 4), Image.Resampling.BOX), int)
        self.assertLessEqual(abs(step(op="resize", width=5, height=4)[..., :3].astype(int) - box).max(), 1)

        height = ((color * (299, 587, 114)).sum(axis=2) + 500) // 1000 / 255 * 3
        right = (numpy.roll(height, -1, 1) - numpy.roll(height, 1, 1)) / 2
        up = (numpy.roll(height, 1, 0) - numpy.roll(height, -1, 0)) / 2  # the first row is the top one
        normal = numpy.dstack([-right, -up, numpy.ones_like(right)])
        normal /= numpy.linalg.norm(normal, axis=2, keepdims=True)
        made = step(op="normals", amount=3)[..., :3]
        self.assertLessEqual(abs(made - (normal * 0.5 + 0.5) * 255).max(), 0.51)


if __name__ == "__main__":
    unittest.main()
