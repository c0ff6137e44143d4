"""What a user does with the window, and what the window does by itself."""

import json
import time
import unittest

from PIL import Image

from texplorer import Window, PATIENCE, wait_for


class AtTheWindow(Window):
    def test_shows_edits_saves_and_closes(self):
        picture = self.display.screenshot()
        middle = picture.crop((400, 200, 850, 600))
        self.assertGreater(len(set(middle.getdata())), 50, "a lit cube and sphere have many shades")
        before = self.save()

        self.orbit()
        wait_for(lambda: "•" in self.title(), "the mark of unsaved changes")
        after = self.save()
        self.assertNotEqual(after["view"]["azimuth"], before["view"]["azimuth"])
        self.assertEqual({**after, "view": before["view"]}, before)
        wait_for(lambda: "•" not in self.title(), "the mark to go away")

        self.display.xdotool("key", "ctrl+z")
        wait_for(lambda: "•" in self.title(), "the undone change")
        self.assertEqual(self.save(), before)

        self.display.ask_to_close(self.window)
        self.assertEqual(self.program.wait(PATIENCE), 0)
        self.assertEqual(self.program.stderr.read(), "")

    def test_asks_before_it_loses_changes(self):
        self.orbit()
        wait_for(lambda: "•" in self.title(), "the mark of unsaved changes")
        quiet = self.display.screenshot()
        self.display.ask_to_close(self.window)
        wait_for(lambda: self.display.screenshot().getpixel((20, 300)) != quiet.getpixel((20, 300)),
                 "the question, which dims the window")
        self.assertIsNone(self.program.poll())
        self.display.xdotool("key", "Escape")
        wait_for(lambda: self.display.screenshot().getpixel((20, 300)) == quiet.getpixel((20, 300)),
                 "the window as it was")
        self.assertIsNone(self.program.poll())
        self.display.xdotool("key", "ctrl+z")
        wait_for(lambda: "•" not in self.title(), "the undone change")
        self.display.ask_to_close(self.window)
        self.assertEqual(self.program.wait(PATIENCE), 0)

    def test_settings_are_kept(self):
        self.display.xdotool("key", "ctrl+equal")
        kept = wait_for(lambda: (read := json.loads(self.settings.read_text())).get("textPercent") == 110 and read,
                        "the settings' file")
        self.assertEqual(kept["fromLater"], 1)
        recent = self.state / "texplorer" / "recent.json"
        wait_for(recent.exists, "the list of files")
        self.assertEqual(json.loads(recent.read_text()), [str(self.scene)])

    def test_writes_pictures(self):
        self.display.xdotool("key", "F12")
        wait_for(lambda: list(self.pictures.glob("*.png")), "the picture of the window")
        with Image.open(self.pictures / "texplorer-window.png") as window:
            window.load()
        self.assertEqual(window.size, (1280, 800))
        self.display.xdotool("key", "shift+F12")
        wait_for(lambda: len(list(self.pictures.glob("*.png"))) == 2, "the picture of the view")
        with Image.open(self.pictures / "texplorer-view.png") as view:
            view.load()
        self.assertLess(view.size, window.size)
        self.assertGreater(len(set(view.convert("RGB").getdata())), 50)

    def test_the_reference_draws_beside_the_window(self):
        self.display.xdotool("mousemove", 2, 798)  # where there is no tooltip
        before = self.display.screenshot()
        place = (330, 70, 900, 460)
        self.display.xdotool("key", "3")
        wait_for(lambda: self.display.screenshot().crop(place).tobytes() != before.crop(place).tobytes(),
                 "the reference's picture")
        self.orbit()
        wait_for(lambda: "•" in self.title(), "the mark of unsaved changes")
        self.display.xdotool("key", "ctrl+z")
        wait_for(lambda: "•" not in self.title(), "the undone change")
        self.display.xdotool("mousemove", 2, 798, "key", "1")
        wait_for(lambda: self.display.screenshot().crop(place).tobytes() == before.crop(place).tobytes(),
                 "the picture of the first renderer again")
        self.display.xdotool("key", "3")
        self.wait_until_it_rests()  # the whole picture, and no more

    def test_a_window_of_one_pixel_goes_on(self):
        before = self.display.xdotool("getwindowgeometry", "--shell", self.window)
        for width, height in ((1, 1), (1, 600), (600, 1), (3, 2), (40, 40)):
            self.display.xdotool("windowsize", "--sync", self.window, width, height)
            time.sleep(0.3)
            self.running()
        self.display.xdotool("windowsize", self.window, 1280, 800)
        self.assertIn("WIDTH=1280", before)
        wait_for(lambda: len(set(self.display.screenshot().crop((400, 200, 850, 600)).getdata())) > 50,
                 "the picture again")

    def test_the_last_frame_is_drawn(self):
        """What comes from a worker needs some frames until its columns have their widths."""
        self.display.xdotool("mousemove", 500, 400)
        before = self.display.screenshot()
        details = (321, 500, 1280, 770)  # the dock below
        self.display.xdotool("keydown", "e")
        wait_for(lambda: self.display.screenshot().crop(details).tobytes() != before.crop(details).tobytes(),
                 "the explanation")
        self.display.xdotool("keyup", "e")
        self.wait_until_it_rests()
        resting = self.display.screenshot().crop(details)
        self.display.xdotool("mousemove", 500, 401)
        self.wait_until_it_rests()
        self.assertEqual(self.display.screenshot().crop(details).tobytes(), resting.tobytes())

    def test_a_click_as_fast_as_the_display_is_one(self):
        """Press, release and the next place may come within one frame."""
        before = self.save()
        self.display.xdotool("mousemove", 600, 440, "mousedown", 1, "mousemove", 700, 440, "mouseup", 1,
                             "mousemove", 610, 430)
        wait_for(lambda: "•" in self.title(), "the mark of unsaved changes")
        self.assertNotEqual(self.save()["view"]["azimuth"], before["view"]["azimuth"])

    def test_sleeps_while_nothing_happens(self):
        self.wait_until_it_rests()


