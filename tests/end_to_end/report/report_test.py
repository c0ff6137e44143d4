"""The page of a report, opened from its folder in Chromium. Pillow and numpy compute what it must show."""

import json
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy
from PIL import Image

from browser import Browser, Keys

SAMPLE = sys.argv.pop(1)
STATES = ["crashed", "timed-out", "error", "failed", "differ", "resized", "missing", "extra", "new", "not-run", "passed",
          "agree", "skipped"]
# The sample's names of the fourth, ninth, twelfth and thirteenth case, as far as they can be printed.
HOSTILE = {
    3: "<script>document.title='owned'</script><img src=x onerror=\"document.title='owned'\">",
    8: "../../\"quoted\" & 'so' on/#?%41",
    11: "line\\u000aof \\u2028 separators and \ufffd",
    12: "</script>${1+1}`\\u0041",
}
FAILED = 3  # its pictures differ


browser = None  # one for all of them
downloads = None


def setUpModule():
    global browser, downloads
    folder = tempfile.TemporaryDirectory()
    unittest.addModuleCleanup(folder.cleanup)
    downloads = Path(folder.name)
    browser = Browser(downloads)
    unittest.addModuleCleanup(browser.quit)


def sample(folder, *numbers):
    subprocess.run([SAMPLE, folder, *map(str, numbers)], check=True)
    return folder


def data_of(folder):
    text = (folder / "report-data.js").read_text()
    return json.loads(text[len("texplorerReport = "):-2])


def numbers_of(path):
    return numpy.asarray(Image.open(path).convert("RGBA")).astype(int)


class Page(unittest.TestCase):
    """A page of the sample, opened again for each test."""
    COUNT = 60

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.path = Path(folder.name)
        cls.report = sample(cls.path / "a report #1 %41", cls.COUNT)
        cls.data = data_of(cls.report)
        cls.browser = browser

    def setUp(self):
        self.browser.size(1280, 800)
        self.browser.media()
        self.open()
        self.browser.script("localStorage.clear()")
        self.open()

    def tearDown(self):
        self.assertEqual(self.browser.complaints(), [])

    def open(self, folder=None, case=None):
        self.browser.driver.get("about:blank")
        self.browser.driver.get(((folder or self.report) / "index.html").as_uri())
        self.browser.wait(lambda: self.browser.script("return performance.getEntriesByName('texplorer-shown').length"), "the page")
        if case is not None:
            self.look_at(case)

    def look_at(self, case):
        """Opens a case by its number in the run, and waits for its pictures and numbers."""
        data = data_of(self.report)["cases"][case]
        self.browser.script("location.hash = '#case=' + encodeURIComponent(arguments[0])", data["name"])
        self.looks_at(data["name"])
        self.wait_for_pictures()
        if data["pictures"]:
            self.browser.wait(lambda: self.browser.all(".magnified-one canvas"), "the pixels")

    def looks_at(self, name):
        """Waits until the case of that name is open."""
        self.browser.wait(lambda: self.browser.texts("#case-name") == [name], name)

    def wait_for_pictures(self):
        self.browser.wait(lambda: self.browser.script(
            "return [...document.querySelectorAll('.pane img')].every((each) => each.complete && each.style.width)"), "pictures")

    def picture(self, case, role):
        files = {each["role"]: each["file"] for each in self.data["cases"][case]["pictures"]}
        return numbers_of(self.report / files[role])

    def names(self):
        """The names of the cases in the list, as shown."""
        count = self.browser.text("#count").split()[0].replace(",", "")
        self.browser.wait(lambda: len(self.browser.all(".row")) == int(count), f"{count} rows")
        return self.browser.texts(".row .name")

    def place_of(self, pixel, pane=".pane"):
        """The position of the middle of a pixel in the window."""
        left, top, _, _ = self.browser.box(pane)
        x, y, scale = self.browser.script(
            "const m = new DOMMatrix(getComputedStyle(document.querySelector(arguments[0] + ' .layer')).transform); return [m.e, m.f, m.a]", pane)
        return left + x + (pixel[0] + 0.5) * scale, top + y + (pixel[1] + 0.5) * scale

    def seen(self, width, height, pane=".pane"):
        """The colours in the middle of each pixel, as the window shows them, without marks."""
        self.browser.script("document.querySelectorAll('.mark').forEach((each) => { each.style.display = 'none' })")
        shot = numpy.asarray(self.browser.screenshot()).astype(int)
        left, top = self.place_of((0, 0), pane)
        right, bottom = self.place_of((width - 1, height - 1), pane)
        columns = numpy.linspace(left, right, width).astype(int)
        rows = numpy.linspace(top, bottom, height).astype(int)
        return shot[numpy.ix_(rows, columns)]


