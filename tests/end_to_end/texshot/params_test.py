"""texshot params, and the help of every command."""

import os
import subprocess
import unittest

from texshot import TEXSHOT, Texshot, results


class Params(Texshot):
    def test_every_parameter_is_listed_with_what_it_accepts(self):
        text = self.succeeds("params").decode()
        for expected in ["textures[].minFilter", "GL_LINEAR_MIPMAP_LINEAR", "passes[].units[].envColor"]:
            self.assertIn(expected, text)
        listed = results(self.succeeds("params", "--json"))
        self.assertTrue(listed)

    def test_it_does_not_load_gl(self):
        trace = subprocess.run([TEXSHOT, "params"], capture_output=True, env={**os.environ, "LD_DEBUG": "libs"})
        self.assertEqual(trace.returncode, 0)
        self.assertNotIn(b"OSMesa", trace.stderr)

    def test_help_and_version(self):
        self.assertIn(b"shot", self.succeeds("--help"))
        self.assertIn(b"--set", self.succeeds("shot", "--help"))
        for command in ("shot", "probe"):
            text = self.succeeds(command, "--help").decode()
            self.assertRegex(text, r"--size WIDTHxHEIGHT +Of the picture, in pixels\.[^-]*Default: 1280x800\.\n")
        for command in ([], ["shot"], ["probe"], ["check"], ["conform"], ["params"], ["decode"], ["info"], ["convert"],
                        ["flip"], ["compress"], ["presets"], ["diff"], ["commands"]):
            with self.subTest(command=command):
                text = self.succeeds(*command, "--help").decode()
                self.assertNotRegex(text, r"\b(TEXT|INT|Needs:|Env:)")
                self.assertIn("Exit status: 0", text)
                self.assertLessEqual(max(map(len, text.splitlines())), 80)
        self.assertRegex(self.succeeds("decode", "--help").decode(), r"From 0 to\s+30\.")
        self.assertRegex(self.succeeds("--version").decode(), r"^texshot \d+\.\d+\.\d+\n$")


if __name__ == "__main__":
    unittest.main()
