"""texshot cost: every row with its times or the reason why it has none. What the times are is not tested."""

import statistics
import unittest

from texshot import Texshot, single, texshot

ROWS = ["bind", "upload-size", "draw-size", "upload-dxt1", "draw-dxt1", "mipmaps", "linear", "anisotropy", "scene"]


class Cost(Texshot):
    def measured(self, *arguments):
        return single(self.succeeds("cost", *arguments, "--json"))

    def test_each_row_has_its_times(self):
        told = self.measured("--pairs", "4")
        self.assertEqual([row["row"] for row in told["rows"]], ROWS)
        for row in told["rows"]:
            with self.subTest(row["row"]):
                self.assertNotIn("lack", row)
                for side in ("a", "b"):
                    self.assertEqual(len(row[side]["samples"]), 4)
                    self.assertGreater(min(row[side]["samples"]), 0)
                    low, median, high = statistics.quantiles(row[side]["samples"], n=4, method="inclusive")
                    for name, value in (("low", low), ("median", median), ("high", high)):
                        self.assertAlmostEqual(row[side]["seconds"][name] / value, 1)
                ratios = [b / a for a, b in zip(row["a"]["samples"], row["b"]["samples"])]
                self.assertAlmostEqual(row["ratio"]["median"] / statistics.median(ratios), 1)
                self.assertFalse(row["differs"], "four pairs are too few")
                self.assertEqual(row["verdict"]["message"], "4 pairs: at least 20 are needed")

    def test_says_what_the_driver_lacks(self):
        told = self.measured("--pairs", "1", "--pretend", "no-s3tc")
        lacks = {row["row"]: row["lack"]["message"] for row in told["rows"] if "lack" in row}
        self.assertEqual(set(lacks), {"upload-dxt1", "draw-dxt1"})
        self.assertIn("no-s3tc", told["version"])
        for sentence in lacks.values():
            self.assertIn("S3TC", sentence)

    def test_a_scene_without_a_texture(self):
        told = self.measured("--pairs", "1", "--set", "passes[0].units[0].enabled=false")
        self.assertEqual(told["rows"][-1]["lack"]["message"], "no enabled unit has a texture")

    def test_the_text_says_what_it_can_not_tell(self):
        said = self.succeeds("cost", "--pairs", "1").decode()
        for expected in ("bind: Bind or upload\n", "  A  Bind", "What these numbers can't tell:\n", "glFinish"):
            self.assertIn(expected, said)
        if "llvmpipe" in said.splitlines()[0]:
            self.assertIn("llvmpipe draws on the processor", said)

    def test_wrong_calls(self):
        for wrong in (["--pairs", "0"], ["--pretend", "nonsense"], ["--context", "nonsense"]):
            self.assertEqual(texshot("cost", *wrong).returncode, 2, wrong)


if __name__ == "__main__":
    unittest.main()
