"""texshot test: suites of pictures, drawn by worker processes that may crash, hang or be killed."""

import base64
import contextlib
import json
import os
import random
import re
import resource
import shlex
import shutil
import signal
import subprocess
import time
import unittest
from pathlib import Path

from PIL import Image

from suites import COLORS, Suites
from texshot import SANITIZED, TEXSHOT, results, single, texshot


class Test(Suites):
    def test_goldens_are_written_once_and_held_against_from_then_on(self):
        suite = self.suite(self.backgrounds("grey", "dark", "blue"))
        self.assertEqual(set(self.states(suite, code=1).values()), {"new"})
        self.assertFalse((self.path / "golden").exists(), "they were not requested")
        said = self.passes(suite, "--update")
        self.assertIn("3 goldens written", said)
        goldens = sorted((self.path / "golden").iterdir())
        self.assertEqual([each.suffix for each in goldens], [".png"] * 3)
        with Image.open(goldens[0]) as picture:
            self.assertEqual((picture.size, picture.mode), ((24, 16), "RGB"))
        written = [each.stat().st_mtime_ns for each in goldens]
        self.assertEqual(self.passes(suite, "--update").splitlines(), ["3 cases: 3 passed"])
        self.assertEqual([each.stat().st_mtime_ns for each in goldens], written, "what is alike is left alone")

    def test_a_golden_is_what_texshot_shot_writes(self):
        suite = self.suite(self.backgrounds("grey", renderer=["fixed", "shader", "reference"],
                                            golden="golden/{case}.png"))
        golden = self.path / "golden"
        golden.mkdir()
        names = self.passes(suite, "--list").splitlines()
        self.assertEqual(names, [f"grey/{renderer}@24x16" for renderer in ("fixed", "shader", "reference")])
        listed = results(self.succeeds("test", suite, "--list", "--json", "-"))
        self.assertEqual(listed, [{"name": name, "suite": listed[0]["suite"], "renderer": renderer, "width": 24, "height": 16, "time": 0}
                                  for name, renderer in zip(names, ("fixed", "shader", "reference"))])
        for name in names:
            renderer = name.split("/")[1].split("@")[0]
            self.succeeds("shot", "--set", f"view.background={COLORS['grey']},1", "--size", "24x16", "--renderer",
                          renderer, "-o", golden / (name.replace("/", "__") + ".png"))
        self.assertEqual(self.passes(suite), "3 cases: 3 passed\n")

    def test_the_reference_draws_what_texshot_shot_has_it_draw(self):
        suite = self.suite([{"name": "fog", "scene": {"example": "fog"}, "renderer": "reference", "golden": "fog.png"}], size="64x48")
        drawn = ("--example", "fog", "--size", "64x48")
        golden = self.shot(*drawn, "--renderer", "reference")
        golden.save(self.path / "fog.png")
        self.assertEqual(self.passes(suite), "1 case: 1 passed\n")
        ellipse = self.shot(*drawn, "--renderer", "reference", "--anisotropy", "ellipse")
        x, y = next((x, y) for y in range(48) for x in range(64) if golden.getpixel((x, y)) != ellipse.getpixel((x, y)))
        wrong = tuple(255 - each for each in golden.getpixel((x, y))[:3])
        golden.putpixel((x, y), wrong)
        golden.save(self.path / "fog.png")
        case = self.record(suite, code=1)["fog"]
        self.assertEqual((case["worst"]["x"], case["worst"]["y"]), (x, y))
        probed = self.succeeds("probe", *drawn, "--no-gl", "--at", f"{x},{y}").decode()
        self.assertEqual(case["explanation"].strip(), probed.strip())

    def test_settings_are_those_of_the_cases_that_have_them(self):
        suite = self.suite([*self.backgrounds("grey", "dark", renderer=["reference"]),
                            *self.backgrounds("blue"), *self.backgrounds("black", golden="reference")])
        without = {name: value for name, value in os.environ.items() if name != "GALLIVM_PERF"}
        self.passes(suite, "--update", env=without)
        found = {name: case.get("settings") for name, case in self.record(suite, code=0, env=without).items()}
        precise = "GALLIVM_PERF=no_rho_approx,no_brilinear,no_quad_lod,no_aos_sampling"
        self.assertEqual(found, {"grey": None, "dark": None, "blue": None, "black": precise})
        self.assertNotIn("settings", single(self.run_of(suite, "--json", "-", env=without).stdout))
        found = self.record(suite, code=0, env={**without, "GALLIVM_PERF": "no_rho_approx"})
        self.assertEqual([found[name].get("settings") for name in ("grey", "blue", "black")],
                         [None, "GALLIVM_PERF=no_rho_approx", "GALLIVM_PERF=no_rho_approx"])

    def test_a_failure_has_pictures_and_an_explanation(self):
        suite = self.suite(self.backgrounds("grey", "dark"))
        self.passes(suite, "--update")
        golden = next((self.path / "golden").glob("grey*"))
        picture = Image.open(golden).convert("RGB")
        picture.putpixel((5, 3), (255, 0, 0))
        picture.save(golden)
        report = self.path / "report"
        case = self.record(suite, "--report", report, code=1)["grey"]
        self.assertEqual(case["state"], "failed")
        self.assertEqual((case["worst"]["x"], case["worst"]["y"]), (5, 3))
        self.assertEqual(case["worst"]["expected"][:3], [255, 0, 0])
        pictures = {kind: report / case[f"{kind}Picture"] for kind in ("expected", "actual", "difference")}
        for each in pictures.values():
            self.assertTrue(each.is_file())
            self.assertTrue(each.with_name(each.name + ".js").is_file(), "its pixels, for the page")
        with Image.open(pictures["expected"]) as expected, Image.open(pictures["actual"]) as actual:
            self.assertEqual(self.difference(expected, actual), (5, 3, 6, 4))
        probed = self.succeeds("probe", "--set", f"view.background={COLORS['grey']},1", "--size", "24x16", "--at", "5,3").decode()
        for line in probed.splitlines()[:3]:
            self.assertIn(line, case["explanation"])
        self.assertTrue((report / "index.html").is_file())
        self.assertEqual(json.loads((report / "run.json").read_text())["status"], 1)
        self.assertNotIn(str(self.path), (report / "run.json").read_text().replace(str(suite), ""))

    def test_a_failure_where_many_fragments_lie_is_a_failure(self):
        scene = self.path / "pile.json"
        scene.write_text(json.dumps({
            "version": 1, "models": [{"shape": "mesh", "mesh": {
                "positions": [[-9, -9, 0], [9, -9, 0], [0, 9, 0]], "indices": [0, 1, 2] * 500}}],
            "textures": [{}], "passes": [{"depthFunc": "GL_LEQUAL", "units": [{"enabled": True}]}]}))
        suite = self.suite([{"name": "pile", "scene": "pile.json"}])
        self.passes(suite, "--update")
        golden = next((self.path / "golden").glob("pile*"))
        picture = Image.open(golden).convert("RGB")
        picture.putpixel((12, 8), (1, 254, 1))
        picture.save(golden)
        case = self.record(suite, code=1)["pile"]
        self.assertEqual(case["state"], "failed", case.get("sentence"))
        self.assertIn("500 fragments cover it. Numbers 469 to 500 are explained (at most 32).", case["explanation"])
        self.assertLess(len(case["explanation"]), 70_000)

    def test_a_failed_case_can_be_drawn_again_and_opened_from_its_report(self):
        texture = self.path / "scenes" / "brick.png"
        texture.parent.mkdir()
        Image.effect_noise((16, 16), 80).convert("RGB").save(texture)
        scene = self.path / "scenes" / "brick.json"
        self.succeeds("scene", "--set", "textures[0].source=file", "--set", f"textures[0].file={texture}", "-o", scene)
        entry = {"name": "it's [new]", "scene": "scenes/brick.json", "axis": "textures[0].wrapS=GL_REPEAT,GL_CLAMP", "renderer": ["shader", "reference"],
                 "time": 0.5, "size": "64x48"}
        suite = self.suite([entry, *self.backgrounds("grey")])
        report = self.path / "out" / "report"
        record = single(self.run_of(suite, "--report", report, "--json", "-").stdout)
        self.assertEqual({case["state"] for case in record["cases"]}, {"new"}, record["cases"])
        text = (report / "report-data.js").read_text()
        cases = json.loads(text[len("texplorerReport = "):-2])["cases"]
        self.assertEqual(len(cases), 5)
        for case, of in zip(cases, record["cases"]):
            repeat, draw = (command["line"] for command in case["commands"])
            words = shlex.split(repeat)
            self.assertEqual(words[0], "texshot")
            self.assertEqual(texshot(*words[1:], "--list").stdout.decode().splitlines(), [of["name"]])
            words = shlex.split(draw)
            again = self.path / "again.png"
            drawn = texshot(*words[1:-1], again, cwd=report)
            self.assertEqual((drawn.returncode, drawn.stderr), (0, b""))
            actual = report / of["actualPicture"]
            with Image.open(actual) as one, Image.open(again) as other:
                self.assertEqual(one.convert("RGB").tobytes(), other.convert("RGB").tobytes())
                texts = one.text
            self.assertEqual(texts["Texplorer renderer"], of["renderer"])
            self.assertEqual(texts["Texplorer size"], f"{of['width']}x{of['height']}")
            self.assertNotIn(str(self.path), "".join(texts.values()))
            self.assertEqual("Texplorer driver" in texts, of["renderer"] != "reference")
            self.succeeds("scene", actual)
            self.assertEqual([link["file"] for link in case["links"]], [of["actualPicture"]])
            self.assertNotIn(b"Texplorer", base64.b64decode(re.search(r'"([^"]*)"\);', (report / f"{of['actualPicture']}.js").read_text())[1]))
        self.passes(suite, "--update")
        for golden in (self.path / "golden").iterdir():
            with Image.open(golden) as picture:
                self.assertEqual(picture.info, {}, "the same bytes on every machine")

    def test_a_rule_says_how_much_it_explains(self):
        suite = self.suite([{"name": "all", "golden": "reference", "renderer": "fixed", "size": "64x48", "set": ["textures[0].minFilter=GL_LINEAR_MIPMAP_LINEAR"]}])
        case = self.record(suite)["all"]
        self.assertTrue(case["metric"].startswith("rule "), case)
        self.assertEqual(case["pixels"], 64 * 48)
        self.assertAlmostEqual(case["shareOver"], case["over"] / (64 * 48))
        self.assertLessEqual(case["unexplained"], case["over"])
        self.assertEqual(case["state"] == "passed", case["unexplained"] / case["pixels"] <= case["share"])

    def test_sizes_are_not_compared_and_the_explanation_shows_the_picture_that_one_sees(self):
        suite = self.suite([{"name": "clear", "set": "view.background=0.2,0.2,0.2,0"}, *self.backgrounds("grey")])
        self.passes(suite, "--update")
        golden = self.path / "golden"
        Image.new("RGB", (24, 16), (255, 0, 0)).save(golden / "clear__fixed@24x16.png")
        Image.new("RGB", (8, 4)).save(golden / "grey__fixed@24x16.png")
        cases = self.record(suite, code=1)
        self.assertEqual(cases["grey"]["state"], "resized")
        for number in ("metric", "score", "tolerance", "share", "shareOver", "pixels", "over"):
            self.assertNotIn(number, cases["grey"])
        found = " ".join(map(str, cases["clear"]["worst"]["actual"]))
        self.assertIn(f"{found} found", cases["clear"]["sentence"])
        reference, drawn = cases["clear"]["explanation"].splitlines()[1:3]
        self.assertEqual(reference.split()[1:5], found.split())
        self.assertEqual(drawn.split()[1:5], found.split())

    def test_update_writes_what_differs_and_accept_what_is_named(self):
        suite = self.suite(self.backgrounds("grey", "dark", "blue"))
        self.passes(suite, "--update")
        changed = self.suite([{**case, "set": "view.background=0.3,0.3,0.3,1"} for case in self.backgrounds("grey", "dark")] +
                             self.backgrounds("blue"))
        before = {each.name: each.read_bytes() for each in (self.path / "golden").iterdir()}
        accepted = self.path / "accept.txt"
        accepted.write_text("# two that look right\n\ngrey/fixed@24x16\n")
        said = self.passes(changed, "--accept", accepted)
        self.assertIn("1 case: 1 passed", said)
        after = {each.name: each.read_bytes() for each in (self.path / "golden").iterdir()}
        self.assertEqual([name for name in before if before[name] != after[name]], ["grey__fixed@24x16.png"])
        self.assertEqual(self.states(changed, code=1), {"grey": "passed", "dark": "failed", "blue": "passed"})
        accepted.write_text("gray/fixed@24x16\n")
        self.complains(2, "gray/fixed@24x16", "test", changed, "--accept", accepted)
        self.complains(2, "--accept", "test", changed, "--accept", accepted, "--update")
        self.passes(changed, "--update")
        self.passes(changed)

    def test_a_golden_that_cases_share_is_written_once_and_the_others_are_held_to_it(self):
        grey, dark = self.backgrounds("grey", "dark")
        suite = self.suite([{**grey, "renderer": ["fixed", "shader"], "tolerance": 2}], golden="golden/{picture}.png")
        said = self.passes(suite, "--update")
        self.assertIn("1 golden written", said)
        self.assertEqual(len(os.listdir(self.path / "golden")), 1)
        self.assertEqual(set(self.states(suite).values()), {"passed"})
        both = self.suite([grey, dark], golden="golden/both.png")
        cases = self.record(both, "--update", code=1)
        self.assertEqual({name: case["state"] for name, case in cases.items()}, {"grey": "passed", "dark": "failed"})
        self.assertIn("its golden is also that of grey/fixed@24x16", cases["dark"]["sentence"])
        with Image.open(self.path / "golden/both.png") as golden, Image.open(self.path / "golden" / os.listdir(
                self.path / "golden")[0]) as other:
            self.assertEqual(golden.getpixel((0, 0)), other.getpixel((0, 0)))
        self.assertEqual(self.states(both, code=1), {"grey": "passed", "dark": "failed"})

    def test_the_reference_is_a_golden_that_needs_no_picture(self):
        suite = self.suite([{"name": "wraps", "axis": "textures[0].wrapS=GL_REPEAT,GL_CLAMP", "golden": "reference",
                             "renderer": ["fixed", "shader"], "size": "48x48"}])
        self.assertEqual(self.passes(suite), "4 cases: 4 passed\n")
        self.assertEqual(sorted(os.listdir(self.path)), ["s.suite.json"])
        self.assertNotIn("written", self.passes(suite, "--update"), "there is none to write")

    def test_a_crash_a_hang_and_an_end_fail_alone(self):
        suite = self.suite(self.backgrounds("grey", "crash", "dark", "hang", "blue", "killed", "exit", "black", seconds=4),
                           golden="reference")
        driver = self.broken_driver()
        report = self.path / "report"
        for jobs in (1, 3):
            with self.subTest(jobs=jobs):
                cases = self.record(suite, "--report", report, "--junit", self.path / "junit.xml", "-j", jobs, code=1,
                                    env=driver)
                self.assertEqual({name: case["state"] for name, case in cases.items()},
                                 {"grey": "passed", "crash": "crashed", "dark": "passed", "hang": "timed-out",
                                  "blue": "passed", "killed": "crashed", "exit": "crashed", "black": "passed"})
                self.assertIn("SIGABRT", cases["crash"]["sentence"])
                self.assertIn("assertion failed", cases["crash"]["explanation"])
                self.assertEqual(cases["crash"]["signal"], signal.SIGABRT)
                self.assertIn("within 4 s", cases["hang"]["sentence"])
                self.assertIn("SIGKILL", cases["killed"]["sentence"])
                self.assertEqual((cases["killed"]["attempt"], cases["crash"]["attempt"]), (2, 1))
                self.assertIn("status 7", cases["exit"]["sentence"])
                self.assertEqual(len(self.junit(self.path / "junit.xml").findall(".//failure")), 4)
                page = (report / "index.html").read_text()
                self.assertIn("<html", page)

    def test_fail_fast_ends_with_the_first_failure(self):
        suite = self.suite(self.backgrounds("grey", "dark", "blue", "black"))
        cases = self.record(suite, "--fail-fast", "-j", 1, code=1)
        self.assertEqual(len(cases), 1)

    def test_a_folder_of_the_users_is_no_report(self):
        suite = self.suite(self.backgrounds("grey"))
        folder = self.path / "mine"
        (folder / "pictures").mkdir(parents=True)
        files = {"index.html": b"my page", "run.json": b"{}", "report.css": b"mine", "pictures/holiday-actual.png": b"my picture"}
        for kept in ({"index.html"}, {"report.css"}, {"run.json"}, {"pictures/holiday-actual.png"}, set(files)):
            for name in files:
                (folder / name).unlink(missing_ok=True)
            for name in kept:
                (folder / name).write_bytes(files[name])
            self.complains(2, "expected a new folder or one with a report", "test", suite, "--report", folder)
            self.assertEqual({name: (folder / name).read_bytes() for name in kept}, {name: files[name] for name in kept})
        self.assertEqual(self.run_of(suite, "--report", self.path / "new", "--json", self.path / "new/result.json").returncode, 1)
        self.complains(2, "no run to resume", "test", suite, "--resume", self.path / "none")
        self.assertFalse((self.path / "none").exists())

    def test_names_with_dots_have_pictures(self):
        suite = self.suite([{**self.backgrounds("grey")[0], "name": "v1..2"}])
        self.assertEqual(self.states(suite, "--report", self.path / "report", code=1), {"v1..2": "new"})

    def test_of_several_goldens_the_nearest_is_updated(self):
        suite = self.suite(self.backgrounds("grey"), golden=["golden/first.png", "golden/second.png"])
        self.passes(suite, "--update")
        golden = self.path / "golden"
        self.assertEqual(os.listdir(golden), ["first.png"])
        right = (golden / "first.png").read_bytes()
        with Image.open(golden / "first.png") as picture:
            picture.putpixel((3, 3), (255, 0, 0))
            picture.save(golden / "second.png")
        Image.new("RGB", (24, 16), (0, 255, 0)).save(golden / "first.png")
        other = (golden / "first.png").read_bytes()
        self.passes(suite, "--update")
        self.assertEqual((golden / "second.png").read_bytes(), right)
        self.assertEqual((golden / "first.png").read_bytes(), other)

    def test_shaders_that_have_changed_are_drawn_again(self):
        shaders = self.path / "shaders"
        shutil.copytree(Path(__file__).resolve().parents[3] / "shaders", shaders)
        suite = self.suite(self.backgrounds("grey", renderer="shader"), golden="reference")
        report = self.path / "report"
        self.passes(suite, "--shaders", shaders, "--report", report)
        again = ("test", suite, "--shaders", shaders, "--resume", report)
        self.assertIn(b"1 of 1 cases were done before", texshot(*again).stdout)
        fragment = shaders / "fragment.glsl"
        fragment.write_text(fragment.read_text() + "\n// another one\n")
        self.assertNotIn(b"done before", texshot(*again).stdout)

    def test_no_output_takes_the_place_of_an_input(self):
        suite = self.suite(self.backgrounds("grey"))
        before = suite.read_bytes()
        self.complains(2, "which is read", "test", suite, "--json", suite)
        self.complains(2, "that of --json", "test", suite, "--json", self.path / "x", "--junit", self.path / "x")
        self.complains(2, "found standard input", "test", "-")
        self.assertEqual(suite.read_bytes(), before)
        self.run_of(suite, "--update")
        (self.path / "golden/grey__fixed@24x16.png").unlink()
        accepted = texshot("test", suite, "--accept", "-", input=b"grey/fixed@24x16\n")
        self.assertEqual(accepted.returncode, 0, accepted.stderr)
        empty = texshot("test", suite, "--accept", "-", input=b"\n")
        self.assertEqual((empty.returncode, empty.stderr),
                         (2, b"texshot: standard input: expected the name of a case on each line, found none\n"))

    def test_what_failed_is_said_even_if_the_results_can_not_be_written(self):
        suite = self.suite(self.backgrounds("grey"))
        result = self.run_of(suite, "--json", "/dev/full")
        self.assertEqual(result.returncode, 2)
        self.assertIn(b"new: grey", result.stdout)
        self.assertIn(b"/dev/full", result.stderr)

    def test_a_crash_without_worker_processes_is_a_sentence(self):
        if SANITIZED:
            self.skipTest("a sanitizer says what crashed")
        result = texshot("shot", "--set", "view.background=1,0,1,1", "--size", "8x8", "-o", self.path / "x.png",
                         env=self.broken_driver())
        self.assertEqual(result.returncode, 1)
        self.assertIn(b"texshot: OpenGL's driver crashed: SIGABRT", result.stderr)
        self.assertFalse((self.path / "x.png").exists())

    def test_a_driver_that_can_not_be_opened_is_an_error(self):
        suite = self.suite(self.backgrounds("grey"))
        result = self.run_of(suite, "--pretend", "units=1", "--context", "egl:99")
        self.assertEqual(result.returncode, 2)
        self.assertRegex(result.stderr.decode(), r"\Atexshot: [^\n]*EGL[^\n]*\n\Z")

    def workers_of(self, run, count=1):
        while run.poll() is None:
            children = self.children_of(run.pid)
            if len(children) >= count:
                return children
            time.sleep(0.005)
        return []

    def seconds_of(self, process):
        """The processor time used so far; infinite once it has ended."""
        try:
            fields = Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()
        except (FileNotFoundError, ProcessLookupError):
            return float("inf")
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def test_workers_that_are_killed_stopped_or_shot_at_lose_nothing(self):
        names = [f"case-{i}" for i in range(60)]
        suite = self.suite([{"name": name, "set": f"view.background=0.{i:02},0,0,1"} for i, name in enumerate(names)],
                           size="96x96", seconds=20)
        self.passes(suite, "--update")
        dice = random.Random(4)
        hit = 0
        for how in (signal.SIGKILL, signal.SIGSEGV):
            report = self.path / f"report-{how}"
            run = self.begun(suite, "-j", 3, "--report", report, "--timeout", 20)
            written = 0  # of the journal: each worker that is hit follows a case that ended, or all might end before one
            while run.poll() is None:
                journal = report / "journal.jsonl"
                size = journal.stat().st_size if journal.exists() else 0
                children = self.children_of(run.pid)
                if children and size > written:
                    written = size
                    with contextlib.suppress(ProcessLookupError):
                        os.kill(dice.choice(children), how)
                        hit += 1
                time.sleep(dice.random() * 0.1)
            said = run.communicate()[0].decode()
            cases = json.loads((report / "run.json").read_text())["cases"]
            self.assertEqual(sorted(case["name"] for case in cases), sorted(f"{name}/fixed@96x96" for name in names), said)
            for case in cases:
                self.assertIn(case["state"], ("passed", "crashed"), case["sentence"])
                if case["state"] == "crashed":
                    self.assertIn("SIGKILL" if how == signal.SIGKILL else "SIGSEGV", case["sentence"])
        self.assertGreater(hit, 0)

    def test_a_worker_that_is_stopped_hangs(self):
        suite = self.suite([{"name": "slow", "golden": "slow.png", "renderer": "reference", "size": "7000x7000",
                             "set": "textures[0].maxAnisotropy=16"}], seconds=600)
        run = self.begun(suite, "-j", 1, "--timeout", 2, "--json", "-")
        for child in self.workers_of(run):
            while self.seconds_of(child) < 0.3:  # before that it has no case yet, and another would get it
                time.sleep(0.005)
            with contextlib.suppress(ProcessLookupError):  # it ended in the meantime
                os.kill(child, signal.SIGSTOP)
        out = run.communicate(timeout=300)[0]
        (case,) = single(out)["cases"]
        self.assertEqual(case["state"], "timed-out")
        self.assertIn("within 2 s", case["sentence"])

    def long_suite(self, count=40):
        return self.suite([{"name": f"case-{i}", "renderer": "reference", "golden": f"golden/{{case}}.png",
                            "set": [f"view.background=0.{i:02},0,0,1", "textures[0].maxAnisotropy=16"]}
                           for i in range(count)], size="160x160")

    def interrupted(self, suite, report, how):
        """Ends a run in its middle, and returns the cases in its journal."""
        run = self.begun(suite, "-j", 2, "--report", report)
        journal = report / "journal.jsonl"
        while run.poll() is None and (not journal.exists() or journal.read_bytes().count(b"\n") < 6):
            time.sleep(0.002)
        children = self.children_of(run.pid)
        run.send_signal(how)
        out, said = run.communicate(timeout=120)
        for child in children:
            while Path(f"/proc/{child}/stat").exists() and ") Z " not in Path(f"/proc/{child}/stat").read_text():
                time.sleep(0.002)  # it ends with its parent
        lines = journal.read_text().splitlines(keepends=True)
        return run.returncode, said.decode(), [json.loads(line)["name"] for line in lines[1:] if line.endswith("\n")]

    def test_an_interrupted_run_says_how_to_go_on_and_does(self):
        suite = self.long_suite()
        self.passes(suite, "--update")
        for how, code in ((signal.SIGINT, 130), (signal.SIGTERM, 143)):
            with self.subTest(how):
                report = self.path / f"report-{code}"
                status, said, done = self.interrupted(suite, report, how)
                self.assertEqual(status, code, said)
                self.assertEqual(said, f"texshot: interrupted; {len(done)} of 40 cases done; the same call with --resume "
                                       f"{report} continues\n")
                self.assertFalse((report / "run.json").exists())
                before = (report / "journal.jsonl").read_bytes()
                said = self.passes(suite, "--resume", report)
                self.assertEqual(said, f"{len(done)} of 40 cases were done before\n40 cases: 40 passed\nreport: {report}/index.html\n")
                self.assertTrue((report / "journal.jsonl").read_bytes().startswith(before))
                self.assertTrue((report / "run.json").exists())

    def test_a_killed_run_goes_on_where_its_journal_ends(self):
        suite = self.long_suite()
        self.passes(suite, "--update")
        report = self.path / "report"
        status, _, done = self.interrupted(suite, report, signal.SIGKILL)
        self.assertEqual(status, -signal.SIGKILL)
        journal = report / "journal.jsonl"
        with open(journal, "ab") as file:  # as after a power failure
            file.write(b'{"name": "case-3')
        golden = self.path / "golden" / f"{done[0].replace('/', '__')}.png"
        Image.new("RGB", (160, 160)).save(golden)  # a case that changed since then runs again
        result = self.run_of(suite, "--resume", report, "--json", "-")
        states = {case["name"]: case["state"] for case in single(result.stdout)["cases"]}
        self.assertEqual((len(states), [name for name in states if states[name] != "passed"]), (40, [done[0]]))
        other = self.suite(self.backgrounds("grey", renderer="reference"), "other.suite.json")
        self.assertIn(b"the journal has other cases", self.run_of(other, "--resume", report).stderr)
        both = self.run_of(suite, "--resume", report, "--report", report)
        self.assertEqual(both.stderr, b"")
        self.assertIn(b"40 of 40 cases were done before", both.stdout)
        self.complains(2, "--resume", "test", suite, "--resume", report, "--report", self.path / "another")
        journal.write_text("nonsense\n")
        said = self.run_of(suite, "--resume", report)
        self.assertEqual(said.returncode, 2)
        self.assertIn(b"journal.jsonl: line 1", said.stderr)

    def test_two_runs_in_one_folder_do_not_mix(self):
        suite = self.long_suite()
        self.passes(suite, "--update")
        report = self.path / "report"
        run = self.begun(suite, "-j", 1, "--report", report)
        while run.poll() is None and not (report / "journal.jsonl").exists():
            time.sleep(0.002)
        second = self.run_of(suite, "--report", report)
        if run.poll() is None:  # otherwise it was too late
            self.assertEqual(second.returncode, 2)
            self.assertIn(b"another run writes its report there", second.stderr)
        run.communicate(timeout=120)
        self.assertEqual(run.returncode, 0)

    def test_shards_are_parts_of_the_whole(self):
        suite = self.suite([{"name": f"c{i}", "golden": "reference"} for i in range(7)])
        whole = self.passes(suite, "--list").splitlines()
        parts = [self.passes(suite, "--list", "--shard", f"{i}/3").splitlines() for i in (1, 2, 3)]
        self.assertEqual(sorted(sum(parts, [])), sorted(whole))
        durations = self.path / "durations.json"
        durations.write_text(json.dumps({"version": 1, "seconds": {name: 9 if i == 0 else 1 for i, name in enumerate(whole)}}))
        parts = [self.passes(suite, "--list", "--shard", f"{i}/2", "--durations", durations).splitlines() for i in (1, 2)]
        self.assertEqual(sorted(map(len, parts)), [1, 6], "9 seconds against six of one")
        empty = self.run_of(suite, "--only", "c0", "--shard", "2/2")
        self.assertEqual((empty.returncode, empty.stderr), (0, b""), "more parts than cases")
        for wrong in ("0/3", "4/3", "x", "1/", "1/0", "-1/2"):
            self.complains(2, "--shard", "test", suite, f"--shard={wrong}")
        self.passes(suite, "--durations", self.path / "new.json")
        self.assertEqual(sorted(json.loads((self.path / "new.json").read_text())["seconds"]), sorted(whole))

    def test_only_and_renderer_choose(self):
        suite = self.suite(self.backgrounds("grey", "dark", "blue", golden="reference"))
        self.assertEqual(self.passes(suite, "--only", "gr*", "--only", "blue/*", "--renderer", "shader", "--renderer",
                                     "fixed", "--list").splitlines(),
                         ["grey/shader@24x16", "grey/fixed@24x16", "blue/shader@24x16", "blue/fixed@24x16"])
        self.assertIn("pink", self.complains(2, "", "test", suite, "--only", "pink*"))
        self.complains(2, "--renderer", "test", suite, "--renderer", "best")

    def test_what_is_said(self):
        suite = self.suite(self.backgrounds("grey", "dark"), golden="reference")
        self.assertEqual(self.passes(suite, "--quiet"), "")
        verbose = self.run_of(suite, "--verbose")
        self.assertEqual(verbose.returncode, 0)
        self.assertRegex(verbose.stderr.decode(), r"(?m)^1/2 passed in \d+\.\d\d s: \w+/fixed@24x16$")
        new = self.suite(self.backgrounds("grey"), "new.suite.json", golden="missing/{case}.png")
        said = self.run_of(new, "--quiet")
        self.assertEqual(said.returncode, 1)
        self.assertIn("new: grey/fixed@24x16\n    there is no golden yet", said.stdout.decode())
        report = self.path / "report"
        said = self.run_of(new, "--report", report).stdout.decode()
        self.assertEqual(said.splitlines()[-2:], ["1 has no golden: --update writes it", f"report: {report}/index.html"])
        self.assertTrue((report / "index.html").exists())
        two = self.suite(self.backgrounds("grey", "dark"), "two.suite.json", golden="missing/{case}.png")
        self.assertTrue(self.run_of(two).stdout.decode().endswith("2 have no golden: --update writes them\n"))
        self.assertNotIn("--update", self.passes(two, "--update"))
        result = self.run_of(suite, "--junit", "-")
        self.assertTrue(result.stdout.startswith(b"<?xml"))
        self.assertIn(b"2 cases: 2 passed", result.stderr)
        self.complains(2, "--json and --junit", "test", suite, "--json", "-", "--junit", "-")
        self.notes("--list runs nothing", "test", suite, "--list", "--report", self.path / "r")
        self.assertFalse((self.path / "r").exists())

    def test_wrong_calls_and_suites(self):
        suite = self.suite(self.backgrounds("grey"))
        self.complains(2, "SUITE", "test")
        self.complains(2, "nothing.json", "test", self.path / "nothing.json")
        self.complains(2, "--jobs", "test", suite, "-j", "0")
        broken = self.path / "broken.suite.json"
        for text, expected in (("{", "broken.suite.json"), ('{"suite": 1, "cases": [{"scenes": "a.json"}]}', "scenes"),
                               ('{"suite": 1, "cases": [{"scene": "../../etc/passwd"}]}', "leads out"),
                               ('{"suite": 1, "cases": [{"golden": "../x.png"}]}', "leads out"),
                               ('{"suite": 1, "cases": [{"golden": "/tmp/x.png"}]}', "absolute")):
            broken.write_text(text)
            self.complains(2, expected, "test", broken, "--update", "--report", self.path / "report")
        many = [{"name": f"<script>{i}", "axis": ["textures[0].wrapS=*", "textures[0].wrapT=*", "textures[0].minFilter=*",
                                                  "textures[0].magFilter=*", "textures[0].maxAnisotropy=1,2,4,8,16"],
                 "size": ["8x8", "9x9", "10x10"]} for i in range(1000)]
        self.complains(2, "cases", "test", self.suite(many, "many.suite.json"))
        pipe = self.path / "pipe.suite.json"
        os.mkfifo(pipe)
        self.complains(2, "pipe.suite.json", "test", pipe)
        self.complains(2, "", "test", "/dev/null")

    def test_hostile_names_stay_in_the_folder(self):
        names = ["../../escape", "<script>alert(1)</script>", "a/../../b", "x" * 3000, "con\u0001trol", "\u202egnp"]
        suite = self.suite([{"name": name} for name in names], "in/s.suite.json")
        report = self.path / "report"
        self.run_of(suite, "--report", report, "--update")
        self.assertEqual(sorted(os.listdir(self.path)), ["in", "report"])
        self.assertEqual(sorted(os.listdir(self.path / "in")), ["golden", "s.suite.json"])
        self.run_of(suite, "--report", report)
        for picture in (report / "pictures").iterdir():
            self.assertLess(len(picture.name), 256)
        for file in (report / "index.html", report / "report-data.js"):
            self.assertNotIn("<script>alert", file.read_text())
        self.assertEqual(len(list((self.path / "in/golden").rglob("*.png"))), len(names))

    def test_links_out_of_the_folder_are_not_followed(self):
        outside = self.path / "outside"
        outside.mkdir()
        suite = self.suite(self.backgrounds("grey"), "in/s.suite.json")
        (self.path / "in/golden").symlink_to(outside)
        self.assertEqual(self.states(suite, "--update", code=2), {"grey": "error"})
        self.assertEqual(os.listdir(outside), [])
        report = self.path / "report"
        report.mkdir()
        (report / "pictures").symlink_to(outside)
        (outside / "holiday-actual.png").write_text("a picture of the user's")
        # Its goldens would be there as well; a suite without goldens reports the folder as not its own.
        self.assertIn(b"expected a folder other than that of", self.run_of(suite, "--report", report).stderr)
        other = self.suite(self.backgrounds("grey"), "reference.suite.json", golden="reference")
        self.assertIn(b"of something else", self.run_of(other, "--report", report).stderr)
        (outside / "holiday-actual.png").unlink()
        self.assertIn(b"of something else", self.run_of(other, "--report", report).stderr)
        (report / "pictures").unlink()
        (report / "journal.jsonl").symlink_to(outside / "journal")
        self.assertEqual(self.run_of(suite, "--report", report).returncode, 2)
        self.assertEqual(os.listdir(outside), [])

    def test_goldens_that_are_no_pictures(self):
        suite = self.suite(self.backgrounds("grey", "dark", "blue", "black"))
        golden = self.path / "golden"
        golden.mkdir()
        (golden / "grey__fixed@24x16.png").mkdir()
        os.mkfifo(golden / "dark__fixed@24x16.png")
        (golden / "blue__fixed@24x16.png").write_bytes(b"\x89PNG\r\n\x1a\n nonsense")
        Image.new("RGB", (16384, 16384)).save(golden / "black__fixed@24x16.png", compress_level=1)
        cases = self.record(suite, code=2)
        self.assertEqual({name: case["state"] for name, case in cases.items()},
                         {"grey": "error", "dark": "error", "blue": "error", "black": "resized"})
        for case in cases.values():
            self.assertTrue(case["sentence"])
        self.assertIn("16384", cases["black"]["sentence"])

    def test_a_full_disk_and_a_folder_that_is_read_only(self):
        suite = self.suite(self.backgrounds("grey", "dark"))
        report = self.path / "report"
        def small_disk():
            resource.setrlimit(resource.RLIMIT_FSIZE, (300, 300))
        result = self.run_of(suite, "--report", report, preexec_fn=small_disk)
        self.assertEqual(result.returncode, 2)
        self.assertRegex(result.stderr.decode(), r"\Atexshot: .*journal\.jsonl: can't be written: File too large\n\Z")
        result = self.run_of(suite, "--update", preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (30, 30)))
        self.assertEqual(result.returncode, 2)
        self.assertEqual(list((self.path / "golden").iterdir()), [], "no half of a golden")
        self.complains(2, "", "test", suite, "--report", "/proc/nowhere")
        self.complains(2, "", "test", suite, "--report", suite)
        self.complains(2, "Not a directory", "test", suite, "--json", suite / "run.json")
        if os.geteuid() != 0:
            locked = self.path / "locked"
            locked.mkdir(mode=0o555)
            self.complains(2, "locked", "test", suite, "--report", locked)

    def test_a_missing_scene_or_image_is_told_and_the_rest_goes_on(self):
        (self.path / "lost.json").write_text(json.dumps({"version": 1, "textures": [{"source": "file", "file": "lost.png"}]}))
        suite = self.suite([{"scene": "nothing.json", "name": "scene"}, {"scene": "lost.json", "name": "image"},
                            {"name": "fine", "golden": "reference"}])
        self.assertEqual(self.states(suite, code=2), {"scene": "missing-scene", "image": "error", "fine": "passed"})

    def test_a_scene_whose_picture_got_lost_is_new(self):
        folder = self.path / "scenes"
        folder.mkdir()
        for name in ("a", "b"):
            (folder / f"{name}.json").write_text(json.dumps({"version": 1}))
        (folder / "package.json").write_text(json.dumps({"name": "x", "version": "1.0.0"}))
        self.assertEqual(self.states(folder, code=1), {"a": "new", "b": "new"})
        self.passes(folder, "--update")
        with Image.open(folder / "b.png") as golden:
            self.assertEqual(golden.size, (512, 512))
        self.assertEqual(self.passes(folder), "2 cases: 2 passed\n")
        (folder / "a.png").unlink()
        self.assertEqual(self.states(folder, code=1), {"a": "new", "b": "passed"})

    def test_a_golden_that_is_no_picture_is_written_anew(self):
        suite = self.suite(self.backgrounds("grey", "dark"), golden="{case}.png")
        self.passes(suite, "--update")
        (golden,) = self.path.glob("grey*.png")
        right = golden.read_bytes()
        pointer = b"version https://git-lfs.github.com/spec/v1\noid sha256:" + b"0" * 64 + b"\nsize 12345\n"
        for broken in (pointer, right[:60], b""):
            with self.subTest(broken[:7]):
                golden.write_bytes(broken)
                case = self.record(suite, code=2)["grey"]
                self.assertEqual(case["state"], "error")
                self.assertEqual("Git LFS pointer" in case["sentence"], broken == pointer, case["sentence"])
                self.passes(suite, "--update")
                self.assertEqual(golden.read_bytes(), right)
        golden.write_bytes(pointer)
        (self.path / "accept.txt").write_text("grey/fixed@24x16\n")
        self.passes(suite, "--accept", self.path / "accept.txt")
        self.assertEqual(golden.read_bytes(), right)
        golden.unlink()
        golden.mkdir()  # unreadable for any user
        self.assertEqual(self.record(suite, "--update", code=2)["grey"]["state"], "error")

    def test_a_suite_that_is_named_without_its_folder_has_goldens_beside_it(self):
        self.suite(self.backgrounds("grey"), "o.suite.json", golden="one.png")
        self.passes("o.suite.json", "--update", cwd=self.path)
        self.assertTrue((self.path / "one.png").is_file())
        self.passes("o.suite.json", cwd=self.path)

    def test_a_mask_that_hides_everything_lets_nothing_pass(self):
        Image.new("L", (24, 16), 0).save(self.path / "mask.png")
        suite = self.suite([*self.backgrounds("grey", golden="reference"), *self.backgrounds("dark", golden="dark.png")],
                           mask="mask.png")
        for arguments in ((), ("--update",)):
            for case in self.record(suite, *arguments, code=2).values():
                self.assertIn("the mask leaves no pixel to compare", case["sentence"])
        self.assertFalse((self.path / "dark.png").exists())

    def test_what_passes_always_is_refused(self):
        suite = self.suite(self.backgrounds("grey"), golden="reference", renderer="reference")
        self.complains(2, "/cases/0: \"golden\": \"reference\" has no effect", "test", suite)
        suite = self.suite(self.backgrounds("grey"), golden="reference")
        self.complains(2, "it is compared with itself", "test", suite, "--renderer", "reference")
        suite = self.suite(self.backgrounds("grey", tolerance=2), golden="reference")
        self.complains(2, "/cases/0/tolerance: has no effect: the rule decides", "test", suite)

    def test_alpha_may_be_left_out(self):
        suite = self.suite([{"name": "a", "golden": "a.png", "set": "view.background=0.2,0.2,0.2,1"}])
        self.passes(suite, "--update")
        golden = Image.open(self.path / "a.png").convert("RGBA")
        golden.putalpha(77)
        golden.save(self.path / "a.png")
        self.assertEqual(self.states(suite, code=1), {"a": "failed"})
        suite = self.suite([{"name": "a", "golden": "a.png", "set": "view.background=0.2,0.2,0.2,1", "rgb": True}])
        self.passes(suite)
        golden.putpixel((1, 1), (255, 0, 0, 77))  # one of 384: 0.26 %
        golden.save(self.path / "a.png")
        for share, state in (("0.2%", "failed"), ("0.3%", "passed")):
            suite = self.suite([{"name": "a", "golden": "a.png", "set": "view.background=0.2,0.2,0.2,1", "rgb": True,
                                 "share": share}])
            self.assertEqual(self.states(suite), {"a": state})

    def test_a_folder_of_scenes_with_pictures_is_a_suite(self):
        folder = self.path / "goldens"
        folder.mkdir()
        for name in ("grey", "blue"):
            (folder / f"{name}.json").write_text(json.dumps({"version": 1}))
            self.succeeds("shot", folder / f"{name}.json", "--size", "20x10", "-o", folder / f"{name}.png")
        self.assertEqual(self.passes(folder), "2 cases: 2 passed\n")

    def test_help_says_how_it_is_called_and_what_comes_of_it(self):
        text = self.succeeds("test", "--help").decode()
        for expected in ("SUITE", "--update", "--accept", "--only", "--renderer", "--jobs", "--shard", "--durations",
                         "--report", "--junit", "--json", "--resume", "--timeout", "--fail-fast", "--list", "--quiet",
                         "--verbose", "--pictures", "--tolerance", "--metric", "Exit status: 0 all are alike"):
            self.assertIn(expected, text)
        self.assertIn("20 % over 16, 5 % over 128 (ellipse)", " ".join(text.split()))
        self.assertNotIn("worker-process", self.succeeds("--help").decode() + text)


