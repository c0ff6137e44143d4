"""texshot lessons --page: the lessons as a page, with their pictures in its folder."""

import html
import html.parser
import json
import unittest

from PIL import Image
from texshot import Texshot, bmp, results, single, texshot

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

    def files(self):
        out = self.path / "out"
        return {str(file.relative_to(out)) for file in out.rglob("*") if file.is_file()}

    def folder_of(self, lesson, name="mine"):
        folder = self.path / name
        folder.mkdir(parents=True)
        (folder / "lesson.json").write_text(json.dumps(lesson))
        return folder

    def test_every_step_has_its_pictures_and_nothing_runs(self):
        text = self.page("--lesson", "wrap", "--lesson", "coordinates")
        page = Page(text)
        self.assertEqual(page.language, "en")
        self.assertNotIn("script", page.tags)
        self.assertNotRegex(text, r"(?:src|href)=\"(?:\w+:|/)")
        self.assertEqual([each for each in page.links if each.startswith("#")], ["#wrap", "#coordinates"])
        self.assertLessEqual({"wrap", "wrap-1", "coordinates"}, page.ids)
        self.assertEqual(self.files(), {"index.html", *(each["src"] for each in page.images), *page.links[2:]})
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
        self.assertEqual(text.count("The colour is "), 2, "for screens, and for the last printed page")
        self.assertEqual([each["src"] for each in page.images],
                         ["mine-1.png", "mine-1-answer-1.png", "mine-1-answer-2.png", "mine-2.png", "mine-2-reached.png"])

    def test_answers_can_be_told_apart_on_paper(self):
        """An alpha of 0 is not shown as white paper: blocks 9 asks for ramps of alpha that end in black."""
        self.page("--lesson", "blocks", "--lesson", "objects")
        pictures = sorted((self.path / "out").glob("*.png"))
        self.assertIn("blocks-9-answer-2.png", [each.name for each in pictures])
        for each in pictures:
            with Image.open(each) as picture:
                self.assertEqual(picture.convert("RGBA").getextrema()[3], (255, 255), each.name)
        with Image.open(self.path / "out/blocks-9-answer-2.png") as picture:
            self.assertEqual(picture.convert("L").getextrema()[0], 0, "the half whose alpha is 0")

    def test_numbers_are_those_of_the_page_s_picture(self):
        text = html.unescape(self.page("--lesson", "laboratory"))
        self.assertNotRegex(text.split("<main>")[1].split("<pre")[0], r"\{\w+\}")
        # The mark of the first step, 500 and 417 thousandths of 320 x 240.
        probed = single(self.succeeds("probe", "--lesson", "laboratory", "--at", "160,100", "--size", "320x240", "--json"))
        lod = probed["fragments"][-1]["units"][0]["sample"]["lod"]
        side, up = lod["texelsPerPixelX"], lod["texelsPerPixelY"]
        self.assertIn(f"lie {side:.2f} texels to the side, and {up:.2f} upwards. What is its lambda?", text)
        self.assertIn(f"Rho is the larger of the two, {up:.2f}, and log2 of it is {lod['log2Rho']:.2f}", text)

    def test_a_lesson_s_keys_and_a_step_s_figure_are_told(self):
        text = self.page("--lesson", "bumps")
        self.assertIn("Keys in the window: <kbd>E</kbd>", text)
        self.assertIn("<kbd>↑</kbd>", text)
        with Image.open(self.path / "out" / "bumps-1.png") as picture:  # its background has an alpha of 0
            self.assertEqual(picture.convert("RGBA").getextrema()[3][0], 255)
        self.assertIn("<kbd>Page Up</kbd>", text)
        self.assertIn("In the window this step opens the figure Emboss.", text)

    def test_programs_are_what_emit_writes(self):
        """Every program that the flavour supports; otherwise the error of emit."""
        (self.path / "emitted").mkdir()
        for lesson in "wrap", "dds":
            text = html.unescape(self.page("--lesson", lesson))
            for step in range(1, text.count("<section class=\"step\"") + 1):
                for flavour, name in ("fixed", f"{lesson}-{step}.c"), ("glsl", f"{lesson}-{step}-glsl.c"):
                    emitted = self.path / "emitted" / name
                    result = texshot("emit", "--lesson", lesson, "--step", step, "--as", flavour, "--files", "-o", emitted)
                    written = self.path / "out/programs" / lesson / name
                    self.assertEqual(written.exists(), result.returncode == 0, result.stderr)
                    if result.returncode == 0:
                        self.assertEqual(written.read_bytes(), emitted.read_bytes())
                    else:
                        self.assertIn(result.stderr.decode().removeprefix("texshot: ").strip(), text)
        files = {file.name for file in (self.path / "emitted").iterdir()} - {file.name for file in (self.path / "out/programs").glob("wrap/*")}
        self.assertEqual(files, {file.name for file in (self.path / "out/programs/dds").iterdir()})
        self.assertIn("turned.dds", files)

    def test_a_program_of_one_s_own_lesson_has_its_files(self):
        folder = self.folder_of({**LESSON, "steps": [{"title": "One", "text": "Text.", "scene": "scene.json"}]})
        (folder / "image.bmp").write_bytes(bmp(8, 4, lambda x, y: (x, y, 9)))
        (folder / "scene.json").write_text(json.dumps({
            "version": 1, "models": [{"shape": "quad"}], "textures": [{"source": "file", "file": "image.bmp"}],
            "passes": [{"units": [{"enabled": True}]}]}))
        text = self.page("--lesson", folder)
        programs = self.path / "out/programs/mine"
        image, = programs.glob("image-*.bmp")
        self.assertEqual(image.read_bytes(), (folder / "image.bmp").read_bytes())
        self.assertIn(f"readBmp(\"{image.name}\", 8, 4, ", (programs / "mine-1.c").read_text())
        self.assertIn(f"which reads {image.name}", text)
        # Two lessons of one name.
        other = self.folder_of(LESSON, "more/mine")
        page = Page(self.page("--lesson", folder, "--lesson", other))
        self.assertLessEqual({"mine", "mine-again", "mine-again-2"}, page.ids)
        # A file with the name of a program does not replace the program.
        (folder / "image.bmp").rename(folder / "mine-1.c")
        (folder / "scene.json").write_text((folder / "scene.json").read_text().replace("image.bmp", "mine-1.c"))
        self.page("--lesson", folder)
        self.assertIn(f"readBmp(\"{image.name}\", 8, 4, ", (programs / "mine-1.c").read_text())

    def test_a_page_fetches_nothing_from_elsewhere(self):
        self.assertIn("<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src 'self' file: data:;",
                      self.page("--lesson", "wrap"))

    def test_what_a_flavour_cannot_say_is_a_sentence(self):
        keyed = {"version": 1, "timeline": [{"time": 0, "path": "models[0].shape", "value": "cube"},
                                           {"time": 1, "path": "models[0].shape", "value": "sphere"}]}
        folder = self.folder_of({**LESSON, "steps": [
            {"title": "One", "text": "Text.", "scene": "keyed.json"},
            {"title": "Two", "text": "Text.", "scene": "cube", "edits": ["textures[0].border=1"]},
            {"title": "Three", "text": "Text.", "scene": "photo.json"}]})
        (folder / "keyed.json").write_text(json.dumps(keyed))
        Image.effect_noise((1200, 1200), 90).convert("RGB").save(folder / "photo.png")
        (folder / "photo.json").write_text(json.dumps({"version": 1, "textures": [{"source": "file", "file": "photo.png", "minFilter": "GL_LINEAR"}],
                                                       "models": [{}], "passes": [{"units": [{"enabled": True}]}]}))
        text = html.unescape(self.page("--lesson", folder))
        self.assertEqual(text.count("can't animate this by key frames, because shapes are made only when the program starts; texshot animate can"), 2)
        self.assertIn("C with OpenGL 3.3: textures[0].border: textures have no border in OpenGL 3.3's core profile", text)
        self.assertRegex(text, r"C with OpenGL 2\.1: the program contains \d+ MB of texels")
        self.assertEqual({name for name in self.files() if name.startswith("programs/")}, {"programs/mine/mine-2.c"})
        self.assertLess(len(text), 60_000)

    def test_the_page_is_in_other_languages(self):
        for language, tag, word in (("ru", "ru", "За краем"), ("zh_CN", "zh-CN", "答案")):
            text = self.page("--lesson", "wrap", "--language", language)
            self.assertEqual(Page(text).language, tag)
            self.assertIn(word, text)
            self.assertNotIn("The right answer", text)

    def test_steps_link_to_the_window_in_a_browser(self):
        address = "https://example.org/texplorer/"
        mine = self.folder_of(LESSON)
        links = Page(self.page("--lesson", "wrap", "--lesson", mine, "--window", address)).links
        steps = [link for link in links if link.startswith(address)]
        self.assertEqual(steps, [f"{address}#lesson=wrap&step={i + 1}" for i in range(len(steps))])
        self.assertGreater(len(steps), 3)

    def test_what_is_wrong_is_said_and_nothing_is_written(self):
        out = self.path / "out"
        for bad in ("javascript:alert(1)", "https://a b", "https://a#b", "ftp://a", "//a"):
            self.complains(2, "--window: expected an address", "lessons", "--page", out, "--window", bad)
        self.complains(2, "expected one of en, zh_CN, ru, found \"de\"", "lessons", "--page", out, "--language", "de")
        self.complains(2, "--lesson: expected one of ", "lessons", "--page", out, "--lesson", "nothing")
        self.complains(2, "--check, --page", "lessons", "--page", out, "--check", self.path)
        self.complains(2, "--page", "lessons", "--language", "ru")
        broken = self.folder_of({**LESSON, "steps": [{"title": "One", "text": "One.", "scene": "nowhere"}]})
        self.complains(1, "/steps/0/scene", "lessons", "--page", out, "--lesson", broken)
        (self.path / "file").write_text("")
        self.complains(1, "file", "lessons", "--page", self.path / "file", "--lesson", "wrap")
        self.page("--lesson", "wrap")
        before = self.files()
        (out / "programs" / "wrap" / "wrap-1.c").unlink()
        (out / "programs" / "wrap" / "wrap-1.c").mkdir()
        self.complains(1, "wrap-1.c: ", "lessons", "--page", out, "--lesson", "wrap")
        self.assertEqual(self.files(), before - {"programs/wrap/wrap-1.c"})

    def test_others_files_stay_and_an_earlier_page_is_replaced(self):
        folder = self.folder_of({**LESSON, "steps": [{"title": "One", "text": "One.", "scene": "cube"}]})
        Image.new("RGB", (8, 4), (255, 0, 0)).save(folder / "mine-1.png")
        before = {file: file.read_bytes() for file in folder.iterdir()}
        self.complains(1, "found other files, which the page might overwrite", "lessons", "--page", folder, "--lesson", folder)
        self.assertEqual({file: file.read_bytes() for file in folder.iterdir()}, before)
        self.page("--lesson", folder)
        (self.path / "out" / "mine-1.png").write_bytes(b"old")
        self.page("--lesson", folder)
        self.assertEqual((self.path / "out" / "mine-1.png").read_bytes()[:4], b"\x89PNG")

    def test_json_has_the_answers_and_the_numbers(self):
        lessons = results(self.succeeds("lessons", "--json"))
        asked = [step for lesson in lessons for step in lesson["steps"] if step["task"] == "predict"]
        self.assertGreater(len(asked), 20)
        for step in asked:
            self.assertLess(step["right"], len(step["answers"]))
            self.assertNotRegex(step["reason"], r"\{\w+\}")


if __name__ == "__main__":
    unittest.main()
