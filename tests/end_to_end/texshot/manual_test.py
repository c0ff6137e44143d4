"""texshot --manual: every page exists, has all that --help has, and mandoc and groff find nothing wrong in it."""

import os
import re
import subprocess
import unittest
from pathlib import Path

from texshot import TEXSHOT, Texshot

TEXPLORER = Path(TEXSHOT).parent / "texplorer"
RELEASED = {**os.environ, "SOURCE_DATE_EPOCH": "1795392000"}


def run(*arguments, **options):
    return subprocess.run([*map(str, arguments)], capture_output=True, timeout=120, **options)


def written(program, page):
    result = run(program, "--manual", page, env=RELEASED)
    assert (result.returncode, result.stderr) == (0, b""), result
    return result.stdout


def shown(page):
    """As man shows it, in lines without an end."""
    result = run("groff", "-man", "-Tascii", "-P-cbou", "-rLL=2000n", "-rHY=0", input=page)
    return re.sub(r"[ \n]+", " ", result.stdout.decode())


class Manual(Texshot):
    def pages(self):
        for program in (TEXSHOT, TEXPLORER):
            names = run(program, "--manual", "list").stdout.decode().split()
            self.assertEqual(names[0], Path(program).name)
            for name in names:
                yield program, name, written(program, name)

    def test_every_command_has_a_page(self):
        names = {name for _, name, _ in self.pages()}
        listed = re.findall(r"^  ([a-z]+)(?: |$)", self.succeeds("--help").decode(), re.MULTILINE)
        self.assertEqual(names, {"texplorer", "texshot", *(f"texshot-{each}" for each in listed)})

    def test_a_page_has_what_help_has(self):
        for program, name, page in self.pages():
            with self.subTest(name):
                command = name.split("-")[1:]
                text = shown(page)
                said = re.sub(r"\s+", " ", run(program, *command, "--help").stdout.decode())
                self.assertIn(" ".join([Path(program).name, *command]), text)
                options = re.findall(r"(?<![\w-])--[a-z][a-z-]*", said)
                self.assertTrue(options)
                for option in options:
                    self.assertIn(option, text)
                # Whole sentences: all but what help puts together of names.
                for sentence in re.findall(r"[A-Z][^.:;\[\]|]{20,}\.(?= )", said):
                    self.assertIn(sentence, text)

    def test_mandoc_and_groff_find_nothing(self):
        for _, name, page in self.pages():
            with self.subTest(name):
                linted = run("mandoc", "-T", "lint", "-W", "style", input=page)
                problems = [each for each in linted.stdout.decode().splitlines()
                            if "referenced manual not found" not in each and "input text line longer than 80" not in each]
                self.assertEqual(problems, [])
                formatted = run("groff", "-man", "-Tutf8", "-ww", "-z", input=page)
                self.assertEqual((formatted.returncode, formatted.stderr), (0, b""))

    def test_the_date_is_that_of_the_release(self):
        for _, name, page in self.pages():
            self.assertRegex(page.decode().splitlines()[0], rf'\.TH {re.escape(name.upper().replace("-", chr(92) + "-"))} 1 2026-11-23 ')

    def test_wrong_calls(self):
        said = self.complains(2, "--manual: expected one of texshot, texshot-", "--manual", "texshot-nothing")
        self.assertIn('found "texshot-nothing"', said)
        self.complains(2, "--manual: expected a value, found none", "--manual")


if __name__ == "__main__":
    unittest.main()
