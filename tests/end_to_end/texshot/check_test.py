"""texshot check: what is wrong in a scene."""

import json
import shlex
import subprocess
import unittest

from texshot import TEXSHOT, Texshot, problem, results, texshot


class Check(Texshot):
    INCOMPLETE = "textures[0].mipmaps=none"

    def test_a_scene_without_a_mistake(self):
        self.assertEqual(self.succeeds("check"), b"")
        self.assertEqual(results(self.succeeds("check", "--json")), [])

    def test_a_warning_is_said_with_what_mends_it(self):
        result = texshot("check", "--set", self.INCOMPLETE)
        self.assertEqual((result.returncode, result.stderr), (1, b""))
        said = result.stdout.decode()
        self.assertIn("warning: textures[0].minFilter: the texture is incomplete", said)
        fixes = [shlex.split(line)[-1] for line in said.splitlines() if "--set " in line]
        self.assertEqual(fixes, ["textures[0].mipmaps=generated", "textures[0].maxLevel=0",
                                 "textures[0].minFilter=GL_LINEAR"])
        for fix in fixes:
            self.assertEqual(texshot("check", "--set", self.INCOMPLETE, "--set", fix).returncode, 0, fix)
        listed = results(texshot("check", "--json", "--set", self.INCOMPLETE).stdout)
        self.assertEqual([each["path"] for each in listed], ["textures[0].minFilter"])
        self.assertEqual([fix["set"] for fix in listed[0]["fixes"]],
                         [{"textures[0].mipmaps": "generated"}, {"textures[0].maxLevel": "0"},
                          {"textures[0].minFilter": "GL_LINEAR"}])

    def test_what_mends_it_can_be_typed_in_every_shell(self):
        said = texshot("check", "--set", self.INCOMPLETE).stdout.decode()
        words, = (line.split(":", 1)[1] for line in said.splitlines() if "maxLevel=0" in line)
        for shell in (["sh"], ["bash"], ["zsh", "-f"], ["fish", "--no-config"]):
            with self.subTest(shell):
                line = f"{TEXSHOT} check --set '{self.INCOMPLETE}'{words}"
                result = subprocess.run([*shell, "-c", line], capture_output=True, timeout=120)
                self.assertEqual((result.returncode, result.stdout, result.stderr), (0, b"", b""))

    def test_a_setting_without_effect_is_named_and_no_failure(self):
        said = self.succeeds("check", "--set", "textures[0].wrapR=GL_CLAMP").decode()
        self.assertIn("hint: textures[0].wrapR: no effect: only a 3D texture has r", said)

    def said_of(self, **members):
        scene = self.path / "scene.json"
        scene.write_text(json.dumps({"version": 1, **members}))
        result = texshot("check", "--json", scene)
        self.assertEqual(result.stderr, b"")
        return {(each["severity"], each["path"]): each["message"] for each in results(result.stdout)}

    def test_what_nobody_wrote_is_not_named(self):
        passes = [{"depthTest": True, "units": [{"enabled": True}]}]
        self.assertEqual(self.said_of(passes=passes), {})
        self.assertEqual(self.said_of(material={"shininess": 9}, passes=passes),
                         {("hint", "material.shininess"): "no pass has lighting"})

    def test_a_unit_that_is_off_is_named_and_so_is_its_texture(self):
        said = self.said_of(passes=[{"depthTest": True, "units": [{"texture": 0, "envMode": "GL_REPLACE"}]}])
        self.assertEqual(said, {("hint", "passes[0].units[0]"): "the unit is off",
                                ("hint", "textures[0]"): "no enabled unit shows this texture"})
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
            self.assertIn(expected, problem(result.stdout))
            self.assertEqual(result.stderr.decode(), f"texshot: {problem(result.stdout)}\n")
        self.complains(2, "minFliter", "check", "--set", "textures[0].minFliter=GL_NEAREST")


if __name__ == "__main__":
    unittest.main()
