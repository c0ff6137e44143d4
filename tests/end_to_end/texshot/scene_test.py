"""texshot scene: a scene as a file, complete or minimal."""

import json
import math
import shlex
import subprocess
import unittest

from PIL import Image, ImageChops

from texshot import TEXSHOT, Texshot, bmp, results, single, texshot


class Scene(Texshot):
    def write(self, name, **members):
        path = self.path / name
        path.parent.mkdir(exist_ok=True)
        path.write_text(json.dumps({"version": 1, **members}))
        return path

    def test_it_says_every_parameter(self):
        scene = json.loads(self.succeeds("scene"))
        for listed in results(self.succeeds("params", "view.", "--json")):
            self.assertIn(listed["path"].removeprefix("view."), scene["view"])
        self.assertEqual(len(scene["models"]), 2)

    def test_changes_are_in_it(self):
        scene = json.loads(self.succeeds("scene", "--set", "view.distance=9", "--set", "textures[0].wrapS=GL_CLAMP"))
        self.assertEqual((scene["view"]["distance"], scene["textures"][0]["wrapS"]), (9, "GL_CLAMP"))
        preset = json.loads(self.succeeds("scene", "--preset", "alpha-test"))
        self.assertNotEqual(preset["passes"], json.loads(self.succeeds("scene"))["passes"])
        step = json.loads(self.succeeds("scene", "--lesson", "wrap", "--step", "2"))
        self.assertEqual(step["version"], 1)

    def test_what_is_written_is_the_same_scene(self):
        whole = self.succeeds("scene", "--preset", "shimmer", "--set", "light.twoSide=true")
        short = self.succeeds("scene", "--preset", "shimmer", "--set", "light.twoSide=true", "--short")
        self.assertLess(len(short), len(whole))
        for text in (whole, short):
            again = texshot("scene", "-", input=text)
            self.assertEqual((again.returncode, again.stdout), (0, whole))
        self.assertEqual(json.loads(self.succeeds("scene", "--short")), {"version": 1})

    def test_a_file_is_written_whole_or_not_at_all(self):
        out = self.path / "out.json"
        self.assertEqual(self.succeeds("scene", "--set", "view.distance=9", "-o", out), b"")
        self.assertEqual(json.loads(out.read_text())["view"]["distance"], 9)
        self.complains(2, f'--out: expected a file other than "{out}", which is read', "scene", out, "--short", "-o", out)
        self.succeeds("scene", out, "--short", "--in-place")
        self.assertEqual(json.loads(out.read_text()), {"version": 1, "view": {"distance": 9}})
        self.succeeds("scene", "--short", "-o", self.path / "new" / "out.json")
        self.assertTrue((self.path / "new" / "out.json").exists())
        self.complains(2, "--in-place: expected SCENE", "scene", "--in-place")
        self.complains(2, 'a scene is JSON: expected a name that ends in .json, found', "scene", "-o", self.path / "a.png")

    def test_images_are_named_from_where_it_is_written(self):
        (self.path / "a").mkdir()
        (self.path / "a" / "in.bmp").write_bytes(bmp(2, 2, lambda x, y: (9, 9, 9)))
        scene = self.write("a/scene.json", textures=[{"source": "file", "file": "in.bmp"}])
        def named(*call, **options):
            result = texshot("scene", scene, "--short", *call, **options)
            self.assertEqual((result.returncode, result.stderr), (0, b""))
            return result.stdout
        self.assertEqual(json.loads(named(cwd=self.path))["textures"][0]["file"], "a/in.bmp")
        self.assertEqual(json.loads(named(cwd=self.path / "a"))["textures"][0]["file"], "in.bmp")
        named("-o", self.path / "above.json")
        self.assertEqual(json.loads((self.path / "above.json").read_text())["textures"][0]["file"], "a/in.bmp")
        named("-o", self.path / "a" / "near.json", cwd="/")
        self.assertEqual(json.loads((self.path / "a" / "near.json").read_text())["textures"][0]["file"], "in.bmp")
        (self.path / "b").mkdir()
        named("-o", self.path / "b" / "else.json")
        self.assertEqual(json.loads((self.path / "b" / "else.json").read_text())["textures"][0]["file"],
                         str(self.path.resolve() / "a" / "in.bmp"))

    def test_what_leads_from_one_to_the_other_is_a_command_line(self):
        a = self.write("a.json", passes=[{"name": "it's one"}])
        b = self.write("b.json", passes=[{"name": 'a "b" $c'}], view={"distance": 9, "background": [0, 0.5, 0, 1]})
        result = texshot("scene", "--diff", a, b)
        self.assertEqual((result.returncode, result.stderr), (1, b""))
        words = shlex.split(result.stdout.decode())
        self.assertEqual(words, ["--set", "view.distance=9", "--set", "view.background=0,0.5,0,1",
                                 "--set", 'passes[0].name=a "b" $c'])
        line = '"$0" scene --diff "$1" "$2" | xargs "$0" scene "$1"'
        there = subprocess.run(["sh", "-c", line, TEXSHOT, a, b], capture_output=True, timeout=60)
        self.assertEqual((there.returncode, there.stdout, there.stderr), (0, self.succeeds("scene", b), b""))
        self.assertEqual(self.succeeds("scene", a, *words), self.succeeds("scene", b))
        listed = results(texshot("scene", "--diff", a, b, "--json").stdout)
        self.assertEqual(listed, [{"set": dict([word.split("=", 1)])} for word in words[1::2]])
        self.assertEqual(self.succeeds("scene", "--diff", a, a), b"")
        self.assertEqual(results(self.succeeds("scene", "--diff", a, a, "--json")), [])

    def test_json_has_the_scene_in_the_document(self):
        told = single(self.succeeds("scene", "--set", "view.distance=9", "--json"))
        self.assertEqual(told, {"file": None, "scene": json.loads(self.succeeds("scene", "--set", "view.distance=9"))})
        out = self.path / "out.json"
        told = single(self.succeeds("scene", "--short", "--set", "view.distance=9", "--json", "-o", out))
        self.assertEqual(told, {"file": str(out), "scene": {"version": 1, "view": {"distance": 9}}})
        self.assertEqual(json.loads(out.read_text()), told["scene"])

    def test_every_shell_reads_what_leads_from_one_to_the_other(self):
        a = self.write("a.json", passes=[{}])
        for name in ("a\tb", "a\nb", "it's\r\t\\\n", "\x1b[31m"):
            b = self.write("b.json", passes=[{"name": name}])
            option = texshot("scene", "--diff", a, b).stdout.decode().removesuffix("\n")
            for shell in (["sh"], ["bash"], ["zsh", "-f"], ["fish", "--no-config"]):
                with self.subTest(f"{shell[0]}: {option}"):
                    line = f"'{TEXSHOT}' scene '{a}' {option}"
                    made = subprocess.run([*shell, "-c", line], capture_output=True, timeout=60)
                    self.assertEqual((made.returncode, made.stdout, made.stderr), (0, self.succeeds("scene", b), b""))

    def test_what_no_set_can_do_is_said(self):
        a = self.write("a.json", textures=[{}])
        b = self.write("b.json", textures=[{}, {}])
        result = texshot("scene", "--diff", a, b)
        self.assertEqual((result.returncode, result.stdout), (1, b""))
        self.assertEqual(result.stderr.decode(),
                         "texshot: textures: 1 element -> 2 elements: no --set changes how many elements a list has\n")
        quiet = texshot("scene", "--diff", a, b, "--quiet", "--json")
        self.assertEqual((quiet.returncode, quiet.stderr), (1, b""))
        self.assertEqual([each for each in results(quiet.stdout) if "path" in each],
                         [{"path": "textures", "from": "1 element", "to": "2 elements"}])

    def test_wrong_calls(self):
        a = self.write("a.json")
        broken = self.write("broken.json", veiw={})
        for code, expected, *call in [
            (1, 'unknown key; did you mean "view"?', "scene", broken),
            (1, "nowhere.json: can't be opened", "scene", self.path / "nowhere.json"),
            (2, "nowhere.json: can't be opened", "scene", "--diff", self.path / "nowhere.json", a),
            (2, 'unknown key; did you mean "view"?', "scene", "--diff", a, broken),
            (2, "--out and --diff exclude each other", "scene", "--diff", a, a, "-o", self.path / "out.json"),
            (2, "no such parameter", "scene", "--set", "view.distanc=3"),
            (2, "--preset: expected one of", "scene", "--preset", "nothing"),
            (2, '--preset: there is no "alpha-tset"; did you mean "alpha-test"?', "scene", "--preset", "alpha-tset"),
        ]:
            with self.subTest(expected):
                self.complains(code, expected, *call)


