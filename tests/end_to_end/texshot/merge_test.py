"""texshot merge: the parts of a run become one."""

import json
import os
import shutil
import unittest

from PIL import Image

from suites import Suites
from texshot import texshot


class Merge(Suites):
    def setUp(self):
        super().setUp()
        self.cases = self.suite([{"name": f"c{i}", "set": f"view.background=0.{i},0,0,1"} for i in range(7)])
        self.passes(self.cases, "--update")
        golden = self.path / "golden" / "c3__fixed@24x16.png"
        picture = Image.open(golden).convert("RGB")
        picture.putpixel((1, 2), (255, 255, 255))
        picture.save(golden)

    def parts(self, count):
        """The reports of all parts."""
        reports = [self.path / f"part-{i}" for i in range(1, count + 1)]
        for i, report in enumerate(reports, 1):
            self.run_of(self.cases, "--shard", f"{i}/{count}", "--report", report)
        return reports

    def merge(self, *arguments):
        return texshot("merge", *arguments)

    def test_the_parts_say_together_what_one_run_says(self):
        whole = {name: (case["state"], case["sentence"]) for name, case in self.record(self.cases, code=1).items()}
        reports = self.parts(3)
        out = self.path / "run.json"
        result = self.merge(*[report / "run.json" for report in reports], "-o", out, "--report", self.path / "all",
                            "--junit", self.path / "junit.xml", "--durations", self.path / "durations.json")
        self.assertEqual((result.returncode, result.stderr), (1, b""))
        self.assertTrue(result.stdout.decode().endswith("7 cases: 6 passed, 1 failed\n"))
        run = json.loads(out.read_text())
        self.assertEqual({case["name"].split("/")[0]: (case["state"], case["sentence"]) for case in run["cases"]}, whole)
        self.assertEqual((run["shard"], run["planned"]), ([1, 1], 7))
        failed = next(case for case in run["cases"] if case["state"] == "failed")
        self.assertEqual(len(self.pictures_of(failed)), 3)
        for picture in self.pictures_of(failed):
            self.assertTrue((self.path / "all" / picture).is_file())
            self.assertTrue((self.path / "all" / f"{picture}.js").is_file())
        self.assertTrue((self.path / "all" / "index.html").is_file())
        self.assertEqual(len(self.junit(self.path / "junit.xml").findall(".//testcase")), 7)
        self.assertEqual(len(json.loads((self.path / "durations.json").read_text())["seconds"]), 7)
        accept = json.loads((self.path / "all/report-data.js").read_text().split("=", 1)[1].rstrip().rstrip(";"))["acceptCommand"]
        self.assertEqual(accept, f"texshot test {self.cases} --accept accept.txt")
        first, *others = [report / "run.json" for report in reports]
        piped = texshot("merge", "-", *others, "-o", "-", input=first.read_bytes())
        self.assertEqual(json.loads(piped.stdout)["cases"], run["cases"])
        folders = self.merge(*reports, "-o", "-", "--report", self.path / "of-folders")
        self.assertEqual(json.loads(folders.stdout), run)
        self.assertEqual(len(os.listdir(self.path / "of-folders/pictures")), 6)
        printed = self.merge(*[report / "run.json" for report in reports], "-o", "-")
        self.assertEqual(json.loads(printed.stdout), run)

    def test_what_is_missing_is_told(self):
        reports = self.parts(3)
        result = self.merge(reports[0] / "run.json", reports[2] / "run.json", "-o", self.path / "run.json")
        self.assertEqual(result.returncode, 2)
        self.assertIn(b"2/3", result.stderr)
        journal = reports[1] / "journal.jsonl"
        lines = journal.read_text().splitlines(keepends=True)
        journal.write_text("".join(lines[:2]))  # as a run leaves it that was killed
        result = self.merge(reports[0] / "run.json", journal, reports[2] / "run.json", "-o", self.path / "run.json")
        self.assertEqual(result.returncode, 2)
        self.assertIn(b"not run", result.stderr)
        self.assertEqual(self.merge(reports[0] / "run.json", reports[1] / "run.json", reports[2] / "run.json", "-o",
                                    self.path / "run.json").returncode, 1)

    def test_what_is_of_another_run_is_refused(self):
        first = self.parts(2)[0] / "run.json"
        other = self.suite(self.backgrounds("grey"), "other.suite.json", golden="reference")
        self.run_of(other, "--report", self.path / "other")
        self.complains(2, "different", "merge", first, self.path / "other/run.json", "-o", self.path / "run.json")
        broken = self.path / "broken.json"
        for text in ("", "{", "[]", '{"version": 1}', "null\n", "\0" * 64):
            broken.write_text(text)
            self.complains(2, "broken.json", "merge", first, broken, "-o", self.path / "run.json")
        self.complains(2, "nothing.json", "merge", first, self.path / "nothing.json", "-o", self.path / "run.json")
        self.complains(2, "standard input: can be read only once", "merge", "-", "-", "-o", self.path / "run.json")
        before = first.read_bytes()
        self.complains(2, "which is read", "merge", first, "-o", first)
        self.complains(2, "one text on standard output", "merge", first, "-o", "-", "--junit", "-")
        self.complains(2, "which is read", "merge", first, "-o", self.path / "run.json", "--report", first.parent)
        self.assertEqual(first.read_bytes(), before)
        self.complains(2, "--out", "merge", first)
        self.complains(2, "RUN", "merge", "-o", self.path / "run.json")
        self.complains(2, "Not a directory", "merge", first, "-o", first / "run.json")

    def test_pictures_that_a_record_only_pretends_to_have_are_left_out(self):
        reports = self.parts(2)
        secret = self.path / "secret.png"
        Image.new("RGB", (4, 4)).save(secret)
        for report in reports:
            text = (report / "run.json").read_text()
            run = json.loads(text)
            for case in run["cases"]:
                for kind, name in zip(("expected", "actual", "difference"),
                                      ("../secret.png", str(secret), "pictures/../../secret-difference.png")):
                    case[f"{kind}Picture"] = name
            (report / "run.json").write_text(json.dumps(run))
        shutil.copy(secret, self.path / "secret-difference.png")
        result = self.merge(*[report / "run.json" for report in reports], "-o", self.path / "run.json", "--report",
                            self.path / "all")
        self.assertIn(result.returncode, (1, 2))
        found = [str(each.relative_to(self.path / "all")) for each in (self.path / "all").rglob("*.png")] \
            if (self.path / "all").exists() else []
        self.assertEqual(found, [])

    def test_help_says_what_it_takes(self):
        text = self.succeeds("merge", "--help").decode()
        for expected in ("RUN", "--out", "--report", "--junit", "--durations", "Exit status"):
            self.assertIn(expected, text)


if __name__ == "__main__":
    unittest.main()
