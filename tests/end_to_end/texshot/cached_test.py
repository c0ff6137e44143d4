"""texshot shot of textures whose compression is cached: the blocks are made once, and long work can be stopped."""

import os
import random
import signal
import subprocess
import time
import unittest

from texshot import TEXSHOT, Texshot, texshot


class Cached(Texshot):
    def test_shot_compresses_once_and_keeps_the_blocks(self):
        cache = self.path / "cache"
        environment = {**os.environ, "XDG_CACHE_HOME": str(cache)}
        call = ["shot", "--size", "64x64", "--set", "textures[0].compression=cached", "-o", "-"]
        first = texshot(*call, env=environment)
        self.assertEqual((first.returncode, first.stderr), (0, b""))
        entries = list((cache / "texplorer/blocks").iterdir())
        self.assertEqual(len(entries), 1)
        self.assertTrue(entries[0].read_bytes().startswith(b"DDS "))
        self.assertEqual(texshot(*call, env=environment).stdout, first.stdout)
        kept = entries[0].read_bytes()
        os.utime(entries[0], (0, 0))
        self.assertEqual(texshot(*call, env=environment).stdout, first.stdout)
        self.assertGreater(entries[0].stat().st_mtime, 1e9, "it is read from there, so it is young again")
        for damaged in (kept[:200], kept[:128] + b"\0" * (len(kept) - 128)):  # a black picture
            entries[0].write_bytes(damaged)
            self.assertEqual(texshot(*call, env=environment).stdout, first.stdout)
            self.assertEqual(entries[0].read_bytes(), kept)
        homeless = {key: value for key, value in environment.items() if key not in ("XDG_CACHE_HOME", "HOME")}
        told = texshot(*call, env=homeless)
        self.assertEqual((told.returncode, told.stdout), (0, first.stdout))
        self.assertIn(b"no cache directory", told.stderr)

    def test_no_bit_that_flips_in_the_cache_is_seen(self):
        cache = self.path / "cache"
        environment = {**os.environ, "XDG_CACHE_HOME": str(cache)}
        call = ["shot", "--renderer", "reference", "--size", "48x32", "--set", "textures[0].compression=cached", "-o", "-"]
        wanted = texshot(*call, env=environment).stdout
        (entry,) = (cache / "texplorer/blocks").iterdir()
        kept = entry.read_bytes()
        dice = random.Random(9)
        places = list(range(0, 128, 4)) + [dice.randrange(128, len(kept)) for _ in range(32)]
        for place in places:
            flipped = bytearray(kept)
            flipped[place] ^= 1 << dice.randrange(8)
            entry.write_bytes(flipped)
            seen = texshot(*call, env=environment)
            self.assertEqual((seen.returncode, seen.stderr), (0, b""))
            self.assertEqual(seen.stdout, wanted, f"a bit of byte {place}")
            self.assertEqual(entry.read_bytes(), kept)

    def begun(self, *arguments):
        """A program that handles Ctrl+C by now."""
        work = subprocess.Popen([TEXSHOT, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                env={**os.environ, "XDG_CACHE_HOME": str(self.path / "cache")})
        self.wait_until_it_watches(work)
        return work

    def test_an_interrupt_stops_the_reference_where_nothing_is_left_to_compress(self):
        call = ["shot", "--renderer", "reference", "--set", "textures[0].compression=cached", "-o", "-"]
        self.begun(*call, "--size", "8x8").communicate(timeout=60)  # the blocks are in the cache now
        work = self.begun(*call, "--size", "6000x6000", "--anisotropy", "ellipse",
                          "--set", "textures[0].maxAnisotropy=16")
        time.sleep(0.2)
        work.send_signal(signal.SIGINT)
        out, said = work.communicate(timeout=60)
        self.assertEqual((work.returncode, len(out)), (130, 0))
        self.assertIn(b"interrupted; nothing was written", said)

    def test_an_interrupt_ends_what_follows_the_long_work(self):
        work = self.begun("shot", "--renderer", "reference", "--set", "textures[0].compression=cached", "--size",
                          "2048x2048", "-o", "-")
        work.stdout.read(1)  # the rest waits for a reader
        work.send_signal(signal.SIGINT)
        self.assertEqual(work.wait(timeout=60), 130)
        self.assertEqual(work.communicate()[1], b"texshot: interrupted\n")


if __name__ == "__main__":
    unittest.main()
