"""The programs of random scenes. TEXPLORER_PROGRAMS sets their number, TEXPLORER_SEED the seed; ./dev soak programs runs
hundreds. Fixed and Glsl as last words choose among them."""

import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from capture import Capture, Display
from proof import FIXED, GLSL, LAST_BITS, Proof
from scenes import Case

TEXSHOT, SOAK, LIBRARY, KEEP = (sys.argv.pop(1) for _ in range(4))
COUNT = int(os.environ.get("TEXPLORER_PROGRAMS", "10"))
SEED = os.environ.get("TEXPLORER_SEED", "1")
TIMES = ("0", "0.4375", "1.75")  # most of their key frames are in the first second


def options_for(file):
    """Programs without GLU draw the same pixels. But only the driver makes the levels that it makes."""
    made_by_calls = ("glGenerateMipmap", "GL_GENERATE_MIPMAP", "gluBuild2DMipmaps")
    textures = json.loads(file.read_text()).get("textures", [])
    return () if any(each.get("mipmaps") in made_by_calls for each in textures) else ("--self-contained",)


class RandomScenes:
    FLAVOUR = None

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = Path(folder.name)

    def cases(self):
        subprocess.run([SOAK, "write", str(self.path), "--count", str(COUNT), "--seed", SEED, "--tame"], check=True)
        numbers = sorted(int(file.stem.split("-")[1]) for file in self.path.glob("scene-*.json"))
        self.assertEqual(len(numbers), COUNT)
        files = [self.path / f"scene-{number}.json" for number in numbers]
        return [Case(file.stem, (str(file), *options_for(file)), file) for file in files]

    def test_draws_what_texshot_draws(self):
        """All pictures are right, and at least half of the scenes can be drawn."""
        display = Display()
        self.addCleanup(display.close)
        # These scenes have extreme values: texture matrices that magnify the last bits.
        proof = Proof(TEXSHOT, self.FLAVOUR, Capture(LIBRARY, display), Path(KEEP) / "random", TIMES, 2 * LAST_BITS)
        verdicts = proof.of_all(self.cases())
        for verdict in verdicts:
            with self.subTest(verdict.case.name):
                if verdict.wrong:
                    self.fail(verdict.wrong)
        refused = [verdict.refused for verdict in verdicts if verdict.refused]
        self.assertLessEqual(len(refused), COUNT / 2, refused)


class Fixed(RandomScenes, unittest.TestCase):
    FLAVOUR = FIXED


class Glsl(RandomScenes, unittest.TestCase):
    FLAVOUR = GLSL


if __name__ == "__main__":
    unittest.main()
