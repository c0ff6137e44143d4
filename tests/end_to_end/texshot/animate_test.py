"""texshot animate: moving pictures. Pillow reads every frame of them, ImageMagick makes GIFs of the same frames."""

import io
import json
import os
import re
import signal
import subprocess
import time
import unittest

import numpy
from PIL import Image, ImageSequence

from texshot import TEXSHOT, Texshot, results, texshot

SMALL = ("--size", "64x48")
TURN = ("--set", "view.azimuth=0..40")


def frames_of(path):
    """Each as RGB, with how long it is shown, in milliseconds."""
    with Image.open(path) as file:
        frames, durations = [], []
        for frame in ImageSequence.Iterator(file):
            frames.append(numpy.asarray(frame.convert("RGB")))
            durations.append(frame.info.get("duration"))
        return frames, durations, file.info.get("loop")


class Animate(Texshot):
    def setUp(self):
        super().setUp()
        self.out = self.path / "out"
        self.out.mkdir()

    def shot(self, seconds, *arguments):
        picture = self.succeeds("shot", *SMALL, "--time", str(seconds), *arguments, "-o", "-")
        return numpy.asarray(Image.open(io.BytesIO(picture)).convert("RGB"))

    def scene(self, keys):
        path = self.path / "moving.json"
        path.write_text(json.dumps({"timeline": keys}))
        return path

    # -- frames

    def test_every_frame_is_the_shot_of_its_time(self):
        scene = self.scene([{"path": "view.azimuth", "value": 0, "easing": "ease-in-out"},
                            {"time": 1, "path": "view.azimuth", "value": 90},
                            {"path": "textures[0].pattern", "value": "checker"},
                            {"time": 0.5, "path": "textures[0].pattern", "value": "brick"},
                            {"path": "models[0].visible", "value": True},
                            {"time": 0.7, "path": "models[0].visible", "value": False}])
        for renderer in ("fixed", "shader", "reference"):
            wanted = [self.shot(i / 8, scene, "--renderer", renderer) for i in range(8)]
            self.assertGreater(len({each.tobytes() for each in wanted}), 6)
            for name in ("x.png", "x.webp", "x-%02d.png"):
                with self.subTest(renderer=renderer, name=name):
                    self.succeeds("animate", scene, *SMALL, "--fps", "8", "--renderer", renderer, "-o", self.out / name)
                    if "%" in name:
                        frames = [numpy.asarray(Image.open(self.out / (name % (i + 1))).convert("RGB")) for i in range(8)]
                    else:
                        frames, durations, loop = frames_of(self.out / name)
                        self.assertEqual(loop, 0)
                        if name.endswith("png"):
                            self.assertEqual(durations, [125] * 8)
                    self.assertEqual(len(frames), 8)
                    for i, (frame, shot) in enumerate(zip(frames, wanted)):
                        self.assertTrue(numpy.array_equal(frame, shot), i)

    def test_a_parameter_moves_by_set(self):
        self.succeeds("animate", *SMALL, "--set", "view.azimuth=-10..30..10", "--set", "view.background=0,0,0,1..1,0.5,0,1",
                      "--set", "textures[0].magFilter=GL_NEAREST..GL_LINEAR", "--seconds", "1", "--fps", "4", "-o", self.out / "x.png")
        frames, _, _ = frames_of(self.out / "x.png")
        values = [(-10, "0,0,0,1", "GL_NEAREST"), (10, "0.25,0.125,0,1", "GL_NEAREST"),
                  (30, "0.5,0.25,0,1", "GL_LINEAR"), (20, "0.75,0.375,0,1", "GL_LINEAR")]
        for frame, (azimuth, background, filtered) in zip(frames, values):
            shot = self.shot(0, "--set", f"view.azimuth={azimuth}", "--set", f"view.background={background}", "--set", f"textures[0].magFilter={filtered}")
            self.assertTrue(numpy.array_equal(frame, shot), azimuth)
        self.assertEqual(len(frames), 4)

    def test_a_star_shows_every_choice_as_long_as_the_others(self):
        self.succeeds("animate", *SMALL, "--example", "checker", "--set", "textures[0].wrapS=*", "--set", "view.azimuth=0..1", "--seconds", "3", "--fps", "5", "-o", self.out / "x-{number}.png")
        names = sorted(os.listdir(self.out))
        self.assertEqual((names[0], names[-1], len(names)), ("x-01.png", "x-15.png", 15))
        listed = results(self.succeeds("params", "--json", "textures[].wrapS"))[0]["choices"]
        self.assertEqual(len(listed), 5)
        for i, name in enumerate(names):
            with Image.open(self.out / name) as picture:
                scene = json.loads(picture.text["Scene"] if "Scene" in picture.text else next(text for text in picture.text.values() if text.startswith("{")))
            wrap = [key["value"] for key in scene["timeline"] if key["path"] == "textures[0].wrapS"]
            self.assertEqual(wrap, [choice["name"] for choice in listed])
            shot = self.shot(0, "--example", "checker", "--set", f"textures[0].wrapS={listed[i // 3]['name']}", "--set", f"view.azimuth={numpy.float32(i / 15)}")
            self.assertTrue(numpy.array_equal(numpy.asarray(Image.open(self.out / name).convert("RGB")), shot), name)

    def test_a_turn_is_an_exact_loop(self):
        self.succeeds("animate", *SMALL, "--set", "view.azimuth=0..360", "--seconds", "1", "--fps", "6", "-o", self.out / "x.webp")
        frames, _, _ = frames_of(self.out / "x.webp")
        self.assertEqual(len(frames), 6, "the one at 360 isn't drawn twice")
        for frame, angle in zip(frames, range(0, 360, 60)):
            self.assertTrue(numpy.array_equal(frame, self.shot(0, "--set", f"view.azimuth={angle}")), angle)

    def test_there_and_back(self):
        self.succeeds("animate", *SMALL, *TURN, "--pingpong", "--seconds", "1", "--fps", "4", "-o", self.out / "x.png")
        frames, durations, _ = frames_of(self.out / "x.png")
        self.assertEqual(durations, [250] * 8)
        for frame, angle in zip(frames, (0, 10, 20, 30, 40, 30, 20, 10)):
            self.assertTrue(numpy.array_equal(frame, self.shot(0, "--set", f"view.azimuth={angle}")), angle)

    def test_it_begins_where_it_is_told(self):
        scene = self.scene([{"path": "view.azimuth", "value": 0}, {"time": 4, "path": "view.azimuth", "value": 40}])
        self.succeeds("animate", scene, *SMALL, "--time", "2", "--fps", "2", "-o", self.out / "x.png")
        frames, _, _ = frames_of(self.out / "x.png")
        self.assertEqual(len(frames), 4, "as long as its keys are from there")
        for i, frame in enumerate(frames):
            self.assertTrue(numpy.array_equal(frame, self.shot(2 + i / 2, scene)))

    # -- files

    def test_durations_and_plays(self):
        for name, fps, durations in (("x.gif", "25", [40] * 5), ("x.gif", "50", [20] * 10), ("x.png", "8", [125, 75]), ("x.png", "30", None)):
            with self.subTest(name=name, fps=fps):
                self.succeeds("animate", *SMALL, *TURN, "--seconds", "0.2", "--fps", fps, "--loop", "3", "-o", self.out / name)
                frames, found, loop = frames_of(self.out / name)
                if durations:
                    self.assertEqual(found, durations)
                else:
                    self.assertAlmostEqual(sum(found), 200, 6)
                self.assertEqual(loop, 2 if name.endswith("gif") else 3, "a GIF says how often again")
        self.succeeds("animate", *SMALL, *TURN, "--seconds", "0.2", "--loop", "1", "-o", self.out / "once.gif")
        self.assertNotIn(b"NETSCAPE", (self.out / "once.gif").read_bytes())

    def test_a_gif_says_when_it_cannot_be_exact_and_is_as_long_all_the_same(self):
        result = texshot("animate", *SMALL, *TURN, "--seconds", "1", "--fps", "30", "-o", self.out / "x.gif")
        self.assertEqual(result.returncode, 0)
        self.assertRegex(result.stderr.decode(), r"\Atexshot: a GIF counts in hundredths of a second: with 30 pictures a second they are shown for 3 to 4 of them[^\n]+\n\Z")
        _, durations, _ = frames_of(self.out / "x.gif")
        self.assertEqual((sum(durations), set(durations)), (1000, {30, 40}))

    def test_a_gif_is_no_worse_than_imagemagicks_and_no_larger(self):
        for example, moves in (("earth", ("--set", "view.azimuth=0..60")), ("cube", ("--set", "view.background=0,0,0,1..1,1,1,1", "--set", "view.azimuth=0..30"))):
            with self.subTest(example):
                call = ("animate", "--example", example, *moves, "--size", "200x160", "--seconds", "0.4")
                self.succeeds(*call, "-o", self.out / "own.gif")
                self.succeeds(*call, "-o", self.out / f"{example}-%02d.png")
                files = sorted(self.out.glob(f"{example}-*.png"))
                self.assertEqual(len(files), 10)
                subprocess.run(["convert", "-delay", "4", *files, "-layers", "optimize", self.out / "peer.gif"], check=True)
                wanted = numpy.asarray([numpy.asarray(Image.open(file).convert("RGB")) for file in files], dtype=float)
                own, peer = (((numpy.asarray(frames_of(self.out / name)[0], dtype=float) - wanted) ** 2).mean((1, 2, 3)) for name in ("own.gif", "peer.gif"))
                self.assertEqual(len(own), 10)
                self.assertTrue((own <= peer).all(), (own, peer))
                self.assertLess((self.out / "own.gif").stat().st_size, 1.1 * (self.out / "peer.gif").stat().st_size)

    def test_what_stays_costs_a_gif_nothing(self):
        self.succeeds("animate", *SMALL, "--set", "models[0].visible=true..false", "--seconds", "0.4", "-o", self.out / "x.gif")
        self.succeeds("animate", *SMALL, "--set", "models[0].visible=true..false", "--seconds", "0.04", "--fps", "50", "-o", self.out / "two.gif")
        frames, _, _ = frames_of(self.out / "x.gif")
        self.assertTrue(all(numpy.array_equal(frame, frames[0]) for frame in frames[:5]))
        self.assertFalse(numpy.array_equal(frames[4], frames[5]))
        self.assertLess((self.out / "x.gif").stat().st_size, (self.out / "two.gif").stat().st_size + 8 * 60)

    def test_webp_with_losses_is_smaller_and_near(self):
        call = ("animate", *SMALL, *TURN, "--seconds", "0.2")
        self.succeeds(*call, "-o", self.out / "all.webp")
        self.succeeds(*call, "--quality", "80", "-o", self.out / "less.webp")
        self.assertLess((self.out / "less.webp").stat().st_size, (self.out / "all.webp").stat().st_size)
        whole, less = (numpy.asarray(frames_of(self.out / name)[0], dtype=float) for name in ("all.webp", "less.webp"))
        self.assertLess(((whole - less) ** 2).mean(), 60)
        self.assertGreater(((whole - less) ** 2).mean(), 0)

    def test_a_png_says_how_it_was_drawn(self):
        call = ("animate", *SMALL, *TURN, "--seconds", "0.2", "-o", self.out / "x.png")
        self.succeeds(*call)
        again = texshot("shot", self.out / "x.png", *SMALL, "--time", "0.1", "-o", self.out / "y.png")
        self.assertEqual(again.returncode, 0, "it holds its scene, with its key frames")
        with Image.open(self.out / "y.png") as picture:
            self.assertTrue(numpy.array_equal(numpy.asarray(picture.convert("RGB")), self.shot(0, "--set", "view.azimuth=20")))
        self.succeeds(*call, "--no-metadata")
        with Image.open(self.out / "x.png") as picture:
            self.assertEqual(picture.text, {})

    def test_the_same_call_gives_the_same_bytes(self):
        for name in ("x.gif", "x.webp", "x.png"):
            files = []
            for _ in range(2):
                self.succeeds("animate", *SMALL, *TURN, "--seconds", "1", "-o", self.out / name)
                files.append((self.out / name).read_bytes())
            self.assertEqual(*files)

    def test_what_does_not_move_is_said(self):
        result = texshot("animate", *SMALL, "--set", "models[0].spin=0,0,0", "--set", "models[1].spin=0,0,0", "--seconds", "0.2", "-o", self.out / "x.gif")
        self.assertEqual((result.returncode, result.stderr.decode()), (0, "texshot: nothing in the scene moves: all pictures are the same\n"))

    # -- what can't be

    def test_wrong_calls_are_one_sentence_before_any_work(self):
        x = self.out / "x.gif"
        two = ("--seconds", "2")
        cases = [
            (2, 'did you mean "azimuth"?', "--set", "view.azimut=0..1", *two, "-o", x),
            (2, 'expected a number from -360 to 360 deg, found "far"', "--set", "view.azimuth=0..far", *two, "-o", x),
            (2, "found 400", "--set", "view.azimuth=0..400", *two, "-o", x),
            (2, "* is for names", "--set", "view.azimuth=*", *two, "-o", x),
            (2, "expected one of GL_NEAREST", "--set", "textures[0].minFilter=GL_NEAREST..GL_LINAER", *two, "-o", x),
            (2, "a key can't move the timeline itself", self.scene([{"path": "view.azimuth", "value": 1}]), "--set", "timeline[0].time=0..1", *two, "-o", x),
            (2, "at 1 s: an enabled unit needs an existing texture", "--set", "passes[0].units[0].texture=0..9", *two, "-o", x),
            (2, "--seconds: expected a length", *TURN, "-o", x),
            (2, "--seconds: expected a number above 0 and up to 3600, found \"0\"", *TURN, "--seconds", "0", "-o", x),
            (2, "found \"nan\"", *TURN, "--seconds", "nan", "-o", x),
            (2, "found \"1e9\"", *TURN, "--seconds", "1e9", "-o", x),
            (2, "--fps: expected a number above 0 and up to 1000, found \"-1\"", *TURN, *two, "--fps", "-1", "-o", x),
            (2, "at most 10000 pictures, found 1000000: 1000 s with 1000 a second", *TURN, "--seconds", "1000", "--fps", "1000", "-o", self.out / "x.png"),
            (2, "expected in GIF files pictures that are shown for at most 655.35 s, found 1000 s", *TURN, "--seconds", "3600", "--fps", "0.001", "-o", x),
            (2, "expected in APNG files pictures that are shown for at most 65.535 s, found 100 s", *TURN, "--seconds", "200", "--fps", "0.01", "-o", self.out / "x.png"),
            (2, "at most 50 a second in GIF files", *TURN, *two, "--fps", "60", "-o", x),
            (2, "--size: expected at most 16383x16383 for WebP files, found 16384x16", *TURN, *two, "--size", "16384x16", "-o", self.out / "x.webp"),
            (2, "--time: expected a begin from 0 to 3600 s, found -1", *TURN, *two, "--time", "-1", "-o", x),
            (2, "--seconds: expected an end within 3600 s, found 3601", *TURN, *two, "--time", "3599", "-o", x),
            (2, "ends in .gif, .webp or .png, or one with a place for the number", *TURN, *two, "-o", self.out / "x.bmp"),
            (2, "ends in .gif, .webp or .png", *TURN, *two, "-o", "-"),
            (2, "ends in one of .bmp, .dds, .png, .tga", *TURN, *two, "-o", self.out / "x-%04d.gif"),
            (2, "a place for the number as %04d or {number}", *TURN, *two, "-o", self.out / "x-%s.png"),
            (2, "a place for the number as %04d or {number}", *TURN, *two, "-o", self.out / "x-%0999d.png"),
            (2, "found two in", *TURN, *two, "-o", self.out / "x-%d-%04d.png"),
            (2, "a place for the number as %04d or {number}, found", *TURN, *two, "-o", self.out / "x-{nope}.png"),
            (2, "found two in", *TURN, *two, "-o", self.out / "x-{number}-{time}.png"),
            (2, "a place for the number as %04d or {number}, found", *TURN, *two, "-o", self.out / "x-{%04d}.png"),
            (2, "expected a name and } after each {", *TURN, *two, "-o", self.out / "x-{number.png"),
            (2, "--quality: expected a number from 0 to 100", *TURN, *two, "--quality", "101", "-o", self.out / "x.webp"),
            (2, "expected one of hold, linear", *TURN, *two, "--easing", "bounce", "-o", x),
            (1, "can't be", *TURN, *two, "-o", "/proc/x.gif"),
            (2, "--out is missing", *TURN, *two),
        ]
        for code, expected, *arguments in cases:
            with self.subTest(expected):
                self.complains(code, expected, "animate", *(() if "--size" in arguments else SMALL), *arguments)
        self.assertEqual(os.listdir(self.out), [])

    def test_options_without_effect_are_notes(self):
        two = ("--seconds", "0.1", "--fps", "20")
        for expected, *arguments in [
            ("--quality: has no effect here", *TURN, *two, "--quality", "50", "-o", self.out / "x.gif"),
            ("--no-metadata: has no effect here", *TURN, *two, "--no-metadata", "-o", self.out / "x.gif"),
            ("--loop: has no effect here", *TURN, *two, "--loop", "2", "-o", self.out / "x-%d.png"),
            ("--context: has no effect here", *TURN, *two, "--renderer", "reference", "--context", "auto", "-o", self.out / "x.gif"),
        ]:
            with self.subTest(expected):
                self.notes(expected, "animate", *SMALL, *arguments)
        still = texshot("animate", *SMALL, *two, "--easing", "hold", "-o", self.out / "x.gif")
        self.assertEqual(still.returncode, 0)
        self.assertIn(b"--easing: has no effect here", still.stderr)

    def test_it_never_takes_the_place_of_its_scene(self):
        drawn = self.out / "scene.png"
        self.succeeds("shot", *SMALL, "-o", drawn)
        before = drawn.read_bytes()
        self.complains(2, "expected a file other", "animate", drawn, *SMALL, *TURN, "--seconds", "1", "-o", drawn)
        drawn.rename(self.out / "scene-1.png")
        self.complains(2, "expected a file other", "animate", self.out / "scene-1.png", *SMALL, *TURN, "--seconds", "1", "-o", self.out / "scene-%d.png")
        self.assertEqual((self.out / "scene-1.png").read_bytes(), before)

    def test_ctrl_c_leaves_nothing_half_written(self):
        for name in ("x.gif", "x.webp", "x.png"):
            with self.subTest(name):
                (self.out / name).write_bytes(b"before")
                call = [TEXSHOT, "animate", *TURN, "--seconds", "200", "--size", "300x200", "-o", str(self.out / name)]
                work = subprocess.Popen(call, stderr=subprocess.PIPE)
                time.sleep(0.5)
                work.send_signal(signal.SIGINT)
                said = work.communicate(timeout=60)[1].decode()
                self.assertEqual(work.returncode, 130, said)
                self.assertRegex(said, r"\Atexshot: [^\n]+\n\Z")
                self.assertEqual((self.out / name).read_bytes(), b"before")
        self.assertEqual(sorted(os.listdir(self.out)), ["x.gif", "x.png", "x.webp"])

    def test_ctrl_c_leaves_whole_pictures(self):
        call = [TEXSHOT, "animate", *TURN, "--seconds", "200", "--size", "64x48", "-o", str(self.out / "x-%04d.png")]
        work = subprocess.Popen(call, stderr=subprocess.PIPE)
        time.sleep(1)
        work.send_signal(signal.SIGINT)
        said = work.communicate(timeout=60)[1].decode()
        self.assertEqual(work.returncode, 130, said)
        for name in os.listdir(self.out):
            self.assertRegex(name, r"\Ax-\d{4}\.png\Z")
            Image.open(self.out / name).load()

    def test_help_and_completion_know_it(self):
        shown = re.sub(r"\s+", " ", self.succeeds("help", "animate").decode())
        self.assertIn("--set PATH=A..B", shown)
        self.assertIn("--pingpong", self.succeeds("--completion", "bash").decode())


if __name__ == "__main__":
    unittest.main()
