"""The page of lessons in Chromium, as a reader opens it, and as the PDF that is printed of it. Poppler reads the PDF."""

import base64
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from PIL import Image

from browser import Browser

TEXSHOT = sys.argv.pop(1)
PAPERS = {"A4": (8.27, 11.69), "Letter": (8.5, 11)}  # inches

browser = None  # one for all of them
folder = None


def setUpModule():
    global browser, folder
    kept = tempfile.TemporaryDirectory()
    unittest.addModuleCleanup(kept.cleanup)
    folder = Path(kept.name)
    for name, words in {"one": ("wrap",), "two": ("wrap", "first-texture")}.items():
        lessons = [word for each in words for word in ("--lesson", each)]
        subprocess.run([TEXSHOT, "lessons", "--page", folder / name, *lessons], check=True)
    browser = Browser(folder)
    unittest.addModuleCleanup(browser.quit)


class Handout(unittest.TestCase):
    def setUp(self):
        browser.size(1280, 800)
        browser.media()

    def tearDown(self):
        self.assertEqual(browser.complaints(), [])

    def open(self, name):
        browser.driver.get("about:blank")
        browser.driver.get((folder / name / "index.html").as_uri())


class OnAScreen(Handout):
    def test_a_program_is_unfolded_and_is_its_file(self):
        self.open("one")
        self.assertEqual(browser.shown(".whole pre, .key"), [])
        browser.click("#wrap-3 .whole summary")
        self.assertEqual(len(browser.shown(".whole pre")), 1)
        text = (folder / "one/programs/wrap/wrap-3.c").read_text()
        self.assertEqual(browser.texts("#wrap-3 .whole code")[0], text)
        self.assertIn(f"{text.count(chr(10))} lines", browser.text("#wrap-3 .whole summary"))
        marked = browser.texts("#wrap-3 .whole mark")
        self.assertTrue(any("GL_TEXTURE_WRAP_S" in each for each in marked), marked)

    def test_the_excerpt_is_of_the_program(self):
        self.open("one")
        for step in range(1, 8):
            program = (folder / f"one/programs/wrap/wrap-{step}.c").read_text()
            (excerpt,) = browser.texts(f"#wrap-{step} .excerpt code") or [""]
            self.assertTrue(excerpt or step == 6, step)
            for line in excerpt.splitlines():
                if "more lines" not in line:
                    self.assertIn(line.strip(), program)
        self.assertIn("GL_TEXTURE_WRAP_S", browser.texts("#wrap-1 .excerpt code")[0])

    def test_the_links_open_the_programs(self):
        for file, said in ("wrap-1.c", "int main(void)"), ("wrap-1-glsl.c", "glUseProgram"):
            self.open("one")
            browser.click(f"a[href='programs/wrap/{file}']")
            self.assertIn(said, browser.text("body"))

    def test_nothing_is_wider_than_the_window(self):
        for width in 1280, 360:
            for scheme in "light", "dark":
                browser.size(width, 800)
                browser.media(scheme)
                self.open("two")
                browser.script("for (const each of document.querySelectorAll('details')) each.open = true")
                self.assertLessEqual(browser.script("return document.documentElement.scrollWidth"), width)
                dark = sum(browser.screenshot().getpixel((2, 2))) < 3 * 64
                self.assertEqual(dark, scheme == "dark")


class OnPaper(Handout):
    def printed(self, name, paper):
        """A page's PDF, and the text of each of its pages."""
        self.open(name)
        width, height = PAPERS[paper]
        data = browser.tool("Page.printToPDF", paperWidth=width, paperHeight=height)["data"]
        file = folder / f"{name}-{paper}.pdf"
        file.write_bytes(base64.b64decode(data))
        text = subprocess.run(["pdftotext", "-layout", file, "-"], capture_output=True, text=True, check=True).stdout
        pages = text.split("\f")[:-1]
        told = subprocess.run(["pdfinfo", file], capture_output=True, text=True, check=True).stdout
        self.assertEqual(re.search(r"Pages: +(\d+)", told)[1], str(len(pages)))
        return file, pages

    def images(self, file):
        """Of each picture the page that it is on, and how many of its pixels there are."""
        listed = subprocess.run(["pdfimages", "-list", file], capture_output=True, text=True, check=True).stdout
        rows = [line.split() for line in listed.splitlines()[2:]]
        return [(int(row[0]), int(row[3]) * int(row[4])) for row in rows if row[2] == "image"]

    def page_of(self, pages, words):
        found = [i for i, page in enumerate(pages, 1) if re.search(words, page)]
        self.assertEqual(len(found), 1, words)
        return found[0]

    def test_each_picture_is_whole_and_below_its_heading(self):
        for paper in PAPERS:
            with self.subTest(paper):
                file, pages = self.printed("one", paper)
                sizes = browser.script("return [...document.images].map((each) => each.naturalWidth * each.naturalHeight)")
                images = self.images(file)
                self.assertEqual([size for _, size in images], sizes, "each once, in their order")
                self.assertLess(len(pages), 8)
                of_steps = [page for page, size in images if size == 320 * 240]
                titles = browser.texts(".step h3")
                self.assertEqual([self.page_of(pages, rf"(?m)^ *{re.escape(each)}") for each in titles], of_steps)

    def test_answers_are_on_the_last_page_and_programs_are_not_printed(self):
        _, pages = self.printed("two", "A4")
        last = self.page_of(pages, r"(?m)^ *Answers$")
        for i, page in enumerate(pages, 1):
            self.assertEqual(bool(re.search("The right answer|Solution", page)), i >= last, i)
        self.assertEqual(self.page_of(pages, r"(?m)^ *Contents$"), 1)
        begin = [self.page_of(pages, rf"(?m)\A *{each}") for each in (r"1\. ", r"2\. ")]
        self.assertEqual(begin[0], 2, "after the contents")
        self.assertTrue(1 < begin[0] < begin[1] < last)
        whole = "\n".join(pages)
        self.assertNotIn("glfwCreateWindow", whole)
        self.assertNotIn("The whole program", whole)
        self.assertIn("GL_TEXTURE_WRAP_S, GL_REPEAT", whole)
        self.assertIn("wrap-3.c", whole)
        for number, page in enumerate(pages[1:], 2):
            self.assertRegex(page, rf"\b{number}\s*\Z")

    def test_a_dark_screen_prints_on_white(self):
        browser.media("dark")
        file, _ = self.printed("one", "A4")
        subprocess.run(["pdftoppm", "-r", "20", "-png", "-f", "1", "-l", "1", file, folder / "dark"], check=True)
        (picture,) = folder.glob("dark-*.png")
        self.assertEqual(Image.open(picture).convert("RGB").getpixel((2, 2)), (255, 255, 255))


if __name__ == "__main__":
    unittest.main()
