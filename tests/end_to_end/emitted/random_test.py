"""The programs and pages of random scenes. TEXPLORER_PROGRAMS sets their number, TEXPLORER_SEED the seed; ./dev soak
programs runs hundreds. Fixed, Glsl and Webgl as last words select among them."""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from canvas import Pages
from capture import Capture, Display
from proof import FIXED, GLSL, LAST_BITS, Proof
from scenes import Case
from web_proof import HEIGHT, WIDTH, PagesProof

TEXSHOT, SOAK, LIBRARY, JUDGE, KEEP = (sys.argv.pop(1) for _ in range(5))
COUNT = int(os.environ.get("TEXPLORER_PROGRAMS", "10"))
SEED = os.environ.get("TEXPLORER_SEED", "1")
TIMES = ("0", "0.4375", "1.75")  # most of their key frames are in the first second


class RandomScenes:
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = Path(folder.name)

    def cases(self, *kind):
        subprocess.run([SOAK, "write", str(self.path), "--count", str(COUNT), "--seed", SEED, *kind], check=True)
        numbers = sorted(int(file.stem.split("-")[1]) for file in self.path.glob("scene-*.json"))
        self.assertEqual(len(numbers), COUNT)
        files = [self.path / f"scene-{number}.json" for number in numbers]
        return [Case(file.stem, (str(file),), file) for file in files]

    def hold(self, proof, cases, least):
        """Checks that all pictures are right, and that at least this share of the scenes can be drawn."""
        verdicts = proof.of_all(cases)
        for verdict in verdicts:
            with self.subTest(verdict.case.name):
                if verdict.wrong:
                    self.fail(verdict.wrong)
        refused = [verdict.refused for verdict in verdicts if verdict.refused]
        self.assertLessEqual(len(refused), (1 - least) * COUNT, refused)

    def of_program(self, flavour, least):
        display = Display()
        self.addCleanup(display.close)
        # These scenes have extreme values: texture matrices that magnify the last bits.
        proof = Proof(TEXSHOT, flavour, Capture(LIBRARY, display), Path(KEEP) / "random", TIMES, 2 * LAST_BITS)
        self.hold(proof, self.cases("--tame"), least)


class Fixed(RandomScenes, unittest.TestCase):
    def test_draws_what_texshot_draws(self):
        self.of_program(FIXED, 0.5)


class Glsl(RandomScenes, unittest.TestCase):
    def test_draws_what_texshot_draws(self):
        self.of_program(GLSL, 0.5)


class Webgl(RandomScenes, unittest.TestCase):
    def test_draws_what_opengl_allows(self):
        browsers = [Pages(WIDTH, HEIGHT), Pages(WIDTH, HEIGHT)]
        for each in browsers:
            self.addCleanup(each.quit)
        self.hold(PagesProof(TEXSHOT, JUDGE, browsers, Path(KEEP) / "random"), self.cases("--comparable"), 0.2)


if __name__ == "__main__":
    unittest.main()
