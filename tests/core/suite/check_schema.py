"""check_schema.py DIR: DIR/schema.json is a schema, takes the good suites and refuses the bad ones, which are written to
DIR/good and DIR/bad for the reader to judge as well."""
import json
import pathlib
import sys

import jsonschema

GOOD = [
    {},
    {"name": "n", "scene": "a/b.json"},
    {"scene": ["a.json", {"example": "checker"}, {"lesson": "wrap", "step": 3, "answer": 2}, {"inline": {"version": 1}}]},
    {"set": "textures[0].wrapS=GL_CLAMP", "axis": ["a=*", "b=1,2"]},
    {"set": ["preset:seam", "x="], "size": ["1x1", "16384x16384"], "time": [0, 1.5], "renderer": ["fixed", "reference"]},
    {"golden": "reference", "rule": "level-blend", "seconds": 5},
    {"golden": ["g/{case}.png", "g/{picture}@{driver}.png"], "metric": "flip", "tolerance": 0.5, "share": 0.1},
    {"golden": {"llvmpipe*": "a.png", "*": ["b.png"]}, "mask": "m.png"},
    {"size": ["016x0016", "9999x10000", "16299x16379"], "mask": ""},
    {"share": "0.1%", "rgb": True},
    {"share": "100%", "tolerance": 255},
    {"metric": "flip", "pixelsPerDegree": 512, "tolerance": 1},
    {"metric": "ssim", "tolerance": 2},
    {"golden": "reference", "rule": "none", "tolerance": 3, "share": 0.5},
]
BAD = [
    {"scnee": "a.json"},
    {"scene": "../a.json"},
    {"scene": "/a.json"},
    {"scene": []},
    {"scene": {"lesson": "wrap", "step": 0}},
    {"scene": {"exmaple": "checker"}},
    {"size": "0x5"},
    {"size": 512},
    {"time": -1},
    {"renderer": "shaders"},
    {"renderer": ["fixed", "fixed"]},
    {"golden": "g.jpg"},
    {"golden": "{cases}.png"},
    {"golden": "a/../../b.png"},
    {"golden": {}},
    {"golden": "reference", "rule": "exakt"},
    {"metric": "psnr"},
    {"tolerance": -1},
    {"share": 2},
    {"seconds": 0},
    {"set": "wrapS"},
    {"axis": ["a=1", "b=1", "c=1", "d=1", "e=1", "f=1", "g=1", "h=1", "i=1"]},
    {"name": 3},
    {"metric": "flip", "tolerance": 200},
    {"metric": "ssim", "tolerance": 2.5},
    {"mask": "../m.png"},
    {"mask": "/m.png"},
    {"mask": "a\tb.png"},
    {"size": "20000x10"},
    {"size": "16385x1"},
    {"size": "00x1"},
    {"rule": "none"},
    {"golden": "g.png", "rule": "none"},
    {"share": "101%"},
    {"share": "much"},
    {"rgb": 1},
    {"metric": "flip", "pixelsPerDegree": 0.5},
    {"golden": "reference", "tolerance": 2},
    {"golden": "reference", "rule": "auto", "metric": "ssim"},
    {"golden": "reference", "renderer": "reference"},
    {"golden": "reference", "rule": "none", "renderer": ["fixed", "reference"]},
]
# Of what stands in "defaults", and of an entry with it.
GOOD_DEFAULTS = [
    ({"metric": "flip", "tolerance": 0.5}, {"metric": "absolute", "tolerance": 200}),
    ({"golden": "reference"}, {"rule": "none", "tolerance": 2}),
    ({"golden": "reference", "rule": "none", "tolerance": 2}, {}),
    ({"golden": "reference", "tolerance": 2}, {"golden": "g.png"}),
]
BAD_DEFAULTS = [
    ({"metric": "flip"}, {"tolerance": 2}),
    ({"golden": "reference"}, {"golden": "g.png", "rule": "none"}),
    ({"golden": "g.png"}, {"rule": "none"}),
    ({"rule": "none"}, {}),
]

folder = pathlib.Path(sys.argv[1])
schema = json.loads((folder / "schema.json").read_text())
jsonschema.Draft202012Validator.check_schema(schema)
validator = jsonschema.Draft202012Validator(schema)
for kind, entries, with_defaults in (("good", GOOD, GOOD_DEFAULTS), ("bad", BAD, BAD_DEFAULTS)):
    (folder / kind).mkdir()
    suites = [{"suite": 1, "cases": [entry]} for entry in entries]
    suites += [{"suite": 1, "defaults": defaults, "cases": [entry]} for defaults, entry in with_defaults]
    for number, suite in enumerate(suites):
        assert validator.is_valid(suite) == (kind == "good"), (kind, suite)
        (folder / kind / f"{number}.suite.json").write_text(json.dumps(suite))
for other in ([], {}, {"suite": 1}, {"suite": 2, "cases": [{}]}, {"suite": 1, "cases": []}, {"suite": 1, "cases": [{}], "x": 1}):
    assert not validator.is_valid(other), other
