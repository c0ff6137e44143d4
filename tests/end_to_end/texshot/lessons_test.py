"""texshot lessons, and --lesson of the commands that take a scene."""

import io
import json
import os
import pathlib
import subprocess
import unittest

from PIL import Image, ImageChops
from texshot import Texshot, bmp, problem, results, single, texshot

STEP = {"title": "S", "text": "T", "scene": "cube"}
SMALL = {"lesson": 1, "title": "Small", "about": "A", "steps": [STEP]}


def predicting(*answers, **more):
    return {**STEP, "predict": {"question": "Q", "answers": answers, "right": 0, "reason": "R", **more}}


class Lessons(Texshot):
    def lesson(self, *steps, text=None):
        """A lesson's folder."""
        folder = self.path / "mine"
        folder.mkdir(exist_ok=True)
        (folder / "lesson.json").write_text(text if text is not None else json.dumps({**SMALL, "steps": steps or [STEP]}))
        return folder

    def small(self, *arguments):
        png = self.succeeds("shot", "--renderer", "reference", "--size", "96x72", "-o", "-", *arguments)
        return Image.open(io.BytesIO(png)).convert("RGB")


class Listing(Lessons):
    def test_each_is_listed_with_its_steps(self):
        text = self.succeeds("lessons").decode()
        lessons = results(self.succeeds("lessons", "--json"))
        self.assertEqual(lessons[0]["name"], "first-texture")
        self.assertGreaterEqual(len(lessons), 12)
        self.assertGreaterEqual(sum(len(each["steps"]) for each in lessons), 60)
        for each in lessons:
            self.assertIn(f"{each['name']}: {each['title']}\n", text)
            for step in each["steps"]:
                self.assertIn(f"{step['title']} ({step['task']})", text)
                self.assertIn(step["task"], ("read", "try", "predict", "match"))
            self.assertIn("predict", [step["task"] for step in each["steps"]])


