"""Drives the real texshot as a user would: exit codes, sentences, pictures. Pillow reads what it writes."""

import io
import json
import os
import resource
import struct
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

import jsonschema
from PIL import Image, ImageChops

TEXSHOT = sys.argv.pop(1)
SANITIZED = os.environ.get("TEXPLORER_SANITIZED") == "1"  # by ./dev sanitize


def within_memory(megabytes):
    """What keeps a texshot within so much memory, for subprocess.run. AddressSanitizer takes far more addresses than
    it uses; it looks at what is used, ten times a second."""
    if SANITIZED:
        limit = f"{os.environ.get('ASAN_OPTIONS', '')}:hard_rss_limit_mb={megabytes}"
        return {"env": {**os.environ, "ASAN_OPTIONS": limit}}
    return {"preexec_fn": lambda: resource.setrlimit(resource.RLIMIT_AS, (megabytes << 20, megabytes << 20))}


OUTPUT = jsonschema.Draft202012Validator(
    json.loads((Path(__file__).parents[3] / "assets" / "schemas" / "output.schema.json").read_text()))


def document(text):
    """What --json prints, as the schema has it."""
    told = json.loads(text)
    OUTPUT.validate(told)
    return told


def results(text):
    return document(text)["results"]


def single(text):
    """The only one."""
    one, = results(text)
    return one


def place(one):
    """Where a problem is, as standard error has it."""
    return ": ".join(f"line {step['line']}" + (f", column {step['column']}" if "column" in step else "") if "line" in step
                     else next(iter(step.values())) for step in one["where"])


def problem(text):
    """The only one, as standard error has it."""
    one, = document(text)["problems"]
    return f"{place(one)}: {one['message']}" if one["where"] else one["message"]


def texshot(*arguments, **options):
    return subprocess.run([TEXSHOT, *map(str, arguments)], capture_output=True, timeout=120, **options)


def bmp(width, height, pixel):
    """A 24-bit BMP whose pixel (x, y), y from the top, is pixel(x, y) as (r, g, b)."""
    rows = b""
    for y in reversed(range(height)):
        row = b"".join(bytes(reversed(pixel(x, y))) for x in range(width))
        rows += row + b"\0" * (-len(row) % 4)
    header = struct.pack("<2sIHHI", b"BM", 54 + len(rows), 0, 0, 54)
    header += struct.pack("<IiiHHIIiiII", 40, width, height, 1, 24, 0, len(rows), 2835, 2835, 0, 0)
    return header + rows


def dds(width, height, pixels, dxgi, levels=1, layers=1, cube=False, depth=1):
    """A DDS file with a DX10 header, its numbers as Microsoft documents them."""
    flags = 0x1007 | (0x20000 if levels > 1 else 0) | (0x800000 if depth > 1 else 0)
    header = struct.pack("<4s7I44x", b"DDS ", 124, flags, height, width, 0, depth if depth > 1 else 0, levels)
    header += struct.pack("<II4s5I", 32, 4, b"DX10", 0, 0, 0, 0, 0) + struct.pack("<5I", 0x1000, 0, 0, 0, 0)
    return header + struct.pack("<5I", dxgi, 4 if depth > 1 else 3, 4 if cube else 0, layers, 0) + pixels


class Texshot(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path = Path(self.folder.name)
        self.addCleanup(self.folder.cleanup)

    def succeeds(self, *arguments):
        result = texshot(*arguments)
        self.assertEqual((result.returncode, result.stderr), (0, b""), arguments)
        return result.stdout

    def complains(self, code, expected, *arguments):
        """Fails with this code and one sentence that holds `expected`, and leaves no file behind."""
        before = sorted(os.listdir(self.path))
        result = texshot(*arguments)
        said = result.stderr.decode()
        self.assertEqual(result.returncode, code, said)
        self.assertRegex(said, r"\Atexshot: [^\n]+\n\Z", "one sentence, and who says it")
        self.assertIn(expected, said)
        json_flag = "--json=no" in arguments or "--json" in arguments and (arguments[0] != "test" or arguments[arguments.index("--json") + 1] == "-")
        if json_flag:  # then the sentence is there as well
            self.assertEqual(problem(result.stdout), said.removeprefix("texshot: ").removesuffix("\n"))
        else:
            self.assertEqual(result.stdout, b"")
        self.assertEqual(sorted(os.listdir(self.path)), before)
        return said

    def notes(self, expected, *arguments):
        """Does what it is asked for, and says in one sentence that an option has no effect."""
        result = texshot(*arguments)
        said = result.stderr.decode()
        self.assertEqual(result.returncode, 0, said)
        self.assertRegex(said, r"\Atexshot: [^\n]+\n\Z")
        self.assertIn(expected, said)
        return result.stdout

    def facts(self, *arguments):
        """What `info --json` says of a file."""
        return results(self.succeeds("info", *arguments, "--json"))[0]

    def difference(self, a, b):
        """Where two opaque pictures differ, or None. Of RGBA Pillow would look at alpha alone."""
        return ImageChops.difference(a.convert("RGB"), b.convert("RGB")).getbbox()

    def shot(self, *arguments):
        return Image.open(io.BytesIO(self.succeeds("shot", *arguments, "-o", "-"))).convert("RGBA")

    def picture(self, width, height):
        file = self.path / "in.bmp"
        file.write_bytes(bmp(width, height, lambda x, y: (x * 255 // width, y * 255 // height, 60)))
        return file

    def distance(self, a, b):
        """The root of the mean square over all channels."""
        squares = [(p - q) ** 2 for p, q in zip(a.convert("RGB").tobytes(), b.convert("RGB").tobytes())]
        return (sum(squares) / len(squares)) ** 0.5

    def wait_until_it_watches(self, work):
        """Until it handles signals: it has a thread for that."""
        while work.poll() is None and len(os.listdir(f"/proc/{work.pid}/task")) < 2:
            time.sleep(0.01)
