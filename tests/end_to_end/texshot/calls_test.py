"""What every command has, and what is said of wrong calls."""

import json
import re
import unittest

from texshot import OUTPUT, Texshot, bmp, document, problem, results, single, texshot


class Calls(Texshot):
    def commands(self):
        """From the list in --help: names stand two columns from the left, titles at it."""
        text = self.succeeds("--help").decode()
        names = re.findall(r"^  ([a-z]+) {2,}\S", text.split("Common options:")[0], re.M)
        self.assertGreater(len(names), 15)
        return names

    def test_help_has_every_command_under_a_title(self):
        text = self.succeeds("--help").decode()
        for title in ("Draw:", "Compare:", "Scenes:", "Images:", "About:", "Common options:"):
            self.assertEqual(text.count(f"\n{title}\n"), 1, title)
        self.assertLessEqual(max(map(len, text.splitlines())), 80)
        self.assertEqual(self.succeeds("help").decode(), text)

    def test_every_command_has_help_and_the_version(self):
        for name in self.commands():
            with self.subTest(name):
                text = self.succeeds(name, "--help").decode()
                self.assertEqual(self.succeeds("help", name).decode(), text)
                self.assertEqual(self.succeeds(name, "-h").decode(), text)
                self.assertIn(f"Usage: texshot {name} ", text)
                self.assertIn("Exit status: 0", text)
                self.assertLessEqual(max(map(len, text.splitlines())), 80)
                for shared in ("--version", "--quiet", "--verbose"):
                    self.assertIn(f"  {shared} ", text)
                self.assertRegex(self.succeeds(name, "--version").decode(), r"\Atexshot \d+\.\d+\.\d+\n\Z")

    def test_every_command_names_what_is_near(self):
        for name in self.commands():
            with self.subTest(name):
                self.complains(2, "there is no option --quite; did you mean --quiet?", name, "--quite")
                self.complains(2, f"there is no option --qqqqqqq; see texshot {name} --help", name, "--qqqqqqq")
                self.complains(2, f'there is no command "{name}x"; did you mean "{name}"?', name + "x")
                self.complains(2, "--quiet and --verbose exclude each other", name, "--quiet", "--verbose")

    def test_wrong_calls_get_a_sentence(self):
        out = self.path / "out.png"
        for expected, *call in [
            ("a command is missing; see texshot --help",),
            ("a command is missing; see texshot --help", "--quiet"),
            ('there is no command "hsot"; did you mean "shot"?', "hsot"),
            ('there is no command "pre"; did you mean "presets"?', "pre"),
            ('there is no command "scene.json"; expected one of ', "scene.json"),
            ('there is no command ""; expected one of ', ""),
            ('expected a command, found "--size"; see texshot --help', "--size", "3x3", "shot"),
            ('expected a command, found "--verison"; did you mean --version?', "--verison"),
            ('there is no command "flpi"; did you mean "flip"?', "help", "flpi"),
            ("there is no option --sise; did you mean --size?", "shot", "--sise", "3x3"),
            ("there is no option -size; did you mean --size?", "shot", "-size", "3x3", "-o", out),
            ("--out is missing; see texshot shot --help", "shot"),
            ("--size: expected a value, found none", "shot", "-o", out, "--size"),
            ("--size: expected a value, found the option -o", "shot", "--size", "-o", out),
            ('--size: expected one value, found "3x3" and "4x4"', "shot", "--size", "3x3", "-o", out, "--size", "4x4"),
            ("SCENE: expected a value, found an empty one", "shot", "", "-o", out),
            ("--out: expected a value, found an empty one", "shot", "-o", ""),
            ('expected no further argument, found "b.json"; see texshot check --help', "check", "a.json", "b.json"),
            ("--json: expected no value", "check", "--json=no"),
            ("--tab requires --ui", "shot", "--tab", "memory", "-o", out),
            ('--tab: there is no "exlain"; did you mean "explain"?', "shot", "--ui", "--tab", "exlain", "-o", out),
            ("SCENE and --lesson exclude each other", "check", "a.json", "--lesson", "wrap"),
            ('--step: expected a whole number from 1 to', "check", "--lesson", "wrap", "--step", "two"),
            ('--texture: expected a whole number from 0 to 63, found "64"', "texture", "--texture", "64", "-o", out),
            ("FROM is missing; see texshot diff --help", "diff"),
            ("--format is missing; see texshot compress --help", "compress", "a", "b"),
            ("there is no option --fromat; did you mean --format?", "compress", "a", "b", "--fromat", "dxt1"),
        ]:
            with self.subTest(call):
                self.complains(2, expected, *call)

    def test_quiet_says_errors_alone(self):
        broken = self.path / "broken.json"
        broken.write_text('{"version": 1, "textures": [{"mipmaps": "none"}], "passes": [{"units": [{"enabled": true}]}]}')
        call = ["shot", broken, "--renderer", "reference", "--size", "4x4", "-o", self.path / "out.png"]
        loud, quiet = texshot(*call), texshot("--quiet", *call)
        self.assertEqual((loud.returncode, quiet.returncode), (0, 0))
        self.assertIn(b"texshot: ", loud.stderr)
        self.assertEqual(quiet.stderr, b"")
        self.complains(1, "No such file or directory", "decode", self.path / "no.bmp", self.path / "out.png", "--quiet")

    def test_verbose_says_what_is_done(self):
        source = self.path / "in.bmp"
        source.write_bytes(bmp(4, 4, lambda x, y: (x, y, 0)))
        result = texshot("convert", "--verbose", source, self.path / "out.png")
        self.assertEqual((result.returncode, result.stdout), (0, b""))
        size = (self.path / "out.png").stat().st_size
        said = result.stderr.decode().splitlines()
        self.assertEqual(said[:2], [f"texshot: read {source}, {source.stat().st_size} bytes",
                                    f"texshot: wrote {self.path / 'out.png'}, {size} bytes"])
        self.assertRegex(said[2], r"\Atexshot: took \d+\.\d{3} s\Z")
        scene = self.path / "scene.json"
        scene.write_text(json.dumps({"version": 1, "textures": [{"source": "file", "file": "in.bmp"}]}))
        said = texshot("shot", scene, "--size", "4x4", "-o", "-", "--verbose").stderr.decode()
        for expected in (f"read {scene}, ", "read in.bmp, BMP, 4 × 4\n", "drawn by ", "wrote standard output, "):
            self.assertIn("texshot: " + expected, said)

    def test_json_is_one_document(self):
        source = self.path / "in.bmp"
        source.write_bytes(bmp(4, 4, lambda x, y: (x, y, 0)))
        for call in (["check"], ["commands"], ["params"], ["params", "wrap"], ["presets"], ["lessons"], ["info", source],
                     ["diff", "-", "-"], ["validate", source], ["convert", source, self.path / "a.png"],
                     ["decode", source, self.path / "b.png"], ["flip", source, self.path / "c.bmp"],
                     ["compress", source, self.path / "d.dds", "--format", "dxt1"],
                     ["texture", "-o", self.path / "e.png"], ["probe", "--no-gl", "--size", "4x4", "--at", "1,1"]):
            if call[0] == "diff":
                scene = self.path / "scene.json"
                scene.write_text('{"version": 1}')
                call = ["diff", scene, scene]
            with self.subTest(call):
                told = document(self.succeeds(*call, "--json"))
                self.assertEqual((told["command"], told["problems"]), (call[0], []))
                version = self.succeeds("--version").decode().split()[-1]
                self.assertEqual((told["texshot"], told["schema"]), (version, OUTPUT.schema["$id"]))

    def test_with_json_every_error_is_json_of_one_shape(self):
        """A file that isn't there, of every command that has --json and reads one; and wrong calls of all."""
        nowhere, picture = self.path / "nowhere.json", self.path / "nowhere.png"
        calls = {
            "shot": (nowhere, "-o", self.path / "a.png"), "sweep": (nowhere, "--axis", "view.azimuth=0,1", "-o", self.path / "a.png"),
            "probe": (nowhere, "--at", "1,1"), "texture": (nowhere, "-o", self.path / "a.png"), "commands": (nowhere,),
            "check": (nowhere,), "cost": (nowhere,), "diff": (nowhere, nowhere), "scene": ("--diff", nowhere, nowhere), "info": (picture,),
            "validate": (picture,), "compare": (picture, picture), "decode": (picture, self.path / "a.png"),
            "convert": (picture, self.path / "a.png"), "flip": (picture, self.path / "a.png"),
            "compress": (picture, self.path / "a.dds", "--format", "dxt1"), "lessons": ("--check", self.path / "nowhere"),
            "conform": ("--feature", "nowhere"), "params": ("nowhere",)}
        without = {"animate", "emit", "merge", "schema", "test"}  # its own --json names a file
        others = {"presets", "drivers", "help"}  # read nothing
        self.assertEqual(set(self.commands()), set(calls) | without | others)
        for command, call in calls.items():
            for wrong in (call, (*call, "--nonsense")):
                with self.subTest(command=command, wrong=wrong):
                    result = texshot(command, *wrong, "--json")
                    self.assertIn(result.returncode, (1, 2))
                    said = problem(result.stdout)
                    self.assertIn("no" if "--nonsense" in wrong else "nowhere", said)
                    self.assertEqual(result.stderr.decode().splitlines()[0], "texshot: " + said)
                    self.assertIsInstance(document(result.stdout)["problems"][0]["id"], int)
        for command in sorted(others - {"help"}):
            result = texshot(command, "--json", "--nonsense")
            self.assertIn("there is no option --nonsense", problem(result.stdout))

    def test_with_json_in_any_spelling_a_wrong_call_is_json(self):
        file = self.path / "test.json"
        for command, said, *call in [
            ("check", "--json: expected no value", "check", "--json=yes"),
            ("shot", "--out is missing", "shot", "--json"),
            ("info", 'expected a command, found "--json=yes"', "--json=yes", "info"),
            ("", 'there is no command "bogus"', "bogus", "--json"),
            ("", 'there is no command "bogus"', "bogus", "check", "--json"),
            ("", "expected a command", "--json"),
            ("emit", "there is no option --json", "emit", "--json"),
            ("help", "there is no option --json", "help", "check", "--json"),
            ("test", "SUITE is missing", "test", "--json=-"),
            ("test", "there is no option --nonsense", "test", "a", "--json", "-", "--nonsense"),
            ("test", "expected a value, found none", "test", "a", "--json"),
            (None, "there is no option --nonsense", "test", "a", "--nonsense", f"--json={file}"),
            (None, "there is no option --nonsense", "check", "--nonsense", "--", "--json"),
        ]:
            with self.subTest(call):
                result = texshot(*call)
                self.assertEqual(result.returncode, 2, result)
                self.assertIn(said, result.stderr.decode())
                if command is None:
                    self.assertEqual(result.stdout, b"")
                else:
                    self.assertEqual((document(result.stdout)["command"], "texshot: " + problem(result.stdout) + "\n"),
                                     (command, result.stderr.decode()))
        self.assertFalse(file.exists())

    def test_a_program_can_take_apart_where_a_problem_is(self):
        folder = self.path / "a: b"
        folder.mkdir()
        scene, out = folder / "c: d.json", self.path / "a.png"

        def where(text, *call):
            scene.write_bytes(text)
            told, = document(texshot(*(call or ("shot", scene, "-o", out)), "--json").stdout)["problems"]
            self.assertIsInstance(told["id"], int, told)
            return told["where"]

        lost = {"textures": [{"source": "file", "file": "e: f.bmp"}]}
        self.assertEqual(where(json.dumps(lost).encode()),
                         [{"file": str(scene)}, {"parameter": "textures[0].file"}, {"file": str(folder / "e: f.bmp")}])
        self.assertEqual(where(b'{"view": {"distanc": 1}}'), [{"file": str(scene)}, {"pointer": "/view/distanc"}])
        self.assertEqual(where(b'{\n "view" 1}'), [{"file": str(scene)}, {"line": 2, "column": 9}])
        self.assertEqual(where('{\n "é\0"}'.encode()), [{"file": str(scene)}, {"line": 2, "column": 4}])
        self.assertEqual(where(b"{}", "shot", scene, "--set", "view.distanc=1", "-o", out), [{"parameter": "view.distanc"}])
        for option, wrong in (("--step", ("--lesson", "wrap", "--step", "abc")), ("--size", ("--size", "")), ("--set", ("--set", "x")),
                              ("--out", ()), ("--size", ("--size",)), ("--size", ("--size", "1x1", "--size", "2x2"))):
            with self.subTest(wrong):
                call = ("shot", *wrong) if option == "--out" else ("shot", "-o", out, *wrong)
                self.assertEqual(where(b"{}", *call), [] if option == "--out" else [{"option": option}])

    def test_a_test_run_that_fails_says_so_where_json_goes(self):
        for out in ("-", self.path / "out.json"):
            result = texshot("test", self.path / "nowhere.suite.json", "--json", out)
            self.assertEqual(result.returncode, 2)
            text = result.stdout if out == "-" else out.read_bytes()
            self.assertIn("nowhere.suite.json", problem(text))
        mine = self.path / "mine.json"
        mine.write_text("{}")
        texshot("test", self.path / "nowhere.suite.json", "--json", mine)
        self.assertEqual(mine.read_text(), "{}", "it may be what the suite would read")
        mine.write_bytes(self.succeeds("check", "--json"))  # another command's, which isn't lost
        before = mine.read_bytes()
        texshot("test", self.path / "nowhere.suite.json", "--json", mine)
        self.assertEqual(mine.read_bytes(), before)

    def test_names_in_capitals_and_lists(self):
        small = ("--size", "16x16")
        self.succeeds("shot", *small, "--renderer", "REFERENCE", "-o", self.path / "a.png")
        self.succeeds("shot", *small, "--preset", "alpha-test,seam", "--renderer", "reference", "-o", self.path / "b.png")
        self.succeeds("shot", *small, "--preset", "alpha-test", "--preset", "seam", "--renderer", "reference", "-o", self.path / "c.png")
        self.assertEqual((self.path / "b.png").read_bytes(), (self.path / "c.png").read_bytes())
        told = single(self.succeeds("conform", "--feature", "wrap,fog", "--scenes", "2", "--json"))
        self.assertEqual({each["feature"] for pair in told["pairs"] for each in pair["features"]}, {"wrap", "fog"})
        suite = self.path / "s.suite.json"
        suite.write_text('{"suite": 1, "cases": [{"scene": {"example": "cube"}}]}')
        listed = self.succeeds("test", "--list", suite, "--renderer", "fixed,shader").decode().split()
        self.assertEqual([name.split("/")[-1].split("@")[0] for name in listed], ["fixed", "shader"])

    def test_params_finds_what_is_looked_for(self):
        def paths(*call):
            return [each["path"] for each in results(self.succeeds("params", *call, "--json")) if each["kind"] != "list"]
        everything = paths()
        self.assertEqual(paths("textures[].wrap?"), ["textures[].wrapS", "textures[].wrapT", "textures[].wrapR"])
        self.assertEqual(paths("textures[3].wrapS"), ["textures[].wrapS"])
        self.assertEqual(paths("*minfilter"), ["textures[].minFilter"])
        self.assertEqual(paths("GL_TEXTURE_MIN_FILTER"), ["textures[].minFilter"])
        self.assertIn("textures[].minFilter", paths("Minification"))
        self.assertIn("textures[].minFilter", paths("seen from afar"))
        self.assertIn("textures[].minFilter", paths("mipmap linear"))
        self.assertEqual(paths("*"), everything)
        self.assertEqual([path for path in everything if path.startswith("view.")], paths("view.*"))
        listed = results(self.succeeds("params", "minFilter", "--json"))[0]
        self.assertEqual((listed["kind"], listed["default"]), ("enum", "GL_NEAREST_MIPMAP_LINEAR"))
        self.assertEqual(len(listed["choices"]), 6)
        listed = results(self.succeeds("params", "minFilter", "--json"))
        self.assertEqual([each["path"] for each in listed if each["kind"] == "list"], ["textures[]"])
        self.complains(1, 'no parameter matches "nosuchthing"', "params", "nosuchthing")
        self.complains(1, 'no parameter matches "nosuch*"', "params", "nosuch*", "--json")


if __name__ == "__main__":
    unittest.main()
