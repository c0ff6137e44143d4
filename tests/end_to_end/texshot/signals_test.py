"""However texshot ends, no half of a file and none of another name stays behind."""

import os
import random
import re
import shutil
import signal
import subprocess
import time
import unittest

from texshot import TEXSHOT, Texshot, bmp, document


class Signals(Texshot):
    KILLS = int(os.environ.get("TEXSHOT_KILLS", "8"))  # of each command by each signal

    def setUp(self):
        super().setUp()
        source, plain = self.path / "in.bmp", self.path / "in.dds"
        source.write_bytes(bmp(256, 256, lambda x, y: (x, y, x * y & 255)))
        self.succeeds("compress", source, plain, "--format", "dxt1")
        self.out = self.path / "out"
        self.commands = [
            ["flip", plain, self.out / "flip.dds"],
            ["compress", source, self.out / "compress.dds", "--format", "dxt5", "--quality", "fast"],
            ["decode", plain, self.out / "decode.png"],
            ["convert", source, self.out / "convert.tga"],
            ["shot", "--renderer", "reference", "--size", "64x64", "-o", self.out / "shot.png"],
            ["sweep", "--axis", "view.azimuth=0..60/4", "--renderer", "reference", "--size", "24x16", "-o", self.out / "sheet.png"],
            ["animate", "--set", "view.azimuth=0..60", "--seconds", "0.3", "--renderer", "reference", "--size", "24x16", "-o", self.out / "turn.gif"],
            ["conform", "--feature", "wrap", "--scenes", "2", "--renderer", "reference", "-o", self.out / "report"],
            ["lessons", "--page", self.out / "handout", "--lesson", "lines"],
        ]

    def content(self):
        """The files with their bytes, but for the hour and the seconds that a report names, and what it calls itself
        after them."""
        clock = re.compile(rb"\d{4}-\d\d-\d\d \d\d:\d\d UTC|in [\d.]+ s\b|\"seconds\": ?[\d.e-]+|\"key\":\"\w+\"")
        return {str(path.relative_to(self.out)): clock.sub(b"", path.read_bytes())
                for path in self.out.rglob("*") if path.is_file()}

    def test_kills_at_any_moment_leave_nothing(self):
        dice = random.Random(9)
        for command in self.commands:
            for fresh in (True, False):  # where nothing is yet, and where something is replaced
                shutil.rmtree(self.out, ignore_errors=True)
                self.out.mkdir()
                start = time.monotonic()
                self.succeeds(*command)
                duration = time.monotonic() - start
                wanted = self.content()
                for kill in (signal.SIGKILL, signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
                    for _ in range((self.KILLS + 1) // 2):
                        if fresh:
                            shutil.rmtree(self.out)
                            self.out.mkdir()
                        self.kill(command, kill, dice.uniform(0, duration), wanted, {} if fresh else wanted)

    def kill(self, command, kill, delay, wanted, before):
        work = subprocess.Popen([TEXSHOT, *map(str, command)], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        time.sleep(delay)
        work.send_signal(kill)
        said = work.communicate(timeout=60)[1].decode()
        # As a shell says it; before texshot has begun to watch for signals, they end it themselves.
        code = work.returncode if work.returncode >= 0 else 128 - work.returncode
        self.assertIn(code, (0, 128 + kill), said)
        found = self.content()
        if kill == signal.SIGKILL:
            if any(name.endswith(".tmp") for name in found):
                self.succeeds(*command)
                self.assertEqual(self.content(), wanted)
            return
        if work.returncode == 128 + kill:
            self.assertIn(said, ("texshot: interrupted; nothing was written\n", "texshot: interrupted\n"))
        self.assertIn(found, (before, wanted), "all of it or nothing")
        if code == 0:
            self.assertEqual(found, wanted)

    def test_every_signal_has_its_exit_status(self):
        pipe = self.path / "pipe"
        os.mkfifo(pipe)
        for kill, code in ((signal.SIGINT, 130), (signal.SIGTERM, 143), (signal.SIGHUP, 129)):
            for command in (["decode", self.path / "in.dds", pipe], ["shot", "--size", "8x8", "-o", pipe]):
                work = subprocess.Popen([TEXSHOT, *map(str, command)], stderr=subprocess.PIPE)
                self.wait_until_it_watches(work)  # then it waits for a reader of the pipe
                work.send_signal(kill)
                self.assertEqual(work.communicate(timeout=60)[1], b"texshot: interrupted; nothing was written\n")
                self.assertEqual(work.returncode, code)

    def test_with_json_an_interrupted_call_prints_its_document(self):
        pipe = self.path / "pipe"
        os.mkfifo(pipe)
        for kill, code in ((signal.SIGINT, 130), (signal.SIGTERM, 143)):
            for command in (["check", "-"], ["info", "-"], ["validate", "-"], ["probe", "-", "--at", "1,1"],
                            ["shot", "-o", self.path / "a.png", "-"], ["shot", "--size", "8x8", "-o", pipe]):
                with self.subTest(command=command, kill=kill):
                    work = subprocess.Popen([TEXSHOT, *map(str, command), "--json"], stdin=subprocess.PIPE,
                                            stdout=subprocess.PIPE, stderr=subprocess.PIPE)
                    self.wait_until_it_watches(work)  # then it waits for its input, or a reader
                    work.send_signal(kill)
                    answer, work.stdin = work.stdout.read(), work.stdin.close()
                    self.assertEqual(work.communicate(timeout=60)[1], b"texshot: interrupted; nothing was written\n")
                    self.assertEqual(work.returncode, code)
                    told = document(answer)
                    self.assertEqual((told["command"], told["results"]), (command[0], []))
                    one, = told["problems"]
                    self.assertEqual((one["message"], one["code"]), ("interrupted; nothing was written", "Cancelled"))
                    self.assertIsInstance(one["id"], int)

    def test_a_document_is_printed_to_its_end(self):
        whole = self.succeeds("params", "--json")
        self.assertGreater(len(whole), 1 << 17, "else the pipe takes it at once")
        work = subprocess.Popen([TEXSHOT, "params", "--json"], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        begin = os.read(work.stdout.fileno(), 1)  # now it waits for room
        work.send_signal(signal.SIGTERM)
        rest, said = work.communicate(timeout=60)
        self.assertEqual(begin + rest, whole)
        self.assertIn((work.returncode, said), ((143, b"texshot: interrupted\n"), (0, b"")))

    def test_a_signal_that_is_ignored_stays_so(self):
        pipe = self.path / "pipe"
        os.mkfifo(pipe)
        work = subprocess.Popen([TEXSHOT, "decode", self.path / "in.dds", pipe],
                                preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))  # as nohup does
        self.wait_until_it_watches(work)
        work.send_signal(signal.SIGHUP)
        self.assertTrue(pipe.read_bytes().startswith(b"\x89PNG"))
        self.assertEqual(work.wait(timeout=60), 0)


if __name__ == "__main__":
    unittest.main()
