"""Compiles programs of GLFW and OpenGL and runs them on their own display, to capture what they draw, frame by frame.
capture.c describes how."""

import os
import re
import select
import shlex
import subprocess
from pathlib import Path

import numpy

PATIENCE = 120  # seconds, for a busy machine
# Mesa as exact as it can be, as in the tests of the renderers.
DRIVER = {"LIBGL_ALWAYS_SOFTWARE": "1", "GALLIVM_PERF": "no_rho_approx,no_brilinear,no_quad_lod,no_aos_sampling"}
WARNINGS = ["-std=c99", "-Wall", "-Wextra", "-Werror"]


class ProgramError(AssertionError):
    """An error of a program, in one sentence."""


def compile_program(source, program, *options):
    """Runs the command in the program's first comment, but with all warnings: GCC makes the program, Clang checks
    it."""
    found = re.search(r"\bcc (.*?-o .*?)\s*(?:\*/)?$", source.read_text()[:2000], re.MULTILINE)
    if not found:
        raise ProgramError("its first comment has no command, cc FILE -o PROGRAM and libraries, that compiles it")
    words = shlex.split(found[1])
    libraries = [word for word in words if word.startswith("-l")]
    expected = {source.name, "-o", words[words.index("-o") + 1], "-std=c99", *libraries}
    if not set(words) <= expected or source.name not in words:
        raise ProgramError(f"its command is \"cc {found[1]}\"")
    run_compiler("gcc", "-O0", "-fuse-ld=mold", *WARNINGS, *options, str(source), "-o", str(program), *libraries)
    run_compiler("clang", "-fsyntax-only", *WARNINGS, *options, str(source))


def run_compiler(*words):
    done = subprocess.run(words, capture_output=True, text=True)
    if done.returncode != 0 or done.stderr:
        raise ProgramError(f"{words[0]} says: {done.stderr}")


class Display:
    """An Xvfb on a number that it chooses."""

    def __init__(self):
        read, write = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", "1280x1024x24", "-nolisten", "tcp", "-noreset"],
            pass_fds=[write], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as pipe:
            if not select.select([pipe], [], [], PATIENCE)[0]:
                raise AssertionError(f"waited {PATIENCE} s for Xvfb")
            self.name = ":" + pipe.readline().strip()

    def close(self):
        self.server.terminate()
        self.server.wait(PATIENCE)


def read_picture(path):
    """The red, green and blue of a file that the library wrote, as an array of rows. Alpha is not visible on a
    screen."""
    head, pixels = Path(path).read_bytes().split(b"ENDHDR\n", 1)
    fields = dict(line.split(b" ", 1) for line in head.splitlines()[1:])
    picture = numpy.frombuffer(pixels, numpy.uint8)
    return picture.reshape(int(fields[b"HEIGHT"]), int(fields[b"WIDTH"]), 4)[:, :, :3]


class Capture:
    def __init__(self, library, display):
        self.environment = {**os.environ, **DRIVER, "DISPLAY": display.name, "MESA_DEBUG": "1",  # reports wrong calls
                            "LD_PRELOAD": os.path.abspath(library)}

    def run(self, program, folder, times=(0,), patience=PATIENCE):
        """The pictures of a program at these times. Also checks that it draws the same in every frame and ends
        correctly."""
        pictures = Path(folder) / "picture"
        for file in Path(folder).glob("picture.*"):
            file.unlink()
        environment = {**self.environment, "CAPTURE_PICTURES": str(pictures), "CAPTURE_TIMES": ",".join(map(str, times))}
        try:
            done = subprocess.run([str(program)], env=environment, cwd=folder, capture_output=True, text=True, timeout=patience)
        except subprocess.TimeoutExpired:
            raise ProgramError(f"it is not through after {patience} s, with {len(list(Path(folder).glob('picture.*')))} pictures") from None
        said = done.stderr.strip()
        if done.returncode != 0:
            raise ProgramError(f"it ends with {done.returncode}: {said}")
        if said:
            raise ProgramError(f"it says: {said}")
        files = [pictures.with_suffix("." + name) for name in ("window", "turned", *map(str, range(len(times))))]
        missing = [file.name for file in files if not file.exists()]
        if missing:
            raise ProgramError(f"it ends without {missing[0]}")
        window, turned, *drawn = map(read_picture, files)
        if not numpy.array_equal(window, turned):
            raise ProgramError(f"its second frame differs from the first in {differing(window, turned)} pixels")
        return drawn


def differing(a, b, bound=0):
    """The number of pixels in which a component differs by more than `bound`, in 255ths."""
    if numpy.array_equal(a, b):
        return 0
    return int((numpy.abs(a.astype(numpy.int16) - b.astype(numpy.int16)).max(axis=2) > bound).sum())
