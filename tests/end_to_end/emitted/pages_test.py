"""The pages of every example, preset and step of a lesson that WebGL has words for draw what OpenGL allows: they are held
against the reference by the rules of texshot conform."""

import sys
import tempfile
import unittest
from pathlib import Path

import moving
from canvas import Pages
from scenes import every_case
from web_proof import HEIGHT, WIDTH, PagesProof

TEXSHOT, JUDGE, KEEP = (sys.argv.pop(1) for _ in range(3))


class PagesTest(unittest.TestCase):
    BROWSERS = 2

    @classmethod
    def setUpClass(cls):
        cls.browsers = []
        for _ in range(cls.BROWSERS):
            cls.browsers.append(Pages(WIDTH, HEIGHT))
            cls.addClassCleanup(cls.browsers[-1].quit)

    def test_draws_what_opengl_allows(self):
        with tempfile.TemporaryDirectory() as folder:
            verdicts = PagesProof(TEXSHOT, JUDGE, self.browsers, KEEP).of_all(every_case(TEXSHOT, folder))
        for verdict in verdicts:
            with self.subTest(verdict.case.name):
                if verdict.wrong:
                    self.fail(verdict.wrong)
        drawn = [verdict for verdict in verdicts if not verdict.refused]
        self.assertGreater(len(drawn), 100, [verdict.refused for verdict in verdicts])

    def test_moves_by_key_frames(self):
        with tempfile.TemporaryDirectory() as folder:
            proof = PagesProof(TEXSHOT, JUDGE, self.browsers, Path(KEEP) / "moving", moving.TIMES)
            verdicts = proof.of_all(moving.cases(TEXSHOT, Path(folder)))
        for verdict in verdicts:
            with self.subTest(verdict.case.name):
                self.assertEqual(verdict.wrong, "")
        drawn = [verdict for verdict in verdicts if not verdict.refused]
        self.assertGreater(len(drawn), 17, [verdict.refused for verdict in verdicts])


if __name__ == "__main__":
    unittest.main()
