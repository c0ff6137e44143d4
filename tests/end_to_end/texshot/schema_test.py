"""texshot schema: python3-jsonschema, which knows nothing of the rows, and the reader agree about scenes."""

import copy
import json
import subprocess
import unittest
from pathlib import Path

import jsonschema

from texshot import OUTPUT, TEXSHOT, Texshot, results, texshot

SOURCE = Path(__file__).parents[3]
SOAK = Path(TEXSHOT).parent / "texplorer_soak"


class Schema(Texshot):
    @classmethod
    def setUpClass(cls):
        made = texshot("schema")
        assert (made.returncode, made.stderr) == (0, b""), made
        cls.schema = json.loads(made.stdout)
        cls.validator = jsonschema.Draft202012Validator(cls.schema)

    def refused(self, scene):
        """What the schema says against a scene; empty: nothing."""
        return [f"{'/'.join(map(str, each.path))}: {each.message}" for each in self.validator.iter_errors(scene)]

    def reads(self, scene):
        """Whether texshot reads it, and what it said."""
        file = self.path / "scene.json"
        file.write_text(json.dumps(scene))
        result = texshot("diff", file, file)
        return result.returncode == 0, result.stderr.decode()

    def test_it_is_a_schema(self):
        self.assertEqual(self.schema["$schema"], "https://json-schema.org/draft/2020-12/schema")
        jsonschema.Draft202012Validator.check_schema(self.schema)
        self.assertTrue(self.succeeds("schema").endswith(b"}\n"))
        file = self.path / "scene.schema.json"
        self.assertEqual(self.succeeds("schema", "-o", file), b"")
        self.assertEqual(json.loads(file.read_text()), self.schema)
        outputs = json.loads(self.succeeds("schema", "--outputs"))
        jsonschema.Draft202012Validator.check_schema(outputs)
        self.assertEqual(outputs, OUTPUT.schema)
        self.complains(2, "expected one of --suites and --outputs", "schema", "--suites", "--outputs")
        suites = json.loads(self.succeeds("schema", "--suites"))
        jsonschema.Draft202012Validator.check_schema(suites)
        self.assertEqual(suites["$id"], self.schema["$id"].replace("scene.", "suite."))
        for place in ("{case}", "{picture}", "{driver}"):
            self.assertIn(place, json.dumps(suites))
        self.complains(1, "Not a directory", "schema", "-o", file / "schema.json")

    def test_every_parameter_has_words_and_an_initial_value_that_it_accepts(self):
        listed = {entry["path"]: entry for entry in results(self.succeeds("params", "--json")) if entry["kind"] != "list"}
        found = {}

        def walk(struct, path):
            self.assertFalse(struct["additionalProperties"], path)
            for key, member in struct["properties"].items():
                inner = member.get("items", {}) if "$ref" in member.get("items", {}) else member
                if "$ref" in inner:
                    brackets = "[]" if inner is not member else ""
                    walk(self.schema["$defs"][inner["$ref"].rsplit("/", 1)[1]], f"{path}{key}{brackets}.")
                elif path or key not in ("$schema", "version"):
                    found[path + key] = member

        walk(self.schema, "")
        self.assertEqual(set(found), set(listed))
        for path, member in found.items():
            with self.subTest(path=path):
                entry = listed[path]
                self.assertEqual(member["title"], entry["label"])
                self.assertTrue(member["description"].startswith(entry["help"]))
                self.assertIn(entry["glCall"], member["description"])
                if "choices" in entry:
                    names = [each for each in member["enum"] if isinstance(each, str)]
                    self.assertEqual(names, [each["name"] for each in entry["choices"]])
                    self.assertEqual(len(member["enum"]), len(member["enumDescriptions"]))
                if "default" in member:
                    self.assertEqual(member["default"], entry["default"])
                    jsonschema.Draft202012Validator(member).validate(member["default"])

    def test_suites_have_one_too(self):
        schema = json.loads(self.succeeds("schema", "--suites"))
        jsonschema.Draft202012Validator.check_schema(schema)
        suites = sorted((SOURCE / "assets").glob("suites/*.suite.json"))
        self.assertNotEqual(suites, [])
        for file in suites:
            jsonschema.Draft202012Validator(schema).validate(json.loads(file.read_text()))
        with self.assertRaises(jsonschema.ValidationError):
            jsonschema.Draft202012Validator(schema).validate({"suite": 1, "casses": []})

    def test_scenes_of_ours_fit(self):
        scenes = sorted((SOURCE / "assets").glob("scenes/*.json"))
        scenes += [each for each in sorted((SOURCE / "assets").glob("lessons/*/*.json")) if each.name != "lesson.json"]
        self.assertGreater(len(scenes), 20)
        for file in scenes:
            self.assertEqual(self.refused(json.loads(file.read_text())), [], file)

    def test_presets_and_lessons_fit(self):
        calls = [("--preset", each["name"]) for each in results(self.succeeds("presets", "--json"))]
        for lesson in results(self.succeeds("lessons", "--json")):
            calls += [("--lesson", lesson["name"], "--step", step + 1) for step in range(len(lesson["steps"]))]
        self.assertGreater(len(calls), 100)
        for call in calls:
            for short in ([], ["--short"]):
                scene = json.loads(self.succeeds("scene", "--quiet", *call, *short))
                self.assertEqual(self.refused(scene), [], call)
                self.assertEqual(scene.get("$schema"), None if short else self.schema["$id"])

    def test_random_scenes_fit(self):
        made = subprocess.run([SOAK, "write", self.path, "--count", "60"], capture_output=True, timeout=120)
        self.assertEqual((made.returncode, made.stderr), (0, b""))
        files = sorted(self.path.glob("*.json"))
        self.assertEqual(len(files), 60)
        for file in files:
            scene = json.loads(file.read_text())
            self.assertEqual(scene["$schema"], self.schema["$id"])
            self.assertEqual(self.refused(scene), [], file)

    def test_both_refuse_what_is_wrong(self):
        mesh = {"primitive": "GL_POINTS", "positions": [[0, 0, 0]]}
        wrong = {
            "no object": [],
            "unknown key": {"vew": {}},
            "unknown key below": {"view": {"azimut": 1}},
            "unknown key in a list": {"textures": [{"colour": 1}]},
            "unknown key in a unit": {"passes": [{"units": [{"texGenS": {"plane": 1}}]}]},
            "schema that is no text": {"$schema": 1},
            "schema below": {"view": {"$schema": "a"}},
            "version of the future": {"version": 2},
            "version 0": {"version": 0},
            "version as a text": {"version": "1"},
            "null": {"view": None},
            "array for an object": {"view": []},
            "object for an array": {"models": {}},
            "number for a bool": {"light": {"twoSide": 1}},
            "text for a number": {"view": {"azimuth": "1"}},
            "too small": {"view": {"distance": 0.05}},
            "too large": {"view": {"fieldOfView": 171}},
            "no whole number": {"models": [{"slices": 3.5}]},
            "unknown enumerant": {"textures": [{"minFilter": "GL_REPEAT"}]},
            "enumerant in small letters": {"textures": [{"minFilter": "gl_nearest"}]},
            "a number that is no name": {"passes": [{"units": [{"combine": {"rgbScale": 3}}]}]},
            "a mode that q hasn't": {"passes": [{"units": [{"texGenQ": {"mode": "GL_SPHERE_MAP"}}]}]},
            "too few numbers": {"view": {"target": [0, 0]}},
            "too many numbers": {"view": {"target": [0, 0, 0, 0]}},
            "a colour out of range": {"view": {"background": [0, 0, 2, 1]}},
            "a text in a vector": {"view": {"target": [0, 0, "0"]}},
            "too many models": {"models": [{}] * 17},
            "too many textures": {"textures": [{}] * 65},
            "too many passes": {"passes": [{}] * 9},
            "no pass": {"passes": []},
            "too many units": {"passes": [{"units": [{}] * 5}]},
            "a long text": {"textures": [{"file": "a" * 4097}]},
            "a zero in a text": {"textures": [{"file": "a\0b"}]},
            "a point of two": {"models": [{"shape": "mesh", "mesh": {**mesh, "positions": [[0, 0]]}}]},
            "a coordinate beyond floats": {"models": [{"shape": "mesh", "mesh": {**mesh, "positions": [[0, 0, 1e39]]}}]},
            "an index below 0": {"models": [{"shape": "mesh", "mesh": {**mesh, "indices": [-1]}}]},
            "a pass of no model": {"models": [{}], "passes": [{"models": []}]},
            "too many keys": {"timeline": [{"path": "view.azimuth", "value": 1}] * 1025},
            "a key too late": {"timeline": [{"path": "view.azimuth", "value": 1, "time": 3601}]},
            "a key of no easing that there is": {"timeline": [{"path": "view.azimuth", "value": 1, "easing": "bounce"}]},
            "a key's object": {"timeline": [{"path": "view.azimuth", "value": {}}]},
            "a key of too many numbers": {"timeline": [{"path": "view.azimuth", "value": [1] * 17}]},
            "a model twice": {"models": [{}], "passes": [{"models": [0, 0]}]},
        }
        for name, scene in wrong.items():
            with self.subTest(name):
                read, said = self.reads(scene)
                self.assertFalse(read, "texshot reads it")
                self.assertRegex(said, r"\Atexshot: [^\n]+\n\Z")
                self.assertTrue(self.refused(scene), said)

    def test_both_accept_what_is_right(self):
        right = {
            "nothing": {},
            "a schema of another place": {"$schema": "https://example.org/scene.json", "version": 1},
            "a whole number with a point": {"models": [{"slices": 8.0}]},
            "a number that is a name": {"passes": [{"units": [{"combine": {"rgbScale": 2}}]}]},
            "that name": {"passes": [{"units": [{"combine": {"rgbScale": "2"}}]}]},
            "no models": {"models": []},
            "a long text": {"textures": [{"file": "a" * 4096}]},
            "letters of several bytes": {"models": [{"name": "\u00e9\U0001f600"}]},
            "keys of every kind": {"timeline": [{"path": "view.azimuth", "value": 1.5}, {"path": "view.target", "value": [1, 2, 3], "time": 2},
                                                {"path": "passes[0].blend", "value": True}, {"path": "models[0].name", "value": "a"}]},
            "some units": {"passes": [{"units": [{}, {}]}]},
        }
        for name, scene in right.items():
            with self.subTest(name):
                self.assertEqual(self.reads(scene), (True, ""))
                self.assertEqual(self.refused(scene), [])

    def test_both_draw_the_same_limits(self):
        """Each number at its limits and beyond them, each enumerant and one that there isn't."""
        start = {"models": [{}], "textures": [{}], "passes": [{}], "timeline": [{"path": "view.azimuth", "value": 1}]}
        places = {"KeyFrame": "timeline/0", "Projector": "light/projector", "Material": "material", "View": "view", "Light": "light",
                  "Texture": "textures/0", "Level": "textures/0/levels/0", "ImageStep": "textures/0/preparation/0",
                  "Subimage": "textures/0/subimages/0",
                  "Model": "models/0", "ModelMaterial": "models/0/material", "Mesh": "models/0/mesh", "ModelUnit": "models/0/units/0",
                  "Pass": "passes/0", "Fog": "passes/0/fog", "Unit": "passes/0/units/0",
                  "Combine": "passes/0/units/0/combine", "Emboss": "passes/0/units/0/emboss", "Upload": "textures/0/upload",
                  "MatrixStep": "passes/0/units/0/matrix/0",
                  **{f"TexGen{each}": f"passes/0/units/0/texGen{each}" for each in "STRQ"}}
        self.assertEqual(set(places), set(self.schema["$defs"]))

        def placed(place, key, value):
            scene = copy.deepcopy(start)
            at = scene
            for part, after in zip(place.split("/"), place.split("/")[1:] + [""]):
                if part.isdigit():
                    at.extend([{}] * (int(part) + 1 - len(at)))
                    at = at[int(part)]
                else:
                    at = at.setdefault(part, [] if after.isdigit() else {})
            at[key] = value
            return scene

        refused, accepted = [], []  # (place, key, value)
        for name, struct in self.schema["$defs"].items():
            for key, member in struct["properties"].items():
                place = (places[name], key)
                if "enum" in member:
                    accepted += [(*place, each) for each in member["enum"]]
                    refused += [(*place, "GL_NOTHING"), (*place, 12345), (*place, True)]
                elif member.get("type") in ("number", "integer"):
                    beyond = max(1, abs(member["maximum"]) * 1e-3)
                    accepted += [(*place, member["minimum"]), (*place, member["maximum"])]
                    refused += [(*place, member["minimum"] - beyond), (*place, member["maximum"] + beyond),
                                (*place, "1"), (*place, True)]
                elif member.get("type") == "array" and member["minItems"] == member["maxItems"] and "type" in member["items"]:
                    least, most, count = member["items"]["minimum"], member["items"]["maximum"], member["minItems"]
                    accepted += [(*place, [least] * count), (*place, [most] * count)]
                    refused += [(*place, [most + max(1, most)] * count), (*place, [most] * (count - 1))]
                elif member.get("type") == "boolean":
                    accepted += [(*place, True), (*place, False)]
                    refused += [(*place, 1), (*place, "true")]
        # Which both know, and what isn't said in a row: a unit that is enabled needs the texture of its number.
        accepted = [each for each in accepted if each[1] != "texture"]
        self.assertGreater(len(accepted), 500)
        self.assertGreater(len(refused), 400)
        for wrong, cases in ((False, accepted), (True, refused)):
            for place, key, value in cases:
                said = self.refused(placed(place, key, value))
                self.assertEqual(bool(said), wrong, f"{place}/{key} = {value!r}: {said}")
        # The reader is asked about all that is accepted of a struct at once, and about each that is refused.
        for place in sorted({each[0] for each in accepted}):
            mine = [each for each in accepted if each[0] == place]
            for turn in range(max(sum(1 for each in mine if each[1] == key) for key in {each[1] for each in mine})):
                scene = copy.deepcopy(start)
                for key in {each[1] for each in mine}:
                    values = [each[2] for each in mine if each[1] == key]
                    scene = self.merged(scene, placed(place, key, values[turn % len(values)]))
                read, said = self.reads(scene)
                self.assertTrue(read, f"{place}: {said}")
        for place, key, value in refused:
            read, said = self.reads(placed(place, key, value))
            self.assertFalse(read, f"texshot reads {place}/{key} = {value!r}")
            self.assertIn(f"/{place}/{key}", said)

    def merged(self, a, b):
        if isinstance(a, dict):
            return {key: self.merged(a[key], b[key]) if key in a and key in b else a.get(key, b.get(key))
                    for key in {**a, **b}}
        if isinstance(a, list) and len(a) == len(b) and all(isinstance(each, dict) for each in a):
            return [self.merged(x, y) for x, y in zip(a, b)]
        return b


if __name__ == "__main__":
    unittest.main()