class Checking(Lessons):
    def says(self, folder, *expected):
        """Every mistake has its own sentence, with its file and position."""
        said = self.complains(1, expected[0], "lessons", "--check", folder)
        for each in expected:
            self.assertIn(each, said)
        self.assertIn("lesson.json", said)

    def test_a_good_one(self):
        folder = self.lesson()
        self.assertEqual(self.succeeds("lessons", "--check", folder).decode(),
                         f"{folder}/lesson.json: 1 step, nothing is wrong\n")

    def test_json_names_each_mistake(self):
        folder = self.lesson()
        told = single(self.succeeds("lessons", "--check", folder, "--json"))
        self.assertEqual(told, {"file": f"{folder}/lesson.json", "steps": 1})
        result = texshot("lessons", "--check", self.lesson(text='{"lesson": 1,\n'), "--json")
        self.assertEqual((result.returncode, result.stderr.count(b"\n")), (1, 1))
        self.assertEqual(result.stderr.decode(), f"texshot: {problem(result.stdout)}\n")

    def test_a_template_has_every_text_for_gettext(self):
        folder = self.lesson({**STEP, "text": "Two {color}s.\nSay \"s\\t\".", "scene": "checker", "look": {"probe": [490, 480]}})
        template = self.succeeds("lessons", "--template", folder)
        made = subprocess.run(["msgen", "-"], input=template, capture_output=True)
        self.assertEqual((made.returncode, made.stderr), (0, b""))
        (folder / "ru.po").write_bytes(made.stdout.replace(b"Language: ", b"Language: ru"))
        self.succeeds("lessons", "--check", folder)
        self.assertIn(b"python-brace-format", template)
        self.complains(2, "expected one of --check, --page and --template", "lessons", "--template", folder, "--check", folder)
        self.complains(1, "lesson.json", "lessons", "--template", self.path / "nowhere")

    def test_what_is_no_lesson(self):
        self.complains(1, "lesson.json", "lessons", "--check", self.path)
        self.complains(1, "lesson.json", "lessons", "--check", self.path / "nowhere")
        self.says(self.lesson(text='{"lesson": 1,\n'), "line 2")
        self.says(self.lesson(text='{"lesson": 1e400}'), "number")
        self.says(self.lesson(text='{"lesson": 7, "title": "L"}'), "/lesson", "found 7")

    def test_what_is_wrong_in_a_step(self):
        for step, *expected in [
                ({**STEP, "titel": "x"}, "/steps/0/titel", 'did you mean "title"?'),
                (predicting(), "/steps/0/predict/answers", "expected a list of 2 to 4, found 0"),
                (predicting({"text": "one"}, {"text": "two"}, right=2), "/steps/0/predict/right"),
                (predicting({"text": "one"}, {"text": "two"}, reason="{colour}"), "/steps/0/predict/reason"),
                (predicting({"text": "one", "edits": ["no=1"]}, {"text": "two"}), "/steps/0/predict/answers/0/edits/0"),
                ({**STEP, "scene": "nothing"}, "/steps/0/scene"),
                ({**STEP, "scene": "../mine/lesson.json"}, "/steps/0/scene"),
                ({**STEP, "look": {"tab": "explian"}}, "/steps/0/look/tab", "explain"),
                ({**STEP, "match": {"task": "M", "edits": ["textures[0].priority=0.5"]}}, "/steps/0/match"),
        ]:
            with self.subTest(step=step):
                self.says(self.lesson(step), *expected)

    def test_numbers_and_marks(self):
        """Values that depend on the picture's size, and values without a number."""
        probed = single(self.succeeds("probe", "--example", "checker", "--at", "156,115", "--size", "320x240", "--json"))
        rho = f"{probed['fragments'][-1]['units'][0]['sample']['lod']['rho']:.2f}"
        mark = {"look": {"probe": [490, 480]}}
        for step, *expected in [
                ({**STEP, **mark, "scene": "checker", "text": f"Rho is {rho}."}, "/steps/0/text", f"{rho} is {{", "expected the word"),
                ({**STEP, "text": "It is {color}."}, "/steps/0/text", "{color}", "probe"),
                ({**STEP, "look": {"probe": [1, 1]}}, "/steps/0/look/probe", "nothing is drawn"),
                ({**STEP, **mark, "scene": "checker", "text": "{texel}", "edits": ["passes[0].units[0].enabled=false"]},
                 "/steps/0/text", "{texel} has no number"),
                ({**STEP, "fallback": {"text": "F", "edits": ["view.distance=9"]}}, "/steps/0/fallback", "it is not needed"),
        ]:
            with self.subTest(step=step):
                self.says(self.lesson(step), *expected)
        self.succeeds("lessons", "--check", self.lesson({**STEP, **mark, "scene": "checker", "text": "Rho is {rho}."}))

    def test_translations_are_those_of_the_texts(self):
        folder = self.lesson({**STEP, "text": "Two {color}s.", "scene": "checker", "look": {"probe": [490, 480]}})

        def catalogue(**texts):
            entries = {"Small": "Klein", "A": "Ein", "S": "Schritt", "Two {color}s.": "Zwei {color}.", **texts}
            (folder / "ru.po").write_text("".join(f'msgid "{key}"\nmsgstr "{text}"\n\n' for key, text in entries.items()))

        catalogue()
        self.succeeds("lessons", "--check", folder)
        catalogue(Old="Alt")
        self.says(folder, "ru.po", "no longer has the text \"Old\"")
        catalogue(Small="")
        self.says(folder, "ru.po", "expected a translation of \"Small\"")
        catalogue(**{"Two {color}s.": "Zwei."})
        self.says(folder, "ru.po", "expected a translation with")

    def test_a_broken_scene_is_named_itself(self):
        folder = self.lesson({**STEP, "scene": "scene.json"})
        (folder / "scene.json").write_text('{"view": {"distanc": 1}}')
        place = f"{folder}/lesson.json: /steps/0/scene: {folder}/scene.json: /view/distanc: unknown key"
        self.says(folder, place)
        self.complains(1, place, "scene", "--lesson", folder, "--step", "1")

    def test_a_picture_that_is_missing_or_lies_elsewhere(self):
        folder = self.lesson({**STEP, "scene": "scene.json"})
        (self.path / "outside.bmp").write_bytes(bmp(2, 2, lambda x, y: (255, 0, 0)))
        (folder / "link.bmp").symlink_to("../outside.bmp")
        for file in ("missing.bmp", "../outside.bmp", "link.bmp"):
            with self.subTest(file=file):
                (folder / "scene.json").write_text(json.dumps({"textures": [{"source": "file", "file": file}]}))
                self.says(folder, "/steps/0/scene", file)
        (folder / "missing.bmp").write_bytes(bmp(2, 2, lambda x, y: (255, 0, 0)))
        (folder / "scene.json").write_text(json.dumps({"textures": [{"source": "file", "file": "missing.bmp"}]}))
        self.succeeds("lessons", "--check", folder)

    def test_a_lesson_that_is_a_link_out_of_its_folder(self):
        folder = self.lesson()
        os.rename(folder / "lesson.json", self.path / "lesson.json")
        (folder / "lesson.json").symlink_to("../lesson.json")
        self.says(folder, "the lesson's folder")

    def test_ten_thousand_other_files(self):
        folder = self.lesson()
        for number in range(10_000):
            (folder / f"{number}.txt").touch()
        self.succeeds("lessons", "--check", folder)

    def test_wrong_calls(self):
        self.complains(2, "--check", "lessons", "--check")
        self.complains(2, "--json and --page exclude each other", "lessons", "--page", self.path / "page", "--json")


