"""Every file of which programs in C are put together says by itself what it needs: GCC and Clang take it alone."""

import subprocess
import unittest
from pathlib import Path

PIECES = Path(__file__).parents[3] / "assets" / "programs"
# A function that nothing calls is what such a file is.
OPTIONS = ["-std=c99", "-pedantic", "-Wall", "-Wextra", "-Wshadow", "-Werror", "-Wno-unused-function", "-Wno-unused-const-variable",
           "-fsyntax-only"]


class PiecesTest(unittest.TestCase):
    def test_compile(self):
        pieces = sorted(PIECES.glob("*.c"))
        self.assertGreater(len(pieces), 30)
        for compiler in ("gcc", "clang"):
            for piece in pieces:
                with self.subTest(f"{compiler} {piece.name}"):
                    done = subprocess.run([compiler, *OPTIONS, str(piece)], capture_output=True, text=True)
                    self.assertEqual((done.returncode, done.stderr), (0, ""))


if __name__ == "__main__":
    unittest.main()
