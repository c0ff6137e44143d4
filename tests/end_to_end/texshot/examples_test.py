"""The examples of help: each can be made as it stands, and so can the manual's and the README's."""

import json
import os
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

from texshot import TEXSHOT, Texshot

README = Path(__file__).resolve().parents[3] / "README.md"


def examples_of(text):
    """The lines under "Examples:" in a help text."""
    found = re.search(r"^Examples:\n((?:  .*\n)+)", text, re.MULTILINE)
    return [line[2:] for line in found[1].splitlines()] if found else []


class Examples(Texshot):
    def made(self, lines, folder):
        """Makes them, one after the other, as a shell does."""
        path = f"{Path(TEXSHOT).parent}:{os.environ['PATH']}"
        for line in lines:
            result = subprocess.run(["bash", "-ec", "set -o pipefail; " + line], cwd=folder, capture_output=True, text=True,
                                    timeout=300, env={**os.environ, "PATH": path})
            self.assertEqual((result.returncode, result.stderr), (0, ""), f"{line}\n{result.stdout[-500:]}")

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

    def test_the_blocks_of_the_readme_can_be_made(self):
        blocks = re.findall(r"<!-- runs -->\n```sh\n(.*?)```", README.read_text(), re.DOTALL)
        self.assertGreater(len(blocks), 3)
        for block in blocks:
            self.assertEqual([line for line in block.splitlines() if len(line) > 80], [])
            with self.subTest(block.splitlines()[0]), tempfile.TemporaryDirectory() as folder:
                self.made([block], folder)

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
