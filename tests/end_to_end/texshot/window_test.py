"""texshot shot --ui: the window, panels and all."""

import unittest

from PIL import Image

from texshot import Texshot


class Window(Texshot):
    def test_the_window_is_drawn_with_its_panels(self):
        picture = self.shot("--ui", "--size", "1280x800").convert("RGB")
        self.assertEqual(picture.size, (1280, 800))
        left = picture.crop((0, 40, 300, 760))
        self.assertGreater(len(left.getcolors(300 * 720)), 20, "the left panel holds text, so it has many greys")

    def test_the_status_bar_says_what_is_pretended(self):
        plain = self.shot("--ui", "--size", "1280x800")
        pretending = self.shot("--ui", "--size", "1280x800", "--pretend", "no-rgtc")
        self.assertEqual(pretending.crop((0, 0, 1280, 770)).tobytes(), plain.crop((0, 0, 1280, 770)).tobytes())
        self.assertNotEqual(pretending.crop((0, 770, 1280, 800)).tobytes(), plain.crop((0, 770, 1280, 800)).tobytes())

    def test_names_of_files_are_shown_in_their_letters(self):
        panel = (0, 165, 310, 205)
        for language in ("en", "zh_CN"):
            seen = set()
            for name in ("纹理", "图像", "饕餮", "שלום", "????"):
                Image.new("RGB", (4, 4), (90, 120, 150)).save(self.path / f"{name}.png")
                window = self.shot("--ui", "--size", "1280x800", "--language", language,
                                   "--set", "textures[0].source=file",
                                   "--set", f"textures[0].file={self.path / name}.png")
                seen.add(window.crop(panel).tobytes())
            self.assertEqual(len(seen), 5, language)

    def test_each_tab_can_be_shown(self):
        dock = (321, 500, 1280, 770)
        above = (0, 0, 1280, 490)
        plain = self.shot("--ui", "--size", "1280x800")
        seen = {plain.crop(dock).tobytes()}
        for tab in ("vertices", "levels", "commands", "glsl", "file", "memory", "a-b", "history"):
            with self.subTest(tab):
                picture = self.shot("--ui", "--size", "1280x800", "--tab", tab)
                self.assertEqual(picture.crop(above).tobytes(), plain.crop(above).tobytes())
                seen.add(picture.crop(dock).tobytes())
        self.assertEqual(len(seen), 9)
        self.assertEqual(self.shot("--ui", "--tab", "explain").tobytes(), plain.tobytes())

    def test_the_window_shows_the_section_that_is_asked_for(self):
        rest = (316, 0, 1280, 800)
        plain = self.shot("--ui", "--size", "1280x800")
        seen = {plain.tobytes()}
        for section in ("coordinates", "pass", "light"):
            with self.subTest(section):
                picture = self.shot("--ui", "--size", "1280x800", "--section", section)
                self.assertEqual(picture.crop(rest).tobytes(), plain.crop(rest).tobytes())
                seen.add(picture.tobytes())
        self.assertEqual(len(seen), 4)

    def test_the_smallest_window_is_drawn(self):
        self.assertEqual(self.shot("--ui", "--size", "320x200").size, (320, 200))

    def test_the_window_shows_the_picture_of_each_renderer(self):
        scene = self.path / "scene.json"
        scene.write_text('{"version": 1, "view": {"azimuth": 33}}')  # a camera that the window need not fit
        place = (321, 64, 321 + 583, 64 + 402)
        for renderer in ("fixed", "shader", "reference"):
            with self.subTest(renderer):
                window = self.shot(scene, "--ui", "--renderer", renderer, "--size", "1280x800")
                alone = self.shot(scene, "--renderer", renderer, "--size", "583x402")
                self.assertIsNone(self.difference(window.crop(place), alone))

    def test_the_window_compares_renderers(self):
        scene = self.path / "scene.json"
        scene.write_text('{"version": 1, "view": {"azimuth": 33}}')
        window = self.shot(scene, "--ui", "--compare", "shader,reference", "--size", "1280x800")
        for renderer, place in [("shader", (330, 110, 600, 420)), ("reference", (630, 110, 900, 420))]:
            alone = self.shot(scene, "--renderer", renderer, "--size", "583x370")
            inside = tuple(value - (321, 64)[i % 2] for i, value in enumerate(place))
            left, top, right, bottom = self.difference(window.crop(place), alone.crop(inside)) or (0, 0, 0, 0)
            self.assertLess(max(right - left, bottom - top), 20, "no more than the ring around the worst pixel")
        three = self.shot(scene, "--ui", "--compare", "fixed,reference,shader", "--size", "1280x800")
        self.assertNotEqual(three.tobytes(), window.tobytes())

    def test_bad_comparisons_are_refused(self):
        for expected, value in [("expected one of fixed, shader, reference, found \"metal\"", "fixed,metal"),
                                ("two renderers or more, found one", "fixed"),
                                ("expected one of fixed, shader, reference, found \"\"", "fixed,shader,"),
                                ("expected one of fixed, shader, reference, found \"\"", ",fixed"),
                                ("found \"shader\" twice", "shader,shader")]:
            with self.subTest(value):
                self.complains(2, expected, "shot", "--ui", "--compare", value, "-o", self.path / "out.png")
        self.complains(2, "--compare", "shot", "--compare", "fixed,shader", "-o", self.path / "out.png")

    def test_a_lessons_window_has_what_the_call_changes(self):
        step = ("--ui", "--size", "1280x800", "--lesson", "filters", "--step", "2")
        plain = self.shot(*step)
        parameters, picture = (0, 60, 315, 770), (330, 110, 900, 450)
        nearest = self.shot(*step, "--set", "textures[0].magFilter=GL_NEAREST", "--set", "textures[0].minFilter=GL_NEAREST",
                            "--set", "view.azimuth=77")
        self.assertIsNotNone(self.difference(nearest.crop(picture), plain.crop(picture)))
        for change in (["--renderer", "reference"], ["--tab", "memory"], ["--probe", "120,180"], ["--preset", "alpha-test"],
                       ["--show", "lambda"]):
            with self.subTest(change):
                self.assertIsNotNone(self.difference(self.shot(*step, *change), plain))
        reached = ("--ui", "--size", "1280x800", "--lesson", "wrap", "--step", "5")
        self.assertIsNotNone(self.difference(self.shot(*reached, "--answer", "1").crop(picture),
                                             self.shot(*reached, "--answer", "2").crop(picture)))

    def test_the_window_explains_the_pixel_that_it_is_asked_for(self):
        window = ("--ui", "--size", "1280x800", "--tab", "explain")
        without = self.shot(*window)
        probed = self.shot(*window, "--probe", "120,180")
        self.assertIsNotNone(self.difference(without, probed))
        self.assertEqual(probed.tobytes(), self.shot(*window, "--probe", "120,180").tobytes())
        out = self.path / "out.png"
        self.complains(2, "and none at 5000,10", "shot", *window, "--probe", "5000,10", "-o", out)
        self.complains(2, "--probe: expected X,Y, found \"here\"", "shot", *window, "--probe", "here", "-o", out)
        self.complains(2, "--probe", "shot", "--probe", "1,1", "-o", out)


if __name__ == "__main__":
    unittest.main()
