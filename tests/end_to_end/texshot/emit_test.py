"""texshot emit: a scene as a program. tests/end_to_end/emitted tests what programs draw."""

import json
import os
import re
import shutil
import subprocess
import unittest
from pathlib import Path

from PIL import Image

from texshot import Texshot, bmp, results, texshot


class Emit(Texshot):
    def emitted(self, *arguments):
        file = self.path / "demo.c"
        self.succeeds("emit", *arguments, "-o", file)
        return file.read_text()

    def refused(self, *arguments, code=1):
        """The error, after a check that nothing was written."""
        file = self.path / "demo.c"
        result = texshot("emit", *arguments, "-o", file)
        self.assertEqual((result.returncode, result.stdout), (code, b""), result.stderr)
        self.assertFalse(file.exists())
        sentence = result.stderr.decode()
        self.assertRegex(sentence, r"\Atexshot: [^\n]+\n\Z")
        return sentence

    def test_the_line_at_its_top_compiles_it(self):
        text = self.emitted("--example", "cube")
        command = re.search(r"\bcc (\S+) -o (\S+) (.*?) \*/", text)
        self.assertEqual(command.groups(), ("demo.c", "demo", "-lglfw -lGL -lm"))
        done = subprocess.run(["gcc", "-std=c99", "-Wall", "-Wextra", "-Werror", "demo.c", "-o", "demo", *command[3].split()],
                              cwd=self.path, capture_output=True)
        self.assertEqual((done.returncode, done.stderr), (0, b""))

    def test_glew_and_cmake_build_it(self):
        """With GLU's shapes, by a name that is a target of CMake itself."""
        self.succeeds("emit", "--example", "quadrics", "--loader", "glew", "--cmake", "-o", self.path / "clean.c")
        for words in (("-S", ".", "-B", "build"), ("--build", "build")):
            done = subprocess.run(["cmake", *words], cwd=self.path, capture_output=True, text=True)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertTrue((self.path / "build" / "clean").exists())
        self.succeeds("emit", "--example", "quadrics", "--loader", "glew", "--cmake", "-o", self.path / "clean.c")

    def test_refuses_what_cmake_cant_have(self):
        for name in ("-", "CMakeLists.txt", "cube", "cube.cpp", "-cube.c", ".c", "my cube.c", "$cube.c", "é.c"):
            with self.subTest(name):
                done = texshot("emit", "--cmake", "-o", name if name == "-" else self.path / name)
                self.assertEqual((done.returncode, done.stdout, list(self.path.iterdir())), (2, b"", []), done.stderr)
        (self.path / "CMakeLists.txt").write_text("project(mine)\n")
        self.assertIn("choose another folder", self.refused("--cmake"))
        self.assertEqual((self.path / "CMakeLists.txt").read_text(), "project(mine)\n")

    def test_a_lesson_says_why(self):
        lesson = results(self.succeeds("lessons", "--json"))
        title = next(each for each in lesson if each["name"] == "filters")["title"]
        text = self.emitted("--lesson", "filters", "--step", "1")
        self.assertTrue(text.startswith(f"/* {title}: Texels are squares\n"), text[:200])
        self.assertIn("This image has 16", text[:400])
        self.assertRegex(text, r"/\* How a colour is found where a texel covers more than one pixel, [^\n]*\*/\n"
                               r" *glTexParameteri\(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST\);")

    def test_the_texels_of_an_image_are_in_it(self):
        """Unpacks the numbers in the program by the format's description, qoiformat.org."""
        picture = Image.effect_noise((32, 16), 60).convert("RGBA")
        picture.putpixel((3, 4), (1, 2, 3, 77))
        picture.save(self.path / "noise.png")
        (self.path / "scene.json").write_text(json.dumps({
            "version": 1, "textures": [{"source": "file", "file": "noise.png"}],
            "models": [{"shape": "quad"}], "passes": [{"units": [{"enabled": True}]}]}))
        text = self.emitted(self.path / "scene.json")
        numbers = re.search(r"texture0Packed\[\d+\] = \{\n(.*?)\};", text, re.DOTALL)[1]
        texels = unpacked([int(each) for each in re.findall(r"\d+", numbers)])
        turned = picture.transpose(Image.Transpose.FLIP_TOP_BOTTOM)
        self.assertEqual(bytes(texels), turned.tobytes())

    def test_what_a_program_has_no_words_for_is_one_sentence(self):
        self.assertIn("models[0].shape: a program (C with OpenGL 2.1) can't animate this by key frames, because shapes are made", self.refused(self.keyed()))
        self.assertIn("--as", self.refused("--as", "assembler", code=2))
        self.assertIn("internalFormat", self.refused("--preset", "shadow-map", "--set", "textures[0].internalFormat=GL_RGBA",
                                                     self.shadowed()))

    def keyed(self):
        file = self.path / "keyed.json"
        file.write_text(json.dumps({"version": 1, "timeline": [
            {"time": 0, "path": "models[0].shape", "value": "cube"}, {"time": 1, "path": "models[0].shape", "value": "sphere"}]}))
        return file

    def shadowed(self):
        file = self.path / "shadowed.json"
        file.write_text(json.dumps({"version": 1, "textures": [{"source": "light-depth"}], "models": [{}],
                                    "passes": [{"units": [{"enabled": True}]}]}))
        return file

    def test_an_output_that_cannot_be_written_is_named_before_any_work(self):
        scene = self.path / "scene.json"
        self.succeeds("scene", "-o", scene)
        (self.path / "file").write_text("")
        result = texshot("emit", "-o", self.path / "file" / "demo.c")
        self.assertEqual(result.returncode, 1)
        self.assertIn(b"Not a directory", result.stderr)
        before = scene.read_bytes()
        self.assertEqual(texshot("emit", scene, "-o", scene).returncode, 2)
        self.assertEqual(scene.read_bytes(), before)

    def test_a_lesson_s_files_are_written_beside_its_program(self):
        step = ("--lesson", "textured-cube", "--step", "5")
        self.assertNotIn("readBmp(", self.emitted(*step))
        self.assertEqual([file.name for file in self.path.iterdir()], ["demo.c"])
        for _ in range(2):  # the second finds it there
            self.assertIn("readBmp(\"uv.bmp\", 96, 96, ", self.emitted(*step, "--files"))
        original = Path(__file__).parents[3] / "assets/lessons/textured-cube/uv.bmp"
        self.assertEqual((self.path / "uv.bmp").read_bytes(), original.read_bytes())
        (self.path / "uv.bmp").write_bytes(b"mine")
        (self.path / "demo.c").unlink()
        self.assertIn("uv.bmp: is there already", self.refused(*step, "--files"))
        self.assertEqual((self.path / "uv.bmp").read_bytes(), b"mine")
        result = texshot("emit", *step, "--files", "-o", self.path / "uv.bmp")  # which would read itself
        self.assertEqual((result.returncode, (self.path / "uv.bmp").read_bytes()), (1, b"mine"), result.stderr)
        (self.path / "uv.bmp").unlink()
        for device in "/dev/full", "/dev/null":  # no files are written next to these
            result = texshot("emit", *step, "--files", "-o", device)
            self.assertEqual((result.returncode, result.stderr.count(b"\n")), (2, 1), result.stderr)
            self.assertIn(b"expected a file, to write other files next to it", result.stderr)
            self.assertFalse(Path("/dev/uv.bmp").exists())
        self.assertIn("--files", self.refused("--example", "cube", "--files", code=2))
        self.assertEqual(list(self.path.glob("*.bmp")), [])
        result = texshot("emit", *step, "--files")
        self.assertEqual((result.returncode, result.stdout), (2, b""))

    def test_a_lesson_s_files_are_never_called_as_it_wants(self):
        lesson = self.path / "mine"
        lesson.mkdir()
        for name in (".bash_profile", "x.html", "a\nb.bmp"):
            with self.subTest(name):
                (lesson / name).write_bytes(bmp(2, 2, lambda x, y: (x * 255, y * 255, 9)))
                (lesson / "lesson.json").write_text(json.dumps({"lesson": 1, "title": "T", "about": "A.", "steps": [
                    {"title": "S", "text": "T.", "scene": "s.json"}]}))
                (lesson / "s.json").write_text(json.dumps({"version": 1, "textures": [{"source": "file", "file": name}],
                                                           "passes": [{"units": [{"enabled": True}]}]}))
                text = self.emitted("--lesson", lesson, "--step", "1", "--files")
                neighbours = sorted(file.name for file in self.path.iterdir() if file.is_file())
                self.assertRegex(" ".join(neighbours), r"\Ademo\.c image-[0-9a-f]{8}\.bmp\Z")
                self.assertIn(f'readBmp("{neighbours[1]}", 2, 2, ', text)
                self.assertEqual((self.path / neighbours[1]).read_bytes(), (lesson / name).read_bytes())
                self.succeeds("lessons", "--page", self.path / "out", "--lesson", lesson)
                written = [file.name for file in (self.path / "out").rglob("*") if file.is_file()]
                self.assertIn(neighbours[1], written)
                self.assertFalse({name, name.split("\n")[0]} & set(written))
                shutil.rmtree(self.path / "out")
                (self.path / neighbours[1]).unlink()
                (self.path / "demo.c").unlink()

    def test_a_hostile_name_stays_within_its_comment(self):
        (self.path / "scene.json").write_text(json.dumps({
            "version": 1, "textures": [{"source": "file", "file": "*/ int broken; /*.png"}],
            "models": [{"name": "*/ int x; /* \n #error"}], "passes": [{"name": "??/\n#error", "units": [{"enabled": True}]}]}))
        Image.new("RGB", (4, 4)).save(self.path / "other.png")
        result = texshot("emit", self.path / "scene.json", "--set", "textures[0].source=pattern")
        self.assertEqual(result.returncode, 0, result.stderr)
        file = self.path / "demo.c"
        file.write_bytes(result.stdout)
        done = subprocess.run(["gcc", "-std=c99", "-Wall", "-Wextra", "-Werror", "-fsyntax-only", os.fspath(file)], capture_output=True)
        self.assertEqual((done.returncode, done.stderr), (0, b""))


def unpacked(codes):
    texels, seen, texel, at = bytearray(), [(0, 0, 0, 0)] * 64, (0, 0, 0, 255), 0
    while at < len(codes):
        code = codes[at]
        at += 1
        run = 1
        if code in (0xFE, 0xFF):
            count = code - 0xFB
            texel = tuple(codes[at:at + count]) + texel[count:]
            at += count
        elif code < 64:
            texel = seen[code]
        elif code < 128:
            texel = tuple((value + (code >> shift & 3) - 2) % 256 for value, shift in zip(texel, (4, 2, 0))) + texel[3:]
        elif code < 192:
            green, others = code - 160, codes[at]
            at += 1
            changes = (green + (others >> 4) - 8, green, green + (others & 15) - 8)
            texel = tuple((value + change) % 256 for value, change in zip(texel, changes)) + texel[3:]
        else:
            run = code - 191
        seen[sum(value * factor for value, factor in zip(texel, (3, 5, 7, 11))) % 64] = texel
        texels += bytes(texel) * run
    return texels


if __name__ == "__main__":
    unittest.main()
