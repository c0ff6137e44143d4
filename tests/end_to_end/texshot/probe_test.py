"""texshot probe: a square of 2 × 2 texels that fills a picture of 4 × 4 pixels exactly."""

import json
import os
import shutil
import subprocess
import unittest

from texshot import SANITIZED, TEXSHOT, Texshot, bmp, document, single, texshot


class Probe(Texshot):
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
        return single(self.succeeds("probe", self.scene, "--size", "4x4", "--json", *arguments))

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

    def test_both_lod_biases_are_told_apart(self):
        found = self.probe("--at", "0,3", "--no-gl", "--set", "textures[0].lodBias=1.5",
                           "--set", "passes[0].units[0].lodBias=-0.25")
        lod = found["fragments"][0]["units"][0]["sample"]["lod"]
        self.assertEqual([lod[key] for key in ("textureBias", "unitBias", "bias", "biased")], [1.5, -0.25, 1.25, 0.25])

    def test_a_texel_of_a_custom_upload_is_followed_to_its_bytes(self):
        # Rows of BMP begin at multiples of 4 bytes: here at 0 and 8, where OpenGL is told 6.
        found = self.probe("--at", "3,0", "--set", "textures[0].magFilter=GL_NEAREST", "--set",
                           "textures[0].upload.custom=true", "--set", "textures[0].upload.format=GL_RGB", "--set",
                           "textures[0].upload.alignment=1")
        tap = found["fragments"][0]["units"][0]["sample"]["taps"][0]
        self.assertEqual(tap["memory"], {"first": 9, "count": 3, "bytes": [102, 102, 255], "holds": "grb",
                                         "readAs": "rgb"})
        for renderer in ("reference", "fixed", "shader"):
            self.assertEqual(found[renderer][:3], [102, 102, 255], renderer)

    def test_it_gives_the_bytes_of_the_pictures_of_all_three_renderers(self):
        pictures = {
            renderer: self.shot(self.scene, "--size", "4x4", "--renderer", renderer)
            for renderer in ("fixed", "shader", "reference")
        }
        for at in ((0, 0), (3, 0), (1, 2), (3, 3)):
            found = self.probe("--at", f"{at[0]},{at[1]}")
            for renderer, picture in pictures.items():
                self.assertEqual(tuple(found[renderer][:3]), picture.getpixel(at)[:3], (renderer, at))

    def test_what_a_lesser_driver_has_there_is_told(self):
        call = ("probe", "--at", "160,100", "--size", "320x200", "--set", "passes[0].units[1].enabled=true", "--json")
        for words, expected in (([], False), (["--pretend", "no-multitexture"], True)):
            done = texshot(*call, *words)
            self.assertEqual(done.returncode, 0)
            self.assertEqual("the driver has 1 texture unit; drawn without this one" in done.stderr.decode(), expected)

    def test_the_text_says_what_the_json_says(self):
        said = self.succeeds("probe", self.scene, "--size", "4x4", "--at", "0,3").decode()
        for expected in ("pixel 0, 3 of 4 × 4, from the top left", "reference  45 45 45 255", "fixed      ", "shader     ",
                         "(0, 0)", "0.5625", "GL_REPLACE", "rho = the longer", "lambda is not above 0"):
            self.assertIn(expected, said)

    def test_without_the_part_that_draws_it_says_so_and_goes_on(self):
        alone = self.path / "bin" / "texshot"
        alone.parent.mkdir()
        shutil.copy(TEXSHOT, alone)
        call = [alone, "probe", self.scene, "--size", "4x4", "--at", "0,3"]
        result = subprocess.run(call, capture_output=True)
        self.assertEqual(result.returncode, 1)
        self.assertRegex(result.stderr, rb"\Atexshot: [^\n]*can't load the module for [^\n]*\n\Z")
        self.assertIn(b"can't load the module for", result.stdout)
        self.assertIn(b"reference  45 45 45 255", result.stdout)
        told = document(subprocess.run([*call, "--json"], capture_output=True).stdout)
        self.assertEqual([each["code"] for each in told["problems"]], [told["results"][0]["fixed"]["error"]["code"]])
        self.assertEqual(told["results"][0]["reference"], [45, 45, 45, 255])
        self.assertEqual(subprocess.run([*call, "--no-gl"], capture_output=True).returncode, 0)

    def test_where_nothing_is_drawn_it_says_so(self):
        said = self.succeeds("probe", self.scene, "--size", "8x8", "--at", "0,0", "--no-gl",
                             "--set", "models[0].size=0.5", "--set", "view.background=0,0.5,1,1")
        self.assertIn(b"No model covers it, so it shows the background", said)
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
        found = single(probe.stdout.read())
        probe.stdout.close()
        _, code, used = os.wait4(probe.pid, 0)
        probe.returncode = code
        self.assertEqual(code, 0)
        self.assertEqual(len(found["pixels"]), 1500 * 1500)  # only at the others' very centres it has no share
        self.assertLess(used.ru_maxrss, (300 if SANITIZED else 150) * 1024)  # KiB

    def test_what_is_as_right_on_a_tie_is_no_difference(self):
        # The middle of 3 x 3 pixels is where four texels meet; llvmpipe takes one of them.
        scene = json.loads(self.scene.read_text())
        scene["textures"][0].update(minFilter="GL_NEAREST", magFilter="GL_NEAREST")
        self.scene.write_text(json.dumps(scene))
        call = ("probe", self.scene, "--size", "3x3", "--at", "1,1")
        found = single(self.succeeds(*call, "--json"))
        every = [[grey, grey, grey, 255] for grey in (0, 51, 102, 255)]
        self.assertEqual(sorted([found["reference"], *found["asRight"]]), every)
        self.assertIn(found["fixed"], every)
        ties = found["fragments"][0]["units"][0]["ties"]
        self.assertEqual([(tie["between"], tie["axis"], {tie["chosen"], tie["other"]}) for tie in ties],
                         [("texels", "s", {0, 1}), ("texels", "t", {0, 1})])
        said = self.succeeds(*call).decode()
        self.assertIn("also correct, on a tie", said)
        self.assertEqual(said.count("also correct, on a tie"), 3 + 2 * (found["fixed"] != found["reference"]), said)

    def test_a_pixel_of_many_fragments_is_explained_in_part(self):
        scene = json.loads(self.scene.read_text())
        scene["models"] = [{"shape": "mesh", "mesh": {"positions": [[-3, -1, 0], [3, -1, 0], [0, 5, 0]],
                                                      "indices": [0, 1, 2] * 43_690}}]
        scene["passes"][0]["depthFunc"] = "GL_LEQUAL"
        self.scene.write_text(json.dumps(scene))
        probe = subprocess.Popen([TEXSHOT, "probe", self.scene, "--size", "4x4", "--json", "--at", "1,1", "--no-gl"],
                                 stdout=subprocess.PIPE)
        found = single(probe.stdout.read())
        probe.stdout.close()
        _, code, used = os.wait4(probe.pid, 0)
        probe.returncode = code
        self.assertEqual((code, found["fragmentCount"], found["firstFragment"], len(found["fragments"])),
                         (0, 43_690, 43_658, 32))
        self.assertLess(used.ru_maxrss, (400 if SANITIZED else 200) * 1024)  # KiB
        said = self.succeeds("probe", self.scene, "--size", "4x4", "--at", "1,1", "--no-gl").decode()
        self.assertIn("43690 fragments cover it. Numbers 43659 to 43690 are explained (at most 32).", said)
        self.assertIn("fragment 43690 of 43690", said)

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
            (2, "--texel: passes[0].units[0] has a texture without a level 5", "--texel", "0,5,0,0"),
            (2, "--texel: expected i from -1 to 2 in level 0, its border included, found 3", "--texel", "0,0,3,0"),
            (2, "--texel: expected a unit from 0 to 3, found 9", "--texel", "9,0,0,0"),
            (2, "--pass: there is no pass 3", "--texel", "0,0,0,0", "--pass", "3"),
            (1, "units[2] samples nothing", "--texel", "2,0,0,0"),
            (2, "--size: expected WIDTHxHEIGHT", "--at", "0,0", "--size", "0x4"),
        ):
            size = () if "--size" in arguments else ("--size", "4x4")
            self.complains(code, expected, "probe", self.scene, *size, *arguments)


if __name__ == "__main__":
    unittest.main()