class ObjFiles(Texshot):
    """A file of meshes is a scene: a square of it is that of the scene that says the same."""

    square = "mtllib square.mtl\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
    face = "usemtl paint\nf 1/1 2/2 3/3 4/4\n"

    def test_are_drawn_like_the_scene_that_says_the_same(self):
        (self.path / "paint.bmp").write_bytes(bmp(8, 8, lambda x, y: (x * 30, y * 30, 99)))
        (self.path / "square.mtl").write_text("newmtl paint\nmap_Kd paint.bmp\n")
        (self.path / "square.obj").write_text(self.square + self.face)
        scene = json.loads(self.succeeds("scene"))
        size = 2 / math.sqrt(2)  # the corners are 2 from the middle
        texture = {**scene["textures"][0], "source": "file", "file": "paint.bmp"}
        passes = [{**scene["passes"][0], "models": [0]}]
        quad = {**scene, "models": [{"shape": "quad", "size": size}], "textures": [texture], "passes": passes}
        (self.path / "quad.json").write_text(json.dumps(quad))
        for renderer in ("fixed", "reference"):
            pictures = []
            for name in ("square.obj", "quad.json"):
                out = self.path / (name + ".png")
                self.succeeds("shot", self.path / name, "--renderer", renderer, "--size", "120x90", "-o", out)
                pictures.append(Image.open(out).convert("RGB"))
            self.assertLessEqual(max(high for _, high in ImageChops.difference(*pictures).getextrema()), 1, renderer)
            self.assertGreater(len(pictures[0].getcolors(10000)), 20, "it is there")

    def test_say_what_is_wrong(self):
        (self.path / "wrong.obj").write_text(self.square + "f 1 2 7\n")
        self.complains(1, "wrong.obj: line 10: expected v from 1 to 4, found 7", "scene", self.path / "wrong.obj")
        (self.path / "square.obj").write_text(self.square + self.face)  # without its library
        without = texshot("scene", self.path / "square.obj")
        self.assertEqual((without.returncode, json.loads(without.stdout)["models"][0]["shape"]), (0, "mesh"))
        self.assertIn(b"square.mtl can't be read", without.stderr)
        (self.path / "square.mtl").write_text("newmtl paint\nmap_Kd gone.png\n")
        self.complains(1, "gone.png", "shot", self.path / "square.obj", "-o", self.path / "x.png")
        piped = texshot("scene", "-", input=(self.square + self.face).encode(), cwd=self.path)
        self.assertEqual((piped.returncode, piped.stderr), (0, b""))
        models = json.loads(self.succeeds("scene", self.path / "square.obj"))["models"]
        self.assertEqual(json.loads(piped.stdout)["models"], models)
        (self.path / "flat.obj").write_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n")
        self.assertIn("the mesh has no texture coordinates", texshot("check", self.path / "flat.obj").stdout.decode())
        self.complains(2, "square.mtl", "scene", self.path / "square.obj", "-o", self.path / "square.mtl")


if __name__ == "__main__":
    unittest.main()
