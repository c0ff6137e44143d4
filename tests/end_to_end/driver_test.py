"""What the real texshot makes of drivers that lack something, and of a disk without room: a picture or a
sentence, never a signal. Both the scene alone and the whole window, which draws through the same code as
texplorer's."""

import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from PIL import Image

TEXSHOT = os.path.abspath(sys.argv.pop(1))

EXTENSIONS = [
    "GL_ARB_depth_texture", "GL_ARB_framebuffer_object", "GL_ARB_multitexture", "GL_ARB_provoking_vertex",
    "GL_ARB_sampler_objects", "GL_ARB_shader_objects", "GL_ARB_texture_compression", "GL_ARB_texture_cube_map",
    "GL_ARB_texture_env_combine", "GL_ARB_texture_non_power_of_two", "GL_ARB_vertex_array_object",
    "GL_ARB_vertex_buffer_object", "GL_EXT_framebuffer_object", "GL_EXT_texture3D",
    "GL_EXT_texture_compression_s3tc", "GL_EXT_texture_env_combine", "GL_EXT_texture_filter_anisotropic",
]
DRIVERS = ["llvmpipe", "softpipe", "zink", "d3d12", "swr", "virpipe", "panfrost", "bogus"]
VERSIONS = ["1.1", "1.5", "2.0", "2.1", "3.0", "3.0FC", "3.1", "3.2CORE", "4.5CORE", "nonsense"]


