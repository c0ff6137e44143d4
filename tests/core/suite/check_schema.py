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
]

folder = pathlib.Path(sys.argv[1])
schema = json.loads((folder / "schema.json").read_text())
jsonschema.Draft202012Validator.check_schema(schema)
validator = jsonschema.Draft202012Validator(schema)
for kind, entries in (("good", GOOD), ("bad", BAD)):
    (folder / kind).mkdir()
    for number, entry in enumerate(entries):
        suite = {"suite": 1, "cases": [entry]}
        assert validator.is_valid(suite) == (kind == "good"), (kind, entry)
        (folder / kind / f"{number}.suite.json").write_text(json.dumps(suite))
for other in ([], {}, {"suite": 1}, {"suite": 2, "cases": [{}]}, {"suite": 1, "cases": []}, {"suite": 1, "cases": [{}], "x": 1}):
    assert not validator.is_valid(other), other
