"""Whether pages that are wrong are found: the sample, with one fault after the other."""

import unittest
from pathlib import Path

from canvas import Pages
from capture import ProgramError

SAMPLE = Path(__file__).parent / "sample.html"
ORANGE, GREEN, BLUE = (255, 153, 0), (51, 255, 51), (0, 51, 102)


class Page:
    """The sample with a fault."""

    def __init__(self, fault):
        self.fault = fault

    def resolve(self):
        return self

    def as_uri(self):
        return SAMPLE.resolve().as_uri() + "?" + self.fault


class CanvasTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.pages = Pages()
        cls.addClassCleanup(cls.pages.quit)

    def complains(self, fault, expected):
        with self.assertRaisesRegex(ProgramError, expected):
            self.pages.run(Page(fault))

    def test_shows_what_a_page_draws_at_each_time(self):
        first, second = self.pages.run(Page(""), (0, 1))
        for picture in (first, second):
            self.assertEqual(picture.shape, (480, 640, 3))
            self.assertEqual(tuple(picture[240, 160]), ORANGE)
            self.assertEqual(tuple(picture[0, 0]), BLUE)
        self.assertEqual((first == ORANGE).all(axis=2).sum(), 160 * 120)
        self.assertEqual((first == GREEN).all(axis=2).sum(), 160 * 240)
        self.assertEqual((second[240, 320:] == GREEN).all(axis=1).sum(), 320)
        self.assertEqual((second[:, 480] == GREEN).all(axis=1).sum(), 120)

    def test_a_page_may_draw_once(self):
        first, second = self.pages.run(Page("once"), (0, 1))
        self.assertEqual(first.tobytes(), second.tobytes())
        self.assertEqual(tuple(first[240, 160]), ORANGE)

    def test_finds_pages_that_fail(self):
        self.complains("leftover", "its second frame differs from the first")
        self.complains("wrong-enum", "says 0x0500|INVALID_ENUM")
        self.complains("throws", "Cannot read properties of null")
        self.complains("alerts", "There is no picture")
        self.complains("talks", "something is odd")
        self.complains("old", "expected one canvas with WebGL 2, found 0")


if __name__ == "__main__":
    unittest.main()
