"""A program that texshot emits against texshot itself: compiled, run, and its pictures compared."""

import json
import os
import re
import shutil
import subprocess
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import NamedTuple

import numpy
from PIL import Image

from capture import DRIVER, PATIENCE, ProgramError, compile_program, differing

TIMES = ("0", "1.75")  # seconds
SIZE = (640, 480)  # of a program's window
AT_ONCE = 25  # scenes that a call of texshot draws
GLU_BOUND = 1  # by how much a component may differ where GLU computes vertices, matrices or levels, in 255ths
LAST_BITS = 1e-4  # of a picture, by which the rule last-bit of texshot conform allows two programs of a driver to differ


class Flavour(NamedTuple):
    name: str  # as texshot emit has it
    renderer: str  # which draws what the program is to draw
    bound: int  # by how much a component may differ, in 255ths


FIXED = Flavour("fixed", "fixed", 0)
GLSL = Flavour("glsl", "shader", 1)


class Refused(Exception):
    """The sentence in which texshot says what of a scene the flavour has no words for."""


class Verdict(NamedTuple):
    case: object
    wrong: str  # empty: nothing is
    refused: str  # empty: there is a program


class Proof:
    """Of one flavour. What is wrong is kept in a folder: the program, its pictures, those of texshot, and what differs."""

    def __init__(self, texshot, flavour, capture, keep, times=TIMES, last_bits=LAST_BITS):
        self.texshot, self.flavour, self.capture, self.times = os.path.abspath(texshot), flavour, capture, times
        self.keep, self.last_bits = Path(keep) / flavour.name, last_bits

    def of_all(self, cases):
        """The verdicts in the order of the cases."""
        shutil.rmtree(self.keep, ignore_errors=True)
        with tempfile.TemporaryDirectory() as expected, ThreadPoolExecutor(os.cpu_count()) as threads:
            failed = {}
            for first in range(0, len(cases), AT_ONCE):
                failed |= self.expect(cases[first:first + AT_ONCE], Path(expected))
            return list(threads.map(lambda case: self.of(case, Path(expected), failed.get(case.name)), cases))

    def of(self, case, expected, failed):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder)
            try:
                self.emit(case, path / "demo.c")
                if failed:
                    raise ProgramError(failed)
                self.compare(case, path, self.draw(path), expected)
            except Refused as sentence:
                return Verdict(case, "", str(sentence))
            except ProgramError as wrong:
                shutil.copytree(path, self.keep / case.name, dirs_exist_ok=True)
                return Verdict(case, f"{wrong}; see {self.keep / case.name}", "")
        return Verdict(case, "", "")

    def run(self, *words, cwd):
        return subprocess.run([self.texshot, *words], cwd=cwd, env={**os.environ, **DRIVER}, capture_output=True, text=True,
                              timeout=PATIENCE)

    def emit(self, case, file):
        done = self.run("emit", *case.words, "--as", self.flavour.name, "-o", file.name, cwd=file.parent)
        if done.returncode == 0 and not done.stderr:
            return
        if done.returncode != 1 or not re.fullmatch(r"texshot: [^\n]+\n", done.stderr) or file.exists():
            raise ProgramError(f"texshot emit ends with {done.returncode}: {done.stderr}")
        raise Refused(done.stderr.strip())

    def draw(self, path):
        """What the program draws at each time."""
        compile_program(path / "demo.c", path / "demo")
        return self.capture.run(path / "demo", path, self.times)

    def shoot(self, files, name, cwd):
        return self.run("shot", *map(str, files), "--renderer", self.flavour.renderer, "--size", "x".join(map(str, SIZE)), "--no-metadata",
                        "--time", ",".join(self.times), "-o", name, cwd=cwd)

    def expect(self, cases, folder):
        """Draws what is expected of the cases in one call; where texshot ends badly, in two, until it is known of which. Says of each
        of these how it ended."""
        if not cases:
            return {}
        done = self.shoot([case.file for case in cases], "{scene}-{time}.png", folder)
        if done.returncode == 0:
            return {}
        if len(cases) == 1:
            return {cases[0].name: f"texshot shot ends with {done.returncode}: {done.stderr}"}
        half = len(cases) // 2
        return self.expect(cases[:half], folder) | self.expect(cases[half:], folder)

    def compare(self, case, path, drawn, expected):
        scene = json.loads(case.file.read_text())
        calls_glu = "#define GLFW_INCLUDE_GLU" in (path / "demo.c").read_text()
        bound = max(self.flavour.bound, GLU_BOUND if calls_glu else 0)
        share = self.last_bits if calls_glu or computes_otherwise(scene, self.flavour) else 0
        wrong = []
        for time, picture in zip(self.times, drawn):
            if picture.shape != (SIZE[1], SIZE[0], 3):
                raise ProgramError(f"it draws an array of {picture.shape}, expected {SIZE}")
            sentence = self.difference(picture, expected / f"{case.name}-{time}.png", bound, share)
            if sentence:
                if not wrong:
                    done = self.shoot([case.file], "texshot-{time}.png", path)
                    (path / "texshot-said.txt").write_text(done.stderr)
                Image.fromarray(picture).save(path / f"program-{time}.png")
                self.run("compare", f"texshot-{time}.png", f"program-{time}.png", "--rgb", "--tolerance", str(bound),
                         "-o", f"difference-{time}.png", cwd=path)
                wrong.append(f"at {time} s {sentence}")
        if wrong:
            raise ProgramError("; ".join(wrong))

    def difference(self, picture, expected, bound, share):
        """What differs by more than the bound in more than a share of the pixels, or nothing."""
        expected = numpy.asarray(Image.open(expected).convert("RGB"))
        pixels = picture.shape[0] * picture.shape[1]
        count = differing(picture, expected, bound)
        if count <= share * pixels:
            return ""
        worst = int(numpy.abs(picture.astype(int) - expected).max())
        return f"{count} of {pixels} pixels differ, by up to {worst}/255"


def computes_otherwise(scene, flavour):
    """Whether something isn't OpenGL's to compute, and is computed by a program in other steps than by texshot: where
    embossed coordinates lie, by the matrix that OpenGL has kept as floats, where texshot has kept doubles; what the light
    sees, which a program has OpenGL draw; where a light projects a picture by shaders, by a matrix whose numbers stand in the
    program."""
    units = [unit for each in scene["passes"] for unit in each["units"] if unit.get("enabled")]
    embosses = any(unit.get("emboss", {}).get("enabled") for unit in units)
    owned = [unit for each in scene["models"] for unit in each.get("units", [])]
    projects = flavour is GLSL and any(step["op"] == "projector" for unit in units + owned for step in unit.get("matrix", []))
    return embosses or projects or any(texture["source"] == "light-depth" for texture in scene["textures"])
