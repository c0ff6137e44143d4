"""The files that pages are put together from are scripts, each for itself, and have what they are called for."""

import re
import unittest
from pathlib import Path

from canvas import Pages

PIECES = Path(__file__).parents[3] / "assets" / "programs"
# With a name as a function's body it is parsed and not run.
PARSE = "try { new Function(arguments[0]); return ''; } catch (error) { return String(error); }"
PAGE = ("handlers", "moving_frames", "still_frames", "start")  # which have no function of their name


class ScriptsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.pages = Pages()
        cls.addClassCleanup(cls.pages.quit)

    def parse(self, text):
        return self.pages.driver.execute_script(PARSE, text)

    def test_are_scripts(self):
        files = sorted(PIECES.glob("*.js"))
        self.assertGreater(len(files), 20)
        for file in files:
            with self.subTest(file.name):
                text = file.read_text()
                self.assertEqual(self.parse('"use strict";\n' + text), "")
                name = re.sub("_(.)", lambda found: found[1].upper(), file.stem)
                if file.stem not in PAGE:
                    self.assertRegex(text, rf"\A(// .*\n)*(function {name}\(|const {name} = )")

    def test_what_is_none_is_found(self):
        text = (PIECES / "halve.js").read_text()
        self.assertRegex(self.parse(text.replace("{width, height", "{width height")), "SyntaxError")


if __name__ == "__main__":
    unittest.main()
