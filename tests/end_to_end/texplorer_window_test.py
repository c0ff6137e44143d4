"""Starts the real texplorer on a virtual display, acts as a user does, and looks at what comes of it."""

import ctypes
import io
import json
import os
import pathlib
import select
import signal
import subprocess
import sys
import tempfile
import time
import unittest

from PIL import Image

PROGRAM = sys.argv.pop(1)
PATIENCE = 60  # seconds until something that must come is given up


def wait_for(condition, what):
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end:
        result = condition()
        if result:
            return result
        time.sleep(0.05)
    raise AssertionError(f"waited {PATIENCE} s for {what}")


class Display:
    """An Xvfb of its own, on a display number that the server chooses. Without -noreset it would start over, and refuse
    connections, whenever its last client leaves, as each xdotool does."""

    def __init__(self, *options):
        read, write = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", "1280x800x24", "-nolisten", "tcp",
             "-noreset", *options],
            pass_fds=[write], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as pipe:
            if not select.select([pipe], [], [], PATIENCE)[0]:
                raise AssertionError(f"waited {PATIENCE} s for Xvfb")
            self.name = ":" + pipe.readline().strip()
        self.environment = {**os.environ, "DISPLAY": self.name}

    def close(self):
        self.server.terminate()
        self.server.wait(PATIENCE)

    def xdotool(self, *words):
        done = subprocess.run(["xdotool", *map(str, words)], env=self.environment, capture_output=True, text=True,
                              timeout=PATIENCE)
        return done.stdout.strip()

    def screenshot(self):
        done = subprocess.run(["import", "-window", "root", "png:-"], env=self.environment, capture_output=True,
                              check=True, timeout=PATIENCE)
        return Image.open(io.BytesIO(done.stdout)).convert("RGB")

    def ask_to_close(self, window):
        """What the cross in a title bar sends: WM_DELETE_WINDOW."""

        class ClientMessage(ctypes.Structure):
            _fields_ = [("type", ctypes.c_int), ("serial", ctypes.c_ulong), ("send_event", ctypes.c_int),
                        ("display", ctypes.c_void_p), ("window", ctypes.c_ulong), ("message", ctypes.c_ulong),
                        ("format", ctypes.c_int), ("data", ctypes.c_long * 5), ("pad", ctypes.c_long * 24)]

        x11 = ctypes.CDLL("libX11.so.6")
        x11.XOpenDisplay.restype = ctypes.c_void_p
        x11.XInternAtom.restype = ctypes.c_ulong
        x11.XInternAtom.argtypes = [ctypes.c_void_p, ctypes.c_char_p, ctypes.c_int]
        x11.XSendEvent.argtypes = [ctypes.c_void_p, ctypes.c_ulong, ctypes.c_int, ctypes.c_long, ctypes.c_void_p]
        x11.XCloseDisplay.argtypes = [ctypes.c_void_p]
        display = x11.XOpenDisplay(self.name.encode())
        event = ClientMessage(type=33, window=window, format=32,
                              message=x11.XInternAtom(display, b"WM_PROTOCOLS", 0))
        event.data[0] = x11.XInternAtom(display, b"WM_DELETE_WINDOW", 0)
        x11.XSendEvent(display, window, 0, 0, ctypes.byref(event))
        x11.XCloseDisplay(display)


def run(*arguments, display=None, **variables):
    environment = {key: value for key, value in os.environ.items() if key not in ("DISPLAY", "WAYLAND_DISPLAY")}
    environment |= variables
    if display:
        environment["DISPLAY"] = display
    return subprocess.run([PROGRAM, *map(str, arguments)], env=environment, capture_output=True, text=True,
                          timeout=PATIENCE)


class Command(unittest.TestCase):
    def one_sentence(self, done, code, *words):
        self.assertEqual(done.returncode, code, done.stderr)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)

    def test_says_what_it_is(self):
        text = run("--help").stdout
        self.assertIn("FILE", text)
        self.assertIn("variable TEXPLORER_SHADERS", text)
        self.assertLessEqual(max(map(len, text.splitlines())), 80)
        version = run("--version")
        self.assertEqual(version.returncode, 0)
        self.assertRegex(version.stdout, r"^texplorer \d+\.\d+\.\d+\n$")

    def test_refuses_a_wrong_call(self):
        self.one_sentence(run("--nonsense"), 2, "texplorer: there is no option --nonsense; see texplorer --help")

    def test_without_a_display_it_names_texshot(self):
        self.one_sentence(run(), 1, "display", "texshot")

    def test_without_opengl_it_names_texshot(self):
        for what, options, variables in (("no OpenGL", ["-extension", "GLX"], {}),
                                         ("an old one", [], {"MESA_GL_VERSION_OVERRIDE": "1.4"})):
            with self.subTest(what):
                display = Display(*options)
                self.addCleanup(display.close)
                self.one_sentence(run(display=display.name, **variables), 1, "OpenGL", "texshot shot --ui")

    def test_says_each_file_of_several_that_are_all_bad(self):
        done = run("/nowhere/a.bmp", "/nowhere/b.json")
        self.assertEqual(done.returncode, 1)
        self.assertEqual([line.split(": ")[1] for line in done.stderr.splitlines()],
                         ["/nowhere/a.bmp", "/nowhere/b.json"])

    def test_one_good_file_of_several_is_worth_a_window(self):
        with tempfile.TemporaryDirectory() as name:
            scene = pathlib.Path(name) / "scene.json"
            scene.write_text('{"version": 1}')
            done = run("/nowhere/a.bmp", scene)  # which then lacks a display
        self.assertEqual(done.returncode, 1)
        lines = done.stderr.splitlines()
        self.assertIn("/nowhere/a.bmp", lines[0])
        self.assertIn("display", lines[1])

    def test_refuses_files_in_one_sentence(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "empty.bmp").touch()
            (folder / "text.bmp").write_text("Hello")
            (folder / "half.json").write_text('{"textures": [')
            for file in ("missing.png", "empty.bmp", "text.bmp", "half.json", "."):
                with self.subTest(file=file):
                    self.one_sentence(run(folder / file), 1, str(folder))