class Drivers(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path = Path(self.folder.name)
        self.addCleanup(self.folder.cleanup)
        self.picture = self.path / "picture.png"
        self.scene = self.path / "scene.json"
        self.scene.write_text(json.dumps({
            "version": 1, "models": [{"shape": "floor"}],
            "textures": [{"mipmaps": "generated", "minFilter": "GL_LINEAR_MIPMAP_LINEAR", "maxAnisotropy": 4}]}))

    def texshot(self, *arguments, **environment):
        return subprocess.run([TEXSHOT, *map(str, arguments)], capture_output=True, timeout=240, cwd=self.path,
                              env={**os.environ, "XDG_CACHE_HOME": str(self.path / "cache"), **environment})

    def shot(self, *arguments, **environment):
        """Into a file: Mesa writes its warnings to standard output."""
        self.picture.unlink(missing_ok=True)
        return self.texshot("shot", self.scene, "--size", "320x240", "-o", self.picture, *arguments, **environment)

    def check(self, result, what):
        """A picture and no more than sentences, or exit status 1 and one sentence."""
        said = result.stderr.decode()
        lines = [each for each in said.splitlines() if not each.startswith(("Warning: ", "error: "))] # Mesa's
        self.assertIn(result.returncode, (0, 1), f"{what}: {said}")
        for line in lines:
            self.assertTrue(line.startswith("texshot: "), f"{what}: {said}")
        if result.returncode == 0:
            Image.open(self.picture).load()
        else:
            self.assertEqual(len(lines), 1, f"{what}: {said}")
        return said

    def test_an_extension_less_is_a_picture_or_a_sentence(self):
        for extension in EXTENSIONS:
            for how in ([], ["--ui"], ["--renderer", "shader"]):
                with self.subTest(extension=extension, how=how):
                    result = self.shot(*how, MESA_EXTENSION_OVERRIDE="-" + extension)
                    said = self.check(result, extension)
                    if result.returncode == 1:
                        self.assertRegex(said, "needs OpenGL [23].[13] with", extension)

    def test_a_driver_that_is_not_there_is_named(self):
        for driver in DRIVERS:
            for how in ([], ["--ui"]):
                with self.subTest(driver=driver, how=how):
                    result = self.shot(*how, GALLIUM_DRIVER=driver)
                    said = self.check(result, driver)
                    self.assertEqual(result.returncode, 0 if driver in DRIVERS[:2] else 1, said)
                    if result.returncode == 1:
                        self.assertIn(f'"{driver}"', said)

    def test_another_version_is_a_picture_or_a_sentence(self):
        for version in VERSIONS:
            for how in ([], ["--ui"]):
                with self.subTest(version=version, how=how):
                    result = self.shot(*how, MESA_GL_VERSION_OVERRIDE=version)
                    said = self.check(result, version)
                    if version in ("1.1", "1.5", "2.0", "3.0FC"):
                        self.assertEqual(result.returncode, 1)
                        self.assertIn("needs OpenGL 2.1", said)

    def test_a_renderer_that_the_driver_lacks_is_not_offered(self):
        old = {"MESA_GL_VERSION_OVERRIDE": "2.1"}
        for how in (["--renderer", "shader"], ["--ui", "--renderer", "shader"], ["--ui", "--compare", "fixed,shader"]):
            with self.subTest(how=how):
                result = self.shot(*how, **old)
                self.assertEqual(result.returncode, 1)
                self.assertIn("needs OpenGL 3.3", self.check(result, str(how)))
        self.assertEqual(self.shot("--ui", "--tab", "glsl", **old).returncode, 0)
        few = ["conform", "--feature", "wrap", "--scenes", "4"]
        result = self.texshot(*few, **old)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn(b"needs OpenGL 3.3", result.stderr)
        self.assertIn(b"reference against fixed", result.stdout)
        self.assertNotIn(b"shader against fixed", result.stdout)
        result = self.texshot(*few, "--renderer", "shader", **old)
        self.assertEqual(result.returncode, 1)
        self.assertEqual(result.stderr.count(b"\n"), 1)
        self.assertIn(b"needs OpenGL 3.3", result.stderr)

    def test_other_variables_of_mesa_do_no_harm(self):
        for name, value in (("LIBGL_ALWAYS_SOFTWARE", "1"), ("LIBGL_ALWAYS_SOFTWARE", "bogus"),
                            ("LIBGL_ALWAYS_INDIRECT", "1"), ("EGL_PLATFORM", "bogus"),
                            ("GALLIUM_DRIVER", ""), ("MESA_SHADER_CACHE_DIR", "/proc"),
                            ("MESA_SHADER_CACHE_DIR", "relative\n"), ("MESA_GLSL_CACHE_DIR", "/dev/null")):
            with self.subTest(name=name, value=value):
                self.assertEqual(self.shot(**{name: value}).returncode, 0)

    def test_the_drivers_cache_is_private_and_used_again(self):
        cache = self.path / "cache/texplorer/driver"

        def entries():
            return {each: each.stat().st_mtime_ns for each in cache.rglob("*")
                    if each.is_file() and each.name != "index"}

        def grown():
            """After another shot. Mesa writes entries in the background and drops those left when a process exits."""
            before = entries()
            self.assertEqual(self.shot().returncode, 0)
            return entries() != before

        self.assertTrue(any(grown() for _ in range(20)), "nothing was written")
        self.assertEqual(cache.stat().st_mode & 0o777, 0o700)
        self.assertTrue(any(not grown() for _ in range(20)), "found and not made again")

    def test_a_full_disk_below_the_cache_directory_is_no_signal(self):
        small = self.path / "small"
        small.mkdir()
        for size, left in (("64k", 0), ("1300k", 8192), ("1500k", 1500 * 1024)):
            with self.subTest(size=size, left=left):
                mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={size}", "tmpfs", str(small)],
                                         capture_output=True)
                if mounted.returncode == 0:
                    try:
                        (small / "other").write_bytes(bytes(int(size[:-1]) * 1024 - left))
                        result = self.shot(XDG_CACHE_HOME=str(small))
                    finally:
                        subprocess.run(["umount", str(small)], check=True)
                    self.assertEqual((result.returncode, result.stderr), (0, b""))
        # Not everybody may mount: a limit on the size of files is as good as a full disk.
        for kilobytes in (0, 4, 1000, 1279):
            with self.subTest(kilobytes=kilobytes):
                result = subprocess.run(
                    ["bash", "-c", 'ulimit -f "$1"; exec "${@:2}"', "bash", str(kilobytes), TEXSHOT, "shot",
                     str(self.scene), "--size", "32x24", "-o", "-"], capture_output=True, timeout=120,
                    env={**os.environ, "XDG_CACHE_HOME": str(self.path / f"limited{kilobytes}")})
                self.assertEqual((result.returncode, result.stderr), (0, b""))

    def test_levels_that_are_not_there_and_lines_are_drawn_and_said(self):
        for how in ([], ["--ui"], ["--renderer", "shader"]):
            for base in (7, 200, 322, 1000):
                with self.subTest(how=how, base=base):
                    result = self.shot("--set", f"textures[0].baseLevel={base}", "--set",
                                       "textures[0].minFilter=GL_NEAREST", *how)
                    self.assertIn("which does not exist", self.check(result, base))
            with self.subTest(how=how):
                result = self.shot("--set", "passes[0].units[0].target=GL_TEXTURE_1D", *how)
                self.assertEqual(result.returncode, 0)
                self.assertIn(b"drawn without anisotropy", result.stderr)
        for target in ("GL_TEXTURE_2D", "GL_TEXTURE_3D", "GL_TEXTURE_CUBE_MAP"):
            with self.subTest(target=target):
                result = self.shot("--set", f"passes[0].units[0].target={target}")
                self.assertEqual(result.returncode, 0)
                self.assertNotIn(b"anisotropy", result.stderr)

    def test_a_probe_survives_what_a_picture_does(self):
        for level in (200, 1000):
            result = self.texshot("probe", self.scene, "--at", "30,20", "--set", f"textures[0].baseLevel={level}",
                                  "--set", "textures[0].minFilter=GL_LINEAR")
            self.assertEqual(result.returncode, 0, result.stderr)


if __name__ == "__main__":
    unittest.main()
