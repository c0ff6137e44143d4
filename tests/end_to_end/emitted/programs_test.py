"""The programs of examples, presets and steps of lessons draw what texshot draws: those of fixed function the same
pixels, those of GLSL within 1/255, the rounding of a component. scenes.py chooses them. Fixed or Glsl as the last word chooses one of them."""

import json
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from PIL import Image

import moving
from capture import Capture, Display
from proof import FIXED, GLSL, Proof
from scenes import Case, chosen, every_case, said, written

TEXSHOT, LIBRARY, KEEP = (sys.argv.pop(1) for _ in range(3))


class Programs:
    FLAVOUR = None

    @classmethod
    def setUpClass(cls):
        display = Display()
        cls.addClassCleanup(display.close)
        cls.capture = Capture(LIBRARY, display)

    def test_draws_what_texshot_draws(self):
        with tempfile.TemporaryDirectory() as folder:
            verdicts = Proof(TEXSHOT, self.FLAVOUR, self.capture, KEEP).of_all(chosen(every_case(TEXSHOT, folder)))
        self.assertGreater(len(verdicts), 0)
        for verdict in verdicts:
            with self.subTest(verdict.case.name):
                if verdict.wrong or verdict.refused:
                    self.fail(verdict.wrong or verdict.refused)

    def test_moves_by_key_frames(self):
        with tempfile.TemporaryDirectory() as folder:
            cases = moving.cases(TEXSHOT, Path(folder))
            proof = Proof(TEXSHOT, self.FLAVOUR, self.capture, Path(KEEP) / "moving", moving.TIMES)
            for each, verdict in zip(moving.MOVING, proof.of_all(cases)):
                with self.subTest(each.name):
                    refused = each.only_fixed if self.FLAVOUR is GLSL else ""
                    self.assertEqual(verdict.wrong, "")
                    self.assertEqual(verdict.refused.partition(": a program")[0].rpartition(" ")[2], refused, verdict.refused)

    def test_refuses_key_frames_that_it_cant_say(self):
        with tempfile.TemporaryDirectory() as folder:
            for path, (one, other) in moving.REFUSED[self.FLAVOUR.name].items():
                scene, out = Path(folder) / "scene.json", Path(folder) / "demo.c"
                scene.write_text(json.dumps({"version": 1, "timeline": moving.keys(path, [(0, one), (1, other)])}))
                with self.subTest(path):
                    done = subprocess.run([TEXSHOT, "emit", str(scene), "--as", self.FLAVOUR.name, "-o", str(out)], capture_output=True, text=True)
                    self.assertEqual((done.returncode, done.stdout, out.exists()), (1, "", False))
                    self.assertRegex(done.stderr, rf"^texshot: .*{re.escape(path)}: a program .*; texshot animate can\n$")

    def test_scales_texels_during_the_upload(self):
        """glPixelTransferf where nothing else prepares the image: halved as NeHe does it, clamped at both ends, with the levels
        of the driver and of GLU, in formats that keep some components. Otherwise, and with shaders, the texels are scaled."""
        scaled = {"half": ([0.5, 0.5, 0.5, 1], [0, 0, 0, 0], {}), "clamped": ([2, -1, 1.5, 0.5], [-0.25, 1, 0.1, 0.3], {}),
                  "driver": ([1.5, 1, 1, 1], [0, 0.2, 0, 0], {"mipmaps": "glGenerateMipmap"}),
                  "glu": ([0.25, 0.5, 0.75, 1], [0.25, 0.5, 0, 0], {"mipmaps": "gluBuild2DMipmaps"}),
                  "luminance": ([0.5, 2, 2, 0.25], [0.25, 0, 0, 0.5], {"internalFormat": "GL_LUMINANCE_ALPHA"})}
        made = {"glu-clamped": ([2, 2, 2, 1], [0, 0, 0, 0], {"mipmaps": "gluBuild2DMipmaps"}),
                "levels": ([0.5, 0.5, 0.5, 1], [0, 0, 0, 0], {"mipmaps": "generated"}),
                "few-bits": ([0.7, 0.7, 0.7, 1], [0, 0, 0, 0], {"internalFormat": "GL_R3_G3_B2"}),
                "four-bits": ([0.7, 0.7, 0.7, 1], [0, 0, 0, 0], {"internalFormat": "GL_RGBA4"})}
        with tempfile.TemporaryDirectory() as folder:
            cases = []
            for name, (factor, bias, settings) in (scaled | made).items():
                scene = Path(folder) / f"short-{name}.json"
                scene.write_text(json.dumps({
                    "version": 1, "models": [{"shape": "quad"}, {"shape": "cube", "position": [1.2, 0, 0]}],
                    "textures": [{"pattern": "gradient", "magFilter": "GL_NEAREST", "minFilter": "GL_LINEAR_MIPMAP_LINEAR" if settings.get("mipmaps") else "GL_NEAREST",
                                  "preparation": [{"op": "scale", "factor": factor, "bias": bias}], **settings},
                                 {"pattern": "gradient"}],
                    "passes": [{"depthTest": True, "blend": True, "blendSrc": "GL_SRC_ALPHA", "blendDst": "GL_ONE_MINUS_SRC_ALPHA",
                                "units": [{"enabled": True, "envMode": "GL_REPLACE"}, {"enabled": True, "texture": 1}]}]}))
                cases.append(Case(name, (str(scene),), Path(folder) / f"{name}.json"))
                written(TEXSHOT, cases[-1])
            proof = Proof(TEXSHOT, self.FLAVOUR, self.capture, Path(KEEP) / "transfer")
            for case, verdict in zip(cases, proof.of_all(cases)):
                with self.subTest(case.name):
                    self.assertEqual((verdict.wrong, verdict.refused), ("", ""))
                    program = said(TEXSHOT, "emit", *case.words, "--as", self.FLAVOUR.name)
                    self.assertEqual("glPixelTransferf(GL_RED_SCALE" in program, self.FLAVOUR is FIXED and case.name in scaled)

    def test_has_prepared_texels(self):
        """Steps that no call of OpenGL makes, and levels that keep their coverage."""
        swizzle = {"op": "swizzle", "red": "other-green", "green": "red", "blue": "zero", "alpha": "luminance", "pattern": "brick"}
        prepared = {"swizzle": [swizzle], "premultiply": [{"op": "premultiply"}], "spread": [{"op": "spread"}],
                    "resize": [{"op": "resize", "share": 0.3}, {"op": "resize", "share": 0.5, "width": 40}],
                    "normals": [{"op": "normals", "amount": 4}], "coverage": []}
        with tempfile.TemporaryDirectory() as folder:
            cases = []
            for name, steps in prepared.items():
                scene = Path(folder) / f"short-{name}.json"
                scene.write_text(json.dumps({
                    "version": 1, "models": [{"shape": "quad"}, {"shape": "cube", "size": 0.2, "position": [1.2, 0, 0]}],
                    "textures": [{"pattern": "tree", "minFilter": "GL_LINEAR_MIPMAP_LINEAR", "mipmaps": "generated",
                                  "mipCoverage": 0.5 if name == "coverage" else 0, "preparation": steps}],
                    "passes": [{"depthTest": True, "alphaTest": True, "alphaFunc": "GL_GREATER", "alphaRef": 0.5,
                                "units": [{"enabled": True, "envMode": "GL_REPLACE"}]}]}))
                cases.append(Case(name, (str(scene),), Path(folder) / f"{name}.json"))
                written(TEXSHOT, cases[-1])
            proof = Proof(TEXSHOT, self.FLAVOUR, self.capture, Path(KEEP) / "prepared")
            for case, verdict in zip(cases, proof.of_all(cases)):
                with self.subTest(case.name):
                    self.assertEqual((verdict.wrong, verdict.refused), ("", ""))

    def test_reads_files(self):
        """BMP, TGA and DDS files by the lines that the program has for them: odd rows, both orders of rows, levels of one and
        two rows, blocks that are turned around."""
        with tempfile.TemporaryDirectory() as folder:
            files = self.made_files(Path(folder))
            cases = []
            for file, reader in files:
                for flip in ("none", "blocks"):
                    scene = Path(folder) / f"{file.stem}-{flip}.json"
                    scene.write_text(json.dumps({
                        "version": 1, "models": [{"shape": "quad"}, {"shape": "sphere", "position": [1.2, 0, 0]}],
                        "textures": [{"source": "file", "file": file.name, "flip": flip, "mipmaps": "file" if reader == "readDds" else "generated",
                                      "minFilter": "GL_LINEAR_MIPMAP_LINEAR" if reader != "readTga" else "GL_LINEAR"}],
                        "passes": [{"depthTest": True, "units": [{"enabled": True, "envMode": "GL_REPLACE"}]}]}))
                    cases.append((Case(scene.stem, (str(scene),), scene), reader, flip))
            proof = Proof(TEXSHOT, self.FLAVOUR, self.capture, Path(KEEP) / "files")
            for (case, reader, flip), verdict in zip(cases, proof.of_all([case for case, _, _ in cases])):
                with self.subTest(case.name):
                    self.assertEqual((verdict.wrong, verdict.refused), ("", ""))
                    if flip == "blocks" or reader == "readDds":
                        self.assertRegex(said(TEXSHOT, "emit", *case.words, "--as", self.FLAVOUR.name), rf"\n +{reader}\(")

    def made_files(self, folder):
        """Each with the function that reads it."""
        picture = Image.effect_noise((64, 64), 80).convert("RGBA")
        picture.paste((200, 40, 20, 255), (0, 0, 20, 30))
        picture.putalpha(Image.linear_gradient("L").resize((64, 64)))
        picture.save(folder / "picture.png")
        picture.crop((0, 0, 37, 50)).convert("RGB").save(folder / "odd.bmp")
        bmp = bytearray((folder / "odd.bmp").read_bytes())
        bmp[10:14] = bmp[34:38] = bytes(4)
        (folder / "zero.bmp").write_bytes(bmp)  # whose header doesn't say where its pixels begin
        picture.save(folder / "top.tga", orientation=1)
        picture.convert("RGB").save(folder / "bottom.tga", orientation=-1)
        found = [(folder / "odd.bmp", "readBmp"), (folder / "zero.bmp", "readBmp"), (folder / "top.tga", "readTga"), (folder / "bottom.tga", "readTga")]
        for name in ("dxt1", "dxt3", "dxt5"):
            said(TEXSHOT, "compress", str(folder / "picture.png"), str(folder / f"{name}.dds"), "--format", name)
            found.append((folder / f"{name}.dds", "readDds"))
        return found

    def test_lets_the_driver_and_glu_make_levels(self):
        """Of odd sizes, too, which the driver halves in its own way and GLU scales."""
        with tempfile.TemporaryDirectory() as folder:
            cases = []
            for width, height in ((64, 64), (37, 50)):
                picture = Image.linear_gradient("L").resize((width, height)).convert("RGB")
                picture.paste((200, 40, 20), (3, 4, 20, 30))
                picture.save(Path(folder) / f"picture{width}.png")
                for call, suffix in (("glGenerateMipmap", "call"), ("GL_GENERATE_MIPMAP", "parameter"), ("gluBuild2DMipmaps", "glu")):
                    scene = Path(folder) / f"{suffix}-{width}.json"
                    scene.write_text(json.dumps({
                        "version": 1, "models": [{"shape": "floor"}], "textures": [{
                            "source": "file", "file": f"picture{width}.png", "mipmaps": call, "minFilter": "GL_LINEAR_MIPMAP_LINEAR"}],
                        "passes": [{"units": [{"enabled": True, "envMode": "GL_REPLACE"}]}]}))
                    cases.append(Case(scene.stem, (str(scene),), scene))
            for case in cases:
                # Where GLU scales, it cuts off where texshot rounds.
                flavour = self.FLAVOUR._replace(bound=7) if case.name == "glu-37" else self.FLAVOUR
                with self.subTest(case.name):
                    verdict, = Proof(TEXSHOT, flavour, self.capture, Path(KEEP) / "levels").of_all([case])
                    self.assertEqual((verdict.wrong, verdict.refused), ("", ""))

    def test_leaves_out_tex_coords(self):
        """In glBegin and glEnd the call is missing; arrays have the coordinates that stay."""
        quad = {"primitive": "GL_QUADS", "positions": [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], "texCoords": [[0, 0], [1, 0], [1, 1], [0, 1]]}
        fan = {"positions": [[0, 0, 0], [1, 0, 0], [0.7, 0.7, 0], [0, 1, 0]], "texCoords": [[0.1, 0.2], [1, 0], [0.9, 1], [0, 0.8]]}
        embossed = {"enabled": True, "depth": 0.1}
        # The model, more of the pass's units, and the glTexCoord or glMultiTexCoord calls of the fixed program; None: arrays.
        models = {
            "cube": ({"shape": "cube", "rotation": [20, 30, 0], "noTexCoord0": [2, 3, 4, 9]}, [], 20),
            "quad": ({"shape": "mesh", "mesh": quad, "noTexCoord0": [2]}, [], 3),
            "from-the-first-on": ({"shape": "mesh", "mesh": quad, "noTexCoord0": [0, 1]}, [], 3),  # one before glBegin
            "none-at-all": ({"shape": "quad", "noTexCoord0": [3, 2, 1, 0]}, [], 1),
            "two-units": ({"shape": "quad", "noTexCoord0": [1], "noTexCoord1": [0, 3]}, [{"enabled": True, "envMode": "GL_ADD"}], 6),
            "shared": ({"shape": "mesh", "mesh": {**fan, "indices": [0, 1, 2, 3, 2, 0]}, "noTexCoord0": [2]}, [], 4),
            "strip": ({"shape": "mesh", "mesh": {**fan, "primitive": "GL_TRIANGLE_STRIP"}, "noTexCoord0": [1, 3]}, [], 2),
            "small-sphere": ({"shape": "sphere", "slices": 4, "stacks": 2, "noTexCoord0": [2, 7]}, [], 19),  # of a pole, sent once, and of the equator, sent four times
            "sphere": ({"shape": "sphere", "noTexCoord0": [100, 101, 200, 300]}, [], None),
            "embossed": ({"shape": "cube", "rotation": [20, 30, 0], "noTexCoord0": [2, 5]}, embossed, None),
            "generated": ({"shape": "quad", "noTexCoord0": [2]}, {"enabled": True, "mode": "GL_OBJECT_LINEAR"}, 3),
        }
        with tempfile.TemporaryDirectory() as folder:
            cases = []
            for name, (model, more, _) in models.items():
                unit = {"enabled": True, "texture": 0, **({"emboss": more} if name == "embossed" else {"texGenS": more} if name == "generated" else {})}
                scene = Path(folder) / f"short-{name}.json"
                scene.write_text(json.dumps({"version": 1, "view": {"distance": 4}, "models": [model], "textures": [{"pattern": "brick"}],
                                             "passes": [{"depthTest": True, "units": [unit, *(more if isinstance(more, list) else [])]}]}))
                cases.append(Case(name, (str(scene),), Path(folder) / f"{name}.json"))
                written(TEXSHOT, cases[-1])
            verdicts = Proof(TEXSHOT, self.FLAVOUR, self.capture, Path(KEEP) / "left-out").of_all(cases)
            for case, verdict, (_, _, calls) in zip(cases, verdicts, models.values()):
                with self.subTest(case.name):
                    self.assertEqual((verdict.wrong, verdict.refused), ("", ""))
                    program = said(TEXSHOT, "emit", *case.words, "--as", self.FLAVOUR.name)
                    drawn = self.FLAVOUR is FIXED and calls is not None
                    self.assertEqual(len(re.findall(r"gl(?:Multi)?TexCoord\df\(", program)), calls if drawn else 0)
                    self.assertEqual("a vertex without glTexCoord has the coordinates of the one before it" in program, not drawn)

    def test_sends_normals_of_any_length(self):
        """No light falls on a vertex whose normal is 0."""
        quad = {"primitive": "GL_QUADS", "positions": [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], "normals": [[0, 0, 0], [0, 0, 5], [3, 0, 3], [0, 0, 0.1]]}
        with tempfile.TemporaryDirectory() as folder:
            cases = []
            for name, more in (("list", {}), ("arrays", {"indices": [0, 1, 2, 3]})):
                scene = Path(folder) / f"scene-{name}.json"
                scene.write_text(json.dumps({"version": 1, "view": {"distance": 4}, "models": [{"shape": "mesh", "mesh": {**quad, **more}}],
                                             "passes": [{"lighting": True}]}))
                cases.append(Case(name, (str(scene),), Path(folder) / f"{name}.json"))
                written(TEXSHOT, cases[-1])
            for case, verdict in zip(cases, Proof(TEXSHOT, self.FLAVOUR, self.capture, Path(KEEP) / "normals").of_all(cases)):
                with self.subTest(case.name):
                    self.assertEqual((verdict.wrong, verdict.refused), ("", ""))

    def test_uploads_what_the_memory_holds(self):
        """glTexImage is given the program's bytes and what it is told of them, whether both agree or not."""
        layout = {"custom": True, "memory": "layout"}
        uploads = {
            "sheared": ({**layout, "memoryFormat": "GL_RGB", "memoryAlignment": 1, "format": "GL_RGB", "alignment": 8}, {}, "glPixelStorei(GL_UNPACK_ALIGNMENT, 8);"),
            "blue-first": ({**layout, "memoryFormat": "GL_BGR", "format": "GL_RGB", "alignment": 1}, {"mipmaps": "generated"}, "GL_RGB, GL_UNSIGNED_BYTE, texture0Level1Memory"),
            "packed": ({"custom": True, "format": "GL_BGRA", "type": "GL_UNSIGNED_SHORT_1_5_5_5_REV"}, {"mipmaps": "glGenerateMipmap"}, "GL_BGRA, GL_UNSIGNED_SHORT_1_5_5_5_REV, "),
            "part": ({"custom": True, "rowLength": 70, "skipRows": 3, "skipPixels": 5}, {}, "glPixelStorei(GL_UNPACK_SKIP_ROWS, 3);"),
            "swapped": ({"custom": True, "format": "GL_RGB", "type": "GL_UNSIGNED_SHORT", "swapBytes": True}, {}, "glPixelStorei(GL_UNPACK_SWAP_BYTES, GL_TRUE);"),
            "swapped-part": ({"custom": True, "format": "GL_RGB", "type": "GL_UNSIGNED_SHORT", "swapBytes": True, "rowLength": 70, "skipPixels": 2}, {}, "texture0Memory + 12"),
            "scaled": ({"custom": True, "scale": [0.5, 1, 2, 1], "bias": [0, 0.25, 0, 0]}, {}, None),
            "luminance": ({"custom": True, "format": "GL_LUMINANCE"}, {"mipmaps": "gluBuild2DMipmaps"}, None),
            "not-an-alignment": ({"custom": True, "format": "GL_RGB", "alignment": 3}, {}, "glPixelStorei(GL_UNPACK_ALIGNMENT, 4);"),
            "depth": ({"custom": True, "format": "GL_DEPTH_COMPONENT", "type": "GL_UNSIGNED_SHORT"}, {"internalFormat": "GL_DEPTH_COMPONENT16"}, "GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT, texture0Memory"),
            "refused": ({"custom": True, "format": "GL_RGB", "type": "GL_UNSIGNED_SHORT_4_4_4_4"}, {}, "GL_UNSIGNED_SHORT_4_4_4_4 takes GL_RGBA or GL_BGRA, not GL_RGB"),
        }
        with tempfile.TemporaryDirectory() as folder:
            cases = []
            for name, (upload, more, _) in uploads.items():
                texture = {"pattern": "uv-template", "minFilter": "GL_LINEAR_MIPMAP_NEAREST" if "mipmaps" in more else "GL_LINEAR", "upload": upload, **more}
                scene = Path(folder) / f"upload-{name}.json"
                # A second texture, whose upload is not custom: what the first has told is set back.
                scene.write_text(json.dumps({"version": 1, "view": {"distance": 7}, "textures": [texture, {"pattern": "brick", "minFilter": "GL_LINEAR"}],
                                             "models": [{"shape": "quad", "position": [-1.2, 0, 0]}, {"shape": "quad", "position": [1.2, 0, 0]}],
                                             "passes": [{"models": [m], "units": [{"enabled": True, "texture": m}]} for m in (0, 1)]}))
                cases.append(Case(name, (str(scene),), Path(folder) / f"{name}.json"))
                written(TEXSHOT, cases[-1])
            verdicts = Proof(TEXSHOT, self.FLAVOUR, self.capture, Path(KEEP) / "uploads").of_all(cases)
            for case, verdict, (name, (_, _, call)) in zip(cases, verdicts, uploads.items()):
                with self.subTest(case.name):
                    self.assertEqual((verdict.wrong, verdict.refused), ("", ""))
                    if call and not (name == "refused" and self.FLAVOUR is not FIXED):  # which leaves it out
                        self.assertIn(call, said(TEXSHOT, "emit", *case.words, "--as", self.FLAVOUR.name))

    def test_another_scene_differs(self):
        class OfAnotherScene(Proof):
            def emit(self, case, file):
                super().emit(case._replace(words=(*case.words, "--set", "light.diffuse=1,1,0.9,1")), file)

        with tempfile.TemporaryDirectory() as folder:
            case = Case("start", (), Path(folder) / "start.json")
            written(TEXSHOT, case)
            verdict, = OfAnotherScene(TEXSHOT, self.FLAVOUR, self.capture, folder).of_all([case])
            self.assertRegex(verdict.wrong, r"at 0 s \d+ of 307200 pixels .* at 1.75 s ")
            kept = sorted(file.name for file in (Path(folder) / self.FLAVOUR.name / "start").iterdir())
        self.assertEqual([name for name in kept if name.endswith((".c", ".png"))],
                         ["demo.c", "difference-0.png", "difference-1.75.png", "program-0.png", "program-1.75.png",
                          "texshot-0.png", "texshot-1.75.png"])


class Fixed(Programs, unittest.TestCase):
    FLAVOUR = FIXED


class Glsl(Programs, unittest.TestCase):
    FLAVOUR = GLSL


if __name__ == "__main__":
    unittest.main()
