"""The programs of every example, preset and step of a lesson draw what texshot draws: those of fixed function the same
pixels, those of GLSL within 1/255, the rounding of a component. Fixed or Glsl as the last word chooses one of them."""

import sys
import tempfile
import unittest
from pathlib import Path

from capture import Capture, Display
from proof import FIXED, GLSL, Proof
from scenes import Case, every_case, without_repeats

TEXSHOT, LIBRARY, KEEP = (sys.argv.pop(1) for _ in range(3))


class Programs:
    FLAVOUR = None

    @classmethod
    def setUpClass(cls):
        display = Display()
        cls.addClassCleanup(display.close)
        cls.capture = Capture(LIBRARY, display)

    def test_draws_what_texshot_draws(self):
        cases = without_repeats(TEXSHOT, every_case(TEXSHOT))
        self.assertGreater(len(cases), 100)
        for verdict in Proof(TEXSHOT, self.FLAVOUR, self.capture, KEEP).of_all(cases):
            with self.subTest(verdict.case.name):
                if verdict.wrong or verdict.refused:
                    self.fail(verdict.wrong or verdict.refused)

    def test_another_scene_differs(self):
        class OfAnotherScene(Proof):
            def emit(self, case, file):
                super().emit(case._replace(words=(*case.words, "--set", "light.diffuse=1,1,0.9,1")), file)

        with tempfile.TemporaryDirectory() as folder:
            verdict = OfAnotherScene(TEXSHOT, self.FLAVOUR, self.capture, folder).of(Case("start", ()))
            self.assertRegex(verdict.wrong, r"at 0 s \d+ of 307200 pixels .* at 1.75 s ")
            kept = sorted(file.name for file in (Path(folder) / self.FLAVOUR.name / "start").iterdir())
        self.assertEqual([name for name in kept if name.endswith((".c", ".png"))],
                         ["demo.c", "difference-0.png", "difference-1.75.png", "program-0.png", "program-1.75.png",
                          "texshot-0.png", "texshot-1.75.png"])


class Fixed(Programs, unittest.TestCase):
    FLAVOUR = FIXED


class Glsl(Programs, unittest.TestCase):
    FLAVOUR = GLSL


if __name__ == "__main__":
    unittest.main()
