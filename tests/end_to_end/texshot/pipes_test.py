"""Standard input, pipes and terminals: what is read from them and written to them."""

import io
import json
import os
import pty
import subprocess
import threading
import unittest

from PIL import Image

from texshot import TEXSHOT, Texshot, bmp, results, texshot, within_memory


class Pipes(Texshot):
    def setUp(self):
        super().setUp()
        self.bmp = bmp(16, 8, lambda x, y: (x * 15, y * 30, 60))
        (self.path / "in.bmp").write_bytes(self.bmp)
        self.wanted = Image.open(io.BytesIO(self.bmp)).convert("RGB").tobytes()

    def fed(self, content, *arguments, **options):
        """What it prints that gets this from standard input."""
        result = texshot(*arguments, input=content, **options)
        self.assertEqual((result.returncode, result.stderr), (0, b""), arguments)
        return result.stdout

    def refuses(self, content, code, sentence, *arguments, **options):
        result = texshot(*arguments, input=content, **options)
        self.assertEqual((result.returncode, result.stderr.decode()), (code, f"texshot: {sentence}\n"))

    def test_images_come_from_standard_input(self):
        for call in (["convert", "-", "-"], ["decode", "-", "-"], ["convert", "/dev/stdin", "/dev/stdout"]):
            with self.subTest(call):
                picture = Image.open(io.BytesIO(self.fed(self.bmp, *call)))
                self.assertEqual((picture.format, picture.convert("RGB").tobytes()), ("PNG", self.wanted))
        flipped = Image.open(io.BytesIO(self.fed(self.bmp, "flip", "-", "-", "--to", "bmp")))
        self.assertEqual(flipped.format, "BMP")
        self.assertEqual(flipped.convert("RGB").transpose(Image.Transpose.FLIP_TOP_BOTTOM).tobytes(), self.wanted)
        for kind, expected in (("BMP", "BMP"), ("TGA", "TGA"), ("DDS", "DDS"), ("PNG", "PNG"), ("JPEG", "PNG")):
            with self.subTest(f"flip keeps {kind}"), io.BytesIO() as content:
                Image.new("RGB", (8, 4), (200, 10, 10)).save(content, kind)
                nameless = self.path / "nameless"
                nameless.write_bytes(content.getvalue())
                for printed in (self.fed(content.getvalue(), "flip", "-", "-"), self.succeeds("flip", nameless, "-")):
                    self.assertEqual(Image.open(io.BytesIO(printed)).format, expected)
                self.succeeds("flip", nameless, "-o", self.path / kind)
                self.assertEqual(os.listdir(self.path / kind), [f"nameless.{expected.lower()}"])
        self.assertTrue(self.fed(self.bmp, "compress", "-", "-", "--format", "dxt1").startswith(b"DDS "))
        self.assertIn(b"standard input", self.fed(self.bmp, "info", "-"))
        told = results(self.fed(self.bmp, "info", "-", "--json"))[0]
        self.assertEqual((told["file"], told["width"], told["height"]), ("-", 16, 8))

    def test_a_file_may_be_standard_input(self):
        with open(self.path / "in.bmp", "rb") as file:
            result = subprocess.run([TEXSHOT, "convert", "-", "-"], stdin=file, capture_output=True, timeout=60)
        self.assertEqual(Image.open(io.BytesIO(result.stdout)).convert("RGB").tobytes(), self.wanted)

    def test_one_after_the_other_in_a_pipe(self):
        line = '"$0" convert "$1" - | "$0" flip - - --to dds | "$0" flip - - --to dds | "$0" decode - -'
        result = subprocess.run(["sh", "-c", line, TEXSHOT, self.path / "in.bmp"], capture_output=True, timeout=60)
        self.assertEqual((result.returncode, result.stderr), (0, b""))
        self.assertEqual(Image.open(io.BytesIO(result.stdout)).convert("RGB").tobytes(), self.wanted)

    def test_named_pipes_are_read(self):
        pipe = self.path / "pipe"
        os.mkfifo(pipe)
        writer = threading.Thread(target=lambda: pipe.write_bytes(self.bmp))
        writer.start()
        picture = Image.open(io.BytesIO(self.succeeds("convert", pipe, "-")))
        writer.join()
        self.assertEqual(picture.convert("RGB").tobytes(), self.wanted)
        line = '"$0" info <(cat "$1")'
        result = subprocess.run(["bash", "-c", line, TEXSHOT, self.path / "in.bmp"], capture_output=True, timeout=60)
        self.assertEqual((result.returncode, result.stderr), (0, b""))
        self.assertIn("16 × 8 texels".encode(), result.stdout)

    def test_a_scene_comes_from_standard_input(self):
        scene = json.dumps({"version": 1, "view": {"background": [1, 0, 0, 1]}, "models": [], "textures": [],
                            "passes": [{}]}).encode()
        call = ["--renderer", "reference", "--size", "4x4", "-o", "-"]
        picture = Image.open(io.BytesIO(self.fed(scene, "shot", "-", *call)))
        self.assertEqual(set(picture.convert("RGB").getdata()), {(255, 0, 0)})
        changed = self.fed(scene, "shot", "-", "--set", "view.background=0,1,0,1", *call)
        self.assertEqual(set(Image.open(io.BytesIO(changed)).convert("RGB").getdata()), {(0, 255, 0)})
        self.fed(scene, "check", "-")
        self.fed(scene, "commands", "-")
        self.fed(scene, "probe", "-", "--no-gl", "--size", "4x4", "--at", "1,1")
        written = self.path / "scene.json"
        written.write_bytes(scene)
        self.assertEqual(self.fed(scene, "diff", "-", written), b"")
        # Its images are looked for in the current folder.
        textured = json.dumps({"version": 1, "textures": [{"source": "file", "file": "in.bmp"}]}).encode()
        texture = self.fed(textured, "texture", "-", "-o", "-", cwd=self.path)
        self.assertEqual(Image.open(io.BytesIO(texture)).convert("RGB").tobytes(), self.wanted)

    def test_what_comes_may_be_wrong(self):
        self.refuses(b"", 1, "standard input: expected an image (BMP, DDS, JPEG, PNG, TGA), the file is empty",
                     "convert", "-", "-")
        self.refuses(b"nonsense", 1, "standard input: expected an image (BMP, DDS, JPEG, PNG, TGA), the file begins "
                     "with 6e 6f 6e 73", "info", "-")
        self.refuses(b"", 1, "standard input: expected an object, found an empty file", "check", "-")
        result = texshot("check", "-", input=b'{"version": 1, "veiw": {}}')
        self.assertEqual(result.returncode, 1)
        self.assertRegex(result.stderr.decode(), r'\Atexshot: standard input: /veiw: unknown key; did you mean "view"\?\n\Z')
        self.refuses(b"x" * ((16 << 20) + 1), 1, f"standard input: at most {16 << 20} bytes are read, but there are more",
                     "check", "-")

    def test_standard_input_can_be_read_once(self):
        said = "standard input: can be read only once, but is named twice"
        for call in (["diff", "-", "-"], ["diff", "-", "/dev/stdin"], ["info", "-", self.path / "in.bmp", "-"],
                     ["validate", "-", "-"], ["scene", "-", "--diff", "-"],
                     ["convert", "-", "-", "-o", self.path / "out", "--to", "png"]):
            with self.subTest(call):
                self.refuses(self.bmp, 2, said, *call)

    def test_what_never_ends_is_not_read_to_its_end(self):
        for call in (["info", "-"], ["convert", "-", "-"], ["validate", "-"]):
            with self.subTest(call):
                endless = subprocess.Popen(["yes"], stdout=subprocess.PIPE)
                result = subprocess.run([TEXSHOT, *call], stdin=endless.stdout, capture_output=True, timeout=60,
                                        **within_memory(500))
                endless.stdout.close()
                endless.wait(timeout=60)
                self.assertEqual(result.returncode, 1)
                self.assertIn(b"begins with 79 0a 79 0a", result.stderr + result.stdout)
        endless = subprocess.Popen(["yes", '{"version": 1}'], stdout=subprocess.PIPE)
        result = subprocess.run([TEXSHOT, "check", "-"], stdin=endless.stdout, capture_output=True, timeout=60,
                                **within_memory(500))
        endless.stdout.close()
        endless.wait(timeout=60)
        self.assertEqual((result.returncode, result.stderr.decode()),
                         (1, f"texshot: standard input: at most {16 << 20} bytes are read, but there are more\n"))

    def test_an_image_that_never_ends_is_read_as_far_as_its_header_goes(self):
        wrong = b"BM" + b"y\n" * 60  # no header that more bytes would make right
        for begin, code, expected in ((self.bmp, 0, "16 × 8 texels".encode()), (wrong, 1, b"BMP: ")):
            with self.subTest(begin[:4]):
                read, write = os.pipe()
                os.write(write, begin)
                endless = subprocess.Popen(["yes"], stdout=write)
                os.close(write)
                result = subprocess.run([TEXSHOT, "info", "-"], stdin=read, capture_output=True, timeout=60,
                                        **within_memory(500))
                os.close(read)
                endless.wait(timeout=60)
                self.assertEqual(result.returncode, code, result.stderr)
                self.assertIn(expected, result.stdout + result.stderr)

    def test_a_file_that_is_no_image_is_not_read_to_its_end(self):
        huge = self.path / "huge"
        with open(huge, "wb") as file:
            file.write(b"nonsense")
            file.truncate(1 << 30)
        scene = self.path / "huge.json"
        scene.write_text(json.dumps({"version": 1, "textures": [{"source": "file", "file": "huge"}]}))
        for call in (["info", huge], ["convert", huge, self.path / "out.png"],
                     ["shot", scene, "--renderer", "reference", "--size", "4x4", "-o", self.path / "out.png"]):
            with self.subTest(call[0]):
                result = subprocess.run([TEXSHOT, *map(str, call)], capture_output=True, timeout=60,
                                        **within_memory(500))
                self.assertEqual(result.returncode, 1)
                self.assertIn(b"begins with 6e 6f 6e 73", result.stderr + result.stdout)

    def test_a_closed_standard_input_is_said(self):
        result = subprocess.run([TEXSHOT, "info", "-"], capture_output=True, timeout=60, preexec_fn=lambda: os.close(0))
        self.assertEqual((result.returncode, result.stderr.decode()),
                         (1, "texshot: standard input: can't be read: Bad file descriptor\n"))

    def test_a_picture_is_not_written_to_a_terminal(self):
        controller, terminal = pty.openpty()
        scene = ["shot", "--renderer", "reference", "--size", "4x4", "-o", "-"]
        for call in (["convert", self.path / "in.bmp", "-"], ["convert", self.path / "in.bmp", "/dev/stdout"], scene,
                     ["compress", self.path / "in.bmp", "-", "--format", "dxt1"],
                     ["convert", self.path / "in.bmp", os.ttyname(terminal)]):
            with self.subTest(call):
                result = subprocess.run([TEXSHOT, *map(str, call)], stdout=terminal, stderr=subprocess.PIPE, timeout=60)
                self.assertEqual(result.returncode, 2)
                self.assertRegex(result.stderr.decode(), r"\Atexshot: (standard output|/dev/pts/\d+): is a terminal, which "
                                 r"can't show a picture; name a file or redirect it\n\Z")
        result = subprocess.run([TEXSHOT, "info", self.path / "in.bmp"], stdout=terminal, stderr=subprocess.PIPE,
                                timeout=60)
        self.assertEqual((result.returncode, result.stderr), (0, b""))  # text is for terminals
        os.close(terminal)
        os.close(controller)

    def test_who_types_is_waited_for(self):
        controller, terminal = pty.openpty()
        work = subprocess.Popen([TEXSHOT, "check", "-"], stdin=terminal, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        os.close(terminal)
        os.write(controller, b'{"version": 1}\n\x04')  # and Ctrl+D
        out, said = work.communicate(timeout=60)
        self.assertEqual((work.returncode, said), (0, b""), out)
        os.close(controller)


if __name__ == "__main__":
    unittest.main()
