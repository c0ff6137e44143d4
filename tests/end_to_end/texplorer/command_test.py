"""What texplorer says before it opens a window."""

import pathlib
import tempfile
import unittest

from texplorer import Display, run


class Command(unittest.TestCase):
    def one_sentence(self, done, code, *words):
        self.assertEqual(done.returncode, code, done.stderr)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)

    def test_says_what_it_is(self):
        text = run("--help").stdout
        self.assertIn("FILE", text)
        self.assertIn("variable TEXPLORER_SHADERS", text)
        words = " ".join(text.split())
        self.assertIn("$TEXPLORER_FRAME_SECONDS (default 10,", words)
        self.assertIn("one of fixed, shader, reference.", words)
        self.assertIn("no-multitexture", text)
        self.assertLessEqual(max(map(len, text.splitlines())), 80)
        version = run("--version")
        self.assertEqual(version.returncode, 0)
        self.assertRegex(version.stdout, r"^texplorer \d+\.\d+\.\d+\n$")

    def test_refuses_a_wrong_call(self):
        self.one_sentence(run("--nonsense"), 2, "texplorer: there is no option --nonsense; see texplorer --help")
        self.one_sentence(run("--pretend", "no-unit"), 2, "texplorer: --pretend: expected one of no-multitexture, ",
                          ', found "no-unit"')
        self.one_sentence(run("--pretend", "units=0"), 2, "a whole number from 1 to 4")
        self.one_sentence(run("--context", "glx"), 2, 'texplorer: --context: expected native or egl, found "glx"')
        self.one_sentence(run("--renderer", "fastest"), 2,
                          'texplorer: --renderer: expected one of fixed, shader, reference, found "fastest"')
        for time in ("", "ten", "-1", "10s", "nan", "1e9"):
            self.one_sentence(run(TEXPLORER_FRAME_SECONDS=time), 2, "texplorer: TEXPLORER_FRAME_SECONDS: expected seconds",
                              f'found "{time}"')
        self.one_sentence(run("--context", "osmesa"), 2, "texplorer: --context: OSMesa", "texshot --context osmesa")

    def test_without_a_display_it_names_texshot(self):
        self.one_sentence(run(), 1, "display", "texshot")

    def test_without_opengl_it_names_texshot(self):
        for what, options, variables in (("no OpenGL", ["-extension", "GLX"], {}),
                                         ("an old one", [], {"MESA_GL_VERSION_OVERRIDE": "1.4"})):
            with self.subTest(what):
                display = Display(*options)
                self.addCleanup(display.close)
                self.one_sentence(run(display=display.name, **variables), 1, "OpenGL", "texshot shot --ui")

    def test_without_egl_it_names_it(self):
        display = Display()
        self.addCleanup(display.close)
        nowhere = {"__EGL_VENDOR_LIBRARY_FILENAMES": "/nonexistent"}
        self.one_sentence(run("--context", "egl", display=display.name, **nowhere), 1, "OpenGL by EGL",
                          "texshot shot --ui")

    def test_says_each_file_of_several_that_are_all_bad(self):
        done = run("/nowhere/a.bmp", "/nowhere/b.json")
        self.assertEqual(done.returncode, 1)
        self.assertEqual([line.split(": ")[1] for line in done.stderr.splitlines()],
                         ["/nowhere/a.bmp", "/nowhere/b.json"])

    def test_one_good_file_of_several_is_worth_a_window(self):
        with tempfile.TemporaryDirectory() as name:
            scene = pathlib.Path(name) / "scene.json"
            scene.write_text('{"version": 1}')
            done = run("/nowhere/a.bmp", scene)  # which then lacks a display
        self.assertEqual(done.returncode, 1)
        lines = done.stderr.splitlines()
        self.assertIn("/nowhere/a.bmp", lines[0])
        self.assertIn("display", lines[1])

    def test_refuses_files_in_one_sentence(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "empty.bmp").touch()
            (folder / "text.bmp").write_text("Hello")
            (folder / "half.json").write_text('{"textures": [')
            for file in ("missing.png", "empty.bmp", "text.bmp", "half.json", "."):
                with self.subTest(file=file):
                    self.one_sentence(run(folder / file), 1, str(folder))


if __name__ == "__main__":
    unittest.main(verbosity=2)
