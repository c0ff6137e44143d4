"""Whether programs that are wrong are found: the sample, with one fault after the other."""

import re
import sys
import tempfile
import unittest
from pathlib import Path

from capture import Capture, Display, ProgramError, compile_program, differing

LIBRARY = sys.argv.pop(1)
SAMPLE = Path(__file__).parent / "sample.c"
ORANGE, GREEN, BLUE = (255, 153, 0), (51, 255, 51), (0, 51, 102)


class CaptureTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.display = Display()
        cls.addClassCleanup(cls.display.close)

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = Path(folder.name)

    def run_sample(self, fault, times=(0, 1), **options):
        compile_program(SAMPLE, self.path / "sample", f"-DFAULT={fault}")
        return Capture(LIBRARY, self.display).run(self.path / "sample", self.path, times, **options)

    def complains(self, fault, expected, **options):
        with self.assertRaises(ProgramError) as raised:
            self.run_sample(fault, **options)
        self.assertRegex(str(raised.exception), expected)

    def test_shows_what_a_program_draws_at_each_time(self):
        first, second = self.run_sample("NONE")
        for picture in (first, second):
            self.assertEqual(picture.shape, (480, 640, 3))
            self.assertEqual(tuple(picture[240, 160]), ORANGE)
            self.assertEqual(tuple(picture[240, 480]), GREEN)
            self.assertEqual(tuple(picture[0, 0]), BLUE)
        # The green quad is 160 wide and 240 high, on its side 320 wide and 120 high; the other is 160 x 120.
        self.assertEqual((first == ORANGE).all(axis=2).sum(), 160 * 120)
        self.assertEqual((first == GREEN).all(axis=2).sum(), 160 * 240)
        self.assertEqual((second[240, 320:] == GREEN).all(axis=1).sum(), 320)
        self.assertEqual((second[:, 480] == GREEN).all(axis=1).sum(), 120)

    def test_the_top_row_comes_first(self):
        picture = self.run_sample("PIXEL", (0,))[0]
        self.assertEqual(tuple(picture[239, 160]), (255, 153, 51))

    def test_finds_one_pixel(self):
        self.assertEqual(differing(self.run_sample("NONE")[0], self.run_sample("PIXEL")[0]), 1)

    def test_finds_programs_that_fail(self):
        self.complains("CRASH", r"it ends with -6: ")
        self.complains("ENDS_AT_ONCE", r"it ends without picture.window")
        self.complains("FAILS_AT_THE_END", r"it ends with 3: ")
        self.complains("TALKS", r"it says: something is odd")
        self.complains("STAYS_OPEN", r"it ends with 70: capture: the program draws on when its window is to be closed")
        self.complains("NEVER_SWAPS", r"it is not through after 1 s, with 0 pictures", patience=1)

    def test_finds_errors_of_opengl(self):
        self.complains("WRONG_ENUM", re.compile(r"GL_INVALID_ENUM in glEnable.*glGetError says 0x0500 at the end of frame 0", re.DOTALL))

    def test_finds_a_second_frame_that_differs(self):
        self.complains("LEFTOVER", r"its second frame differs from the first in \d+ pixels")
        self.complains("ONLY_THE_WINDOW", r"its second frame differs from the first in \d+ pixels")

    def test_finds_warnings(self):
        source = self.path / "warns.c"
        command = "/* cc warns.c -o warns */\n"
        source.write_text(command + "int main(int count) { return 0; }\n")
        with self.assertRaisesRegex(ProgramError, "gcc says: (.|\n)*unused parameter"):
            compile_program(source, self.path / "warns")
        source.write_text(command + "int main(void) { int a = 1; if ((a == 2)) return 1; return 0; }\n")  # which GCC doesn't mind
        with self.assertRaisesRegex(ProgramError, "clang says: (.|\n)*extraneous parentheses"):
            compile_program(source, self.path / "warns")

    def test_compiles_by_the_command_in_the_program(self):
        source = self.path / "alone.c"
        for command, expected in (("", "no command"), ("/* cc alone.c */", "no command"), ("/* cc other.c -o alone */", "cc other.c -o alone"),
                                  ("/* cc alone.c -w -o alone */", "cc alone.c -w -o alone")):
            source.write_text(command + "\nint main(void) { return 0; }\n")
            with self.assertRaisesRegex(ProgramError, expected):
                compile_program(source, self.path / "alone")
        source.write_text("/* Alone.\n   cc alone.c -o alone -lm */\nint main(void) { return 0; }\n")
        compile_program(source, self.path / "alone")
        self.assertTrue((self.path / "alone").exists())


if __name__ == "__main__":
    unittest.main()
