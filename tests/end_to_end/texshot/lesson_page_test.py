"""texshot lessons --page: the lessons as a page, with their pictures beside it."""

import html.parser
import json
import unittest

from PIL import Image
from texshot import Texshot

LESSON = {"lesson": 1, "title": "Mine & <yours>", "about": "\"Quoted\".", "steps": [
    {"title": "One", "text": "A < B.", "scene": "cube", "look": {"probe": [500, 250]},
     "predict": {"question": "Which?", "right": 1, "reason": "The colour is {color}.", "answers": [
         {"text": "This.", "edits": ["textures[0].wrapS=GL_CLAMP", "textures[0].pattern=gradient"]},
         {"text": "That.", "edits": ["textures[0].magFilter=GL_NEAREST", "textures[0].pattern=brick"]}]}},
    {"title": "Two", "text": "Text.", "match": {"task": "Reach it.", "edits": ["textures[0].pattern=gradient"]}}]}


class Page(html.parser.HTMLParser):
    """What is in a page: balanced elements, images, links and what they lead to."""

    VOID = {"meta", "img", "br", "link"}

    def __init__(self, text):
        super().__init__()
        self.open, self.tags, self.images, self.links, self.ids, self.language = [], [], [], [], set(), None
        self.feed(text)
        self.close()
        assert not self.open, self.open

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.tags.append(tag)
        if tag not in self.VOID:
            self.open.append(tag)
        if tag == "html":
            self.language = attributes["lang"]
        if tag == "img":
            self.images.append(attributes)
        if tag == "a":
            self.links.append(attributes["href"])
        if "id" in attributes:
            assert attributes["id"] not in self.ids
            self.ids.add(attributes["id"])

    def handle_endtag(self, tag):
        assert self.open.pop() == tag, tag


class LessonPage(Texshot):
    def page(self, *arguments):
        self.assertEqual(self.succeeds("lessons", "--page", self.path / "out", *arguments), b"")
        return (self.path / "out" / "index.html").read_text()

    def folder_of(self, lesson):
        folder = self.path / "mine"
        folder.mkdir()
        (folder / "lesson.json").write_text(json.dumps(lesson))
        return folder

    def test_every_step_has_its_pictures_and_nothing_runs(self):
        text = self.page("--lesson", "wrap", "--lesson", "coordinates")
        page = Page(text)
        self.assertEqual(page.language, "en")
        self.assertNotIn("script", page.tags)
        self.assertNotRegex(text, r"(?:src|href)=\"(?:\w+:|/)")
        self.assertEqual(page.links, ["#wrap", "#coordinates"])
        self.assertLessEqual({"wrap", "wrap-1", "coordinates"}, page.ids)
        listed = {file.name for file in (self.path / "out").iterdir()}
        self.assertEqual(listed, {"index.html", *(each["src"] for each in page.images)})
        for each in page.images:
            with Image.open(self.path / "out" / each["src"]) as picture:
                self.assertEqual((str(picture.width), str(picture.height)), (each["width"], each["height"]))
            self.assertNotEqual(each["alt"], "")

    def test_a_reason_has_its_numbers_and_what_is_foreign_is_escaped(self):
        text = self.page("--lesson", self.folder_of(LESSON))
        page = Page(text)
        self.assertIn("Mine &amp; &lt;yours&gt;", text)
        self.assertIn("&quot;Quoted&quot;", text)
        self.assertIn("A &lt; B.", text)
        self.assertRegex(text, r"<details><summary>The right answer</summary><p>B\. The colour is [^{}]*\d")
        self.assertIn("<code>textures[0].pattern=gradient</code>", text)
        self.assertEqual([each["src"] for each in page.images],
                         ["mine-1.png", "mine-1-answer-1.png", "mine-1-answer-2.png", "mine-2.png", "mine-2-reached.png"])

    def test_a_lesson_s_keys_and_a_step_s_figure_are_told(self):
        text = self.page("--lesson", "bumps")
        self.assertIn("Keys in the window: <kbd>E</kbd>", text)
        self.assertIn("<kbd>↑</kbd>", text)
        with Image.open(self.path / "out" / "bumps-1.png") as picture:  # its background has an alpha of 0
            self.assertEqual(picture.convert("RGBA").getextrema()[3][0], 255)
        self.assertIn("<kbd>Page Up</kbd>", text)
        self.assertIn("In the window this step opens the figure Emboss.", text)

    def test_the_page_is_in_other_languages(self):
        for language, tag, word in (("ru", "ru", "За краем"), ("zh_CN", "zh-CN", "课程")):
            text = self.page("--lesson", "wrap", "--language", language)
            self.assertEqual(Page(text).language, tag)
            self.assertIn(word, text)
            self.assertNotIn("The right answer", text)

    def test_what_is_wrong_is_said_and_nothing_is_written(self):
        out = self.path / "out"
        self.complains(2, "expected one of en, zh_CN, ru, found \"de\"", "lessons", "--page", out, "--language", "de")
        self.complains(2, "--lesson: expected one of ", "lessons", "--page", out, "--lesson", "nothing")
        self.complains(2, "--check, --page", "lessons", "--page", out, "--check", self.path)
        self.complains(2, "--page", "lessons", "--language", "ru")
        broken = self.folder_of({**LESSON, "steps": [{"title": "One", "text": "One.", "scene": "nowhere"}]})
        self.complains(1, "/steps/0/scene", "lessons", "--page", out, "--lesson", broken)
        (self.path / "file").write_text("")
        self.complains(1, "file", "lessons", "--page", self.path / "file", "--lesson", "wrap")

    def test_json_has_the_answers_and_the_numbers(self):
        lessons = json.loads(self.succeeds("lessons", "--json"))["lessons"]
        asked = [step for lesson in lessons for step in lesson["steps"] if step["task"] == "predict"]
        self.assertGreater(len(asked), 20)
        for step in asked:
            self.assertLess(step["right"], len(step["answers"]))
            self.assertNotRegex(step["reason"], r"\{\w+\}")


if __name__ == "__main__":
    unittest.main()