class CoreProfile(AtTheWindow):
    """A driver that has given up fixed functions: everything works, and the reference draws."""

    VARIABLES = {"MESA_GL_VERSION_OVERRIDE": "3.3FC"}

    def test_keys_of_what_is_not_there_change_nothing(self):
        place = (330, 70, 900, 460)
        self.display.xdotool("mousemove", 2, 798)
        self.wait_until_it_rests()
        before = self.display.screenshot().crop(place).tobytes()
        for key in "124":
            self.display.xdotool("key", key)
        self.wait_until_it_rests()
        self.assertEqual(self.display.screenshot().crop(place).tobytes(), before)
        colours = {colour for _, colour in self.display.screenshot().crop((0, 772, 1280, 800)).getcolors(1 << 20)}
        self.assertTrue(any(red > 200 and 100 < green < 180 and blue < 130 for red, green, blue in colours),
                        "see the status bar")

    test_the_reference_draws_beside_the_window = None  # it draws always


class ByEgl(Window):
    """Where the display has no GLX, which the window asks unless it is told otherwise."""

    OPTIONS = ("--context", "egl")
    DISPLAY = ("-extension", "GLX")
    VARIABLES = {"EGL_PLATFORM": "wayland"}  # which GLFW knows better

    def test_shows_edits_and_saves(self):
        self.assertGreater(len(set(self.display.screenshot().crop((400, 200, 850, 600)).getdata())), 50)
        before = self.save()
        self.orbit()
        wait_for(lambda: "•" in self.title(), "the mark of unsaved changes")
        self.assertNotEqual(self.save()["view"]["azimuth"], before["view"]["azimuth"])

    def test_looks_as_by_glx(self):
        self.display.xdotool("mousemove", 2, 798)  # where there is no tooltip
        self.wait_until_it_rests()
        by_egl = self.display.screenshot()
        self.end_program()
        self.display.close()
        self.OPTIONS, self.DISPLAY = (), ()
        self.setUp()
        self.display.xdotool("mousemove", 2, 798)
        self.wait_until_it_rests()
        views = (330, 70, 900, 460)
        self.assertEqual(self.display.screenshot().crop(views).tobytes(), by_egl.crop(views).tobytes())


if __name__ == "__main__":
    unittest.main(verbosity=2)
