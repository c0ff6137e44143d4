"""On Mesa's softpipe, whose rho is the least that OpenGL 2.1, section 3.8.8, allows: what holds on one driver holds on
another."""

import json
import os
import unittest

from PIL import ImageChops

from suites import Suites
from texshot import single, texshot

os.environ["GALLIUM_DRIVER"] = "softpipe"

# A square with a colour for each level, its texture turned by 30 degrees.
TURNED = {
    "view": {"projection": "orthographic", "azimuth": 0, "elevation": 0, "distance": 5},
    "models": [{"shape": "quad"}],
    "textures": [{"pattern": "mip-colors", "mipmaps": "colored", "minFilter": "GL_LINEAR_MIPMAP_LINEAR"}],
    "passes": [{"units": [{"enabled": True, "envMode": "GL_REPLACE",
                           "matrix": [{"op": "rotate", "amount": [0, 0, 1], "angle": 30}]}]}],
}


class Softpipe(Suites):
    def scene(self):
        scene = self.path / "turned.json"
        scene.write_text(json.dumps(TURNED))
        return scene

    def worst(self, a, b):
        return max(high for _, high in ImageChops.difference(a.convert("RGB"), b.convert("RGB")).getextrema())

    def test_its_rho_is_the_lower_end(self):
        scene = self.scene()
        # 256 texels on so many pixels: rho is 256 / pixels, times cos 30 at the lower end.
        size = ("--size", "160x120")
        drawn = self.shot(scene, *size)
        self.assertLessEqual(self.worst(drawn, self.shot(scene, *size, "--renderer", "reference", "--rho", "lower")), 2)
        self.assertGreater(self.worst(drawn, self.shot(scene, *size, "--renderer", "reference")), 20)
        found = {}
        for rho in ("ideal", "lower", "upper"):
            said = single(self.succeeds("probe", scene, *size, "--at", "80,60", "--no-gl", "--rho", rho, "--json"))
            lod = said["fragments"][0]["units"][0]["sample"]["lod"]
            self.assertEqual(lod["rhoMethod"], rho)
            found[rho] = lod["log2Rho"]
        self.assertAlmostEqual(found["lower"] - found["ideal"], -0.2075187, 4)  # log2(cos 30)
        self.assertAlmostEqual(found["upper"] - found["ideal"], 0.7924813, 4)  # log2(2 cos 30)

    def test_the_renderers_agree(self):
        result = texshot("conform", "--scenes", "150", "--json")
        report = single(result.stdout)
        differ = [feature["feature"] for pair in report["pairs"] for feature in pair["features"] if not feature["agrees"]]
        self.assertEqual((result.returncode, differ), (0, []))
        self.assertEqual(report["driver"], "softpipe")
        of_reference = {feature["feature"]: feature for feature in report["pairs"][1]["features"]}
        self.assertEqual(list(of_reference["given-levels"]["rho"]), ["lower"])
        self.assertEqual(of_reference["nearest"]["rho"], {})
        said = self.succeeds("conform", "--feature", "given-levels", "--scenes", "4").decode()
        self.assertRegex(said, r"\nrho: given-levels: \d scenes? with rho at its lower end \(--rho lower\), "
                               r"which OpenGL 2\.1, section 3\.8\.8, allows\n")

    def test_one_suite_serves_every_driver(self):
        self.scene()
        suite = self.path / "all.suite.json"
        suite.write_text(json.dumps({
            "suite": 1,
            "defaults": {"size": "160x120", "renderer": ["fixed", "shader"], "golden": "reference"},
            "cases": [{"name": "turned", "scene": "turned.json"},
                      {"name": "checker", "scene": {"example": "checker"}, "axis": "textures[0].minFilter=*"},
                      {"name": "cube", "scene": {"example": "cube"}}]}))
        record = self.record(suite, code=0)
        self.assertEqual({case["state"] for case in record.values()}, {"passed"})
        for name, case in record.items():
            if name.startswith("turned"):
                self.assertTrue(case["sentence"].endswith(
                    "; rho is at the lower end of what OpenGL 2.1, section 3.8.8, allows (--rho lower)"), case["sentence"])


if __name__ == "__main__":
    unittest.main()