class Files(Lessons):
    """The images of the program's lessons, as Pillow reads them."""
    FOLDER = pathlib.Path(__file__).parents[3] / "assets/lessons"

    def shown(self, name):
        return Image.open(io.BytesIO(self.succeeds("convert", self.FOLDER / name, "-", "--lossy", "--quiet"))).convert("RGBA")

    def test_they_are_what_another_decoder_says(self):
        files = sorted(path.relative_to(self.FOLDER) for kind in ("tga", "dds") for path in self.FOLDER.glob(f"*/*.{kind}"))
        self.assertGreaterEqual(len(files), 9)
        for name in files:
            with self.subTest(name=str(name)):
                self.assertLess((self.FOLDER / name).stat().st_size, 40_000)
                theirs = Image.open(self.FOLDER / name).convert("RGBA")
                worst = max(high for _, high in ImageChops.difference(self.shown(name), theirs).getextrema())
                self.assertLessEqual(worst, 2, "DXT's thirds may be rounded either way")

    def test_the_tutorials_fields_are_0(self):
        file = (self.FOLDER / "textured-cube/uv.bmp").read_bytes()
        self.assertEqual((file[:2], file[10:14], file[34:38]), (b"BM", bytes(4), bytes(4)))
        self.assertEqual(len(file), 54 + 96 * 96 * 3)

    def test_a_lesson_has_them_without_its_folder(self):
        embedded = self.small("--lesson", "dds", "--step", "2")
        self.assertIsNone(self.difference(embedded, self.small("--lesson", self.FOLDER / "dds", "--step", "2")))