class Pictures(Suites):
    def setUp(self):
        super().setUp()
        self.actual = self.path / "actual"
        self.golden = self.path / "golden"
        for folder in (self.actual, self.golden):
            (folder / "menus").mkdir(parents=True)
        for folder in (self.actual, self.golden):
            Image.new("RGB", (8, 8), (10, 20, 30)).save(folder / "same.png")
            Image.new("RGB", (8, 8), (10, 20, 30)).save(folder / "menus/main.png")

    def test_alike_is_0(self):
        self.assertEqual(self.passes("--pictures", self.golden, self.actual), "2 cases: 2 passed\n")

    def test_missing_extra_resized_and_different_ones_fail_by_name(self):
        Image.new("RGB", (8, 8), (10, 20, 33)).save(self.actual / "menus/main.png")
        Image.new("RGB", (9, 8)).save(self.actual / "same.png")
        Image.new("RGB", (4, 4)).save(self.actual / "extra.png")
        Image.new("RGB", (4, 4)).save(self.golden / "missing.png")
        (self.actual / "notes.txt").write_text("no picture")
        report = self.path / "report"
        result = self.run_of("--pictures", self.golden, self.actual, "--json", "-", "--report", report)
        self.assertEqual(result.returncode, 1)
        cases = {case["name"]: case for case in single(result.stdout)["cases"]}
        self.assertEqual({name: case["state"] for name, case in cases.items()},
                         {"menus/main.png": "failed", "same.png": "resized", "extra.png": "extra", "missing.png": "missing"})
        self.assertIn("9", cases["same.png"]["sentence"])
        for name, case in cases.items():
            pictures = self.pictures_of(case)
            self.assertTrue(pictures)
            for picture in pictures:
                self.assertTrue((report / picture).is_file(), name)
        said = self.run_of("--pictures", self.golden, self.actual).stdout.decode()
        for name, case in cases.items():
            self.assertIn(name, said)
        self.assertEqual(self.run_of("--pictures", self.golden, self.actual, "--tolerance", "3", "--only", "menus*").returncode, 0)
        self.assertEqual(self.run_of("--pictures", self.golden, self.actual, "--tolerance", "2", "--only", "menus*").returncode, 1)
        self.assertEqual(self.run_of("--pictures", self.golden, self.actual, "--share", "1", "--only", "menus*").returncode, 0)

    def test_a_mask_and_metrics(self):
        picture = Image.new("RGB", (32, 32), (10, 20, 30))
        picture.save(self.golden / "same.png")
        picture.putpixel((2, 1), (255, 255, 255))
        picture.save(self.actual / "same.png")
        mask = Image.new("L", (32, 32), 255)
        mask.putpixel((2, 1), 0)
        mask.save(self.path / "mask.png")
        call = ["--pictures", self.golden, self.actual, "--only", "same.png"]
        self.assertEqual(self.run_of(*call).returncode, 1)
        self.passes(*call, "--mask", self.path / "mask.png")
        for metric in ("ssim", "flip"):
            result = self.run_of(*call, "--metric", metric, "--json", "-")
            self.assertEqual(single(result.stdout)["cases"][0]["metric"], metric)

    def test_names_that_are_no_text_and_links_are_cases_of_their_own(self):
        odd = b"caf\xe9.png"
        for folder in (self.actual, self.golden):
            Image.new("RGB", (4, 4)).save(os.path.join(os.fsencode(folder), odd), "PNG")
        (self.actual / "leads-out.png").symlink_to("/dev/zero")
        states = self.states("--pictures", self.golden, self.actual, code=2)
        self.assertEqual((states["caf\ufffd.png"], states["leads-out.png"], states["same.png"]), ("passed", "error", "passed"))

    def test_a_report_among_the_pictures_is_none_of_them(self):
        Image.new("RGB", (9, 8)).save(self.actual / "same.png")
        call = ["--pictures", self.golden, self.actual, "--report", self.actual / "report"]
        first = self.states(*call, code=1)
        self.assertEqual(self.states(*call, code=1), first)

    def test_update_takes_the_pictures_over(self):
        Image.new("RGB", (8, 8), (1, 2, 3)).save(self.actual / "same.png")
        Image.new("RGB", (4, 4)).save(self.actual / "menus/extra.png")
        Image.new("RGB", (4, 4)).save(self.golden / "missing.png")
        states = self.states("--pictures", "--expected", self.golden, "--actual", self.actual, "--update", code=1)
        self.assertEqual(states["missing.png"], "missing")
        (self.golden / "missing.png").unlink()
        for name in ("same.png", "menus/extra.png"):
            self.assertEqual((self.golden / name).read_bytes(), (self.actual / name).read_bytes())
        self.passes("--pictures", self.golden, self.actual)

    def test_the_folders_have_the_order_of_compare_or_names(self):
        Image.new("RGB", (4, 4)).save(self.golden / "missing.png")
        for folders in ([self.golden, self.actual], ["--actual", self.actual, "--expected", self.golden]):
            self.assertEqual(self.states("--pictures", *folders, code=1)["missing.png"], "missing")
        before = {each: each.read_bytes() for each in self.path.rglob("*.png")}
        for option in (["--update"], ["--accept", self.path / "list"]):
            self.complains(2, "expected --expected DIR and --actual DIR when goldens are written", "test", "--pictures",
                           self.golden, self.actual, *option)
        for wrong in ([self.golden], [self.golden, self.actual, self.path], ["--expected", self.golden],
                      ["--expected", self.golden, "--actual", self.actual, self.path]):
            self.complains(2, "EXPECTED ACTUAL, or --expected DIR --actual DIR", "test", "--pictures", *wrong)
        self.assertEqual({each: each.read_bytes() for each in self.path.rglob("*.png")}, before)

    def test_update_takes_the_place_of_what_is_no_picture(self):
        (self.golden / "same.png").write_bytes(b"version https://git-lfs.github.com/spec/v1\n")
        case = self.record("--pictures", self.golden, self.actual, code=2)["same.png"]
        self.assertIn("Git LFS pointer", case["sentence"])
        self.passes("--pictures", "--expected", self.golden, "--actual", self.actual, "--update")
        self.assertEqual((self.golden / "same.png").read_bytes(), (self.actual / "same.png").read_bytes())

    def test_what_can_not_be_read_is_an_error_of_its_own(self):
        (self.actual / "same.png").write_bytes(b"\x89PNG\r\n\x1a\n")
        self.assertEqual(self.run_of("--pictures", self.golden, self.actual).returncode, 2)
        self.complains(2, "nowhere", "test", "--pictures", self.path / "nowhere", self.actual)
        self.complains(2, "expected two folders", "test", "--pictures", self.actual)
        empty = self.path / "empty"
        empty.mkdir()
        self.assertEqual(self.run_of("--pictures", empty, empty).returncode, 2)
        self.complains(2, "--tolerance", "test", "--pictures", self.golden, self.actual, "--tolerance", "many")
        (self.actual / "same.png").write_bytes((self.golden / "same.png").read_bytes())
        self.notes("--pictures draws nothing", "test", "--pictures", self.golden, self.actual, "--renderer", "fixed")
        suite = self.suite(self.backgrounds("grey"))
        self.complains(2, "--pictures", "test", suite, "--tolerance", "1")


if __name__ == "__main__":
    unittest.main()
