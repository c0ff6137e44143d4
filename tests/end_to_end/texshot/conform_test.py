"""texshot conform: whether the renderers agree."""

import json
import os
import shutil
import signal
import subprocess
import sys
import time
import unittest
from pathlib import Path

from PIL import Image

from texshot import TEXSHOT, Texshot, document, single, texshot

sys.path.append(str(Path(__file__).parents[2] / "support"))
from browser import Browser  # noqa: E402


class Conform(Texshot):
    FEW = ("conform", "--feature", "wrap", "--feature", "environment", "--scenes", "16")

    def test_the_three_renderers_agree(self):
        said = self.succeeds(*self.FEW).decode()
        self.assertRegex(said, r"shader against fixed\nfeature +scenes")
        self.assertRegex(said, r"reference against fixed\nfeature +scenes")
        self.assertEqual(len([line for line in said.splitlines() if " agree " in line]), 4)
        self.assertIn("with GALLIVM_PERF=no_rho_approx", said)
        self.assertIn("\n16 scenes of 64 × 64 pixels, seed 1, in ", said)

    def test_the_command_that_a_report_gives_makes_it_again(self):
        report = self.succeeds(*self.FEW, "--json", "--seed", "7", "--renderer", "shader")
        command = single(report)["command"]
        self.assertRegex(command, r"\AGALLIVM_PERF=\S+ texshot conform --seed 7 --scenes 16 --feature wrap --feature environment --renderer shader\Z")
        path = f"{Path(TEXSHOT).parent}:{os.environ['PATH']}"
        again = subprocess.run(f"{command} --json", shell=True, stdout=subprocess.PIPE, env=os.environ | {"PATH": path})
        self.assertEqual((again.returncode, again.stdout), (0, report))

    def test_what_is_pretended_is_skipped_and_said(self):
        report = single(self.succeeds("conform", "--feature", "seamless", "--feature", "units", "--scenes", "16", "--json",
                                          "--pretend", "no-multitexture,no-seamless-cube-maps"))
        self.assertTrue(report["command"].endswith(" --pretend no-multitexture,no-seamless-cube-maps"))
        self.assertIn("pretending no-multitexture, no-seamless-cube-maps", json.dumps(report))
        of_reference = next(pair for pair in report["pairs"] if pair["renderer"] == "reference")
        skips = [skip for feature in of_reference["features"] for skip in feature["skipped"]]
        self.assertEqual([(skip["name"], skip["scenes"]) for skip in skips], [("no-seamless-cube-maps", 8), ("too-few-units", 8)])

    def test_one_pair_as_json(self):
        report = single(self.succeeds(*self.FEW, "--json", "--renderer", "shader", "--against", "reference"))
        self.assertTrue(report["agrees"])
        self.assertEqual([(pair["renderer"], pair["against"]) for pair in report["pairs"]], [("shader", "reference")])
        for feature in report["pairs"][0]["features"]:
            self.assertEqual(feature["all"]["over"], 0)
            self.assertEqual(feature["all"]["pixels"], 64 * 64 * feature["all"]["scenes"])

    def test_the_same_seed_gives_the_same_report(self):
        self.assertEqual(self.succeeds(*self.FEW, "--json"), self.succeeds(*self.FEW, "--json"))
        self.assertNotEqual(self.succeeds(*self.FEW, "--json"), self.succeeds(*self.FEW, "--json", "--seed", "2"))

    def test_the_folder_holds_worst_scenes_that_can_be_drawn_again(self):
        folder = self.path / "new" / "report"
        self.succeeds(*self.FEW, "-o", folder)
        self.assertEqual(json.loads((folder / "report.json").read_text())["scenes"], 16)
        data = (folder / "report-data.js").read_text()
        page = json.loads(data[data.index("{"):data.rindex("}") + 1])
        self.assertRegex(page["madeBy"], r"\Atexshot [0-9.]+ on \d{4}-\d\d-\d\d \d\d:\d\d UTC in [0-9.]+ s\Z")
        self.assertRegex(page["command"], r"\AGALLIVM_PERF=\S+ texshot conform --seed 1 ")
        self.assertEqual([case["name"] for case in page["cases"]],
                         ["wrap-shader-fixed", "environment-shader-fixed", "wrap-reference-fixed", "environment-reference-fixed"])
        for case in page["cases"]:
            for picture in case["pictures"]:
                with Image.open(folder / picture["file"]) as image:
                    self.assertEqual(image.size, (64, 64))
                self.assertTrue((folder / f"{picture['file']}.js").exists())
            self.assertTrue((folder / case["links"][0]["file"]).exists())
        for renderer in ("reference", "fixed"):
            kept = Image.open(folder / f"wrap-reference-fixed-{renderer}.png").convert("RGB")
            again = self.shot(folder / "wrap-reference-fixed.json", "--renderer", renderer, "--size", "64x64")
            self.assertIsNone(self.difference(kept, again))

    def test_the_folder_is_a_page_for_a_browser(self):
        folder = self.path / "report"
        self.succeeds(*self.FEW, "-o", folder)
        browser = Browser(self.path)
        self.addCleanup(browser.quit)
        browser.driver.get((folder / "index.html").as_uri())
        browser.wait(lambda: browser.script("return performance.getEntriesByName('texplorer-shown').length"), "the page")
        self.assertEqual(browser.driver.title, "Do the renderers agree?")
        browser.wait(lambda: browser.texts(".overview h2") == ["All agree"], "the overview")
        self.assertEqual(browser.texts("section h3")[:2], ["Shader against fixed function", "Reference against fixed function"])
        self.assertEqual(browser.texts("tbody th"), ["wrap", "environment"] * 2)
        browser.script("document.querySelectorAll('tbody th a')[2].click()")
        browser.wait(lambda: browser.all("#case-name") and browser.text("#case-name") == "wrap-reference-fixed", "the case")
        self.assertEqual(browser.texts("figcaption .caption"), ["Fixed function", "Reference", "Where they differ"])
        browser.wait(lambda: len(browser.all(".magnified canvas")) == 2, "the pixels")
        self.assertIn("Rule", browser.text(".facts"))
        self.assertEqual(browser.complaints(), [])

    def test_shaders_that_are_wrong_are_found(self):
        shaders = self.path / "shaders"
        shutil.copytree(Path(__file__).parents[3] / "shaders", shaders)
        environment = shaders / "environment.glsl"
        text = environment.read_text()
        self.assertIn("color.rgb = min(color.rgb + texelUNIT.rgb, 1.0);", text)
        environment.write_text(text.replace("color.rgb = min(color.rgb + texelUNIT.rgb, 1.0);", "color.rgb = texelUNIT.rgb;"))
        result = texshot("conform", "--feature", "environment", "--renderer", "shader", "--shaders", shaders)
        self.assertEqual((result.returncode, result.stderr), (1, b""))
        self.assertRegex(result.stdout.decode(), r"environment .* DIFFER")

    def test_shaders_that_cannot_be_read_are_refused(self):
        nowhere = self.path / "nowhere"
        self.complains(1, "nowhere/", "conform", "--feature", "wrap", "--shaders", nowhere, "-o", self.path / "report")
        self.assertFalse((self.path / "report").exists())
        result = texshot("conform", "--renderer", "reference", "--feature", "wrap", "--scenes", "1", "--shaders", nowhere)
        self.assertIn(b"--shaders: has no effect here", result.stderr)

    def test_the_list_gives_features_and_reasons(self):
        said = self.succeeds("conform", "--list").decode()
        for expected in ("trilinear", "dEQP", "undefined-decal", "3.8.13"):
            self.assertIn(expected, said)

    def test_the_list_as_json_names_the_rules_of_its_features(self):
        listing = single(self.succeeds("conform", "--list", "--json"))
        rules = {rule["name"] for rule in listing["rules"]}
        self.assertEqual({feature[key] for feature in listing["features"] for key in ("reference", "shader")}, rules)
        text = self.succeeds("conform", "--list").decode()
        for row in listing["features"] + listing["notCompared"]:
            self.assertIn("\n" + row["name"], text)
        self.assertTrue(all(rule["reason"] in text for rule in listing["rules"]))

    def test_wrong_calls(self):
        for expected, *arguments in (
            ("--feature: expected one of coverage, depth, ", "--feature", "none"),
            ("--renderer: expected one of fixed, shader, reference, found \"gpu\"", "--renderer", "gpu"),
            ("expected two different renderers, found \"fixed\" twice", "--renderer", "fixed", "--against", "fixed"),
            ("--renderer: expected a renderer other than fixed, the default of --against", "--renderer", "fixed"),
            ("--against: expected a renderer other than fixed, the default of --renderer", "--against", "fixed"),
            ("--scenes: expected a whole number from 1 to 100000, found \"0\"", "--scenes", "0"),
            ("--seed: expected a whole number from 0 to 4294967295, found \"-1\"", "--seed", "-1"),
            ("--seed: expected a whole number from 0 to 4294967295, found \"some\"", "--seed", "some"),
        ):
            with self.subTest(expected=expected):
                self.complains(2, expected, "conform", *arguments)

    def test_an_interrupt_writes_nothing(self):
        work = subprocess.Popen([TEXSHOT, "conform", "--scenes", "100000", "-o", self.path / "report"],
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        time.sleep(3)
        work.send_signal(signal.SIGINT)
        out, said = work.communicate(timeout=60)
        self.assertEqual((work.returncode, out), (130, b""))
        self.assertIn(b"interrupted", said)
        self.assertEqual(os.listdir(self.path), [])


if __name__ == "__main__":
    unittest.main()
