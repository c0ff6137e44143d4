"""Closed and opened again at any moment, in the middle of its work, texplorer ends as it should."""

import os
import random
import signal
import subprocess
import time
import unittest

from texplorer import PATIENCE, Display, Window


class Reopening(Window):
    ROUNDS = int(os.environ.get("TEXPLORER_ROUNDS", "6"))
    SEED = int(os.environ.get("TEXPLORER_SEED", "1"))
    # What is freed is overwritten, and what is freed twice noticed at once.
    VARIABLES = {"GLIBC_TUNABLES": "glibc.malloc.perturb=165:glibc.malloc.tcache_count=0"}
    LESSONS = ["filters", "mipmaps", "laboratory", "blocks", "textured-cube"]
    KEYS = ["k", "t", "m", "e", "1", "2", "3", "4", "space", "ctrl+z", "ctrl+y", "ctrl+n", "Tab", "F1",
            "Escape", "Return", "Home", "l", "p"]

    def act(self, dice):
        """As fast as xdotool can: the window's workers are busy with the last but one when the next one comes."""
        words = []
        for _ in range(dice.randint(0, 25)):
            words += dice.choice([
                ["key", dice.choice(self.KEYS)],
                ["mousemove", dice.randrange(1280), dice.randrange(800), "click", dice.choice([1, 1, 1, 3, 4, 5])],
            ])
        if words:
            self.display.xdotool(*words)

    def close(self):
        end = time.monotonic() + PATIENCE
        while self.program.poll() is None and time.monotonic() < end:
            self.display.ask_to_close(self.window)
            try:
                self.program.wait(0.7)
            except subprocess.TimeoutExpired:  # it asks about changes: "Don't save"
                self.display.xdotool("mousemove", 640, 418, "click", 1)
        return 0

    def end_by_signal(self):
        self.program.send_signal(signal.SIGTERM)
        return -signal.SIGTERM

    def take_the_display(self):
        self.display.server.kill()
        return 1

    def test_it_ends_as_it_should(self):
        for number in range(self.ROUNDS):
            dice = random.Random(f"{self.SEED} {number}")
            end = [self.close, self.end_by_signal, self.take_the_display][number % 3]
            with self.subTest(f"TEXPLORER_SEED={self.SEED}, round {number}, {end.__name__}"):
                self.act(dice)
                time.sleep(dice.uniform(0, 0.3))
                expected = end()
                self.assertEqual(self.program.wait(PATIENCE), expected)
                said = self.program.stderr.read()
                if end != self.take_the_display:  # of which Xlib and GLFW have a word to say
                    self.assertEqual(said, "")
                self.assertNotRegex(said, "free|corrupt|terminate|Assertion")
            self.program.kill()
            self.program.wait(PATIENCE)
            self.program.stderr.close()
            for draft in self.drafts():
                draft.unlink()
            if end == self.take_the_display:
                self.display.close()
                environment = self.display.environment
                self.display = Display(*self.DISPLAY)
                self.addCleanup(self.display.close)
                self.display.environment = environment | {"DISPLAY": self.display.name}
            self.scene.write_text('{"version": 1}')
            self.begin(*(["--lesson", dice.choice(self.LESSONS)] if dice.random() < 0.5 else [self.scene]))


if __name__ == "__main__":
    unittest.main(verbosity=2)
