"""decode, convert, flip, compress and info of many files at once."""

import os
import signal
import subprocess
import time
import unittest

from PIL import Image

from texshot import TEXSHOT, Texshot, bmp, document, single, texshot


class Batch(Texshot):
    def setUp(self):
        super().setUp()
        self.files = []
        for number in range(3):
            file = self.path / f"picture{number}.bmp"
            file.write_bytes(bmp(8, 4, lambda x, y: (x * 30, y * 60, number * 100)))
            self.files.append(file)
        self.out = self.path / "out" / "below"  # it is made, with what is above it

    def pixels(self, file):
        with Image.open(file) as picture:
            return picture.convert("RGB").tobytes()

    def test_each_input_becomes_a_file_of_its_name(self):
        for call, extension in ((["convert", "--to", "tga"], ".tga"), (["decode"], ".png"), (["decode", "--to", "BMP"], ".bmp"),
                                (["compress", "--format", "dxt5"], ".dds")):
            with self.subTest(call):
                self.assertEqual(self.succeeds(*call, *self.files, "-o", self.out), b"")
                names = [file.stem + extension for file in self.files]
                self.assertEqual(sorted(name for name in os.listdir(self.out) if name.endswith(extension)), names)
                for file, name in zip(self.files, names):
                    if extension != ".dds":
                        self.assertEqual(self.pixels(self.out / name), self.pixels(file))

    def test_flip_keeps_the_format_and_the_name(self):
        dds = self.path / "a.b.DDS"
        self.succeeds("compress", self.files[0], dds, "--format", "dxt1")
        jpeg = self.path / "photo.jpg"
        Image.new("RGB", (8, 8), (200, 10, 10)).save(jpeg)
        self.succeeds("flip", self.files[1], dds, jpeg, "-o", self.out)
        self.assertEqual(sorted(os.listdir(self.out)), ["a.b.DDS", "photo.png", "picture1.bmp"])
        with Image.open(self.out / "picture1.bmp") as turned:
            self.assertEqual(turned.convert("RGB").transpose(Image.Transpose.FLIP_TOP_BOTTOM).tobytes(),
                             self.pixels(self.files[1]))
        self.succeeds("flip", self.out / "a.b.DDS", "-o", self.path / "back")
        self.assertEqual((self.path / "back" / "a.b.DDS").read_bytes(), dds.read_bytes())

    def test_two_that_would_become_one_are_refused_before_anything_is_written(self):
        (self.path / "other").mkdir()
        same = self.path / "other" / "picture0.tga"
        self.succeeds("convert", self.files[0], same)
        said = self.complains(2, f'--out: "{self.files[0]}" and "{same}" would both become {self.out / "picture0.png"}',
                              "convert", *self.files, same, "-o", self.out, "--to", "png")
        self.assertEqual(said.count("\n"), 1)
        self.assertFalse(self.out.exists())
        self.complains(2, "would both become", "convert", self.files[0], self.files[0], "-o", self.out, "--to", "png")

    def test_one_that_fails_is_said_and_the_others_go_on(self):
        broken = self.path / "broken.bmp"
        broken.write_bytes(self.files[0].read_bytes()[:60])
        missing = self.path / "missing.bmp"
        result = texshot("convert", self.files[0], broken, missing, self.path, self.files[1], "-o", self.out, "--to", "png",
                         "--json")
        self.assertEqual(result.returncode, 1)
        sentences = result.stderr.decode().splitlines()
        self.assertEqual(len(sentences), 3, sentences)
        for sentence, name in zip(sentences, (broken, missing, self.path)):
            self.assertTrue(sentence.startswith(f"texshot: {name}: "), sentence)
        self.assertEqual(sorted(os.listdir(self.out)), ["picture0.png", "picture1.png"])
        told = document(result.stdout)
        self.assertEqual([each["input"] for each in told["results"]], [str(self.files[0]), str(self.files[1])])
        self.assertEqual([each["where"] for each in told["problems"]], [[{"file": str(each)}] for each in (broken, missing, self.path)])
        self.assertEqual(told["problems"][1]["message"], "can't be opened: No such file or directory")
        self.assertEqual(told["problems"][1]["arguments"], ["No such file or directory"])
        self.assertEqual([each["code"] for each in told["problems"]], ["Malformed", "NotFound", "Unreadable"])

    def test_where_all_fail_no_folder_is_made(self):
        self.complains(1, "No such file", "decode", self.path / "missing.bmp", "-o", self.out)

    def test_reports_say_what_became_of_what(self):
        text = self.succeeds("convert", *self.files, "-o", self.out, "--to", "png", "--report").decode()
        self.assertEqual(text.splitlines(),
                         [f"{file} -> {self.out / file.stem}.png: PNG, 8 × 4, 1 level, "
                          f"{(self.out / file.stem).with_suffix('.png').stat().st_size} bytes" for file in self.files])
        told = document(self.succeeds("compress", *self.files, "-o", self.out, "--format", "dxt1", "--json"))
        self.assertEqual((len(told["results"]), told["problems"]), (3, []))
        first = told["results"][0]
        self.assertEqual({key: first[key] for key in ("format", "width", "height", "depth", "faces", "levelCount", "bytes")},
                         {"format": "DDS", "width": 8, "height": 4, "depth": 1, "faces": 1, "levelCount": 4,
                          "bytes": (self.out / "picture0.dds").stat().st_size})
        # 8 x 4, 4 x 2, 2 x 1 and 1 x 1 texels in blocks of 4 x 4 with 8 bytes each
        self.assertEqual([level["bytes"] for level in first["report"]["levels"]], [16, 8, 8, 8])
        alone = single(self.succeeds("flip", self.files[0], self.path / "one.tga", "--json"))
        self.assertEqual(alone["file"], str(self.path / "one.tga"))
        self.complains(2, "--json: standard output can have the picture or the JSON, not both", "flip", self.files[0], "-", "--json")
        self.complains(2, "--report: standard output can have the picture or the JSON, not both", "compress", self.files[0], "-",
                       "--format", "dxt1", "--report")

    def test_an_input_may_be_its_own_output_where_that_is_said(self):
        wanted = self.pixels(self.files[0])
        self.complains(2, f'--out: expected a file other than "{self.files[0]}", which is read', "flip", *self.files, "-o", self.path)
        self.complains(2, f'OUT: expected a file other than "{self.files[0]}", which is read', "flip", self.files[0], self.files[0])
        self.assertEqual(self.pixels(self.files[0]), wanted)
        os.symlink(self.files[0], self.path / "link.bmp")
        for other in (self.path / "link.bmp", self.path / "." / ".." / self.path.name / self.files[0].name):
            self.complains(2, "--in-place: expected a file other than", "flip", self.files[0], other, "--in-place")
        os.remove(self.path / "link.bmp")
        self.assertEqual(self.pixels(self.files[0]), wanted)
        self.succeeds("flip", *self.files, "--in-place")
        self.assertNotEqual(self.pixels(self.files[0]), wanted)
        self.succeeds("flip", *self.files, "--in-place")
        self.assertEqual(self.pixels(self.files[0]), wanted)
        self.assertEqual(sorted(os.listdir(self.path)), [file.name for file in self.files])

    def test_info_of_many(self):
        text = self.succeeds("info", *self.files).decode()
        self.assertEqual(text.count("biBitCount"), 3)
        broken = self.path / "broken.bmp"
        broken.write_bytes(b"BM")
        result = texshot("info", "--json", self.files[0], broken, self.files[1])
        self.assertEqual((result.returncode, result.stderr.count(b"\n")), (1, 1))
        told = document(result.stdout)
        self.assertEqual([each["file"] for each in told["results"]], [str(self.files[0]), str(broken), str(self.files[1])])
        self.assertEqual([each["where"] for each in told["problems"]], [[{"file": str(broken)}]])
        self.assertEqual(self.facts(self.files[0])["width"], 8)  # of one, it alone

    def test_wrong_calls(self):
        out = self.path / "new"
        (self.path / "file").write_bytes(b"")
        for expected, *call in [
            ("OUT is missing: expected IN OUT, or IN... -o DIR", "convert", self.files[0]),
            ("expected IN OUT, or IN... -o DIR, found 3 files", "convert", *self.files),
            ("IN is missing; see texshot convert --help", "convert", "-o", out),
            ("--to is missing: with -o it says the format, one of bmp, dds, png, tga", "convert", *self.files, "-o", out),
            ('--to: expected one of bmp, dds, png, tga, found "jpeg"', "convert", *self.files, "-o", out, "--to", "jpeg"),
            ("--to: expected the format of OUT, whose extension says PNG, found BMP", "convert", self.files[0], self.path / "a.png",
             "--to", "bmp"),
            (f'--out: expected a folder, found "{self.path / "a.png"}"; IN OUT writes one file', "decode", self.files[0], "-o",
             self.path / "a.png"),
            ("standard input: has no name for a file in a folder; IN OUT writes one file", "decode", "-", "-o", out),
            ("expected a file's name", "decode", str(self.path) + "/", "-o", out),
            ("there is no option --to", "compress", *self.files, "-o", out, "--format", "dxt1", "--to", "png"),
        ]:
            with self.subTest(expected):
                self.complains(2, expected, *call)
        self.complains(1, "file", "decode", self.files[0], "-o", self.path / "file")

    def test_ctrl_c_leaves_whole_files(self):
        large = []
        for number in range(4):
            file = self.path / f"large{number}.bmp"
            file.write_bytes(bmp(256, 256, lambda x, y: (x, y, (x * y + number) & 255)))
            large.append(file)
        call = [TEXSHOT, "compress", *large, "-o", self.out, "--format", "dxt5", "--quality", "best"]
        work = subprocess.Popen(call, stderr=subprocess.PIPE)
        while work.poll() is None and not (self.out / "large0.dds").exists():
            time.sleep(0.01)
        work.send_signal(signal.SIGINT)
        said = work.communicate(timeout=60)[1]
        if work.returncode != 0:  # else it was done before
            self.assertEqual((work.returncode, said), (130, b"texshot: interrupted\n"))
        names = sorted(os.listdir(self.out))
        self.assertEqual(names, [f"large{number}.dds" for number in range(len(names))])
        for name in names:
            self.succeeds("validate", self.out / name)


if __name__ == "__main__":
    unittest.main()
