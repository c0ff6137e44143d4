"""The pages of examples, presets and steps of lessons that WebGL can draw show what OpenGL allows: they are compared with the
reference by the rules of texshot conform. scenes.py chooses them."""

import sys
import tempfile
import unittest
from pathlib import Path

import moving
from canvas import Pages
from scenes import Case, chosen, every_case, written
from web_proof import HEIGHT, WIDTH, PagesProof

TEXSHOT, JUDGE, KEEP = (sys.argv.pop(1) for _ in range(3))

START = ()
LEVELS = ("--example", "levels")
ANISOTROPY = ("--preset", "anisotropy")
BORDER = ("--lesson", "wrap", "--step", "7")
FAULTS = (  # what of the page of which scene becomes what
    ("another colour", START, "checkerboard(64, 8, 255, 255, 255)", "checkerboard(64, 8, 255, 250, 255)"),
    ("another board", START, "checkerboard(64, 8, 255, 255, 255)", "checkerboard(64, 4, 255, 255, 255)"),
    ("another view", START, "rotation(-azimuth,", "rotation(0.5 - azimuth,"),
    ("one level", START, "gl.LINEAR_MIPMAP_LINEAR", "gl.LINEAR"),
    ("darker levels", START, "(sum + 2) >> 2", "(sum - 16) >> 2"),
    ("levels that aren't blended", LEVELS, "gl.LINEAR_MIPMAP_LINEAR", "gl.LINEAR_MIPMAP_NEAREST"),
    ("levels too small", LEVELS, "textureProj(texture0, texCoord0)", "textureProj(texture0, texCoord0, 0.125)"),
    ("levels too large", LEVELS, "textureProj(texture0, texCoord0)", "textureProj(texture0, texCoord0, -0.125)"),
    ("a wrong level", LEVELS, "gl.UNSIGNED_BYTE, texels3)", "gl.UNSIGNED_BYTE, texels3.fill(128))"),
    ("no anisotropy", ANISOTROPY, "anisotropic.TEXTURE_MAX_ANISOTROPY_EXT, ", "anisotropic.TEXTURE_MAX_ANISOTROPY_EXT, 1 / "),
    ("no border", BORDER, "bvec2(true, true)", "bvec2(true, false)"),
    ("an error", START, "init();", "init(0..nothing());"),
)


class BrokenPages(PagesProof):
    """Pages with something in them replaced."""

    def emit(self, case, file):
        name, _, what, by = next(fault for fault in FAULTS if fault[0] == case.name)
        super().emit(case, file)
        text = file.read_text()
        if what not in text:
            raise LookupError(f"{name}: there is no {what} in the page")
        file.write_text(text.replace(what, by))


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
            verdicts = PagesProof(TEXSHOT, JUDGE, self.browsers, KEEP).of_all(chosen(every_case(TEXSHOT, folder)))
        for verdict in verdicts:
            with self.subTest(verdict.case.name):
                if verdict.wrong:
                    self.fail(verdict.wrong)
        refused = [verdict.refused for verdict in verdicts if verdict.refused]
        self.assertLessEqual(len(refused), 11, refused)

    def test_finds_what_is_wrong(self):
        with tempfile.TemporaryDirectory() as folder:
            cases = [Case(name, words, Path(folder) / f"{name}.json") for name, words, _, _ in FAULTS]
            for case in cases:
                written(TEXSHOT, case)
            verdicts = BrokenPages(TEXSHOT, JUDGE, self.browsers, KEEP + "/broken").of_all(cases)
        for verdict in verdicts:
            with self.subTest(verdict.case.name):
                self.assertRegex(verdict.wrong, "pixels differ|it fails")

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
