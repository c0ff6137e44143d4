#!/usr/bin/env python3
"""page_test.py PAGE [CASE…]: the page in Chromium, from a server that knows nothing but files."""

import functools
import hashlib
import http.server
import io
import json
import pathlib
import re
import sys
import tempfile
import threading
import unittest

from PIL import Image, ImageChops

from browser import Browser, Keys

PAGE = pathlib.Path()
PROJECT = pathlib.Path(__file__).resolve().parents[2]
SCENES = PROJECT / "assets/scenes"
DOCUMENT = PROJECT / "docs/web.md"
MOUSE = 0


class Server(http.server.ThreadingHTTPServer):
    """Serves the page, and counts what is asked for."""

    def __init__(self):
        self.paths = []
        server = self

        class Handler(http.server.SimpleHTTPRequestHandler):
            def log_message(self, *_):
                server.paths.append(self.path)

        super().__init__(("localhost", 0), functools.partial(Handler, directory=str(PAGE)))
        threading.Thread(target=self.serve_forever, daemon=True).start()

    @property
    def address(self):
        return f"http://localhost:{self.server_port}/"


browser = None  # one for all; each test has an address, and with it a storage, of its own
downloads = pathlib.Path()


def setUpModule():
    global browser, downloads
    folder = tempfile.TemporaryDirectory()
    unittest.addModuleCleanup(folder.cleanup)
    downloads = pathlib.Path(folder.name)
    browser = Browser(downloads)
    unittest.addModuleCleanup(browser.quit)


