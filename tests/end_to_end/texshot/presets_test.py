"""texshot presets, and --preset of every command that takes a scene."""

import io
import unittest

from PIL import Image
from texshot import Texshot, results, texshot


class Presets(Texshot):
    MISTAKES = {  # that these presets show
        "slanted": {"upload-rows"},
        "swapped-colours": {"upload-pixels"},
        "wrong-format": {"format-refused"},
        "no-levels": {"incomplete"},
        "wrong-unit": {"no-tex-coord"},
    }

    def names(self):
        return [each["name"] for each in results(self.succeeds("presets", "--json"))]

    def background(self, *arguments):
        """The share of the pixels that have the background's colour."""
        png = self.succeeds("shot", "--renderer", "reference", "--size", "96x96", "-o", "-", *arguments)
        colors = Image.open(io.BytesIO(png)).convert("RGB").getcolors(96 * 96)
        return sum(count for count, color in colors if color == (28, 33, 41)) / 96 ** 2

    def test_each_is_listed_with_what_it_sets_and_what_there_is_to_see(self):
        text = self.succeeds("presets").decode()
        for name in self.names():
            self.assertIn(f"  {name}: ", text)
        self.assertIn("Alpha test > 0.5", text)

    def test_a_preset_is_drawn(self):
        self.assertGreater(self.background("--preset", "alpha-test"), self.background() + 0.03)

    def test_each_leaves_a_scene_in_which_nothing_is_wrong(self):
        for name in self.names():
            with self.subTest(name=name):
                if name not in self.MISTAKES:
                    self.succeeds("check", "--preset", name)

    def test_mistakes_are_what_the_check_finds(self):
        for name, rules in self.MISTAKES.items():
            with self.subTest(name=name):
                found = texshot("check", "--json", "--preset", name)
                self.assertEqual(found.returncode, 1)
                wrong = {each["rule"] for each in results(found.stdout) if each["severity"] != "hint"}
                self.assertEqual(wrong, rules)

    def test_several_follow_one_another_and_what_is_set(self):
        seam = self.succeeds("shot", "--renderer", "reference", "--size", "96x96", "-o", "-", "--preset", "seam")
        cured = self.succeeds("shot", "--renderer", "reference", "--size", "96x96", "-o", "-", "--preset", "seam",
                              "--preset", "seam-cure")
        self.assertNotEqual(seam, cured)

    def test_one_that_there_is_not_is_a_wrong_call(self):
        self.complains(2, "expected one of shimmer, ", "check", "--preset", "nothing")


if __name__ == "__main__":
    unittest.main()
