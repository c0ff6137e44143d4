"""No output of a call replaces one of its inputs or another output, under any name."""

import json
import os
import re
import shutil
import subprocess
import unittest

from PIL import Image

from suites import Suites
from texshot import TEXSHOT, texshot

SMALL = ("--size", "16x16")


class Inputs(Suites):
    def setUp(self):
        super().setUp()
        self.inputs = self.path / "inputs"
        self.inputs.mkdir()
        picture = Image.new("RGB", (24, 16), (10, 20, 30))
        for name in ("image.png", "other.png", "mask.png", "golden.png"):
            picture.save(self.inputs / name)
        texture = {"source": "file", "file": "image.png", "mipmaps": "none", "minFilter": "GL_LINEAR"}
        scene = {"version": 1, "textures": [texture], "passes": [{"units": [{"enabled": True}]}]}
        (self.inputs / "scene.json").write_text(json.dumps(scene))
        shutil.copytree(os.path.join(os.path.dirname(__file__), "../../../shaders"), self.inputs / "shaders")
        lesson = self.inputs / "lesson"
        lesson.mkdir()
        (lesson / "lesson.json").write_text(json.dumps({"lesson": 1, "title": "T", "source": "S", "about": "A.", "steps": [
            {"title": "One", "text": "Text.", "scene": "own.json"}]}))
        (lesson / "own.json").write_text(json.dumps(scene))
        picture.save(lesson / "image.png")
        for suite in ("a", "b"):
            (self.inputs / f"{suite}.suite.json").write_text(json.dumps({"suite": 1, "cases": [
                {"name": "one", "scene": "scene.json", "size": "24x16", "golden": ["golden.png", "{case}@{driver}.png"],
                 "mask": "mask.png", "tolerance": 255},
                {"name": "lesson", "scene": {"lesson": "lesson"}, "size": "24x16", "golden": "golden.png", "tolerance": 255}]}))
        picture.save(self.inputs / "one__fixed@24x16@llvmpipe.png")
        for shard in ("1", "2"):
            self.run_of(self.inputs / "a.suite.json", "--shard", f"{shard}/2", "--report", self.inputs / f"part{shard}")
        (self.inputs / "list").write_text("a/one/fixed@24x16\n")
        self.run_of(self.inputs / "a.suite.json", "--durations", self.inputs / "durations.json")
        self.before = self.contents()

    def contents(self):
        return {each: each.read_bytes() for each in self.inputs.rglob("*") if each.is_file()}

    def kept(self, *call, said="which is read", **options):
        """Checks that the call is refused and that every input is unchanged."""
        result = texshot(*call, cwd=self.path, **options)
        self.assertEqual(result.returncode, 2, (call, result.stderr))
        self.assertIn(said, result.stderr.decode(), call)
        self.assertEqual(result.stderr.count(b"\n"), 1, result.stderr)
        self.assertEqual(self.contents(), self.before, call)

    def calls(self):
        """For each output option of each command: a call, with its inputs. {} is the output."""
        read = self.inputs
        shot = ["scene.json", "image.png"]
        suite = ["a.suite.json", "b.suite.json", "scene.json", "image.png", "mask.png", "golden.png",
                 "one__fixed@24x16@llvmpipe.png", "lesson/lesson.json", "lesson/own.json", "lesson/image.png"]
        suites = ("test", read / "a.suite.json", read / "b.suite.json")
        both = ("test", "--pictures", "--expected", read / "part1", "--actual", read / "part2")
        merged = ("merge", read / "part1", read / "part2")
        part = ["part1/run.json", "part2/run.json"]
        return {
            ("shot", "--out"): [(("shot", read / "scene.json", *SMALL, "-o", "{}"), shot),
                                (("shot", "--lesson", read / "lesson", *SMALL, "-o", "{}"),
                                 ["lesson/lesson.json", "lesson/own.json", "lesson/image.png"]),
                                (("shot", *SMALL, "--renderer", "shader", "--shaders", read / "shaders", "-o", "{}"),
                                 ["shaders/fragment.glsl"])],
            ("sweep", "--out"): [(("sweep", read / "scene.json", *SMALL, "--axis", "view.azimuth=1,2", "-o", "{}"), shot)],
            ("animate", "--out"): [(("animate", read / "scene.json", *SMALL, "--set", "view.azimuth=0..9", "--seconds", "1", "-o", "{}"), shot)],
            ("texture", "--out"): [(("texture", read / "scene.json", "-o", "{}"), shot)],
            ("emit", "--out"): [(("emit", read / "scene.json", "-o", "{}"), shot)],
            ("scene", "--out"): [(("scene", read / "scene.json", "--set", "view.distance=9", "-o", "{}"), shot)],
            ("compare", "--out"): [(("compare", read / "image.png", read / "other.png", "--mask", read / "mask.png", "-o", "{}"),
                                    ["image.png", "other.png", "mask.png"])],
            ("test", "--json"): [((*suites, "--json", "{}"), suite),
                                 ((*suites, "--shard", "1/2", "--durations", read / "durations.json", "--json", "{}"),
                                  ["durations.json"]),
                                 ((*suites, "--accept", read / "list", "--json", "{}"), ["list"]),
                                 ((*both, "--json", "{}"), [])],
            ("test", "--junit"): [((*suites, "--junit", "{}"), suite)],
            ("test", "--durations"): [((*suites, "--durations", "{}"), suite)],
            ("merge", "--out"): [((*merged, "-o", "{}"), part)],
            ("merge", "--junit"): [((*merged, "-o", self.path / "new", "--junit", "{}"), part)],
            ("merge", "--durations"): [((*merged, "-o", self.path / "new", "--durations", "{}"), part)],
            ("flip", "OUT"): [(("flip", read / "image.png", "{}"), ["image.png"])],
            ("convert", "OUT"): [(("convert", read / "image.png", "{}"), ["image.png"])],
            ("decode", "OUT"): [(("decode", read / "image.png", "{}"), ["image.png"])],
        }

    def test_of_every_command_and_output(self):
        for (command, option), calls in self.calls().items():
            for call, read in calls:
                for name in read:
                    out = self.inputs / name
                    link = self.path / f"link{re.sub('^.*[.]', '.', os.path.basename(name))}"
                    hard = link.with_stem("hard")
                    link.symlink_to(out)
                    os.link(out, hard)
                    names = [out, link, hard, self.inputs / ".." / "inputs" / name, os.path.relpath(out, self.path)]
                    if command in ("shot", "sweep", "animate", "texture", "compare", "flip", "convert", "decode") \
                            and out.suffix != ".png":  # not a picture by its extension, but a link to one
                        names = [self.path / "picture.png"]
                        names[0].symlink_to(out)
                    if command == "scene" and out.suffix != ".json":
                        names = [self.path / "scene.json"]
                        names[0].symlink_to(out)
                    for path in names:
                        with self.subTest(command=command, option=option, name=name, path=path):
                            # A file that is not a list of durations cannot be read as one, and is not overwritten
                            # either.
                            self.kept(*[str(path) if each == "{}" else each for each in call],
                                      said="" if (command, option) == ("test", "--durations") else "which is read")
                    for each in (link, hard, self.path / "picture.png", self.path / "scene.json"):
                        each.unlink(missing_ok=True)

    def test_every_output_option_is_tried(self):
        """The options whose value help calls FILE or DIR: each output must be tested here or listed as an exception."""
        reads = {"--shaders", "--mask", "--lesson", "--expected", "--actual", "--accept", "--resume", "--check", "--template", "--diff"}
        elsewhere = {("schema", "--out"), ("conform", "--out"), ("conform", "--report"), ("lessons", "--page"), ("test", "--report"),
                     ("merge", "--report"), ("flip", "--out"), ("convert", "--out"), ("decode", "--out"), ("compress", "--out")}
        tried = set(self.calls()) | elsewhere
        for command in re.findall(r"^  ([a-z]+)(?: |$)", self.succeeds("--help").decode(), re.MULTILINE):
            text = self.succeeds("help", command).decode()
            for names in re.findall(r"^  ((?:-\w,)?--[\w-]+(?:,--[\w-]+)*) (?:FILE|DIR)\b", text, re.MULTILINE):
                for name in names.split(","):
                    if name.startswith("--") and name not in reads:
                        self.assertIn((command, name), tried, "an output that is not tried")

    def test_standard_input_and_output_are_files_too(self):
        with open(self.inputs / "image.png", "rb") as file:
            self.kept("compare", "-", self.inputs / "other.png", "-o", self.inputs / "image.png", stdin=file)
        for name in ("-", "/dev/stdin", "/dev/fd/0"):
            with open(self.inputs / "scene.json", "rb") as file:
                self.kept("scene", name, "-o", self.inputs / "scene.json", stdin=file)
        with open(self.inputs / "image.png", "rb") as file:
            self.kept("flip", "-", self.inputs / "image.png", stdin=file)
        with open(self.inputs / "image.png", "ab") as file:  # as of cat(1)
            result = subprocess.run([TEXSHOT, "flip", self.inputs / "image.png", "-"], stdout=file, stderr=subprocess.PIPE)
        self.assertEqual((result.returncode, self.contents()), (2, self.before), result.stderr)

    def test_folders(self):
        read = self.inputs
        images = [read / "image.png", read / "other.png"]
        for command, *options in (("flip",), ("convert", "--to", "png"), ("decode",)):
            self.kept(command, *images, *options, "-o", read)
        for part in ("part1", "part1/run.json", "part1/journal.jsonl"):
            self.kept("merge", read / part, read / "part2", "-o", self.path / "new.json", "--report", read / "part1")

    def test_a_golden_that_is_written_is_no_input(self):
        """Of a folder of scenes X.json with X.png, one whose texture is X.png."""
        pairs = self.path / "pairs"
        pairs.mkdir()
        shutil.copy(self.inputs / "image.png", pairs / "brick.png")
        (pairs / "brick.json").write_text(json.dumps({"version": 1, "textures": [
            {"source": "file", "file": "brick.png", "mipmaps": "none", "minFilter": "GL_LINEAR"}], "passes": [{"units": [{"enabled": True}]}]}))
        before = (pairs / "brick.png").read_bytes()
        self.complains(2, "--update: expected a file other than", "test", pairs, "--update")
        masked = self.suite([{"name": "one", "scene": {"example": "cube"}, "golden": "mask.png", "mask": "./mask.png"}], "pairs/s.suite.json")
        shutil.copy(self.inputs / "mask.png", pairs / "mask.png")
        self.complains(2, "--update: expected a file other than", "test", masked, "--update")
        (pairs / "list").write_text("one/fixed@24x16\n")
        self.complains(2, "--accept: expected a file other than", "test", masked, "--accept", pairs / "list")
        self.complains(2, "--update: expected a file other than", "test", "--pictures", "--expected", pairs, "--actual", pairs, "--update")
        self.assertEqual((pairs / "brick.png").read_bytes(), before)

    def test_outputs_of_one_call_are_apart(self):
        suite = self.inputs / "a.suite.json"
        out = self.path / "o"
        for name in ("index.html", "run.json", "journal.jsonl", "report-data.js", "pictures/x.png", "../o/index.html"):
            for option in ("--json", "--junit", "--durations"):
                with self.subTest(name=name, option=option):
                    self.complains(2, option, "test", suite, "--report", out, option, out / name)
        out.mkdir()
        (self.path / "linked").symlink_to(out)
        self.complains(2, "--report", "test", suite, "--report", out, "--junit", self.path / "linked" / "index.html")
        self.complains(2, "that of --json", "test", suite, "--json", self.path / "x", "--junit", self.path / "y" / ".." / "x")
        self.complains(2, "--junit", "merge", self.inputs / "part1", self.inputs / "part2", "-o", self.path / "x", "--report", out,
                       "--junit", out / "index.html")
        self.complains(2, "one text on standard output", "test", suite, "--json", "-", "--junit", "/dev/fd/1")
        self.assertIn(self.run_of(suite, "--json", "/dev/null", "--junit", "/dev/null").returncode, (0, 1))
        self.assertIn(self.run_of(suite, "--report", out, "--junit", out / "junit.xml", "--json", out / "result.json").returncode, (0, 1))
        self.assertTrue((out / "junit.xml").exists() and (out / "index.html").exists() and (out / "result.json").exists())

    def test_a_folder_of_somebody_stays_theirs(self):
        suite = self.inputs / "a.suite.json"
        site = self.path / "site"
        (site / "pictures").mkdir(parents=True)
        (site / "index.html").write_text("my page")
        (site / "pictures" / "cat-actual.png").write_bytes(b"a cat")
        for journal in (None, ""):
            if journal is not None:
                (site / "journal.jsonl").write_text(journal)
            self.complains(2, "expected a new folder or one with a report of texshot test", "test", suite, "--report", site)
            self.complains(1, "expected a new folder or one with a report of texshot conform", "conform", "--feature", "wrap",
                           "--scenes", "1", "-o", site)
        self.assertEqual((site / "index.html").read_text(), "my page")
        self.assertEqual((site / "pictures" / "cat-actual.png").read_bytes(), b"a cat")
        fresh = self.path / "fresh"
        fresh.mkdir()
        (fresh / "journal.jsonl").write_text("")  # left by a run that could not begin
        self.assertIn(self.run_of(suite, "--report", fresh).returncode, (0, 1))
        for _ in range(2):  # its own report is replaced
            self.succeeds("conform", "--feature", "wrap", "--scenes", "1", "-o", self.path / "report")


if __name__ == "__main__":
    unittest.main()
