"""texshot shot with several scenes, sizes, times and axes: one call, many pictures, each with its name and its
texts."""

import json
import os
import re
import resource
import shutil
import signal
import struct
import subprocess
import time
import unittest
import zlib

from PIL import Image

from texshot import SANITIZED, TEXSHOT, Texshot, bmp, problem, results, texshot

SMALL = ("--size", "48x32")


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def with_chunks(png, *chunks):
    """The PNG with additional chunks after its header."""
    return png[:33] + b"".join(chunks) + png[33:]


def packed_zeros(megabytes):
    """A zlib stream of so many zeros; not made as a whole, so that this process is not mistaken for texshot's
    memory."""
    packer = zlib.compressobj(9)
    return b"".join(packer.compress(b"0" * (1 << 20)) for _ in range(megabytes)) + packer.flush()


class Shots(Texshot):
    def setUp(self):
        super().setUp()
        self.out = self.path / "out"
        self.out.mkdir()

    def scene(self, name, **changes):
        file = self.path / name
        file.write_text(json.dumps({"version": 1, **changes}))
        return file

    def names(self):
        return sorted(os.listdir(self.out))

    def draws(self, *arguments):
        self.assertEqual(self.succeeds("shot", *(() if "--size" in arguments else SMALL), *arguments), b"")
        return self.names()

    # -- the pictures and their names

    def test_json_tells_of_every_picture_what_it_is_of(self):
        blue = self.scene("blue.json", view={"background": [0, 0, 1, 1]})
        broken = self.path / "broken.json"
        broken.write_text("{")
        result = texshot("shot", broken, blue, "--axis", "textures[0].wrapS=GL_REPEAT,GL_CLAMP", "--size", "16x12,24x8",
                         "--time", "0.5", "-o", self.out / "{number}.png", "--json")
        self.assertEqual(result.returncode, 1)
        self.assertIn(str(broken), problem(result.stdout))
        told = results(result.stdout)
        self.assertEqual([(os.path.basename(each["file"]), each["values"]["textures[0].wrapS"], each["time"])
                          for each in told],
                         [("1.png", "GL_REPEAT", 0.5), ("2.png", "GL_CLAMP", 0.5), ("3.png", "GL_REPEAT", 0.5),
                          ("4.png", "GL_CLAMP", 0.5)])
        for each in told:
            with Image.open(each["file"]) as picture:
                self.assertEqual(picture.size, (each["width"], each["height"]))
                self.assertEqual(picture.text["Texplorer driver"], f"{each['driver']}, {each['version']}")
            self.assertEqual((each["scene"], each["warnings"]), (str(blue), []))
        self.complains(2, "not both", "shot", blue, "-o", "-", "--json")

    def test_several_scenes_get_a_picture_each(self):
        red = self.scene("red.json", view={"background": [1, 0, 0, 1]})
        blue = self.scene("blue.texplorer.json", view={"background": [0, 0, 1, 1]})
        self.assertEqual(self.draws(red, blue, "-o", self.out / "{scene}.png"), ["blue.png", "red.png"])
        for name, colour in (("red", (255, 0, 0)), ("blue", (0, 0, 255))):
            with Image.open(self.out / f"{name}.png") as picture:
                self.assertEqual((picture.size, picture.getpixel((0, 0))), ((48, 32), colour))

    def test_axes_sizes_and_times_make_every_combination(self):
        names = self.draws("--axis", "textures[0].minFilter=GL_NEAREST,GL_LINEAR", "--axis", "passes[0].lighting=*",
                           "--size", "16x16,32x16", "--time", "0,0.5,2",
                           "-o", self.out / "{size} {time} {minFilter} {passes[0].lighting}.png")
        self.assertEqual(len(names), 2 * 2 * 2 * 3)
        self.assertIn("32x16 0.5 GL_LINEAR false.png", names)
        for name in names:
            with Image.open(self.out / name) as picture:
                self.assertEqual(f"{picture.width}x{picture.height}", name.split()[0])

    def test_numbers_follow_the_order_of_the_scenes_and_then_of_the_axes(self):
        a, b = self.scene("a.json"), self.scene("b.json")
        self.draws(a, b, "--axis", "view.azimuth=0,10", "--axis", "view.elevation=5,6,7", "-o",
                   self.out / "{number} {scene} {azimuth} {elevation}.png")
        self.assertEqual(self.names(), [f"{2 * 3 * s + 3 * x + y + 1:02} {scene} {x * 10} {y + 5}.png"
                                        for s, scene in enumerate("ab") for x in (0, 1) for y in (0, 1, 2)])

    def test_a_picture_among_many_is_the_picture_alone(self):
        photo = self.path / "photo.bmp"
        photo.write_bytes(bmp(24, 20, lambda x, y: (x * 9, y * 11, x * y & 255)))
        scenes = [self.scene("file.json", textures=[{"source": "file", "file": "photo.bmp", "mipmaps": "generated"}],
                             passes=[{"units": [{"enabled": True}]}]),
                  self.scene("plain.json"),
                  self.scene("cube.json", textures=[{"pattern": "brick", "mipmaps": "generated"}], passes=[{"units": [
                      {"enabled": True, "target": "GL_TEXTURE_CUBE_MAP"}]}]),
                  self.scene("again.json", textures=[{"source": "file", "file": "photo.bmp", "compression": "driver",
                                                 "minFilter": "GL_LINEAR"}],
                             passes=[{"units": [{"enabled": True}]}])]
        for renderer in ("fixed", "shader", "reference"):
            many = texshot("shot", *scenes, "--renderer", renderer, "--axis", "textures[0].wrapS=GL_REPEAT,GL_CLAMP_TO_EDGE",
                           "--size", "40x30,64x48", "-o", self.out / "{renderer}-{scene}-{size}-{wrapS}.png")
            self.assertEqual(many.returncode, 0, many.stderr)
            pictures = {}  # of each sentence
            for scene in scenes:
                for size in ("40x30", "64x48"):
                    for wrap in ("GL_REPEAT", "GL_CLAMP_TO_EDGE"):
                        with self.subTest((renderer, scene.name, size, wrap)):
                            name = self.out / f"{renderer}-{scene.stem}-{size}-{wrap}.png"
                            alone = texshot("shot", scene, "--renderer", renderer, "--size", size,
                                            "--set", f"textures[0].wrapS={wrap}", "-o", "-")
                            self.assertEqual((alone.returncode, name.read_bytes()), (0, alone.stdout))
                            for line in alone.stderr.decode().splitlines():
                                pictures.setdefault(line.removeprefix("texshot: "), []).append(name)
            more = {len(names): f" (and of {len(names) - 1} more picture{'s' * (len(names) > 2)})" if len(names) > 1 else ""
                    for names in pictures.values()}
            self.assertEqual(many.stderr.decode(), "".join(f"texshot: {names[0]}: {sentence}{more[len(names)]}\n"
                                                           for sentence, names in pictures.items()),
                             "the same sentences, each once, in the order of the pictures")

    def test_windows_are_drawn_too(self):
        names = self.draws("--ui", "--size", "800x600", "--axis", "textures[0].magFilter=*", "-o", self.out / "{magFilter}.png")
        self.assertEqual(names, ["GL_LINEAR.png", "GL_NEAREST.png"])
        self.assertEqual((self.out / "GL_LINEAR.png").read_bytes(),
                         self.succeeds("shot", "--ui", "--size", "800x600", "--set", "textures[0].magFilter=GL_LINEAR", "-o", "-"))

    def test_one_picture_may_have_places_too(self):
        self.assertEqual(self.draws(self.scene("a b.json"), "-o", self.out / "{scene}-{{x}}.png"), ["a_b-{x}.png"])
        self.assertIn("{y}.png", self.draws("-o", self.out / "{{y}}.png"))
        (self.out / "{y}.png").unlink()
        self.assertEqual(self.draws("--lesson", "filters", "--step", "2", "-o", self.out / "{scene}.tga")[-1],
                         "filters-2.tga")

    # -- errors before anything is drawn

    def refuses(self, expected, *arguments, code=2):
        self.complains(code, expected, "shot", *(() if "--size" in arguments else SMALL), *arguments)
        self.assertEqual(self.names(), [])

    def test_names_that_cant_be_are_refused(self):
        a, b = self.scene("a.json"), self.scene("b.json")
        (self.path / "other").mkdir()
        twin = self.scene("other/a.json")
        axis = ("--axis", "textures[0].minFilter=GL_NEAREST,GL_LINEAR")
        self.refuses('expected a name that differs for each picture, as in {scene}.png or {number}.png, found "%s"'
                     % (self.out / "x.png"), a, b, "-o", self.out / "x.png")
        self.refuses("expected a name that differs for each picture", a, "--time", "0,1", "-o", "-")
        self.refuses('found "%s" for number 1 and number 2' % (self.out / "x.png"), a, *axis, "-o", self.out / "x.png")
        self.refuses("for number 1 and number 2", a, twin, "-o", self.out / "{scene}.png")
        self.refuses("for number 1 and number 2", a, *axis, "-o", self.out / "{scene}.png")
        self.refuses("expected one of {scene}, {number}, {renderer}, {time}, {size}, {minFilter}; found {magFilter}",
                     a, *axis, "-o", self.out / "{magFilter}.png")
        self.refuses("{envMode} may be passes[0].units[0].envMode or passes[0].units[1].envMode", a,
                     "--axis", "passes[0].units[0].envMode=*", "--axis", "passes[0].units[1].envMode=*",
                     "-o", self.out / "{envMode}.png")
        self.refuses("expected a name and } after each {", a, b, "-o", self.out / "{scene.png")
        self.refuses("--out: expected a name that ends in one of .bmp, .dds, .png, .tga", a, b, "-o", "{scene}")
        self.refuses('expected a name that differs for each picture, as in {minFilter}.png or {number}.png, found "-"',
                     a, *axis, "-o", "-")
        self.refuses("expected each axis once, found textures[0].minFilter twice", a, *axis, *axis, "-o", self.out / "{number}.png")
        self.refuses('expected each once, found "0" twice', a, "--time", "0,1,0", "-o", self.out / "{time}.png")
        self.refuses("--size: expected WIDTHxHEIGHT", a, "--size", "8x8,", "-o", self.out / "{size}.png")
        self.refuses("textures[0].nonsense", a, b, "--axis", "textures[0].nonsense=*", "-o", self.out / "{number}.png")
        self.notes("--no-metadata: has no effect here: it applies to PNG files only", "shot", *SMALL, a, b, "--no-metadata",
                   "-o", self.out / "{scene}.bmp")

    def test_folders_are_made_whatever_the_name(self):
        a = self.scene("a.json")
        axis = ("--axis", "textures[0].minFilter=GL_NEAREST,GL_LINEAR")
        self.succeeds("shot", *SMALL, a, *axis, "-o", self.out / "new" / "{minFilter}" / "{scene}.png")
        self.assertEqual(sorted(str(each.relative_to(self.out)) for each in self.out.rglob("*.png")),
                         ["new/GL_LINEAR/a.png", "new/GL_NEAREST/a.png"])
        self.succeeds("shot", *SMALL, a, "-o", self.out / "another" / "one.png")
        self.assertTrue((self.out / "another" / "one.png").exists())
        self.complains(1, "nowhere.bmp", "shot", *SMALL, self.scene("b.json", textures=[{"source": "file", "file": "nowhere.bmp"}],
                       passes=[{"units": [{"enabled": True}]}]), "-o", self.out / "empty" / "one.png")
        self.assertFalse((self.out / "empty").exists(), "nothing is in it")
        (self.out / "file").write_text("")
        for name in ("{scene}.png", "one.png"):
            self.complains(1, "the folder can't be made: Not a directory", "shot", *SMALL, a, "-o", self.out / "file" / "in" / name)

    def test_several_renderers_are_a_picture_each(self):
        a = self.scene("a.json")
        self.succeeds("shot", *SMALL, a, "--renderer", "fixed,Reference", "--time", "0,1", "-o", self.out / "{renderer}-{time}.png")
        for renderer in ("fixed", "reference"):
            for time in ("0", "1"):
                with self.subTest(renderer=renderer, time=time):
                    self.succeeds("shot", *SMALL, a, "--renderer", renderer, "--time", time, "-o", self.path / "alone.png")
                    self.assertEqual((self.out / f"{renderer}-{time}.png").read_bytes(), (self.path / "alone.png").read_bytes())
        told = results(self.succeeds("shot", *SMALL, a, "--renderer", "shader,reference", "--json", "-o", self.out / "{number}.png"))
        self.assertEqual([each["renderer"] for each in told], ["shader", "reference"])
        self.complains(2, "expected a name that differs for each picture", "shot", *SMALL, a, "--renderer", "fixed,shader", "-o", self.out / "one.png")
        self.complains(2, '--renderer: expected each once, found "fixed" twice', "shot", a, "--renderer", "fixed,fixed", "-o", self.out / "{renderer}.png")
        self.complains(2, '--renderer: expected one of fixed, shader, reference, found ""', "shot", a, "--renderer", "fixed,", "-o", self.out / "{renderer}.png")
        result = texshot("shot", *SMALL, a, "--renderer", "fixed,reference", "--context", "auto", "-o", self.out / "{renderer}.png")
        self.assertEqual((result.returncode, result.stderr), (0, b""), "one of them asks OpenGL")

    def test_a_warning_is_said_once(self):
        a = self.scene("a.json", textures=[{"minFilter": "GL_LINEAR_MIPMAP_LINEAR", "mipmaps": "none"}],
                       passes=[{"units": [{"enabled": True}]}])
        result = texshot("shot", *SMALL, a, "--axis", "view.azimuth=0..90/10", "-o", self.out / "{azimuth}.png")
        said = result.stderr.decode().splitlines()
        self.assertEqual((result.returncode, len(self.names()), len(said), len(set(said))), (0, 10, len(set(said)), len(said)))
        self.assertTrue(said)
        for each in said:
            self.assertRegex(each, r"\Atexshot: .*/0\.png: .* \(and of 9 more pictures\)\Z")

    def test_no_value_leads_out_of_the_folder(self):
        evil = self.scene("..<script>.json", view={"azimuth": 1})
        names = self.draws(evil, "--axis", "view.background=0,0,0,1;1,1,1,1", "-o", self.out / "{scene}{background}.png")
        self.assertEqual(names, ["_._script_0,0,0,1.png", "_._script_1,1,1,1.png"])
        for name in ("..json", "....json"):
            inner = self.out / "in"
            inner.mkdir(exist_ok=True)
            evil = self.scene(name)
            self.succeeds("shot", *SMALL, evil, "-o", self.out / "in" / "{scene}.png")
        self.assertEqual(sorted(os.listdir(self.path)), sorted(
            ["..<script>.json", "..json", "....json", "out"]))
        self.assertTrue(all(name.startswith("_") for name in os.listdir(inner)), os.listdir(inner))

    def test_too_many_pictures_are_refused_at_once(self):
        axes = []
        for path in ("view.azimuth=0..100/100", "view.elevation=0..80/100", "view.distance=2..9/100"):
            axes += ["--axis", path]
        self.refuses("one call draws at most 100000 pictures, expected fewer", *axes, "-o", self.out / "{number}.png")
        for times in (11, 40):
            self.refuses("at most 100000", *axes[:4], "--time", ",".join(map(str, range(times))), "-o", self.out / "{number}.png")
        million = [*axes, "--axis", "view.fieldOfView=10..90/100"]
        if not SANITIZED:
            self.assertLess(self.peak([], *million, "-o", self.out / "{number}.png", code=2), 64 << 10, "kilobytes")

    # -- errors while drawing

    def test_broken_scenes_are_said_and_the_others_drawn(self):
        good, more = self.scene("good.json"), self.scene("more.json")
        broken = self.path / "broken.json"
        broken.write_text('{"version": 1, "textures": [')
        unloadable = self.scene("unloadable.json", textures=[{"source": "file", "file": "missing.bmp"}],
                                passes=[{"units": [{"enabled": True}]}])
        missing = self.path / "missing.json"
        result = texshot("shot", *SMALL, good, broken, unloadable, missing, more, "-o", self.out / "{scene}.png")
        said = result.stderr.decode().splitlines()
        self.assertEqual((result.returncode, self.names()), (1, ["good.png", "more.png"]), said)
        self.assertEqual(len(said), 3)
        self.assertIn("broken.json", said[0])
        self.assertIn("missing.json: can't be opened: No such file or directory", said[1])
        self.assertRegex(said[2], r"unloadable\.png: .*unloadable\.json: .*missing\.bmp")
        result = texshot("shot", *SMALL, broken, missing, "-o", self.out / "x{number}.png")
        self.assertEqual((result.returncode, len(result.stderr.splitlines())), (1, 2))

    def test_a_full_disk_ends_it_with_one_sentence(self):
        scenes = [self.scene(f"{i}.json", view={"azimuth": i}) for i in range(12)]
        self.succeeds("shot", "--size", "256x256", scenes[0], "-o", self.out / "0.png")
        old = (self.out / "0.png").read_bytes()
        limit = 64
        result = texshot("shot", "--size", "256x256", *scenes, "-o", self.out / "{scene}.png",
                         preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit)))
        self.assertEqual(result.returncode, 1)
        self.assertRegex(result.stderr.decode(),
                         r"\Atexshot: [^\n]*/\d+\.png: can't be written: File too large; 0 of 12 pictures were written\n\Z")
        self.assertEqual((self.names(), (self.out / "0.png").read_bytes()), (["0.png"], old))

    def test_a_disk_that_fills_up_keeps_what_was_written(self):
        """Small pictures fit, a large one does not: those that were written before it are complete."""
        call = ("shot", "--size", "16x16,512x512", "--axis", "view.azimuth=0..90/4", "-o", self.out / "{size}-{azimuth}.png")
        limit = 12000
        result = texshot(*call, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit)))
        self.assertEqual(result.returncode, 1)
        self.assertLessEqual(set(self.names()), {f"16x16-{angle}.png" for angle in (0, 30, 60, 90)})
        self.assertRegex(result.stderr.decode(),
                         rf"\Atexshot: [^\n]*512x512-[^\n]*; {len(self.names())} of 8 pictures were written\n\Z")
        for name in self.names():
            with Image.open(self.out / name) as picture:
                picture.load()

    def test_a_signal_keeps_what_was_written(self):
        call = [TEXSHOT, "shot", "--size", "300x200", "--axis", "view.azimuth=0..90/256", "--axis", "view.elevation=0..80/256",
                "-o", str(self.out / "{number}.png")]
        for kill, code in ((signal.SIGINT, 130), (signal.SIGTERM, 143)):
            with self.subTest(kill):
                shutil.rmtree(self.out)
                self.out.mkdir()
                work = subprocess.Popen(call, stderr=subprocess.PIPE)
                while work.poll() is None and len(os.listdir(self.out)) < 5:
                    time.sleep(0.01)
                work.send_signal(kill)
                said = work.communicate(timeout=100)[1].decode()
                self.assertEqual(work.returncode, code, said)
                names = self.names()
                self.assertEqual(said, f"texshot: interrupted; {len(names)} of 65536 pictures were written\n")
                self.assertEqual(names, [f"{i + 1:05}.png" for i in range(len(names))])
                for name in names:
                    with Image.open(self.out / name) as picture:
                        picture.load()

    def test_a_kill_leaves_no_half_of_a_file(self):
        call = [TEXSHOT, "shot", "--size", "300x200", "--axis", "view.azimuth=0..90/200", "-o", str(self.out / "{number}.png")]
        work = subprocess.Popen(call, stderr=subprocess.DEVNULL)
        while work.poll() is None and len(os.listdir(self.out)) < 5:
            time.sleep(0.01)
        work.kill()
        work.wait()
        for name in self.names():
            if re.fullmatch(r"\d+\.png", name):
                with Image.open(self.out / name) as picture:
                    picture.load()
            else:
                self.assertRegex(name, r"\A\.texplorer-.*\.tmp\Z")
        self.succeeds("shot", *SMALL, "--time", "0,1", "-o", self.out / "x{number}.png")
        self.assertTrue(all(re.fullmatch(r"x?\d+\.png", name) for name in self.names()), self.names())

    @unittest.skipIf(SANITIZED, "AddressSanitizer keeps what was freed")
    def test_memory_stays_bounded_over_many_scenes(self):
        """500 scenes with 250 images and as many meshes; the memory of a single one is not used 500 times."""
        files = [self.scene(f"scene{i}.json", models=[{"shape": "sphere", "slices": 16 + i % 40, "stacks": 50 + i // 40}],
                            textures=[{"source": "file", "file": f"{i // 2}.bmp", "mipmaps": "generated"}],
                            passes=[{"units": [{"enabled": True, "envMode": mode}]}])
                 for i, mode in zip(range(500), 100 * ["GL_MODULATE", "GL_REPLACE", "GL_ADD", "GL_DECAL", "GL_BLEND"])]
        image = bmp(256, 256, lambda x, y: (x, y, 0))
        for i in range(250):  # 0.35 MB each with its levels
            (self.path / f"{i}.bmp").write_bytes(image[:60] + bytes([i]) + image[61:])
        for renderer in ("fixed", "shader"):
            few, many = (self.peak(files[:count], *SMALL, "--renderer", renderer, "-o", self.out / "{scene}.png")
                         for count in (100, 500))
            self.assertEqual(len(self.names()), 500)
            self.assertGreater(few, resource.getrusage(resource.RUSAGE_SELF).ru_maxrss, "a child begins with its parent's")
            self.assertLess(many - few, 40 << 10, f"kilobytes: {few} for 100 scenes, {many} for 500")

    def peak(self, files, *arguments, code=0):
        """The most memory that texshot shot has used, in kilobytes."""
        with open(self.path / "said.txt", "w+b") as said:
            work = subprocess.Popen([TEXSHOT, "shot", *map(str, [*files, *arguments])], stderr=said)
            _, status, usage = os.wait4(work.pid, 0)
            work.returncode = os.waitstatus_to_exitcode(status)
            said.seek(0)
            self.assertEqual(work.returncode, code, said.read())
        return usage.ru_maxrss

    # -- the texts in a picture

    def texts(self, name):
        with Image.open(self.out / name) as picture:
            picture.load()
            return dict(picture.text)

    def test_a_png_says_how_it_was_drawn(self):
        scene = self.scene("a.json", view={"azimuth": 33}, textures=[{"source": "file", "file": "größe.bmp"}])
        (self.path / "größe.bmp").write_bytes(bmp(4, 4, lambda x, y: (x, y, 0)))
        self.draws(scene, "--set", "textures[0].mipmaps=generated", "--time", "0.25", "--renderer", "shader", "--set", "view.elevation=12", "-o", self.out / "a.png")
        texts = self.texts("a.png")
        version = self.succeeds("--version").decode().split()[-1]
        self.assertEqual(texts["Software"], f"texshot {version}")
        self.assertEqual(texts["Texplorer renderer"], "shader")
        self.assertIn("llvmpipe", texts["Texplorer driver"])
        self.assertRegex(texts["Texplorer driver"], r"Mesa \d")
        self.assertTrue(texts["Texplorer context"])
        self.assertEqual((texts["Texplorer time"], texts["Texplorer size"]), ("0.25", "48x32"))
        document = json.loads(texts["Texplorer scene"])
        self.assertEqual((document["view"]["azimuth"], document["view"]["elevation"]), (33, 12))
        self.assertEqual(document["textures"][0]["file"], "größe.bmp")
        self.draws("--renderer", "reference", "-o", self.out / "b.png")
        self.assertNotIn("Texplorer driver", self.texts("b.png"))
        self.draws("-o", self.out / "c.png", "--no-metadata")
        self.assertEqual(self.texts("c.png"), {})
        self.draws("--ui", "--size", "800x600", "--compare", "fixed,reference", "-o", self.out / "d.png")
        self.assertEqual(self.texts("d.png")["Texplorer renderer"], "fixed,reference")

    def test_a_picture_is_its_own_scene(self):
        scene = self.scene("a.json", view={"azimuth": 33}, models=[{"shape": "sphere", "slices": 9}])
        self.draws(scene, "--set", "material.color=1,0,0,1", "-o", self.out / "first.png")
        self.draws(self.out / "first.png", "-o", self.out / "second.png")
        self.assertEqual((self.out / "first.png").read_bytes(), (self.out / "second.png").read_bytes())
        self.assertNotEqual((self.out / "first.png").read_bytes(), self.succeeds("shot", *SMALL, scene, "-o", "-"))
        self.succeeds("check", self.out / "first.png")

    def test_pngs_without_a_scene_or_with_a_hostile_one_are_refused(self):
        self.draws("-o", self.out / "good.png", "--no-metadata")
        plain = (self.out / "good.png").read_bytes()
        self.draws("-o", self.out / "good.png")
        good = (self.out / "good.png").read_bytes()
        keyword = b"Texplorer scene\0"
        bomb = packed_zeros(200)
        evil = self.path / "evil.png"
        at = good.index(b"iTXt")
        cases = [
            ("expected a scene, found a PNG without a scene", plain),
            ("line 1, column 2", with_chunks(plain, chunk(b"tEXt", keyword + b"{nonsense"))),
            ("holds more than 16777216 bytes", with_chunks(plain, chunk(b"zTXt", keyword + b"\0" + bomb))),
            ("the zlib stream is damaged", with_chunks(plain, chunk(b"zTXt", keyword + b"\0" + zlib.compress(b"{}" * 99)[:-3]))),
            ("expected compression method 0", with_chunks(plain, chunk(b"zTXt", keyword + b"\7" + bomb[:90]))),
            ("expected a language", with_chunks(plain, chunk(b"iTXt", keyword + b"\0\0enenen"))),
            ("is damaged", with_chunks(plain, chunk(b"tEXt", keyword + b'{"version": 1}')[:-1] + b"?")),
            ("", good[:at + 40]),
            ("", good[:20]),
        ]
        for expected, content in cases:
            with self.subTest(expected):
                evil.write_bytes(content)
                said = self.complains(1, expected, "shot", *SMALL, evil, "-o", self.out / "new.png")
                self.assertIn("evil.png", said)
                evil.unlink()
        evil.write_bytes(with_chunks(plain, chunk(b"tEXt", keyword + b'{"version": 1}')))  # not texshot's
        self.draws(evil, "-o", self.out / "new.png")

    def test_info_shows_texts_whatever_they_hold(self):
        self.draws("-o", self.out / "good.png")
        shown = self.succeeds("info", self.out / "good.png").decode()
        self.assertRegex(shown, r"keyword +Texplorer renderer\n.*text +fixed\n")
        self.assertRegex(shown, r'text +\{\\u000a  "\$schema": .* \d+ bytes uncompressed')
        png = (self.out / "good.png").read_bytes()
        hostile = [chunk(b"tEXt", b"Comment\0\x1b[2J\nred \xe4"), chunk(b"tEXt", b"\0"), chunk(b"tEXt", b"x" * 300),
                   chunk(b"zTXt", b"Bomb\0\0" + packed_zeros(64)), chunk(b"zTXt", b"Cut\0"),
                   chunk(b"iTXt", b"Packed\0\1\0en\0\0" + b"rubbish"), chunk(b"iTXt", b"Two\0\2\0\0\0"),
                   chunk(b"iTXt", b"Broken\0\0\0\0\0\xff\xfe\xe2\x80\xae")]
        file = self.path / "hostile.png"
        file.write_bytes(with_chunks(png, *hostile))
        for form in ((), ("--json",)):
            shown = self.succeeds("info", file, *form).decode()
            self.assertNotIn("\x1b", shown)
            self.assertNotIn("\u202e", shown)
            for expected in ("red ä", "expected a keyword of 1 to 79 letters", "more than 1048576 bytes uncompressed",
                             "expected compression method 0", "the zlib stream is damaged", "expected 0 or 1"):
                self.assertIn(expected, shown)
        with Image.open(self.out / "good.png") as picture:
            picture.verify()


if __name__ == "__main__":
    unittest.main()
