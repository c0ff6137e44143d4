"""A driver that never returns from drawing a scene: the window starts again with the reference renderer, or ends."""

import json
import os
import pathlib
import signal
import subprocess
import tempfile
import time
import unittest

from texplorer import PATIENCE, PROGRAM, Window, wait_for

HANGING = (13, 3, 7)  # of 16: the background of a scene with which hanging_driver.c hangs


def make_driver(folder):
    library = folder / "hanging_driver.so"
    source = pathlib.Path(__file__).with_name("hanging_driver.c")
    subprocess.run(["cc", "-shared", "-fPIC", "-o", library, source, "-ldl"], check=True)
    return library


class Hang(Window):
    # Each frame before the one that hangs has this time, the first one six times as much.
    VARIABLES = {"TEXPLORER_FRAME_SECONDS": "4"}

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.hangs = pathlib.Path(folder.name) / "hangs"
        self.said = pathlib.Path(folder.name) / "said"
        preload = [os.environ.get("LD_PRELOAD"), str(make_driver(pathlib.Path(folder.name)))]
        self.VARIABLES = self.VARIABLES | {"LD_PRELOAD": " ".join(filter(None, preload)),
                                           "HANGS_WHILE": str(self.hangs), "HANGS_SAID": str(self.said)}
        super().setUp()
        self.quiet = self.display.screenshot().getpixel((20, 300))
        self.hanging = self.scene.with_name("hanging.json")
        self.hanging.write_text(json.dumps({"version": 1, "view": {"background": [c / 16 for c in HANGING] + [1]}}))

    def command_line(self):
        return pathlib.Path(f"/proc/{self.program.pid}/cmdline").read_text().split("\0")[1:-1]

    def is_restarted(self):
        self.running()
        return "--renderer" in self.command_line()

    def environment(self):
        return pathlib.Path(f"/proc/{self.program.pid}/environ").read_text().split("\0")

    def wait_for_restart(self):
        wait_for(self.is_restarted, "the new window's program")
        self.window = int(wait_for(lambda: self.running() and self.display.xdotool("search", "--name", "Texplorer"),
                                   "the new window").split()[0])

    def shows_background(self):
        """Of the scene, drawn by the reference."""
        wanted = tuple(round(255 * c / 16) for c in HANGING)
        near = [1 for colour in set(self.display.screenshot().crop((330, 70, 900, 460)).getdata())
                if all(abs(a - b) <= 1 for a, b in zip(colour, wanted))]
        return len(near) > 0

    def hang_after_an_edit(self):
        self.end_program()
        self.begin(self.hanging)
        self.edit()
        self.hangs.touch()
        self.display.xdotool("mousemove", 600, 440, "mousemove", 610, 440)  # draws again
        wait_for(self.said.exists, "the hanging driver")

    def close(self):
        self.display.ask_to_close(self.window)
        self.assertEqual(self.program.wait(PATIENCE), 0)

    def hung(self):
        return self.said.read_text().split()

    def test_the_scene_that_hangs_is_shown_by_the_reference(self):
        self.end_program()
        self.hangs.touch()
        self.program = subprocess.Popen([PROGRAM, "--pretend", "no-s3tc", self.hanging], env=self.display.environment,
                                        stderr=subprocess.PIPE, text=True)
        self.wait_for_restart()
        self.assertEqual(self.command_line(), ["--context", "native", "--pretend", "no-s3tc", "--renderer",
                                               "reference", str(self.hanging)])
        self.assertEqual(pathlib.Path(f"/proc/{self.program.pid}/comm").read_text(), "texplorer\n")
        wait_for(self.shows_background, "the reference's picture")
        wait_for(lambda: "hanging.json" in self.title(), "the title")
        self.assertEqual(self.hung(), ["scene"])
        blocked = [line for line in pathlib.Path(f"/proc/{self.program.pid}/status").read_text().splitlines()
                   if line.startswith("SigIgn")]
        self.assertEqual(int(blocked[0].split()[1], 16) >> (signal.SIGTERM - 1) & 1, 0)

        # It can be edited, and the driver tried again.
        self.edit()
        wait_for(self.drafts, "the draft")
        self.display.xdotool("key", "ctrl+z")
        wait_for(lambda: not self.drafts(), "the draft to go")
        self.hangs.unlink()
        self.display.xdotool("key", "1")
        self.wait_until_it_rests()
        self.running()
        self.assertEqual(self.hung(), ["scene"])
        self.close()
        said = self.program.stderr.read()
        self.assertEqual(said.count("\n"), 1, said)
        self.assertRegex(said, "^texplorer: the driver did not finish a picture within [0-9]+ s; the window starts ")

    def test_unsaved_work_is_offered(self):
        self.hang_after_an_edit()
        self.wait_for_restart()
        wait_for(lambda: self.dims(self.quiet), "the offer, which dims the window")
        self.assertEqual(len(self.drafts()), 1)
        azimuth = self.draft()["view"]["azimuth"]
        self.display.xdotool("key", "Return")
        wait_for(lambda: "hanging.json •" in self.title(), "the restored scene")
        self.scene = self.hanging
        self.assertEqual(self.save()["view"]["azimuth"], azimuth)
        wait_for(lambda: not self.drafts(), "the draft to go")
        self.assertEqual(self.hung(), ["scene"])
        self.close()

    def test_a_driver_that_is_tried_again_hangs_again(self):
        self.hang_after_an_edit()
        self.wait_for_restart()
        wait_for(lambda: self.dims(self.quiet), "the offer, which dims the window")
        self.display.xdotool("key", "Return")
        wait_for(lambda: "hanging.json •" in self.title(), "the restored scene")
        self.wait_until_it_rests()
        self.display.xdotool("key", "1")
        wait_for(lambda: self.hung() == ["scene"] * 2, "the hanging driver")
        wait_for(lambda: self.running() and not self.display.xdotool("search", "--name", "Texplorer"),
                 "the window to go")
        self.wait_for_restart()
        wait_for(lambda: self.dims(self.quiet), "the offer, which dims the window")
        self.assertEqual(len(self.drafts()), 1)

    def test_one_signal_is_enough(self):
        for number in (signal.SIGTERM, signal.SIGINT):
            with self.subTest(signal=number):
                self.display.environment["TEXPLORER_FRAME_SECONDS"] = "0"  # else it starts again
                self.hang_after_an_edit()
                self.program.send_signal(number)
                self.assertEqual(self.program.wait(PATIENCE), -number)
                self.assertEqual(self.program.stderr.read(), "")
                self.assertEqual(len(self.drafts()), 1)
                self.assertNotEqual(self.draft()["view"]["azimuth"], 0)
                self.drafts()[0].unlink()
                self.hangs.unlink()
                self.said.unlink()

    def test_a_new_window_that_hangs_as_well_ends(self):
        self.display.environment["HANGS_ALWAYS"] = "1"
        self.hang_after_an_edit()
        self.assertEqual(self.program.wait(2 * PATIENCE), 1)
        self.assertEqual(self.hung(), ["scene", "panels"])
        said = self.program.stderr.read().splitlines()
        self.assertEqual(len(said), 2, said)
        self.assertIn("the window starts again", said[0])
        self.assertIn("although it does not draw the scene", said[1])
        self.assertEqual(len(self.drafts()), 1)

    def test_a_window_that_hangs_when_it_closes_ends(self):
        self.end_program()
        self.display.environment |= {"HANGS_CLOSING": "1", "TEXPLORER_FRAME_SECONDS": "0"}
        self.begin(self.scene)
        self.wait_until_it_rests()
        self.hangs.touch()
        self.close()
        self.assertEqual(self.hung(), ["closing"])
        self.assertEqual(self.program.stderr.read(), "")

    def test_the_driver_does_not_draw_the_scene_for_the_reference(self):
        """Not even for the tab GLSL, which was in front when the last window was closed."""
        self.end_program()
        self.hangs.touch()
        settings = json.loads(self.settings.read_text())
        self.settings.write_text(json.dumps(settings | {"workspace": {"front": {"below": "glsl"}}}))
        self.begin("--renderer", "reference", self.hanging)
        wait_for(self.shows_background, "the reference's picture")
        self.wait_until_it_rests()
        self.display.xdotool("mousemove", 600, 440, "mousemove", 610, 440)
        self.wait_until_it_rests()
        self.assertFalse(self.said.exists())
        self.hangs.unlink()
        self.close()
        self.assertEqual(json.loads(self.settings.read_text())["workspace"]["tabs"]["glsl"]["open"], True)

    def test_a_program_that_is_stopped_in_a_frame_does_not_hang(self):
        self.display.environment["TEXPLORER_FRAME_SECONDS"] = "10"
        self.hang_after_an_edit()
        self.program.send_signal(signal.SIGSTOP)
        time.sleep(11)
        self.hangs.unlink()
        self.program.send_signal(signal.SIGCONT)
        self.wait_until_it_rests()
        self.assertNotIn("--renderer", self.command_line())
        self.assertIn("•", self.title())


if __name__ == "__main__":
    unittest.main(verbosity=2)
