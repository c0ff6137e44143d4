"""Runs the real texplorer on a virtual display, for tests that act as a user and check the result."""

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
PATIENCE = 60  # seconds to wait for something


def wait_for(condition, what):
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end:
        result = condition()
        if result:
            return result
        time.sleep(0.05)
    raise AssertionError(f"waited {PATIENCE} s for {what}")


class Display:
    """An Xvfb on a display number that the server chooses. Without -noreset it would restart, and refuse connections,
    whenever its last client leaves, as each xdotool does."""

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

    @staticmethod
    @ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p, ctypes.c_void_p)
    def ignore_error(_display, _error):
        return 0

    def ask_to_close(self, window):
        """Sends what the close button of a title bar sends, WM_DELETE_WINDOW; a window that is gone ignores it."""

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
        x11.XSetErrorHandler(self.ignore_error)  # Xlib's own handler ends the process
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


class Window(unittest.TestCase):
    """Each test starts with a window that has shown its first picture of the scene in the file `scene`."""

    VARIABLES = {}  # of the environment
    OPTIONS = ()  # of the program
    DISPLAY = ()  # options of its server

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.scene = pathlib.Path(folder.name) / "scene.json"
        self.scene.write_text('{"version": 1}')
        self.display = Display(*self.DISPLAY)
        self.addCleanup(self.display.close)
        self.state = pathlib.Path(folder.name) / "state"
        self.config = pathlib.Path(folder.name) / "config"
        self.pictures = pathlib.Path(folder.name) / "pictures"
        self.pictures.mkdir()
        self.settings = self.config / "texplorer" / "settings.json"
        self.settings.parent.mkdir(parents=True)
        self.settings.write_text('{"hasSeenTour": true, "fromLater": 1}')
        (self.config / "user-dirs.dirs").write_text(f'XDG_PICTURES_DIR="{self.pictures}"\n')
        self.display.environment |= {"XDG_STATE_HOME": str(self.state),
                                     "XDG_CONFIG_HOME": str(self.config)} | self.VARIABLES
        self.program = None
        self.addCleanup(self.end_program)
        self.begin(self.scene)

    def begin(self, *files):
        self.program = subprocess.Popen([PROGRAM, *self.OPTIONS, *map(str, files)], env=self.display.environment,
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
        """The scene in the only draft."""
        return json.loads(self.drafts()[0].read_text().split("\n", 4)[4])

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
        """A drag below the models, at the speed of a user."""
        self.display.xdotool("mousemove", 600, 440)
        time.sleep(0.1)
        self.display.xdotool("mousedown", 1)
        for x in range(610, 700, 10):
            time.sleep(0.05)
            self.display.xdotool("mousemove", x, 440)
        self.display.xdotool("mouseup", 1)
        time.sleep(0.1)

    def wait_until_it_rests(self):
        """Checks that it uses almost no processor time for a second when there is nothing to draw or to wait for."""

        def rests():
            begin = self.cpu_seconds()
            time.sleep(1)
            return self.cpu_seconds() - begin < 0.05

        wait_for(rests, "a second of rest")

    def title(self):
        return self.display.xdotool("getwindowname", self.window)

    def cpu_seconds(self):
        fields = pathlib.Path(f"/proc/{self.program.pid}/stat").read_text().rsplit(")", 1)[1].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")
