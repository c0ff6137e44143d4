"""Unsaved work is kept, however the window ends."""

import signal
import unittest

from texplorer import PATIENCE, Window, wait_for


class Unsaved(Window):
    def test_unsaved_work_outlives_a_crash_and_is_restored(self):
        saved = self.scene.read_text()
        quiet = self.display.screenshot().getpixel((20, 300))
        self.edit()
        wait_for(self.drafts, "the draft")
        self.assertEqual((self.state / "texplorer" / "unsaved").stat().st_mode & 0o777, 0o700)
        self.wait_until_it_rests()
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


if __name__ == "__main__":
    unittest.main(verbosity=2)
