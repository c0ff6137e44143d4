"""Nothing is above its ceiling in ceilings.txt. The argument is the sum of the everyday tests' declared seconds."""

import pathlib
import sys
import unittest

HERE = pathlib.Path(__file__).parent
ROOT = HERE.parents[1]
SECONDS = int(sys.argv.pop(1))
SOURCE = (".cpp", ".h", ".inl", ".c", ".py", ".sh", ".cmake", ".txt", ".glsl", ".vert", ".frag", ".js", ".mjs", ".css",
          ".html")


def lines():
    files = [file for folder in ("app", "core", "shaders", "tests", "cmake", "assets", "packaging")
             for file in (ROOT / folder).rglob("*") if file.suffix in SOURCE]
    return sum(file.read_bytes().count(b"\n") for file in [*files, ROOT / "dev", ROOT / "CMakeLists.txt"])


class Ceilings(unittest.TestCase):
    def test_nothing_is_above_its_ceiling(self):
        measured = {
            "README.md, bytes": (ROOT / "README.md").stat().st_size,
            "CONTRIBUTING.md, bytes": (ROOT / "CONTRIBUTING.md").stat().st_size,
            "everyday tests, seconds of one processor": SECONDS,
            "source, lines": lines(),
        }
        rows = [line.split(maxsplit=1) for line in (HERE / "ceilings.txt").read_text().splitlines() if line[0] != "#"]
        self.assertEqual([what for _, what in rows], list(measured))
        for ceiling, what in rows:
            with self.subTest(what):
                self.assertLessEqual(measured[what], int(ceiling))


if __name__ == "__main__":
    unittest.main()