class PageTest(unittest.TestCase):
    tour_is_over = False

    def setUp(self):
        self.server = Server()
        self.addCleanup(self.server.server_close)
        self.addCleanup(self.server.shutdown)
        self.browser = browser
        self.downloads = downloads
        self.browser.size(1280, 800)
        self.addCleanup(self.browser.driver.get, "about:blank")

    def open(self, fragment=""):
        self.browser.driver.get("about:blank")
        self.browser.driver.get(self.server.address + fragment)
        self.ready()
        if not self.tour_is_over:
            self.click("tour:Skip")
            self.until(lambda: self.browser.script("return texplorer.place('tour:Skip')") is None)
            self.tour_is_over = True

    def ready(self):
        self.browser.wait(lambda: self.browser.script("return document.documentElement.dataset.state") == "ready",
                          "the window")

    def place(self, name):
        return self.browser.wait(lambda: self.browser.script("return texplorer.place(arguments[0])", name), name)

    def middle(self, name):
        left, top, right, bottom = self.place(name)
        return (left + right) / 2, (top + bottom) / 2

    def mouse(self, kind, x, y, button="left", buttons=0):
        self.browser.tool("Input.dispatchMouseEvent", type=kind, x=x, y=y, button=button, buttons=buttons, clickCount=1)

    def click(self, name):
        x, y = self.middle(name)
        self.mouse("mouseMoved", x, y, "none")
        self.mouse("mousePressed", x, y, buttons=1)
        self.mouse("mouseReleased", x, y)

    def spoken(self, selector):
        return self.browser.script("return document.querySelector(arguments[0]).textContent", selector)

    def send(self, **message):
        return self.browser.script("return texplorer.send(arguments[0])", {"texplorer": 1, **message})

    def parameter(self, path):
        value = self.send(do="read")["scene"]
        for name in path.replace("]", "").replace("[", ".").split("."):
            value = value[int(name) if name.isdigit() else name]
        return value

    def until(self, condition):
        return self.browser.wait(condition, self.id())

    def key(self, key, code, control=False):
        held = 2 if control else 0
        for kind in ("rawKeyDown", "keyUp"):
            self.browser.tool("Input.dispatchKeyEvent", type=kind, key=key, code=code, modifiers=held)

    def tap(self, name):
        """The browser makes both of its events: a slow machine does not make a long press of it."""
        x, y = self.middle(name)
        self.browser.tool("Input.synthesizeTapGesture", x=x, y=y, gestureSourceType="touch")

    def fingers(self, *moments):
        """Each moment has the places of all fingers."""
        for i, places in enumerate(moments):
            points = [{"x": x, "y": y, "id": number} for number, (x, y) in enumerate(places)]
            self.browser.tool("Input.dispatchTouchEvent", type="touchMove" if i else "touchStart", touchPoints=points)
        self.browser.tool("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])

    def picture(self):
        return Image.open(io.BytesIO(self.browser.driver.get_screenshot_as_png())).convert("RGB")

    def downloaded(self, pattern):
        def whole():
            return [path for path in self.downloads.glob(pattern) if path.suffix != ".crdownload"]
        return self.browser.wait(whole, pattern)[0]


class Opening(PageTest):
    def test_the_window_is_drawn_and_nothing_is_complained_of(self):
        self.browser.complaints()  # of others
        self.open()
        self.assertNotIn("drawn without", self.spoken("#status"))
        self.assertGreater(len(set(self.picture().getdata())), 1000)
        ours = [each for each in self.browser.complaints() if "GL Driver Message" not in each]
        self.assertEqual(ours, [])

    def test_only_files_of_its_own_are_asked_for(self):
        self.open()
        hosts = self.browser.script("return performance.getEntriesByType('resource').map((each) => new URL(each.name).host)")
        self.assertEqual(set(hosts), {self.server.address.split("/")[2]})

    def test_the_chinese_font_is_fetched_when_a_name_needs_it(self):
        asked = "return performance.getEntriesByType('resource').some((each) => each.name.endsWith('fonts/Chinese.ttf'))"
        self.open()
        self.assertFalse(self.browser.script(asked))
        Files.drop(self, **{"纹理.bmp": Files.RED})
        self.until(lambda: self.browser.script(asked))
        self.assertEqual(self.parameter("textures[0].file"), "纹理.bmp")


class Input(PageTest):
    def test_a_choice_is_clicked_and_undone(self):
        self.open()
        before = self.picture()
        self.click("textures[0].wrapS=GL_CLAMP_TO_EDGE")
        self.until(lambda: self.parameter("textures[0].wrapS") == "GL_CLAMP_TO_EDGE")
        self.until(lambda: self.picture() != before)
        self.key("z", "KeyZ", control=True)
        self.until(lambda: self.parameter("textures[0].wrapS") == "GL_REPEAT")

    def test_a_finger_presses_what_it_touches_first(self):
        """Without a mouse before it: the position must arrive before the press."""
        self.open()
        self.tap("textures[0].wrapS=GL_CLAMP_TO_EDGE")
        self.until(lambda: self.parameter("textures[0].wrapS") == "GL_CLAMP_TO_EDGE")
        self.tap("textures[0].wrapS=GL_REPEAT")
        self.until(lambda: self.parameter("textures[0].wrapS") == "GL_REPEAT")

    def test_one_finger_orbits_and_two_zoom(self):
        self.open()
        x, y = self.middle("view")
        azimuth, distance = self.parameter("view.azimuth"), self.parameter("view.distance")
        self.browser.tool("Input.synthesizeScrollGesture", x=x, y=y, xDistance=60, gestureSourceType="touch")
        self.until(lambda: self.parameter("view.azimuth") != azimuth)
        self.assertEqual(self.parameter("view.distance"), distance)
        self.fingers(*[[(x - gap, y), (x + gap, y)] for gap in (40, 50, 60, 80)])
        self.until(lambda: float(self.parameter("view.distance")) < float(distance))

    def test_a_long_press_explains_the_pixel(self):
        self.open()
        x, y = self.middle("view")
        self.browser.tool("Input.dispatchTouchEvent", type="touchStart", touchPoints=[{"x": x, "y": y}])
        self.place("explained pixel")
        self.browser.tool("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])

    def scrolls(self, before, *moments):
        """Again if need be: where the page answers late, the fingers rest long enough for a long press."""
        def has_moved():
            self.fingers(*moments)
            return self.browser.script("return texplorer.place('textures[0].wrapS')") != before
        self.until(has_moved)
        self.assertEqual(self.parameter("textures[0].wrapS"), "GL_REPEAT")

    def test_two_fingers_scroll_a_list(self):
        self.browser.size(1000, 480)
        self.open("#layout=teacher")
        before = self.place("textures[0].wrapS")
        x, y = self.middle("textures[0].wrapS")
        self.scrolls(before, *[[(x - 20, y - move), (x + 20, y - move)] for move in (0, 20, 40, 80, 120)])

    def test_one_finger_scrolls_a_list(self):
        self.browser.size(1000, 480)
        self.open("#layout=teacher")
        before = self.place("textures[0].wrapS")
        x, y = self.middle("textures[0].wrapS")
        self.scrolls(before, *[[(x, y - move)] for move in (0, 12, 32, 62, 92)])

    def test_a_phone_has_large_controls_and_one_panel(self):
        self.browser.tool("Emulation.setTouchEmulationEnabled", enabled=True, maxTouchPoints=5)
        self.addCleanup(self.browser.tool, "Emulation.setTouchEmulationEnabled", enabled=False)
        self.browser.size(360, 740, phone=True)
        self.open()
        for name in ("menu:File", "menu:View", "lower panel", "parameters' tabs"):
            left, top, right, bottom = self.place(name)
            self.assertGreaterEqual(bottom - top, 36, name)  # and 2 pixels above and below it
        for tab in ("Explain", "Vertices"):  # of both docks
            self.tap("lower panel")
            self.tap(f"lower:{tab}")
        self.place("vertex:0")
        self.tap("menu:File")
        left, top, right, bottom = self.place("menu:Copy link to this scene")
        self.assertGreaterEqual(bottom - top, 36)
        self.browser.script("navigator.clipboard.writeText = (text) => { window.copied = text; return Promise.resolve(); }")
        self.tap("menu:Copy link to this scene")
        self.until(lambda: self.browser.script("return window.copied"))

    def test_the_wheel_stays_in_the_page(self):
        self.open()
        x, y = self.middle("view")
        distance = self.parameter("view.distance")
        self.browser.point(x, y, wheel=-300)
        self.until(lambda: float(self.parameter("view.distance")) < float(distance))
        self.assertEqual(self.browser.script("return [scrollX, scrollY, visualViewport.scale]"), [0, 0, 1])

    def test_text_is_typed_pasted_and_copied(self):
        self.open()
        self.key("f", "KeyF", control=True)
        self.until(lambda: self.browser.script("return document.activeElement.id") == "field")
        self.browser.keys("aniso")
        self.until(lambda: any(self.browser.script("return texplorer.place(`found:${arguments[0]}`)", i) for i in range(1, 40)))


class Files(PageTest):
    # A BMP file of one red pixel: 54 bytes of headers (MSDN, BITMAPINFOHEADER), blue, green, red and a byte of padding.
    RED = (b"BM" + (58).to_bytes(4, "little") + bytes(4) + (54).to_bytes(4, "little") + (40).to_bytes(4, "little")
           + (1).to_bytes(4, "little") * 2 + b"\1\0\x18\0" + bytes(24) + b"\0\0\xff\0")

    def drop(self, **files):
        self.browser.script("""
            const transfer = new DataTransfer();
            for (const [name, bytes] of Object.entries(arguments[0]))
                transfer.items.add(new File([new Uint8Array(bytes)], name));
            document.querySelector('canvas').dispatchEvent(
                new DragEvent('drop', { dataTransfer: transfer, bubbles: true, cancelable: true }));
            """, {name: list(content) for name, content in files.items()})

    def test_a_dropped_image_becomes_the_texture(self):
        self.open()
        self.drop(**{"red.bmp": self.RED})
        self.until(lambda: self.parameter("textures[0].file") == "red.bmp")
        self.drop(**{"broken.bmp": b"BM no image"})
        self.until(lambda: "broken.bmp" in self.spoken("#status"))

    def test_a_file_that_changes_is_read_again(self):
        """From the browser's own folder: its files have the same handles as those of a disk."""
        self.open()
        write = """const [name, bytes, answered] = arguments; (async () => {
            const handle = await (await navigator.storage.getDirectory()).getFileHandle(name, { create: true });
            const stream = await handle.createWritable(); await stream.write(new Uint8Array(bytes)); await stream.close();
            window.showOpenFilePicker = async () => [handle]; })().then(() => answered(null), (error) => answered(String(error)))"""
        blue = self.RED[:-4] + bytes([255, 0, 0, 0])
        self.assertIsNone(self.browser.driver.execute_async_script(write, "paint.bmp", list(self.RED)))
        self.click("menu:File")
        self.click("menu:Open image…")
        self.until(lambda: self.parameter("textures[0].file") == "paint.bmp")
        def shows(strong, weak):
            left, top, right, bottom = self.place("view")
            colour = self.picture().getpixel((int(left + 0.3 * (right - left)), int((top + bottom) / 2)))  # of the cube
            return colour[strong] > 2 * colour[weak]
        self.until(lambda: shows(0, 2))
        self.assertIsNone(self.browser.driver.execute_async_script(write, "paint.bmp", list(blue)))
        self.until(lambda: shows(2, 0))
        self.assertIsNone(self.browser.driver.execute_async_script(write, "paint.bmp", list(blue[:30])))
        self.until(lambda: "has changed and can't be read" in self.spoken("#status"))
        self.assertEqual(self.parameter("textures[0].file"), "paint.bmp")

    def test_a_picture_is_downloaded(self):
        self.open()
        self.click("menu:File")
        self.click("menu:Picture of the view")
        picture = Image.open(self.downloaded("texplorer-*.png"))
        self.assertGreater(picture.width, 100)
        self.assertGreater(len(set(picture.convert("RGB").getdata())), 100)

    def test_an_animation_is_recorded_while_the_window_goes_on(self):
        self.open()
        self.send(do="set", path="models[0].spin", value="0,90,0")
        for name in ("menu:File", "menu:Record animation…", "record:GIF", "record:choose",
                     "textures[0].wrapS=GL_CLAMP"):
            self.click(name)
        self.until(lambda: self.parameter("textures[0].wrapS") == "GL_CLAMP")
        with Image.open(self.downloaded("*.gif")) as recorded:
            self.assertEqual((recorded.format, recorded.n_frames), ("GIF", 100))

    def test_a_link_leads_back_to_the_scene(self):
        self.open()
        self.send(do="set", path="textures[0].wrapS", value="GL_CLAMP")
        self.until(lambda: self.parameter("textures[0].wrapS") == "GL_CLAMP")
        self.browser.script("navigator.clipboard.writeText = (text) => { window.copied = text; return Promise.resolve(); }")
        self.click("menu:File")
        self.click("menu:Copy link to this scene")
        link = self.until(lambda: self.browser.script("return window.copied"))
        self.assertTrue(link.startswith(self.server.address + "#texplorer:1:"), link[:60])
        self.open()
        self.assertEqual(self.parameter("textures[0].wrapS"), "GL_REPEAT")
        self.browser.script("location.hash = arguments[0]", link.split("#")[1])
        self.until(lambda: self.parameter("textures[0].wrapS") == "GL_CLAMP")

    def test_a_damaged_link_is_a_message(self):
        self.open("#texplorer:1:AAAA")
        self.until(lambda: "damaged" in self.spoken("#status"))


class Renderers(PageTest):
    SCENES = ["checker", "floats", "internal-formats", "packed-pixels"]  # without animation

    def setUp(self):
        super().setUp()
        self.browser.complaints()  # of others

    def view(self, renderer):
        for old in self.downloads.glob("texplorer-*.png"):
            old.unlink()
        self.click(f"renderer:{renderer}")
        self.click("menu:File")
        self.click("menu:Picture of the view")
        return Image.open(self.downloaded("texplorer-*.png")).convert("RGB")

    def test_workers_draw_the_reference(self):
        self.open()
        self.browser.script("""const Plain = Worker; window.made = 0;
            window.Worker = class extends Plain { constructor(...values) { super(...values); window.made += 1; } };""")
        same = json.loads((PROJECT / "tests/support/reference_picture.json").read_text(encoding="utf-8"))
        scene = json.loads((SCENES / f"{same['example']}.json").read_text(encoding="utf-8"))
        self.assertNotIn("error", self.send(do="load", scene=scene))
        before = self.view("Reference")
        self.assertEqual(list(before.size), same["size"])  # of the view at 1280 x 800
        self.assertEqual(hashlib.sha256(before.tobytes()).hexdigest(), same["sha256"])  # as texshot's
        self.send(do="set", path="view.azimuth", value="50")
        self.assertNotEqual(list(self.view("Reference").getdata()), list(before.getdata()))
        self.assertGreater(self.browser.script("return window.made"), 0)

    def test_shaders_draw_what_the_reference_draws(self):
        self.open()
        for name in self.SCENES:
            with self.subTest(name):
                scene = json.loads((SCENES / f"{name}.json").read_text(encoding="utf-8"))
                self.assertNotIn("error", self.send(do="load", scene=scene))
                shader, reference = self.view("Shader"), self.view("Reference")
                self.click("renderer:Shader")  # the next one is not drawn by the reference first
                self.assertEqual(shader.size, reference.size)
                self.assertGreater(len(set(reference.getdata())), 1)
                far = sum(max(each) > 8 for each in ImageChops.difference(shader, reference).getdata())
                self.assertLess(far, 0.01 * shader.width * shader.height)
        ours = [each for each in self.browser.complaints() if "GL Driver Message" not in each]
        self.assertEqual(ours, [])

    def test_shaders_are_shown(self):
        self.open()
        self.click("renderer:Shader")
        self.click("tab:GLSL")
        self.until(lambda: self.browser.script("return texplorer.place('glsl:1')") is not None)


class Lessons(PageTest):
    def test_a_lesson_is_answered_without_the_canvas(self):
        """As a screen reader does it: by the page's own controls."""
        self.open("#lesson=first-texture&step=2")
        self.until(lambda: len(self.browser.all("#lesson ol button")) > 2)
        self.assertTrue(self.browser.script("return document.querySelector('#lesson .text').textContent"))
        self.browser.script("document.querySelectorAll('#lesson ol button')[2].click()")
        self.until(lambda: self.spoken("#lesson .verdict"))
        done = next(each for each in self.send(do="read")["answers"] if each["lesson"] == "first-texture")
        self.assertTrue(done["steps"][1]["done"])

    def step_of(self, lesson, step):
        return next(each for each in self.send(do="read")["answers"] if each["lesson"] == lesson)["steps"][step - 1]

    def test_a_picture_is_reached_by_mouse_and_touch(self):
        wanted = ("textures[0].wrapS=GL_CLAMP_TO_EDGE", "textures[0].wrapT=GL_CLAMP_TO_BORDER")
        for press in (self.click, self.tap):
            with self.subTest(press.__name__):
                self.open("#lesson=wrap&step=3")
                for choice in wanted:
                    press(choice)
                self.place("reached")
                self.assertTrue(self.step_of("wrap", 3)["done"])
                self.send(do="open", address="lesson=wrap&step=1")

    def test_a_page_around_it_sets_parameters_and_hears_of_lessons(self):
        self.open()  # over with the tour
        self.browser.driver.get(self.server.address + "lecture.html")
        frame = "const frame = document.querySelector('#scene').contentWindow;"
        for name in ("scene", "lesson"):
            self.until(lambda name=name: self.browser.script(
                f"return document.querySelector('#{name}').contentWindow.document.documentElement.dataset.state") == "ready")
        self.browser.script("document.querySelector('[data-value=GL_CLAMP]').click()")
        self.until(lambda: "GL_CLAMP" in self.spoken("#said"))
        self.until(lambda: self.browser.script(
            f"{frame} return frame.texplorer.send({{texplorer: 1, do: 'read'}}).scene.textures[0].wrapS") == "GL_CLAMP")
        self.browser.script("document.querySelector('[data-open]').click()")
        self.until(lambda: "Step 3: 1 of 7" in self.spoken("#progress"))

    def test_slides_around_it_set_parameters_and_hear_of_answers(self):
        self.open()  # over with the tour
        self.browser.complaints()  # of others
        self.browser.driver.get(self.server.address + "slides.html")
        self.browser.one(".reveal.ready")
        within = "const frame = document.querySelector('.present iframe').contentWindow; return frame."

        def go_on(hash):
            self.browser.keys(Keys.RIGHT)
            self.until(lambda: self.browser.script("return location.hash") == hash)

        def wait_for_the_window():
            self.until(lambda: self.browser.script(f"{within}document.documentElement.dataset.state") == "ready")
            self.assertEqual(len(self.browser.all("iframe[src]")), 1)

        def wait_for_mode(mode):
            self.until(lambda: self.browser.script(
                f"{within}texplorer.send({{texplorer: 1, do: 'read'}}).scene.textures[0].wrapT") == mode)

        go_on("#/1")
        wait_for_the_window()
        self.until(lambda: self.browser.script(f"{within}texplorer.send({{texplorer: 1, do: 'read'}}).scene.models[0].name") == "Square")
        for step, mode in enumerate(("GL_MIRRORED_REPEAT", "GL_CLAMP_TO_EDGE", "GL_CLAMP_TO_BORDER")):
            go_on(f"#/1/0/{step}")
            wait_for_mode(mode)
        self.browser.keys(Keys.LEFT)
        wait_for_mode("GL_CLAMP_TO_EDGE")
        go_on("#/1/0/2")
        go_on("#/2")
        wait_for_the_window()
        self.until(lambda: self.browser.script(f"{within}document.querySelectorAll('#lesson ol button').length"))
        self.browser.script(f"{within}document.querySelectorAll('#lesson ol button')[1].click()")
        self.until(lambda: "Answer 2" in self.spoken(".present .said"))
        left, top, width, height = self.browser.box(".present iframe")
        for kind, buttons in (("mousePressed", 1), ("mouseReleased", 0)):
            self.mouse(kind, left + width / 2, top + height / 2, buttons=buttons)
        self.until(lambda: self.browser.script("return document.activeElement.tagName") == "IFRAME")
        self.browser.keys(Keys.ESCAPE)
        self.until(lambda: self.browser.script("return document.activeElement.tagName") == "BODY")
        go_on("#/3")
        ours = [each for each in self.browser.complaints() if "GL Driver Message" not in each]
        self.assertEqual(ours, [])

    def test_the_page_of_the_document_works(self):
        """docs/web.md's iframe and script, with this server's address for the one that they name."""
        html, js = (re.search(rf"^```{language}\n(.*?)^```", DOCUMENT.read_text(), re.MULTILINE | re.DOTALL)[1]
                    .replace("https://example.org/texplorer/", self.server.address)
                    .replace("https://example.org", self.server.address[:-1]) for language in ("html", "js"))
        self.open()  # over with the tour
        self.browser.driver.get(self.server.address + "embed.json")  # of the same origin, and with no script of its own
        self.browser.script("""document.body.innerHTML = arguments[0]; window.frame = document.querySelector('iframe');
            window.said = []; console.log = (...words) => said.push(words)""", html)
        within = "return frame.contentWindow."
        self.until(lambda: self.browser.script(f"{within}document.documentElement.dataset.state") == "ready")
        self.browser.script(js)
        self.until(lambda: self.browser.script(
            f"{within}texplorer.send({{texplorer: 1, do: 'read'}}).scene.textures[0].wrapS") == "GL_CLAMP")
        self.browser.script(f"{within}texplorer.send({{texplorer: 1, do: 'open', address: 'lesson=wrap&step=5'}})")
        self.until(lambda: self.browser.script("return said.some(([lesson, step]) => lesson == 'wrap' && step == 5)"))

    def test_an_unknown_lesson_is_a_message(self):
        self.open("#lesson=first")
        self.until(lambda: "first-texture" in self.spoken("#status"))


class Storage(PageTest):
    def reopen(self):
        self.browser.driver.get("about:blank")  # the lock of the page ends
        self.browser.driver.get(self.server.address)
        self.ready()

    def test_settings_are_kept(self):
        self.open()
        self.stored("settings.json")
        self.reopen()
        self.browser.wait(lambda: self.browser.script("return texplorer.place('view')"), "the window")
        self.assertIsNone(self.browser.script("return texplorer.place('tour:Skip')"))

    def test_unsaved_work_is_offered_with_its_image(self):
        self.open()
        Files.drop(self, **{"red.bmp": Files.RED})
        self.until(lambda: self.parameter("textures[0].file") == "red.bmp")
        self.stored("unsaved/")
        self.reopen()
        self.click("restore:restore")
        self.until(lambda: self.parameter("textures[0].file") == "red.bmp")
        self.until(lambda: self.browser.script("return texplorer.place('restore:restore')") is None)
        self.assertNotIn("red.bmp", self.spoken("#status"))

    def stored(self, part):
        """Until a file whose path has this part is in the browser's storage."""
        self.until(lambda: self.browser.driver.execute_async_script("""
            const [part, answer] = arguments;
            indexedDB.open('texplorer /').onsuccess = ({ target }) => {
                target.result.transaction('files').objectStore('files').getAllKeys().onsuccess = ({ target: keys }) => {
                    target.result.close();
                    answer(keys.result.some((key) => key.includes(part)));
                };
            };""", part))


class Offline(PageTest):
    def test_the_page_opens_without_its_server(self):
        self.open()
        self.until(lambda: self.browser.driver.execute_async_script(
            "navigator.serviceWorker.ready.then(({ active }) => arguments[0](active.state === 'activated'))"))
        self.server.shutdown()
        self.server.server_close()
        self.browser.driver.get(self.server.address)
        self.ready()
        self.assertTrue(self.browser.driver.execute_async_script(
            "fetch('fonts/Chinese.ttf').then(({ ok }) => arguments[0](ok), () => arguments[0](false))"))

    def test_a_lost_context_is_restored(self):
        def above_the_status():  # which has the time that a frame took
            return self.picture().crop((0, 0, 1280, 770))
        self.open()
        before = above_the_status()
        self.browser.script("""
            const lose = document.querySelector('canvas').getContext('webgl2').getExtension('WEBGL_lose_context');
            lose.loseContext();
            setTimeout(() => lose.restoreContext(), 100);""")
        self.until(lambda: self.browser.script(
            "return !document.querySelector('canvas').getContext('webgl2').isContextLost()"))
        self.until(lambda: above_the_status() == before)


def main():
    global PAGE
    PAGE = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main()


if __name__ == "__main__":
    main()
