"""texshot sweep: variations of a scene on labelled sheets. Pillow looks at every pixel of every cell."""

import io
import json
import os
import re
import signal
import subprocess
import time
import unittest

from PIL import Image, ImageChops

from texshot import TEXSHOT, Texshot, results, texshot

SMALL = ("--size", "48x32")
WRAP = "textures[0].wrapS=GL_REPEAT,GL_CLAMP_TO_EDGE,GL_MIRRORED_REPEAT"
FILTER = "textures[0].minFilter=GL_NEAREST,GL_LINEAR_MIPMAP_LINEAR"
GROUND = (251, 251, 250)
FRAME = (200, 200, 200)


class Sweep(Texshot):
    def setUp(self):
        super().setUp()
        self.out = self.path / "out"
        self.out.mkdir()
        self.scene = self.path / "far.json"  # minified, and coordinates beyond the texture
        self.scene.write_text(json.dumps({"version": 1, "view": {"distance": 9, "background": [0.2, 0.4, 0.1, 1]},
                                          "textures": [{"pattern": "uv-template", "mipmaps": "generated"}],
                                          "passes": [{"depthTest": True, "units": [{"enabled": True, "matrix": [{"op": "scale", "amount": [3, 3, 1]}]}]}]}))

    def sweep(self, *arguments, code=0):
        """What the call tells of its sheets."""
        result = texshot("sweep", self.scene, *(() if "--size" in arguments else SMALL), *arguments, "--json")
        self.assertEqual(result.returncode, code, result.stderr)
        return results(result.stdout)

    def cell(self, picture, cell):
        return picture.crop((cell["x"], cell["y"], cell["x"] + cell["width"], cell["y"] + cell["height"]))

    def alone(self, values, *arguments):
        sets = [word for path, value in values.items() for word in ("--set", f"{path}={value}")]
        picture = self.succeeds("shot", self.scene, *(() if "--size" in arguments else SMALL), *sets, *arguments, "-o", "-")
        return Image.open(io.BytesIO(picture)).convert("RGB")

    def assert_same(self, a, b, *what):
        self.assertEqual((a.size, a.tobytes()), (b.size, b.tobytes()), what)

    # -- what is on a sheet

    def test_every_cell_is_the_shot_with_its_values(self):
        for renderer in ("fixed", "shader", "reference"):
            with self.subTest(renderer):
                drawn = ("--renderer", renderer, "--time", "0.5")
                sheet, = self.sweep("--axis", WRAP, "--axis", FILTER, *drawn, "-o", self.out / "sheet.png")
                with Image.open(self.out / "sheet.png") as picture:
                    self.assertEqual((picture.mode, picture.size), ("RGB", (sheet["width"], sheet["height"])))
                    self.assertEqual([list(cell["values"].values()) for cell in sheet["cells"]],
                                     [[wrap, kind] for wrap in ("GL_REPEAT", "GL_CLAMP_TO_EDGE", "GL_MIRRORED_REPEAT")
                                      for kind in ("GL_NEAREST", "GL_LINEAR_MIPMAP_LINEAR")])
                    for cell in sheet["cells"]:
                        self.assert_same(self.cell(picture, cell), self.alone(cell["values"], *drawn), cell)
                    self.assertGreater(len({self.cell(picture, cell).tobytes() for cell in sheet["cells"]}), 3)

    def test_a_table_has_its_first_axis_down(self):
        sheet, = self.sweep("--axis", WRAP, "--axis", FILTER, "-o", self.out / "sheet.png")
        places = [(cell["x"], cell["y"]) for cell in sheet["cells"]]
        columns, rows = (sorted(set(each)) for each in zip(*places))
        self.assertEqual((len(columns), len(rows)), (2, 3))
        self.assertEqual(places, [(x, y) for y in rows for x in columns])
        with Image.open(self.out / "sheet.png") as picture:
            for y in rows:  # a label at the left of each row, and nothing between the pictures
                self.assertTrue(self.has_words(picture.crop((24, y, columns[0] - 12, y + 32))))
                self.assertEqual(picture.crop((columns[0] + 49, y, columns[1] - 1, y + 32)).getcolors()[0][1], GROUND)
            for x in columns:
                self.assertTrue(self.has_words(picture.crop((x, rows[0] - 24, x + 48, rows[0] - 6))))

    def has_words(self, picture):
        """Dark on the light ground, with the greys between that smooth letters."""
        colors = {color for _, color in picture.convert("RGB").getcolors(1 << 16)}
        return min(sum(color) for color in colors) < 150 and len(colors) > 8 and GROUND in colors

    def test_one_axis_fills_rows_with_a_label_below_each_picture(self):
        sheet, = self.sweep("--axis", "view.azimuth=0..75/6", "-o", self.out / "sheet.png")
        places = [(cell["x"], cell["y"]) for cell in sheet["cells"]]
        columns, rows = (sorted(set(each)) for each in zip(*places))
        self.assertEqual(places, [(x, y) for y in rows for x in columns])
        self.assertEqual((len(columns), len(rows)), (3, 2))
        self.assertEqual([cell["values"]["view.azimuth"] for cell in sheet["cells"]], ["0", "15", "30", "45", "60", "75"])
        with Image.open(self.out / "sheet.png") as picture:
            for x, y in places:
                self.assertTrue(self.has_words(picture.crop((x, y + 33, x + 48, y + 32 + 24))))

    def test_margins_are_equal_and_frames_outside(self):
        sheet, = self.sweep("--axis", "view.azimuth=0..50/9", "--size", "200x100", "-o", self.out / "sheet.png")
        with Image.open(self.out / "sheet.png") as picture:
            left, top, right, bottom = ImageChops.difference(picture, Image.new("RGB", picture.size, GROUND)).getbbox()
            self.assertEqual((left, picture.width - right), (23, 23))  # 24 and the frame
            self.assertTrue(24 <= top < 32 and 24 <= picture.height - bottom < 34, (top, bottom))
            for cell in sheet["cells"]:
                x, y, width, height = (cell[key] for key in ("x", "y", "width", "height"))
                around = [picture.getpixel(at) for i in range(width + 2)
                          for at in ((x - 1 + i, y - 1), (x - 1 + i, y + height))]
                around += [picture.getpixel(at) for i in range(height) for at in ((x - 1, y + i), (x + width, y + i))]
                self.assertEqual(set(around), {FRAME})

    def test_labels_are_names_or_words(self):
        pictures = []
        for labels in ("names", "words"):
            sheet, = self.sweep("--axis", FILTER, "--labels", labels, "-o", self.out / f"{labels}.png")
            picture = Image.open(self.out / f"{labels}.png")
            pictures.append((picture, [self.cell(picture, cell).tobytes() for cell in sheet["cells"]]))
        self.assertEqual(pictures[0][1], pictures[1][1])
        self.assertNotEqual(pictures[0][0].tobytes(), pictures[1][0].tobytes())
        plain, = self.sweep("--axis", FILTER, "-o", self.out / "plain.png")
        self.assertEqual((self.out / "plain.png").read_bytes(), (self.out / "names.png").read_bytes())

    def test_a_third_axis_makes_pages(self):
        call = ("--axis", WRAP, "--axis", FILTER, "--axis", "textures[0].magFilter=*")
        sheets = self.sweep(*call, "-o", self.out / "sheet-{page}.png")
        self.assertEqual([os.path.basename(sheet["file"]) for sheet in sheets], ["sheet-1.png", "sheet-2.png"])
        for sheet, magnified in zip(sheets, ("GL_NEAREST", "GL_LINEAR")):
            self.assertEqual([cell["values"]["textures[0].magFilter"] for cell in sheet["cells"]], 6 * [magnified])
            with Image.open(sheet["file"]) as picture:
                for cell in sheet["cells"]:
                    self.assert_same(self.cell(picture, cell), self.alone(cell["values"]), cell)
                texts = picture.text
                self.assertEqual(texts["Texplorer axes"].splitlines(), [WRAP, FILTER, f"textures[0].magFilter={magnified}"])
                self.assertEqual(json.loads(texts["Texplorer scene"])["textures"][0]["magFilter"], magnified)
        self.sweep(*call, "-o", self.out / "new" / "{magFilter} {scene}.png")
        self.assertEqual(sorted(os.listdir(self.out / "new")), ["GL_LINEAR far.png", "GL_NEAREST far.png"])
        self.assertEqual((self.out / "new" / "GL_LINEAR far.png").read_bytes(), (self.out / "sheet-2.png").read_bytes())
        one = self.sweep(*call[:4], "--axis", "textures[0].magFilter=GL_LINEAR", "-o", self.out / "one.png")
        self.assertEqual(len(one), 1)

    def test_a_name_with_a_place_for_every_axis_is_of_single_pictures(self):
        call = (self.scene, *SMALL, "--axis", WRAP, "--axis", FILTER)
        self.succeeds("sweep", *call, "-o", self.out / "sweep {wrapS} {minFilter}.png")
        self.succeeds("shot", *call, "-o", self.out / "shot {wrapS} {minFilter}.png")
        names = sorted(os.listdir(self.out))
        self.assertEqual(len(names), 12)
        for name in names[6:]:
            self.assertEqual((self.out / name).read_bytes(), (self.out / name.replace("sweep", "shot")).read_bytes())
        told = results(self.succeeds("sweep", *call, "-o", self.out / "{number}.png", "--json"))
        self.assertEqual(len(told), 6)

    # -- differences

    def test_difference_shows_and_counts_what_changes(self):
        sheet, = self.sweep("--axis", WRAP, "--axis", FILTER, "--difference", "first", "-o", self.out / "sheet.png")
        first = self.alone(sheet["cells"][0]["values"])
        counts = []
        with Image.open(self.out / "sheet.png") as picture:
            self.assert_same(self.cell(picture, sheet["cells"][0]), first)
            for cell in sheet["cells"][1:]:
                other = self.alone(cell["values"])
                differs = [a != b for a, b in zip(first.getdata(), other.getdata())]
                shown = list(self.cell(picture, cell).getdata())
                self.assertEqual([color != (0, 0, 0) for color in shown], differs, cell)
                self.assertEqual(cell["differing"], sum(differs))
                counts.append(cell["differing"])
        self.assertNotIn("differing", sheet["cells"][0])
        self.assertGreater(max(counts), 50)

    def test_what_changes_nothing_says_so(self):
        sheet, = self.sweep("--axis", "textures[0].priority=0,0.5,1", "--difference", "first", "-o", self.out / "sheet.png")
        self.assertEqual([cell.get("differing") for cell in sheet["cells"]], [None, 0, 0])
        with Image.open(self.out / "sheet.png") as picture:
            self.assertEqual(self.cell(picture, sheet["cells"][1]).getcolors(), [(48 * 32, (0, 0, 0))])

    # -- what a sheet says of itself

    def test_a_sheet_says_how_it_was_drawn(self):
        self.sweep("--axis", WRAP, "--axis", "material.color=1,0,0,1;0,1,0,1", "--time", "0.25", "-o", self.out / "a.png")
        with Image.open(self.out / "a.png") as picture:
            texts = picture.text
        self.assertEqual(texts["Texplorer axes"], WRAP + "\nmaterial.color=1,0,0,1;0,1,0,1")
        self.assertEqual((texts["Texplorer time"], texts["Texplorer size"]), ("0.25", "48x32"))
        self.assertIn("llvmpipe", texts["Texplorer driver"])
        again = [word for axis in texts["Texplorer axes"].splitlines() for word in ("--axis", axis)]
        self.succeeds("sweep", self.scene, "--size", texts["Texplorer size"], "--time", texts["Texplorer time"], *again, "-o", self.out / "b.png")
        self.assertEqual((self.out / "a.png").read_bytes(), (self.out / "b.png").read_bytes())
        self.assertIsNone(self.difference(self.shot(self.out / "a.png", *SMALL), self.shot(self.scene, *SMALL)))
        self.sweep("--axis", WRAP, "-o", self.out / "c.png", "--no-metadata")
        with Image.open(self.out / "c.png") as picture:
            self.assertEqual(picture.text, {})

    def test_other_formats_and_standard_output(self):
        self.sweep("--axis", WRAP, "-o", self.out / "a.png")
        self.assertEqual(self.succeeds("sweep", self.scene, *SMALL, "--axis", WRAP, "-o", "-"), (self.out / "a.png").read_bytes())
        for name in ("a.bmp", "a.tga"):
            self.sweep("--axis", WRAP, "-o", self.out / name)
            with Image.open(self.out / name) as other, Image.open(self.out / "a.png") as png:
                self.assert_same(other.convert("RGB"), png)

    # -- what can't be drawn, and wrong calls

    def test_a_picture_that_cannot_be_drawn_says_so_in_its_place(self):
        call = ("sweep", *SMALL, "--axis", "textures[0].source=pattern,file")
        result = texshot(*call, "-o", self.out / "sheet.png", "--json")
        self.assertEqual(result.returncode, 1)
        said = result.stderr.decode()
        self.assertRegex(said, r"\Atexshot: textures\[0\]\.source=file: [^\n]+\n\Z")
        drawn, failed = results(result.stdout)[0]["cells"]
        self.assertIn(failed["error"]["message"], said)
        self.assertNotIn("error", drawn)
        with Image.open(self.out / "sheet.png") as picture:
            place = self.cell(picture, failed)
            self.assertEqual(place.getpixel((0, 0)), (243, 234, 232))
            self.assertGreater(len(place.getcolors(1 << 16)), 8, "words")
        result = texshot(*call, "--difference", "first", "-o", self.out / "b.png")
        self.assertEqual(result.returncode, 1)
        backwards = texshot("sweep", *SMALL, "--axis", "textures[0].source=file,pattern", "--difference", "first", "-o", self.out / "c.png", "--json")
        self.assertEqual(backwards.returncode, 1)
        self.assertIn("no first picture", backwards.stdout.decode())

    def test_a_sheet_without_any_picture_is_not_written(self):
        self.complains(1, "textures[0].source=file", "sweep", *SMALL, "--axis", "textures[0].source=file", "-o", self.out / "x.png")
        self.assertEqual(os.listdir(self.out), [])

    def test_wrong_calls_are_one_sentence_before_any_work(self):
        x = self.out / "x.png"
        many = [word for path in ("azimuth", "elevation", "distance", "roll") for word in ("--axis", f"view.{path}=1,2")]
        cases = [
            (2, 'did you mean "minFilter"?', "--axis", "textures[0].minFiltr=*", "-o", x),
            (2, "2 to 256 values after the slash, found \"1000000\"", "--axis", "view.azimuth=0..1/1000000", "-o", x),
            (2, "at most 4096 pictures on the sheets of a call, found 65536", "--axis", "view.azimuth=0..1/256", "--axis", "view.elevation=0..1/256", "-o", x),
            (2, 'view.azimuth: expected each value once, found "1" twice', "--axis", "view.azimuth=0,1,1.0", "-o", x),
            (2, "found view.azimuth twice", "--axis", "view.azimuth=0,1", "--axis", "view.azimuth=2", "-o", x),
            (2, "at most 3 axes, down, across and pages, found 4", *many, "-o", x),
            (2, "differs for each of 2 pages, as in sheet-{page}.png or {distance}.png, found", *many[:6], "-o", x),
            (2, "found {azimuth}", *many[:4], "-o", self.out / "{azimuth}.png"),
            (2, "found {flavour}", *many[:4], "-o", self.out / "{flavour}.png"),
            (2, "--size: expected a sheet of at most 16384 × 16384 pixels", *many[:2], "--size", "9000x9000", "-o", x),
            (2, "--axis is missing", "-o", x),
            (2, "expected one of first, found \"last\"", *many[:2], "--difference", "last", "-o", x),
            (2, "expected one of names, words, found \"gl\"", *many[:2], "--labels", "gl", "-o", x),
            (2, "--difference: expected a name for sheets", *many[:2], "--difference", "first", "-o", self.out / "{azimuth}.png"),
            (2, "not both", *many[:2], "--json", "-o", "-"),
            (2, "ends in one of .bmp, .dds, .png, .tga", *many[:2], "-o", self.out / "x.txt"),
            (2, "expected PATH=VALUES", "--axis", "view.azimuth", "-o", x),
        ]
        for code, expected, *arguments in cases:
            with self.subTest(expected):
                self.complains(code, expected, "sweep", *(() if "--size" in arguments else SMALL), *arguments)
        self.assertEqual(os.listdir(self.out), [])
        self.complains(1, "far.json", "sweep", self.path / "not" / "far.json", "--axis", "view.azimuth=0,1", "-o", x)

    def test_options_without_effect_are_notes(self):
        few = ("--axis", "view.azimuth=0,1")
        for expected, *arguments in [
            ("--labels: has no effect here", "--labels", "words", "-o", self.out / "{azimuth}.png"),
            ("--context: has no effect here", "--renderer", "reference", "--context", "auto", "-o", self.out / "x.png"),
            ("--anisotropy: has no effect here", "--anisotropy", "ellipse", "-o", self.out / "x.png"),
            ("--no-metadata: has no effect here", "--no-metadata", "-o", self.out / "x.bmp"),
        ]:
            with self.subTest(expected):
                self.notes(expected, "sweep", *SMALL, *few, *arguments)

    def test_a_sheet_never_takes_the_place_of_its_scene(self):
        drawn = self.out / "scene.png"
        self.succeeds("shot", self.scene, *SMALL, "-o", drawn)
        before = drawn.read_bytes()
        self.complains(2, "expected a file other", "sweep", drawn, *SMALL, "--axis", WRAP, "-o", drawn)
        self.assertEqual(drawn.read_bytes(), before)

    def test_ctrl_c_leaves_nothing_half_written(self):
        call = [TEXSHOT, "sweep", "--axis", "view.azimuth=0..90/200", "--size", "300x200", "--renderer", "reference", "-o", str(self.out / "x.png")]
        work = subprocess.Popen(call, stderr=subprocess.PIPE)
        time.sleep(0.5)
        work.send_signal(signal.SIGINT)
        said = work.communicate(timeout=60)[1].decode()
        if work.returncode == 0:  # it was done before
            return Image.open(self.out / "x.png").load()
        self.assertEqual(work.returncode, 130, said)
        self.assertRegex(said, r"\Atexshot: [^\n]+\n\Z")
        self.assertEqual(os.listdir(self.out), [])

    def test_names_from_outside_are_words_and_nothing_else(self):
        hostile = self.path / "a\x1b[31m\u202e/b"
        hostile.parent.mkdir()
        scene = hostile.with_name("größe \x1b[2J" + 200 * "n" + ".json")
        scene.write_text('{"version": 1}')
        self.succeeds("sweep", scene, *SMALL, "--axis", "view.azimuth=0,1", "-o", self.out / "x.png")
        with Image.open(self.out / "x.png") as picture:
            self.assertLess(picture.width, 600, "the title is shortened")

    def test_help_and_completion_know_it(self):
        shown = self.succeeds("help", "sweep").decode()
        self.assertRegex(shown, r"--axis PATH=VALUES")
        self.assertIn("16384 × 16384", re.sub(r"\s+", " ", shown))
        self.assertIn("--difference", self.succeeds("--completion", "bash").decode())


if __name__ == "__main__":
    unittest.main()