class Opening(Page):
    def test_names_are_texts_whatever_they_say(self):
        self.assertEqual(self.browser.driver.title, "Sample <of> a report")
        self.browser.click("#sort option[value=run]")
        names = self.names()
        self.assertEqual(len(names), self.COUNT)
        for index, name in HOSTILE.items():
            self.assertEqual(names[index], name)
            self.look_at(index)
            self.assertEqual(self.browser.driver.title, f"{name} – Sample <of> a report")
        self.assertEqual(self.browser.script("return [...document.scripts].map((each) => each.getAttribute('src'))"), ["report-data.js", "report.js"])

    def test_the_overview_says_what_is_wrong_and_what_it_ran_on(self):
        self.assertEqual(self.browser.text(".overview h2"), "9 of 60 cases are wrong")
        text = self.browser.text(".overview")
        for expected in ("a disk, and the same disk a pixel further", "Made by report_sample on 2026-01-02 03:04 UTC.", "report_sample DIR",
                         "llvmpipe (LLVM 15.0.6, 256 bits)", "egl, surfaceless", "By group", "A case belongs to one group.",
                         "The process ended by signal 11 (Segmentation fault)."):
            self.assertIn(expected, text)
        wrong = [each["name"] for each in self.data["cases"] if each["state"] in STATES[:9]]
        self.assertCountEqual(self.browser.texts(".card .name"), wrong)
        self.assertEqual(self.browser.texts("tbody tr td.number"), ["20", "40"])
        self.browser.click("tbody tr:nth-child(2) a")
        self.looks_at("wrap/GL_REPEAT/case-1")

    def test_a_case_says_everything(self):
        self.look_at(FAILED)
        case = self.data["cases"][FAILED]
        text = self.browser.text(".detail")
        for expected in ("Failed", "filter", case["message"], "absolute", "64 × 48", "16, 9", "Scene", *case["commands"][0].values()):
            self.assertIn(expected, text)
        self.assertEqual(self.browser.script("return document.querySelector('pre').textContent"), case["explanation"])
        self.assertEqual([each.text for each in self.browser.all(".legend span")], ["0", "4", "255"])
        self.browser.click(".links a")
        self.assertEqual(self.browser.driver.current_url, (self.report / "scene.json").as_uri())

    def test_a_page_without_cases_opens(self):
        self.open(sample(self.path / "none", 0))
        self.assertEqual(self.browser.text("#count"), "0 cases")
        self.assertEqual(self.browser.text(".none"), "No case is like that.")
        self.browser.keys("j", "k", "a", "w", "g", "1")
        self.assertEqual(self.browser.text(".overview h2"), "0 of 0 cases are wrong")

    def test_what_is_not_there_is_said(self):
        broken = self.path / "broken"
        shutil.copytree(self.report, broken)
        files = {each["role"]: each["file"] for each in self.data["cases"][FAILED]["pictures"]}
        (broken / files["actual"]).unlink()
        (broken / f"{files['actual']}.js").unlink()
        (broken / f"{files['expected']}.js").write_text("texplorerPixels(\"%s\",\"iVBORw0KGgo=\");\n" % files["expected"])
        self.open(broken)
        self.browser.script("location.hash = '#case=' + encodeURIComponent(arguments[0])", HOSTILE[FAILED])
        self.browser.wait(lambda: self.browser.texts(".absent") == [f"{files['actual']} is not there."], "a sentence")
        self.browser.wait(lambda: "The numbers of the pixels can't be shown: " in self.browser.text(".magnifier"), "a sentence")
        (broken / "report-data.js").unlink()
        self.browser.driver.get("about:blank")
        self.browser.driver.get((broken / "index.html").as_uri())
        self.browser.wait(lambda: self.browser.text("main") == "report-data.js is not beside this page, or is damaged.", "a sentence")
        self.assertTrue(all("ERR_FILE_NOT_FOUND" in each for each in self.browser.complaints()))


