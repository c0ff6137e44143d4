"""Compiles the programs of the lesson page in their folder, so that those that read image files find them."""

import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy
from PIL import Image

from capture import DRIVER, Capture, Display, compile_program, differing

TEXSHOT, LIBRARY = (sys.argv.pop(1) for _ in range(2))


def texshot(*words, cwd):
    subprocess.run([os.path.abspath(TEXSHOT), *map(str, words)], cwd=cwd, env={**os.environ, **DRIVER}, check=True, capture_output=True)


class Handout(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        display = Display()
        cls.addClassCleanup(display.close)
        cls.capture = Capture(LIBRARY, display)

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = Path(folder.name)

    def draws(self, program, lesson, step, renderer, bound):
        compile_program(program, self.path / "program")
        (drawn,) = self.capture.run(self.path / "program", program.parent)
        height, width, _ = drawn.shape
        texshot("shot", "--lesson", lesson, "--step", step, "--renderer", renderer, "--size", f"{width}x{height}", "-o", "shot.png",
                cwd=self.path)
        expected = numpy.asarray(Image.open(self.path / "shot.png").convert("RGB"))
        self.assertEqual(differing(drawn, expected, bound), 0)

    def test_programs_that_read_files(self):
        texshot("lessons", "--page", "page", "--lesson", "textured-cube", "--lesson", "dds", cwd=self.path)
        readers = set()
        for program in sorted((self.path / "page/programs").glob("*/*.c")):
            calls = set(re.findall(r"\n +(read\w+)\(\"", program.read_text()))
            if not calls:
                continue
            readers |= calls
            lesson, step, glsl = re.fullmatch(r"(.*)-(\d+)(-glsl)?", program.stem).groups()
            with self.subTest(program.name):
                self.draws(program, lesson, step, *(("shader", 1) if glsl else ("fixed", 0)))
        self.assertEqual(readers, {"readBmp", "readTga", "readDds"})


if __name__ == "__main__":
    unittest.main()