class Window(unittest.TestCase):
    VARIABLES = {}  # of the environment

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.scene = pathlib.Path(folder.name) / "scene.json"
        self.scene.write_text('{"version": 1}')
        self.display = Display()
        self.addCleanup(self.display.close)
        self.state = pathlib.Path(folder.name) / "state"
        self.display.environment |= {"XDG_STATE_HOME": str(self.state)} | self.VARIABLES
        self.program = None
        self.addCleanup(self.end_program)
        self.begin(self.scene)

    def begin(self, *files):
        self.program = subprocess.Popen([PROGRAM, *map(str, files)], env=self.display.environment,
                                        stderr=subprocess.PIPE, text=True)
        self.window = int(wait_for(lambda: self.running() and self.display.xdotool("search", "--name", "Texplorer"), "the window").split()[0])
        wait_for(lambda: len(set(self.display.screenshot().getdata())) > 100, "the first picture")

    def running(self):
        if self.program.poll() is not None:
            raise AssertionError(f"texplorer ended with {self.program.returncode}: {self.program.stderr.read()}")
        return True

    def drafts(self):
        return sorted((self.state / "texplorer" / "unsaved").glob("*.scene"))

    def draft(self):
        """The scene in the one draft that there is."""
        return json.loads(self.drafts()[0].read_text().split("\n", 3)[3])

    def edit(self):
        self.orbit()
        wait_for(lambda: "•" in self.title(), "the mark of unsaved changes")

    def dims(self, quiet):
        return self.display.screenshot().getpixel((20, 300)) != quiet

    def end_program(self):
        if self.program.poll() is None:
            self.program.send_signal(signal.SIGKILL)
        self.program.wait(PATIENCE)
        self.program.stderr.close()

    def saved(self):
        return json.loads(self.scene.read_text())

    def save(self):
        before = self.scene.stat().st_ino  # a save replaces the file
        self.display.xdotool("key", "ctrl+s")
        wait_for(lambda: self.scene.stat().st_ino != before, "the saved file")
        return self.saved()

    def orbit(self):
        """A drag below the models, as slow as a hand's."""
        self.display.xdotool("mousemove", 600, 700)
        time.sleep(0.1)
        self.display.xdotool("mousedown", 1)
        for x in range(610, 700, 10):
            time.sleep(0.05)
            self.display.xdotool("mousemove", x, 700)
        self.display.xdotool("mouseup", 1)
        time.sleep(0.1)

    def title(self):
        return self.display.xdotool("getwindowname", self.window)

    def cpu_seconds(self):
        fields = pathlib.Path(f"/proc/{self.program.pid}/stat").read_text().rsplit(")", 1)[1].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

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

    def test_the_reference_draws_beside_the_window(self):
        self.display.xdotool("mousemove", 2, 798)  # where there is no tooltip
        before = self.display.screenshot()
        place = (330, 70, 900, 740)
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
        time.sleep(2)  # the whole picture, and no more
        begin = self.cpu_seconds()
        time.sleep(2)
        self.assertLess(self.cpu_seconds() - begin, 0.5, "two idle seconds")

    def test_unsaved_work_outlives_a_crash_and_is_restored(self):
        saved = self.scene.read_text()
        quiet = self.display.screenshot().getpixel((20, 300))
        self.edit()
        wait_for(self.drafts, "the draft")
        self.assertEqual((self.state / "texplorer" / "unsaved").stat().st_mode & 0o777, 0o700)
        time.sleep(2)
        begin = self.cpu_seconds()
        time.sleep(2)
        self.assertLess(self.cpu_seconds() - begin, 0.5, "two idle seconds with unsaved work")
        azimuth = self.draft()["view"]["azimuth"]
        self.program.kill()
        self.program.wait(PATIENCE)
        self.program.stderr.close()
        self.assertEqual(self.scene.read_text(), saved)

        self.begin()  # without the file: it is remembered
        wait_for(lambda: self.dims(quiet), "the offer, which dims the window")
        self.assertEqual(len(self.drafts()), 1)
        self.display.xdotool("key", "Return")
        wait_for(lambda: "scene.json •" in self.title(), "the restored scene")
        self.assertEqual(self.save()["view"]["azimuth"], azimuth)
        wait_for(lambda: not self.drafts(), "the draft to go")
        self.display.ask_to_close(self.window)
        self.assertEqual(self.program.wait(PATIENCE), 0)
        self.assertEqual(list((self.state / "texplorer" / "unsaved").iterdir()), [])

    def test_signals_write_the_rest_and_end_the_window(self):
        for number in (signal.SIGTERM, signal.SIGHUP, signal.SIGINT):
            with self.subTest(signal=number):
                self.edit()
                self.program.send_signal(number)  # before the draft is due
                self.assertEqual(self.program.wait(PATIENCE), -number)
                self.assertEqual(self.program.stderr.read(), "")
                self.program.stderr.close()
                self.assertEqual(len(self.drafts()), 1)
                self.assertNotEqual(self.draft()["view"]["azimuth"], 0)
                for draft in self.drafts():
                    draft.unlink()
                self.begin(self.scene)

    def test_the_end_of_the_display_writes_the_rest(self):
        self.edit()
        self.display.server.kill()
        self.program.wait(PATIENCE)
        wait_for(self.drafts, "the draft")

    def test_what_is_given_up_is_gone(self):
        quiet = self.display.screenshot().getpixel((20, 300))
        self.edit()
        wait_for(self.drafts, "the draft")
        self.display.xdotool("key", "ctrl+z")
        wait_for(lambda: not self.drafts(), "the draft of what is as saved to go")
        self.display.xdotool("key", "ctrl+y")
        wait_for(self.drafts, "the draft")
        self.display.ask_to_close(self.window)
        wait_for(lambda: self.dims(quiet), "the question")
        middle = self.display.screenshot()
        self.assertNotEqual(middle.getpixel((20, 300)), quiet)
        self.display.xdotool("mousemove", 640, 418, "click", 1)  # Don't save
        self.assertEqual(self.program.wait(PATIENCE), 0)
        self.assertEqual(self.drafts(), [])

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
        details = (905, 440, 1280, 770)
        self.display.xdotool("keydown", "e")
        wait_for(lambda: self.display.screenshot().crop(details).tobytes() != before.crop(details).tobytes(),
                 "the explanation")
        self.display.xdotool("keyup", "e")
        time.sleep(3)
        resting = self.display.screenshot().crop(details)
        self.display.xdotool("mousemove", 500, 401)
        time.sleep(1)
        self.assertEqual(self.display.screenshot().crop(details).tobytes(), resting.tobytes())

    def test_a_click_as_fast_as_the_display_is_one(self):
        """Press, release and the next place may come within one frame."""
        before = self.save()
        self.display.xdotool("mousemove", 600, 700, "mousedown", 1, "mousemove", 700, 700, "mouseup", 1,
                             "mousemove", 610, 690)
        wait_for(lambda: "•" in self.title(), "the mark of unsaved changes")
        self.assertNotEqual(self.save()["view"]["azimuth"], before["view"]["azimuth"])

    def test_sleeps_while_nothing_happens(self):
        time.sleep(2)  # the last pictures of the start
        begin = self.cpu_seconds()
        time.sleep(2)
        self.assertLess(self.cpu_seconds() - begin, 0.5, "two idle seconds")


class CoreProfile(Window):
    """A driver that has given up fixed functions: everything works, and the reference draws."""

    VARIABLES = {"MESA_GL_VERSION_OVERRIDE": "3.3FC"}

    def test_keys_of_what_is_not_there_change_nothing(self):
        place = (330, 70, 900, 740)
        self.display.xdotool("mousemove", 2, 798)
        before = self.display.screenshot().crop(place).tobytes()
        for key in "124":
            self.display.xdotool("key", key)
        time.sleep(1)
        self.assertEqual(self.display.screenshot().crop(place).tobytes(), before)
        colours = {colour for _, colour in self.display.screenshot().crop((0, 772, 1280, 800)).getcolors(1 << 20)}
        self.assertTrue(any(red > 200 and 100 < green < 180 and blue < 130 for red, green, blue in colours),
                        "the status bar says why")

    # What needs no other renderer is tried again; the rest would only repeat it.
    test_the_reference_draws_beside_the_window = None
    test_signals_write_the_rest_and_end_the_window = None
    test_the_end_of_the_display_writes_the_rest = None
    test_unsaved_work_outlives_a_crash_and_is_restored = None
    test_what_is_given_up_is_gone = None


if __name__ == "__main__":
    unittest.main(verbosity=2)