class Choosing(Page):
    def test_what_is_worst_comes_first(self):
        cases = self.data["cases"]
        self.names()
        worst = sorted(cases, key=lambda each: (STATES.index(each["state"]), -each.get("distance", 0)))
        self.assertEqual(self.browser.texts(".row .name"), [each["name"] for each in worst])
        self.browser.click("#sort option[value=slowest]")
        self.assertEqual(self.names(), [each["name"] for each in sorted(cases, key=lambda each: -each["seconds"])])
        self.browser.click("#sort option[value=run]")
        self.assertEqual(self.names(), [each["name"] for each in cases])

    def test_states_words_and_groups_filter(self):
        of = lambda *states: [each["name"] for each in self.data["cases"] if each["state"] in states]
        chip = lambda state: f".chip[data-state={state}]"
        self.assertEqual(self.browser.text(chip("failed")), f"Failed {len(of('failed'))}")
        self.browser.click(chip("failed"))
        self.assertEqual(self.browser.one(chip("failed")).get_attribute("aria-pressed"), "true")
        self.assertCountEqual(self.names(), of("failed"))
        self.assertEqual(self.browser.text("#count"), f"{len(of('failed'))} of 60 cases")
        self.assertEqual(self.browser.texts("#said"), [f"{len(of('failed'))} cases shown"])
        self.browser.click(chip("passed"))
        self.assertCountEqual(self.names(), of("failed", "passed"))
        self.browser.click("#group option[value=filter]")
        self.assertEqual(set(self.browser.texts(".row .row-facts > .muted:nth-child(2)")), {"filter"})
        self.browser.click("#group option[value='']")
        self.browser.click(chip("failed"))
        self.browser.keys("/")
        self.browser.keys("case-2 clamp")  # both words, in any order
        self.assertEqual(self.names(), [name for name in of("passed") if "case-2" in name and "CLAMP" in name])
        self.browser.keys("nowhere")
        self.assertEqual(self.names(), [])
        self.assertEqual(self.browser.text(".none"), "No case is like that.")

    def test_rows_buttons_and_keys_lead_from_case_to_case(self):
        names = self.names()
        self.browser.click(".row:nth-child(3) a")
        self.looks_at(names[2])
        self.assertEqual(self.browser.text(".steps .muted"), "3 of 60")
        for key, place in (("j", 3), (Keys.ARROW_RIGHT, 4), (Keys.ARROW_DOWN, 5), ("k", 4), (Keys.ARROW_LEFT, 3), (Keys.ARROW_UP, 2)):
            self.browser.keys(key)
            self.looks_at(names[place])
        self.assertEqual(self.browser.texts(".row a[aria-current] .name"), [names[2]])
        self.browser.click("#next")
        self.looks_at(names[3])
        self.browser.driver.refresh()  # the address says which case it is
        self.looks_at(names[3])
        self.browser.keys(Keys.ESCAPE)
        self.browser.wait(lambda: self.browser.all(".overview"), "the overview")
        self.browser.driver.back()
        self.looks_at(names[3])

    def test_the_list_is_one_stop_of_the_tab_key(self):
        names = self.names()
        self.browser.click("#sort option[value=run]")
        stops = lambda: [each.get_attribute("title") for each in self.browser.all(".row a[tabindex='0']")]
        run = [each["name"] for each in self.data["cases"]]
        self.assertEqual(stops(), run[:1])
        self.browser.script("document.querySelector(\".row a[tabindex='0']\").focus()")
        focused = lambda: self.browser.script("return document.activeElement.title")
        for key, place in ((Keys.ARROW_DOWN, 0), (Keys.ARROW_DOWN, 1), ("j", 2), ("k", 1)):
            self.browser.keys(key)
            self.looks_at(run[place])
            self.assertEqual((focused(), stops()), (run[place], [run[place]]))
        self.browser.script("document.getElementById('skip').focus()")
        self.browser.keys(Keys.ENTER)
        self.assertEqual(self.browser.script("return document.activeElement.id"), "main")
        self.looks_at(run[1])
        self.assertEqual(self.browser.script("return document.querySelector('#to-overview').getAttribute('aria-current')"), None)
        self.browser.keys("o")
        self.browser.wait(lambda: self.browser.all(".overview"), "the overview")
        self.assertEqual(self.browser.script("return document.querySelector('#to-overview').getAttribute('aria-current')"), "page")
        self.assertEqual([each.get_attribute("title") for each in self.browser.all(".row.last a")], [run[1]])
        self.assertEqual(len(names), len(run))

    def test_rows_show_the_end_of_long_names_and_no_group_twice(self):
        long = self.path / "long"
        shutil.copytree(self.report, long)
        text = (long / "report-data.js").read_text()
        data = json.loads(text[len("texplorerReport = "):-2])
        names = [f"filters/{'textures[0].minFilter=GL_LINEAR_MIPMAP_LINEAR/' * 4}renderer-{i}@512x512" for i in range(len(data["cases"]))]
        for name, case in zip(names, data["cases"]):
            case.update(name=name, group="filters")
        (long / "report-data.js").write_text(f"texplorerReport = {json.dumps(data)};\n")
        self.open(long)
        self.browser.click("#sort option[value=run]")
        self.assertEqual(self.names(), names)  # for screen readers and search
        row = self.browser.one(".row:nth-child(8)")
        tail, name = (row.find_element("css selector", f".name{part}") for part in (" .tail", ""))
        self.assertTrue(tail.text.replace("\n", "").endswith("renderer-7@512x512"), tail.text)
        cut = self.browser.script("return arguments[0].scrollHeight > arguments[0].clientHeight + 1", tail)
        self.assertFalse(cut, "nothing of it is left out")
        line = float(name.value_of_css_property("line-height")[:-2])
        self.assertLessEqual(name.size["height"], 3 * line + 1)
        hidden = self.browser.script("return arguments[0].querySelector('.unseen').textContent", name)
        self.assertEqual(hidden, "filters/")

    def test_the_keys_are_listed(self):
        self.browser.keys("?")
        self.assertTrue(self.browser.one("dialog").is_displayed())
        self.assertEqual(self.browser.texts("dialog kbd"), ["j ↓ →", "k ↑ ←", "1", "2", "3", "4", "f", "p", "g", "+ or wheel", "−", "0", "z", "w",
                                                            "Shift and arrows", "a", "u", "/", "o or Esc", "t", "?"])
        self.browser.keys("j")  # belongs to the page behind
        self.assertEqual(self.browser.all("#case-name"), [])
        self.browser.keys(Keys.ESCAPE)
        self.assertFalse(self.browser.one("dialog").is_displayed())