class Drawing(Lessons):
    MATCH = {**STEP, "match": {"task": "M", "edits": ["view.background=1,0,0,1"]}}
    PREDICT = predicting({"text": "one", "edits": ["view.background=0,1,0,1"]},
                         {"text": "two", "edits": ["view.background=0,0,1,1"]})

    def corner(self, *arguments):
        return self.small(*arguments).getpixel((0, 0))

    def test_a_step_is_drawn_as_its_scene_is(self):
        folder = self.lesson({**STEP, "edits": ["view.background=1,1,0,1"]}, {"title": "S", "text": "T"})
        self.assertEqual(self.corner("--lesson", folder), (255, 255, 0))
        self.assertEqual(self.corner("--lesson", folder, "--step", "2"), (255, 255, 0))
        self.assertEqual(self.corner("--lesson", folder, "--set", "view.background=0,1,1,1"), (0, 255, 255))

    def test_answers_and_the_picture_to_reach(self):
        folder = self.lesson(self.MATCH, self.PREDICT)
        self.assertEqual(self.corner("--lesson", folder, "--step", "1", "--reached"), (255, 0, 0))
        self.assertEqual(self.corner("--lesson", folder, "--step", "2", "--answer", "1"), (0, 255, 0))
        self.assertEqual(self.corner("--lesson", folder, "--step", "2", "--answer", "2"), (0, 0, 255))

    def test_the_programs_own_go_by_name(self):
        start = self.small("--lesson", "wrap", "--step", "3")
        reached = self.small("--lesson", "wrap", "--step", "3", "--reached")
        self.assertIsNotNone(self.difference(start, reached))
        self.succeeds("check", "--lesson", "wrap")
        self.assertIn(b"pixel", self.succeeds("probe", "--lesson", "wrap", "--at", "10,10").lower())

    def test_one_unit_is_fallen_back_on(self):
        """NeHe 22: units > 1 ? two : one. Step 8 draws with one unit on every driver."""
        wanted = self.shot("--lesson", "bumps", "--step", "8", "--size", "320x240")
        for pretence in "units=1", "no-multitexture":
            result = texshot("shot", "--lesson", "bumps", "--pretend", pretence, "--size", "320x240", "-o", "-")
            self.assertEqual(result.returncode, 0)
            self.assertIn(b"three passes draw the cube instead of two", result.stderr)
            self.assertNotIn(b"unit 1", result.stderr)
            self.assertIsNone(self.difference(wanted, Image.open(io.BytesIO(result.stdout)).convert("RGBA")))
        two = self.shot("--lesson", "bumps", "--size", "320x240")
        self.assertIsNotNone(self.difference(wanted, two), "the plate of multitexturing, at least")

    def test_wrong_calls(self):
        folder = self.lesson(self.MATCH, self.PREDICT)
        for expected, *arguments in [
                ("expected one of first-texture, ", "--lesson", "nothing"),
                ('--lesson: there is no lesson "warp"; did you mean "wrap"?', "--lesson", "warp"),
                ("a step from 1 to 2, found 3", "--lesson", folder, "--step", "3"),
                ("--step", "--lesson", folder, "--step", "0"),
                ("no picture to reach", "--lesson", folder, "--step", "2", "--reached"),
                ("no answers", "--lesson", folder, "--step", "1", "--answer", "1"),
                ("2 answers", "--lesson", folder, "--step", "2", "--answer", "3"),
                ("--lesson", "--step", "2"),
                ("--lesson", "--answer", "2"),
                ("--lesson", "--lesson", folder, "scene.json"),
                ("--answer", "--lesson", folder, "--answer", "1", "--reached"),
        ]:
            with self.subTest(arguments=arguments):
                self.complains(2, expected, "shot", "-o", self.path / "out.png", *arguments)

    def test_a_broken_one_fails(self):
        self.complains(1, "/steps", "shot", "--lesson", self.lesson(text=json.dumps({**SMALL, "steps": []})),
                       "-o", self.path / "out.png")
        self.complains(1, "/steps/0/scene", "shot", "--lesson", self.lesson({**STEP, "scene": "no"}),
                       "-o", self.path / "out.png")

    def test_the_window_shows_the_step(self):
        plain = self.shot("--ui", "--size", "1280x800")
        first = self.shot("--ui", "--size", "1280x800", "--lesson", "wrap")
        second = self.shot("--ui", "--size", "1280x800", "--lesson", "wrap", "--step", "2")
        self.assertIsNotNone(self.difference(plain, first))
        self.assertIsNotNone(self.difference(first, second))
        russian = self.shot("--ui", "--size", "1280x800", "--lesson", "wrap", "--language", "ru")
        self.assertIsNotNone(self.difference(first, russian))


if __name__ == "__main__":
    unittest.main()
