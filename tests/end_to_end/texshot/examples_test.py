"""The examples of help, of the manual and of the documents. Each runs unchanged and shows its subject: pictures with a
content, which differ if a parameter takes several values; a pixel of a model; valid scenes."""

import io
import itertools
import json
import os
import re
import shlex
import subprocess
import tempfile
import unittest
from pathlib import Path

from PIL import Image, ImageChops, ImageSequence

from texshot import TEXSHOT, Texshot, document, texshot

ROOT = Path(__file__).resolve().parents[3]
DOCUMENTS = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").rglob("*.md"))]


def examples_of(text):
    """The lines under "Examples:" in a help text."""
    found = re.search(r"^Examples:\n((?:  .*\n)+)", text, re.MULTILINE)
    return [line[2:] for line in found[1].splitlines()] if found else []


def shows_something(picture):
    """Whether a picture, or each of an animation, has more than one colour."""
    return all(any(low != high for low, high in frame.convert("RGBA").getextrema()) for frame in ImageSequence.Iterator(picture))


def blocks_of(file, language):
    """The code blocks of a text, with the line before each."""
    return re.findall(rf"^([^\n]*)\n```{language}\n(.*?)^```", file.read_text(), re.MULTILINE | re.DOTALL)


class Examples(Texshot):
    def made(self, lines, folder):
        """Runs them one after the other, as a shell does, and checks what each leaves."""
        path = f"{Path(TEXSHOT).parent}:{os.environ['PATH']}"
        for line in lines:
            before = {each: each.stat().st_mtime_ns for each in Path(folder).rglob("*")}
            result = subprocess.run(["bash", "-ec", "set -o pipefail; " + line], cwd=folder, capture_output=True, text=True,
                                    timeout=300, env={**os.environ, "PATH": path})
            self.assertEqual((result.returncode, result.stderr), (0, ""), f"{line}\n{result.stdout[-500:]}")
            self.looked_at(line, folder, result.stdout,
                           [each for each in Path(folder).rglob("*") if before.get(each) != each.stat().st_mtime_ns])

    def looked_at(self, block, folder, said, written):
        for file in written:
            if file.suffix in (".png", ".gif", ".webp", ".bmp", ".tga") and "report" not in file.parts and "out" not in file.parts \
                    and not re.search("-(expected|difference)|handout|where", str(file)):
                with Image.open(file) as picture:
                    self.assertTrue(shows_something(picture), f"{file} shows nothing:\n{block}")
                    frames = [frame.convert("RGBA") for frame in ImageSequence.Iterator(picture)]
                    if len(frames) > 1:
                        self.assertTrue(all(a.tobytes() != b.tobytes() for a, b in itertools.pairwise(frames)),
                                        f"{file} does not move:\n{block}")
        for line in re.sub(r"\\\n\s*", "", block).splitlines():
            words = shlex.split(line, comments=True) if line.startswith("texshot ") else []
            if words[:2] == ["texshot", "probe"]:
                self.assertNotIn("shows the background", said, line)
                self.assertTrue("fragment" in said or "pixel" in said, line)
            if words[:2] == ["texshot", "shot"] and "--probe" in words:
                self.explains_a_model(words[1:], folder)
            if words[:2] in (["texshot", "sweep"], ["texshot", "shot"]) and "--axis" in words:
                self.cells_differ(words[1:], folder)

    def explains_a_model(self, words, folder):
        """The panel below the view shows another text than for a pixel without a model: all models are hidden."""
        panels = []
        for sight in ((), ("--set", "view.target=90,90,0")):
            result = texshot(*words[:words.index("-o")], *sight, "-o", "-", cwd=folder)
            self.assertEqual(result.returncode, 0, result.stderr)
            window = Image.open(io.BytesIO(result.stdout)).convert("RGB")
            panels.append(window.crop((window.width // 4, window.height * 2 // 3, window.width, window.height * 29 // 30)))
        self.assertTrue(panels[0].tobytes() != panels[1].tobytes(), f"nothing covers the pixel: {shlex.join(words)}")

    def cells_differ(self, words, folder):
        """The pictures of a sheet, or of a list: no two are equal."""
        call = ["shot"]
        rest = iter(words[1:])
        for word in rest:
            if word in ("-o", "--labels", "--difference", "--size"):
                next(rest)
            else:
                call.append(word)
        with tempfile.TemporaryDirectory() as cells:
            result = texshot(*call, "--size", "320x200", "-o", Path(cells) / "{number}.png", cwd=folder)
            self.assertEqual(result.returncode, 0, result.stderr)
            pictures = [Image.open(each).convert("RGB").tobytes() for each in sorted(Path(cells).iterdir())]
        self.assertGreater(len(pictures), 1)
        self.assertEqual(len(set(pictures)), len(pictures), f"some of the pictures are the same: {shlex.join(words)}")
        if "--difference" in words:
            self.differ_in_more_than_rounding(pictures, words)

    def differ_in_more_than_rounding(self, pictures, words):
        """Of the pixels that differ from the first picture's, hardly any does by a single 255th."""
        first, *others = (Image.frombytes("RGB", (320, 200), each) for each in pictures)
        for other in others:
            red, green, blue = ImageChops.difference(first, other).split()
            same, by_one, *more = ImageChops.lighter(ImageChops.lighter(red, green), blue).histogram()
            self.assertEqual(same + by_one + sum(more), 320 * 200)
            self.assertLess(by_one, 0.02 * sum(more), f"the noise of rounding is shown: {shlex.join(words)}")

    def commands(self):
        return re.findall(r"^  ([a-z]+)(?: |$)", self.succeeds("--help").decode(), re.MULTILINE)

    def test_every_command_has_examples_that_can_be_made(self):
        for command in self.commands():
            with self.subTest(command), tempfile.TemporaryDirectory() as folder:
                lines = examples_of(self.succeeds("help", command).decode())
                self.assertTrue(1 <= len(lines) <= 4, lines)
                self.assertTrue(any(re.search(rf"\btexshot {command}\b", line) for line in lines), lines)
                self.assertEqual([line for line in lines if len(line) > 78], [])
                self.made(lines, folder)

    def test_the_manual_has_them_letter_by_letter(self):
        for command in self.commands():
            page = self.succeeds("--manual", f"texshot-{command}")
            shown = subprocess.run(["groff", "-man", "-Tascii", "-P-cbou", "-rLL=2000n"], input=page, capture_output=True,
                                   timeout=60, check=True).stdout.decode()
            lines = [line.strip() for line in shown.splitlines()]
            for line in examples_of(self.succeeds("help", command).decode()):
                self.assertIn(line, lines)

    def prepare(self, folder):
        """The files that blocks of the documents find in the folder: pictures, and a suite with one wrong golden."""
        folder = Path(folder)
        shot = [TEXSHOT, "shot", "--size", "64x64", "-o"]
        for name in ("golden.png", "now.png", "clock.png", "golden/a.png", "actual/a.png"):
            subprocess.run([*shot, folder / name], check=True, timeout=60)
        (folder / "other.suite.json").write_text('{"suite": 1, "cases": [{"name": "cube", "scene": {"example": "cube"}, '
                                                 '"size": "64x64", "time": [0, 1], "golden": "suite/{case}.png"}]}')
        subprocess.run([TEXSHOT, "test", folder / "other.suite.json", "--update"], check=True, capture_output=True, timeout=120)
        (folder / "other.suite.json").rename(folder / "my.suite.json")
        listed = subprocess.run([TEXSHOT, "test", "--list", folder / "my.suite.json"], check=True, capture_output=True, timeout=60)
        (folder / "accept.txt").write_bytes(listed.stdout.splitlines()[0] + b"\n")

    def test_the_blocks_of_the_documents_run(self):
        blocks = [(file.name, *block) for file in DOCUMENTS for block in blocks_of(file, "sh")]
        self.assertGreater(len(blocks), 16)
        for name, before, block in blocks:
            with self.subTest(f"{name}: {block.splitlines()[0]}"), tempfile.TemporaryDirectory() as folder:
                self.assertEqual([line for line in block.splitlines() if len(line) > 80], [])
                if "./dev" in block:  # of the clone
                    continue
                self.assertEqual(before, "<!-- runs -->")
                if re.search(r"\bgolden\b|accept\.txt|--shard", block):
                    self.prepare(folder)
                self.made([block], folder)

    def test_scenes_suites_and_lessons_are_what_they_should_be(self):
        seen = []
        for file in DOCUMENTS:
            for _, block in blocks_of(file, "json"):
                document = json.loads(block)
                with self.subTest(f"{file.name}: {block[:80]}"), tempfile.TemporaryDirectory() as folder:
                    if "lesson" in document:
                        seen.append("lesson")
                        (Path(folder) / "lesson.json").write_text(block)
                        self.succeeds("lessons", "--check", folder)
                        continue
                    name = Path(folder) / ("s.suite.json" if "suite" in document else "scene.json")
                    name.write_text(block)
                    if "suite" in document:
                        seen.append("suite")
                        self.succeeds("scene", "-o", Path(folder) / "bricks.json")
                        self.succeeds("test", "--list", name)
                        continue
                    seen.append("scene")
                    self.succeeds("validate", name)
                    for path in {key["path"] for key in document.get("timeline", [])}:
                        values = {str(key["value"]) for key in document["timeline"] if key["path"] == path}
                        self.assertGreater(len(values), 1, f"{path} does not move")
                    times = ("--time", "0,2") if "timeline" in document else ("--time", "0")
                    self.succeeds("shot", name, "--size", "160x100", *times, "-o", Path(folder) / "{time}.png")
                    pictures = [Image.open(each).convert("RGB") for each in sorted(Path(folder).glob("*.png"))]
                    for picture in pictures:
                        self.assertTrue(shows_something(picture))
                    self.assertEqual(len({each.tobytes() for each in pictures}), len(pictures))
        self.assertEqual(sorted(set(seen)), ["lesson", "scene", "suite"])

    def test_the_programs_of_the_documents_are_compiled_where_the_library_is_installed(self):
        """tests/end_to_end/install_test.sh compiles and runs C++ and CMake, tests/web/page_test.py runs what is for a
        browser; there is no such test for other languages."""
        languages = {each for file in DOCUMENTS for each in re.findall(r"^ *```(\S+)$", file.read_text(), re.MULTILINE)}
        self.assertEqual(languages, {"sh", "json", "cpp", "cmake", "html", "js"})

    def test_an_example_of_the_program_is_a_scene(self):
        self.assertIn("teapot", self.succeeds("help", "shot").decode())
        scene = json.loads(self.succeeds("scene", "--example", "teapot", "--short"))
        self.assertEqual(scene["models"][0]["shape"], "teapot")
        call = ["--size", "32x32", "--renderer", "reference"]
        file = self.path / "teapot.json"
        self.succeeds("scene", "--example", "teapot", "-o", file)
        self.assertIsNone(self.difference(self.shot("--example", "teapot", *call), self.shot(file, *call)))
        changed = json.loads(self.succeeds("scene", "--example", "fog", "--set", "view.distance=9"))
        self.assertEqual(changed["view"]["distance"], 9)
        self.succeeds("shot", "--example", "teapot", *call, "-o", self.path / "{scene}.png")
        self.assertTrue((self.path / "teapot.png").exists())
        for command in ("check", "commands"):
            self.succeeds(command, "--example", "cube")

    def test_an_example_that_there_is_not(self):
        self.complains(2, '--example: there is no example "tepot"; did you mean "teapot"?', "scene", "--example", "tepot")
        self.complains(2, "--example: there is no example \"zzzzzzz\"", "scene", "--example", "zzzzzzz")
        self.complains(2, "exclude each other", "scene", "--example", "cube", "scene.json")
        self.complains(2, "exclude each other", "scene", "--example", "cube", "--lesson", "wrap")


if __name__ == "__main__":
    unittest.main()