class Looking(Page):
    def setUp(self):
        super().setUp()
        self.look_at(FAILED)
        self.expected = self.picture(FAILED, "expected")
        self.actual = self.picture(FAILED, "actual")
        self.worst = (16, 9)
        self.opaque = (self.actual[..., 3] == 255)  # all except the worst pixel

    def assert_shows(self, seen, expected, where):
        apart = numpy.abs(seen - expected[..., :3]).max(axis=2) * where
        self.assertLessEqual(apart.max(), 1, numpy.argwhere(apart > 1)[:3])

    def test_side_by_side(self):
        self.assertEqual(self.browser.texts("figcaption .caption"), ["Expected", "Actual", "Where it differs"])
        for i, picture in enumerate((self.expected, self.actual)):
            self.assert_shows(self.seen(64, 48, f".figure:nth-child({i + 1}) .pane"), picture, self.opaque)

    def test_the_slider_is_dragged_and_has_keys(self):
        self.browser.keys("2")
        self.wait_for_pictures()
        now = lambda: int(self.browser.one(".divider").get_attribute("aria-valuenow"))
        self.assertEqual(now(), 50)
        left, top, width, height = self.browser.box(".pane")
        self.browser.drag((left + width / 2, top + 50), (left + width / 4, top + 60))
        self.assertEqual(now(), 25)
        self.browser.script("document.querySelector('.divider').focus()")
        self.browser.keys(Keys.ARROW_RIGHT)
        self.assertEqual(now(), 26)
        self.browser.shift(Keys.ARROW_RIGHT)
        self.assertEqual(now(), 36)
        self.browser.keys(Keys.END)
        self.assertEqual(now(), 100)
        self.browser.keys(Keys.HOME)
        self.assertEqual(now(), 0)
        self.assertEqual(self.browser.text("#case-name"), HOSTILE[FAILED])  # arrows move the slider
        # Expected on its left, actual on its right: the disk is one pixel further right there.
        self.browser.drag((left + 1, top + 50), (left + width / 2, top + 50))
        self.assertEqual(now(), 50)
        columns = numpy.array([self.place_of((x, 0))[0] for x in range(64)])
        handle = numpy.abs(columns - (left + width / 2)) > 22
        both = numpy.where((columns < left + width / 2)[None, :, None], self.expected, self.actual)
        self.assert_shows(self.seen(64, 48), both, self.opaque & handle[None, :])
        self.assertGreater(numpy.abs(self.expected - self.actual).max(), 20)

    def test_a_finger_drags_the_slider(self):
        self.browser.keys("2")
        left, top, width, _ = self.browser.box(".pane")
        self.browser.tool("Emulation.setTouchEmulationEnabled", enabled=True)
        self.addCleanup(self.browser.tool, "Emulation.setTouchEmulationEnabled", enabled=False)
        self.browser.touch((left + width / 2, top + 50), (left + width * 0.6, top + 50), (left + width * 0.75, top + 55))
        self.browser.wait(lambda: self.browser.one(".divider").get_attribute("aria-valuenow") == "75", "the divider")

    def test_flicker_by_hand_and_by_itself(self):
        self.browser.keys("f")
        self.wait_for_pictures()
        caption = lambda: self.browser.text("figcaption .caption")
        self.assertEqual(caption(), "Expected")
        self.assert_shows(self.seen(64, 48), self.expected, self.opaque)
        self.browser.keys("f")
        self.assertEqual(caption(), "Actual")
        self.assertEqual(self.browser.texts("#said"), ["Actual"])
        self.assert_shows(self.seen(64, 48), self.actual, self.opaque)
        self.browser.click("[data-tool=rate] option[value='3']")
        self.browser.script("""window.shown = [];
            new MutationObserver(() => shown.push(document.querySelector('figcaption .caption').textContent))
                .observe(document.querySelector('figcaption .caption'), {childList: true})""")
        self.browser.click("[data-tool=play]")
        self.assertEqual(self.browser.text("[data-tool=play]"), "Stop")
        self.browser.wait(lambda: len(self.browser.script("return shown")) >= 4, "four pictures")
        self.assertEqual(self.browser.script("return shown")[:4], ["Expected", "Actual"] * 2)
        self.browser.keys("p")
        self.assertEqual(self.browser.text("[data-tool=play]"), "Play")
        count = len(self.browser.script("return shown"))
        self.browser.keys("1", "3")  # and it stays in place in another view and back
        self.assertEqual(len(self.browser.script("return shown")), count)

    def test_the_difference_has_a_gain(self):
        self.browser.keys("4")
        self.browser.wait(lambda: self.browser.all(".pane canvas"), "the difference")
        apart = numpy.abs(self.expected - self.actual)
        apart = numpy.maximum(apart[..., :3], apart[..., 3:])  # alpha shows in all channels
        for gain in (8, 16, 32, 64, 1, 2, 4):
            self.assertEqual(self.browser.text(".gain"), f"Gain × {gain}")
            self.assertEqual(self.browser.text("[data-tool=difference]"), f"Difference × {gain}")
            numbers = self.browser.script("""const canvas = document.querySelector('.pane canvas');
                return [...canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data]""")
            shown = numpy.array(numbers).reshape(48, 64, 4)[..., :3]
            self.assertEqual(numpy.abs(shown - numpy.minimum(apart * gain, 255)).max(), 0, gain)
            self.browser.keys("g")
        self.browser.script("const bar = document.querySelector('[data-tool=gain]'); bar.focus(); bar.value = 0; bar.dispatchEvent(new Event('input'))")
        self.assertEqual(self.browser.text("figcaption .caption"), "Expected − Actual, × 1")
        self.assert_shows(self.seen(64, 48), apart, numpy.full((48, 64), True))

    # Without numbers the browser computes the difference.
    def test_the_difference_of_pictures_without_pixels(self):
        bare = self.path / "bare"
        shutil.copytree(self.report, bare, dirs_exist_ok=True)
        data = (bare / "report-data.js").read_text()
        (bare / "report-data.js").write_text(data.replace("\"pixels\":true", "\"pixels\":false"))
        for script in bare.glob("*.png.js"):
            script.unlink()
        self.open(bare)
        self.browser.script("location.hash = '#case=' + encodeURIComponent(arguments[0])", HOSTILE[FAILED])
        self.browser.wait(lambda: self.browser.all("#case-name"), "the case")
        self.assertIn("were not kept", self.browser.text(".magnifier"))
        self.browser.keys("4")
        self.wait_for_pictures()
        self.browser.keys("g")
        self.wait_for_pictures()
        self.assertEqual(self.browser.text(".gain"), "Gain × 16")
        apart = numpy.minimum(numpy.abs(self.expected - self.actual) * 16, 255)
        self.assert_shows(self.seen(64, 48), apart, self.opaque)

    def numbers(self):
        return [each.text for each in self.browser.all(".magnified .numbers")]

    def assert_numbers(self, x, y):
        expected, actual = self.expected[y, x], self.actual[y, x]
        self.browser.wait(lambda: self.browser.text(".place").startswith(f"Pixel {x}, {y}"), f"pixel {x}, {y}")
        self.assertEqual(self.numbers(), [" ".join(map(str, each)) for each in (expected, actual, numpy.abs(expected - actual))])

    def test_the_numbers_of_the_pixel_that_one_points_at(self):
        self.assertEqual(self.browser.text(".place"), "Pixel 16, 9 (the worst), from the upper left")
        self.assert_numbers(16, 9)
        self.assertEqual([each.text for each in self.browser.all(".magnified .hex")][1], "#ff01fe80")  # alpha has not changed the others
        for pixel, figure in (((0, 0), 1), ((63, 47), 2), ((13, 20), 3)):
            self.browser.point(*self.place_of(pixel, f".figure:nth-child({figure}) .pane"))
            self.assert_numbers(*pixel)
        self.browser.point(5, 5)
        self.assert_numbers(16, 9)  # nowhere: that of the mark
        x, y = self.place_of((40, 30))
        self.browser.drag((x, y), (x, y))  # a click
        self.browser.point(5, 5)
        self.assert_numbers(40, 30)
        self.browser.shift(Keys.ARROW_RIGHT, Keys.ARROW_RIGHT, Keys.ARROW_UP)
        self.assert_numbers(42, 29)
        # The pixels around it, as in the picture.
        middle = self.browser.script("""return [...document.querySelectorAll('.magnified canvas')].map((canvas) =>
            [...canvas.getContext('2d').getImageData(55 + 10, 55 - 20, 1, 1).data])""")
        self.assertEqual(middle, [self.expected[27, 43].tolist(), self.actual[27, 43].tolist()])

    def test_zoom(self):
        scale = lambda: self.browser.text(".scale")
        grid = lambda: len(self.browser.shown(".grid"))
        self.assertEqual(scale(), "400 %")
        self.browser.keys("z")
        self.assertEqual(scale(), "100 %")
        self.browser.keys("+", "+")
        self.assertEqual((scale(), grid()), ("300 %", 0))
        self.browser.keys("-")
        self.assertEqual(scale(), "200 %")
        for _ in range(4):
            self.browser.click("[data-tool=in]")
        self.assertEqual((scale(), grid()), ("800 %", 3))
        self.assertEqual(self.browser.one(".grid").value_of_css_property("background-size"), "8px 8px, 8px 8px")
        self.browser.keys("0")
        self.assertEqual((scale(), grid()), ("400 %", 0))
        # The wheel zooms around the mouse: the point below it stays in place.
        place = self.place_of((10, 12))
        self.browser.point(*place, wheel=-300)
        self.browser.wait(lambda: scale() != "400 %", "the wheel")
        self.assertGreater(int(scale().split()[0]), 600)
        for before, after in zip(place, self.place_of((10, 12))):
            self.assertAlmostEqual(before, after, delta=4)
        # All pictures show the same part.
        self.assertEqual(len({each.get_attribute("style") for each in self.browser.all(".layer")}), 1)
        left, top = self.place_of((0, 0))
        self.browser.drag(place, (place[0] + 30, place[1] + 20))
        self.assertEqual([round(after - before) for before, after in zip((left, top), self.place_of((0, 0)))], [30, 20])

    def test_the_worst_pixel_is_marked(self):
        def middle():
            left, top, width, height = self.browser.box(".mark.worst")
            return left + width / 2, top + height / 2
        for keys in ("", "+++", "w", "2", "4"):
            self.browser.keys(*keys)
            for mark, pixel in zip(middle(), self.place_of(self.worst)):
                self.assertAlmostEqual(mark, pixel, delta=1.5, msg=keys)
        self.browser.keys("1", "w")
        left, top, width, height = self.browser.box(".pane")
        for mark, pane in zip(middle(), (left + width / 2, top + height / 2)):
            self.assertAlmostEqual(mark, pane, delta=1.5)

    def test_one_picture_has_no_other_to_be_compared_with(self):
        self.look_at(STATES.index("new"))
        self.assertEqual(self.browser.texts("figcaption .caption"), ["Actual"])
        self.assertEqual([each.is_enabled() for each in self.browser.all("[aria-label=View] button")], [True, False, False, False])
        self.browser.keys("2", "f", "g", "p")
        self.assertEqual(self.browser.texts("figcaption .caption"), ["Actual"])

    def test_pictures_of_two_sizes(self):
        case = STATES.index("resized")
        self.look_at(case)
        expected, actual = self.picture(case, "expected"), self.picture(case, "actual")
        self.assertEqual((expected.shape[1], actual.shape[1]), (64, 48))
        self.assertEqual(self.browser.texts("figcaption .extent"), ["64 × 48", "48 × 48"])
        corner = self.browser.script("""const a = { width: 1, height: 2, max: 255, rgba: new Array(8).fill(9) };
            return [...differenceOf(a, { ...a, width: 2, height: 1 }, 1).rgba]""")
        self.assertEqual(corner, [0, 0, 0, 255, *[255] * 8, 0, 0, 0, 0])  # what neither has shows nothing
        self.browser.keys("4", "g", "g", "g", "g")
        shown = self.browser.script("const canvas = document.querySelector('.pane canvas');"
                                    "return [...canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data]")
        shown = numpy.array(shown).reshape(48, 64, 4)
        self.assertEqual(shown[:, 48:, :3].min(), 255)  # only one of them has it
        self.assertEqual(numpy.abs(shown[:, :48, :3] - numpy.abs(expected[:, :48, :3] - actual[:, :, :3])).max(), 0)
        self.browser.point(*self.place_of((60, 5)))
        self.browser.wait(lambda: self.browser.text(".place").startswith("Pixel 60, 5"), "the pixel")
        self.assertEqual(self.numbers(), [" ".join(map(str, expected[5, 60])), "–", "–"])


