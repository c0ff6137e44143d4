"""Killed at any moment while it saves or keeps unsaved work, texplorer loses nothing and leaves no half of a file."""

import json
import os
import random
import time
import unittest

from texplorer import PATIENCE, Window, wait_for


class Kills(Window):
    KILLS = int(os.environ.get("TEXPLORER_KILLS", "4"))
    SEED = int(os.environ.get("TEXPLORER_SEED", "1"))
    LATEST = 1.5  # seconds: by then the draft of an edit is due

    def setUp(self):
        super().setUp()
        self.quiet = self.display.screenshot().getpixel((20, 300))
        self.initial = self.save()

    def kill(self, wait):
        """At the latest after `wait` seconds."""
        try:
            self.program.wait(wait)
        except Exception:  # it runs, as it should
            pass
        self.assertIsNone(self.program.poll())
        self.program.kill()
        self.program.wait(PATIENCE)
        self.program.stderr.close()

    def kept(self):
        """The scenes that are on the disk, all of which are whole: the saved one and the drafts."""
        drafts = [json.loads(draft.read_text().split("\n", 4)[4]) for draft in self.drafts()]
        return [self.saved(), *drafts]

    def save_restored(self):
        """Where the window that was killed had saved after it wrote the draft, the file isn't what the draft was made
        of: it stays, and the scene is saved elsewhere."""
        wait_for(lambda: not self.dims(self.quiet), "the offer to go")
        before = self.scene.stat().st_ino
        self.display.xdotool("key", "ctrl+s")
        wait_for(lambda: self.scene.stat().st_ino != before or self.dims(self.quiet), "the saved file, or a question")
        if self.scene.stat().st_ino == before:
            kept = self.scene.read_text()
            elsewhere = self.scene.with_name(f"kept-{before}.json")
            self.display.xdotool("key", "Return")
            time.sleep(0.5)
            self.display.xdotool("type", str(elsewhere))
            self.display.xdotool("key", "Return")
            wait_for(elsewhere.exists, "the file elsewhere")
            self.assertEqual(self.scene.read_text(), kept)
            self.scene = elsewhere
        return self.saved()

    def leftovers(self):
        return [*self.scene.parent.glob(".texplorer-*"), *(self.state / "texplorer" / "unsaved").glob(".texplorer-*")]

    def test_kills_lose_nothing(self):
        azimuth = self.initial["view"]["azimuth"]
        for number in range(self.KILLS):
            dice = random.Random(f"{self.SEED} {number}")
            saves, wait = dice.random() < 0.5, dice.uniform(0, self.LATEST)
            with self.subTest(f"TEXPLORER_SEED={self.SEED}, kill {number}: {wait:.3f} s after "
                              + ("a save" if saves else "an edit")):
                self.edit()
                wait_for(self.drafts, "the draft")
                self.orbit()
                if saves:
                    self.display.xdotool("key", "ctrl+s")
                self.kill(wait)
                self.assertTrue(any(each["view"]["azimuth"] != azimuth for each in self.kept()),
                                "the first edit was on the disk, and is no more")
                drafts = len(self.drafts())
                self.assertLessEqual(drafts, 1)

                # The next start sweeps up, and offers what wasn't saved.
                self.begin(self.scene)
                if drafts:
                    wait_for(lambda: self.dims(self.quiet), "the offer, which dims the window")
                    self.display.xdotool("key", "Return")
                    wait_for(lambda: "•" in self.title(), "the restored scene")
                restored = self.save_restored()
                self.assertNotEqual(restored["view"]["azimuth"], azimuth)
                wait_for(lambda: not self.drafts(), "the draft to go")
                self.assertEqual(self.leftovers(), [])
                azimuth = restored["view"]["azimuth"]


if __name__ == "__main__":
    unittest.main(verbosity=2)