class Decoding(Page):
    # Colour types, depths, interlacing, transparency, filters: ImageMagick reads them with 16 bits.
    def test_pngs_of_every_kind(self):
        folder = self.path / "kinds"
        folder.mkdir()
        subprocess.run([sys.executable, Path(__file__).parents[2] / "fixtures" / "make_png.py", folder], check=True)
        files = sorted(folder.glob("*.png"))
        self.assertGreater(len(files), 200)
        known = subprocess.run(["convert", *files, "-depth", "16", "-endian", "LSB", "rgba:-"], check=True, stdout=subprocess.PIPE).stdout
        for file in files:
            shown = self.decoded(file.read_bytes())
            self.assertNotIn("error", shown, file.name)
            self.assertEqual(shown["max"], 65535 if "d16" in file.name else 255, file.name)
            numbers = numpy.array(shown["rgba"]) * (65535 // shown["max"])
            size = numbers.size * 2
            self.assertEqual(numbers.tolist(), numpy.frombuffer(known[:size], "<u2").tolist(), file.name)
            known = known[size:]
        self.assertEqual(known, b"")

    def test_damaged_pngs_are_refused_with_a_sentence(self):
        png = (self.report / self.data["cases"][FAILED]["pictures"][0]["file"]).read_bytes()
        huge = png[:16] + b"\x7f\xff\xff\xff\x7f\xff\xff\xff" + png[24:]
        for name, damaged in (("empty", b""), ("cut", png[:len(png) // 2]), ("no PNG", b"GIF89a" * 20), ("huge", huge),
                              ("another kind", png[:25] + b"\x07" + png[26:])):
            with self.subTest(name):
                self.assertTrue(self.decoded(damaged)["error"])

    def decoded(self, data):
        return self.browser.driver.execute_async_script("""const done = arguments[1];
            decodePng(new Uint8Array(arguments[0])).then(({max, rgba}) => done({max, rgba: [...rgba]}), (error) => done({error: String(error)}))""", list(data))


class Accepting(Page):
    def setUp(self):
        super().setUp()
        for file in downloads.iterdir():
            file.unlink()
        self.acceptable = [each["name"] for each in self.data["cases"] if each.get("acceptable")]

    def downloaded(self):
        self.browser.click("#download")
        file = downloads / "accept.txt"
        self.browser.wait(lambda: file.exists() and file.read_text(), "the list")
        return file.read_text()

    def accepted(self):
        return self.browser.script("""return [...document.querySelectorAll('.row')].filter((row) => !row.querySelector('.accepted').hidden)
            .map((row) => row.querySelector('.name').textContent)""")

    def test_one_case(self):
        self.assertIn(HOSTILE[FAILED], self.acceptable)
        self.look_at(FAILED)
        self.assertEqual(self.browser.one("#accept").get_attribute("aria-pressed"), "false")
        self.browser.keys("a")
        self.assertEqual(self.browser.one("#accept").get_attribute("aria-pressed"), "true")
        self.assertEqual(self.browser.texts("#said"), ["1 case accepted"])
        self.assertEqual(self.accepted(), [HOSTILE[FAILED]])
        self.assertEqual(self.downloaded(), HOSTILE[FAILED] + "\n")
        self.assertIn("texshot test suite.json --accept accept.txt", self.browser.text("#tray"))
        self.browser.click("#accept")
        self.assertEqual(self.accepted(), [])
        self.browser.keys("u")
        self.assertEqual(self.accepted(), [HOSTILE[FAILED]])

    def test_all_that_are_shown(self):
        self.browser.click(".chip[data-state=failed]")
        failed = [each["name"] for each in self.data["cases"] if each["state"] == "failed"]
        self.assertEqual(self.browser.text("#accept-all"), f"Accept all shown ({len(failed)})")
        self.browser.click("#accept-all")
        self.assertFalse(self.browser.one("#accept-all").is_enabled())
        self.assertCountEqual(self.accepted(), failed)
        self.browser.click(".chip[data-state=failed]")
        self.browser.click("#accept-all")
        self.assertCountEqual(self.accepted(), self.acceptable)
        self.assertEqual(self.downloaded().splitlines(), self.acceptable)  # in the order of the run
        self.browser.click("#undo")
        self.assertCountEqual(self.accepted(), failed)
        self.browser.click("#clear")
        self.assertEqual(self.accepted(), [])
        self.browser.click("#undo")
        self.assertCountEqual(self.accepted(), failed)

    def test_the_list_is_copied(self):
        self.browser.tool("Browser.grantPermissions", permissions=["clipboardReadWrite", "clipboardSanitizedWrite"])
        self.browser.click("#accept-all")
        self.browser.click("#copy")
        self.browser.wait(lambda: self.browser.texts("#said") == ["Copied"] and self.browser.text("#copy") == "Copied", "the copy")
        self.assertEqual(self.browser.driver.execute_async_script("navigator.clipboard.readText().then(arguments[0])").splitlines(), self.acceptable)

    def test_the_browser_keeps_it_for_this_run_alone(self):
        folder = sample(self.path / "twice", 20)
        self.open(folder)
        self.browser.click("#accept-all")
        names = self.accepted()
        self.assertGreater(len(names), 2)
        self.open(folder)
        self.assertEqual(self.accepted(), names)
        self.open(sample(folder, 21))  # the next run
        self.assertEqual(self.accepted(), [])

    def test_what_cannot_be_accepted_has_no_button(self):
        for state in ("crashed", "missing", "skipped", "passed"):
            self.look_at(STATES.index(state))
            self.assertEqual(self.browser.all("#accept"), [], state)
            self.browser.keys("a")
        self.assertEqual(self.accepted(), [])


def contrast(*colors):
    """WCAG 2.2, of two colours of 0 to 255."""
    linear = lambda each: each / 12.92 if each <= 0.04045 else ((each + 0.055) / 1.055) ** 2.4
    dark, light = sorted(sum(weight * linear(each / 255) for weight, each in zip((0.2126, 0.7152, 0.0722), color)) for color in colors)
    return (light + 0.05) / (dark + 0.05)


LIGHT = "rgb(246, 246, 244)"
DARK = "rgb(23, 25, 27)"

# For each visible text: the contrast of its colour with the background (WCAG 2.2, contrast ratio).
CONTRASTS = """
const parse = (text) => (text.match(/[\\d.]+/g) ?? []).map(Number);
const luminance = (rgb) => rgb.slice(0, 3).map((each) => each / 255).map((each) => each <= 0.04045 ? each / 12.92 : ((each + 0.055) / 1.055) ** 2.4)
  .reduce((sum, each, k) => sum + each * [0.2126, 0.7152, 0.0722][k], 0);
const behind = (element) => {
  for (; element; element = element.parentElement) {
    const color = parse(getComputedStyle(element).backgroundColor);
    if (color.length === 3) return color;
  }
  return [255, 255, 255];
};
const found = [];
for (const element of document.querySelectorAll('body *')) {
  if (![...element.childNodes].some((node) => node.nodeType === 3 && node.textContent.trim())) continue;
  if (!element.checkVisibility() || element.matches('.unseen, :disabled, :disabled *, script, noscript')) continue;
  const [a, b] = [luminance(parse(getComputedStyle(element).color)), luminance(behind(element))];
  found.push([(Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05), element.className + ' ' + element.textContent.slice(0, 30)]);
}
return found;
"""


class Seeing(Page):
    def background(self):
        return self.browser.one("body").value_of_css_property("background-color").replace("rgba", "rgb").replace(", 1)", ")")

    def test_light_and_dark(self):
        self.assertEqual(self.background(), LIGHT)
        self.browser.media("dark")
        self.assertEqual(self.background(), DARK)
        self.assertEqual(self.browser.text("#theme"), "Theme: auto")
        self.browser.click("#theme")
        self.assertEqual((self.browser.text("#theme"), self.background()), ("Theme: light", LIGHT))
        self.browser.keys("t")
        self.browser.media("light")
        self.assertEqual((self.browser.text("#theme"), self.background()), ("Theme: dark", DARK))
        self.open()
        self.assertEqual(self.background(), DARK)

    def test_every_text_has_contrast(self):
        for scheme in ("light", "dark"):
            self.browser.media(scheme)
            for case in (None, FAILED, STATES.index("new"), STATES.index("skipped")):
                if case is None:
                    self.open()
                else:
                    self.look_at(case)
                    self.browser.keys("a")
                found = self.browser.script(CONTRASTS)
                self.assertGreater(len(found), 40)
                self.assertEqual([each for each in found if each[0] < 4.5], [], scheme)
            placeholder, behind = self.browser.script("""const parse = (text) => text.match(/[\\d.]+/g).map(Number);
                const search = document.getElementById('search');
                return [parse(getComputedStyle(search, '::placeholder').color), parse(getComputedStyle(search).backgroundColor)]""")
            self.assertGreaterEqual(contrast(placeholder, behind), 4.5, scheme)
            self.browser.script("localStorage.clear()")

    def test_every_control_has_a_name_and_shows_its_focus(self):
        self.look_at(FAILED)
        for view in "1234":
            self.browser.keys(view)
            nameless = self.browser.script("""return [...document.querySelectorAll('button, a, input, select, [role=slider]')]
                .filter((each) => !(each.textContent.trim() || each.ariaLabel)).map((each) => each.outerHTML)""")
            self.assertEqual(nameless, [])
        self.browser.keys(Keys.TAB)
        self.assertEqual(self.browser.script("const style = getComputedStyle(document.activeElement);"
                                             "return [document.activeElement.tagName !== 'BODY', style.outlineStyle, style.outlineWidth]"), [True, "solid", "2px"])

    def test_a_phone_has_no_sideways_scrolling(self):
        self.browser.size(360, 740, phone=True)
        self.open()
        widths = lambda: self.browser.script("return [document.documentElement.scrollWidth, window.innerWidth, visualViewport.width]")
        self.assertEqual(widths(), [360, 360, 360])
        self.assertTrue(self.browser.one(".row").is_displayed())
        self.assertFalse(self.browser.one("main").is_displayed())
        self.browser.click("#to-overview")
        self.browser.wait(lambda: self.browser.one("main").is_displayed(), "the overview")
        self.assertEqual(widths(), [360, 360, 360])
        for case in HOSTILE:
            self.look_at(case)
            for view in "1234":
                self.browser.keys(view)
                self.wait_for_pictures()
                self.assertEqual(widths(), [360, 360, 360], (case, view))
        self.assertFalse(self.browser.one(".row").is_displayed())
        self.browser.click("#to-list")
        self.browser.wait(lambda: self.browser.one(".row").is_displayed(), "the list")
        self.assertEqual(widths(), [360, 360, 360])

    def test_a_phones_list_comes_back_as_it_was_left(self):
        self.browser.size(360, 740, phone=True)
        self.open()
        names = self.names()
        self.browser.script("document.querySelectorAll('.row a')[40].scrollIntoView({ block: 'center' })")
        left = self.browser.script("return scrollY")
        self.assertGreater(left, 1000)
        self.browser.script("document.querySelectorAll('.row a')[40].click()")
        self.looks_at(names[40])
        self.browser.wait(lambda: self.browser.script("return scrollY") == 0, "its top")
        for back in ("document.getElementById('to-list').click()", "history.back()"):
            self.browser.script(back)
            self.browser.wait(lambda: self.browser.script("return document.body.dataset.show") == "list", "the list")
            self.browser.wait(lambda: abs(self.browser.script("return scrollY") - left) < 200, "where it was")
            self.assertTrue(self.browser.script("""const box = document.querySelector('.row.last').getBoundingClientRect();
                return box.top >= 0 && box.bottom <= innerHeight"""))
            self.assertEqual(self.browser.texts(".row.last .name"), [names[40]])
            if back.startswith("document"):
                self.browser.script("document.querySelectorAll('.row a')[40].click()")
                self.looks_at(names[40])

    def test_what_is_said_of_a_case_has_room(self):
        self.look_at(FAILED)
        width = lambda selector: self.browser.box(selector)[2]
        self.assertGreater(width("pre"), 0.95 * width(".said-of-it"))
        self.browser.size(1920, 1080)
        self.assertGreater(width("pre"), 0.6 * width(".said-of-it"))
        left, top, _, _ = self.browser.box("pre")
        facts_left, facts_top, facts_width, _ = self.browser.box(".facts")
        self.assertGreater(left, facts_left + facts_width)
        self.assertLess(abs(top - facts_top), 40)

    def test_a_command_breaks_between_words(self):
        self.browser.size(360, 740, phone=True)
        self.look_at(FAILED)
        for word in self.browser.all(".command .word"):
            lines = self.browser.script("return arguments[0].getClientRects().length", word)
            self.assertEqual(lines, 1, word.text)
            self.assertLess(word.size["height"], 30, word.text)

    def test_paper_has_what_is_looked_at_and_no_controls(self):
        self.look_at(FAILED)
        self.browser.media(kind="print")
        for selector in (".cases", ".tools", "#accept", "#theme"):
            self.assertEqual(self.browser.shown(selector), [], selector)
        self.assertTrue(self.browser.one("#case-name").is_displayed())
        self.assertTrue(self.browser.one("pre").is_displayed())
        self.assertEqual(self.browser.one("main").value_of_css_property("overflow"), "visible")


class Opened(Page):
    COUNT = 2000

    # The time is printed and depends on the machine; only the complete list is checked.
    def test_two_thousand_cases(self):
        self.browser.wait(lambda: self.browser.script("return performance.getEntriesByName('first-contentful-paint').length"), "the first picture")
        times = self.browser.script("""const [page] = performance.getEntriesByType('navigation');
            return { loaded: page.loadEventEnd, painted: performance.getEntriesByName('first-contentful-paint')[0].startTime,
                     shown: performance.getEntriesByName('texplorer-shown')[0].startTime }""")
        print(f"2,000 cases: loaded after {times['loaded']:.0f} ms, painted {times['painted']:.0f} ms, list shown {times['shown']:.0f} ms", file=sys.stderr)
        names = self.names()
        self.assertEqual(len(names), 2000)
        self.browser.keys("/")
        self.browser.keys("case-1999")
        self.assertEqual(self.names(), ["wrap/GL_REPEAT/case-1999"])


if __name__ == "__main__":
    unittest.main()
