"""Scenes that move by key frames: at least one parameter of each kind that calls or uniforms of a frame can say, each easing,
and those that a flavour has to refuse."""

import json
from typing import NamedTuple

from scenes import Case, said

TIMES = ("0", "0.3", "0.5", "1.3125", "2", "3.5")  # before, at and between keys, and behind the last one; one that is rounded


class Moving(NamedTuple):
    name: str
    keys: dict  # of each path (time, value) or (time, value, easing)
    scene: dict = {}
    pass_: dict = {}  # of the only pass
    unit: dict = {}  # of its first unit
    example: str = ""  # instead of all these
    only_fixed: str = ""  # the parameter that glsl refuses


CUBES = [{"shape": "cube", "position": [-1.2, 0, 0]}, {"shape": "sphere", "position": [1.2, 0, 0]}]
COLOR = {"envMode": "GL_BLEND", "envColor": [1, 0, 0, 1]}
EASINGS = ("hold", "linear", "ease-in", "ease-out", "ease-in-out")

MOVING = (
    Moving("camera", {"view.azimuth": [(0, -30, "ease-in-out"), (1, 75), (3, 10)], "view.elevation": [(0.25, 10, "ease-in"), (2, 50)],
                      "view.distance": [(0, 8, "ease-out"), (3, 3)], "view.roll": [(0, 0), (3, 40)], "view.target": [(0, [0, 0, 0]), (2, [0.5, 0.3, -0.2])],
                      "view.fieldOfView": [(0, 40), (3, 70)], "view.background": [(0, [0, 0, 0, 1]), (2, [0.3, 0.5, 0.7, 1])]}),
    Moving("orthographic-camera", {"view.distance": [(0, 8), (3, 4)], "view.fieldOfView": [(0, 40), (2, 20)]},
           scene={"view": {"projection": "orthographic"}}),
    Moving("easings", {f"models[{i}].position": [(0.25, [i - 2, -1, 0], easing), (3, [i - 2, 1.5, 0])] for i, easing in enumerate(EASINGS)},
           scene={"models": [{"shape": "cube", "size": 0.4} for _ in EASINGS]}),
    Moving("jumps", {"models[0].rotation": [(0, [0, 0, 0]), (1, [0, 90, 0]), (1, [45, 0, 0]), (2, [45, 45, 45])]}, scene={"models": CUBES}),
    Moving("models", {"models[0].rotation": [(0, [0, 0, 0]), (3, [350, -30, 45])], "models[0].spin": [(0, [0, 0, 0]), (2, [0, 30, 0])],
                      "models[1].size": [(0, 1), (2, 0.5)], "models[1].scale": [(0, [1, 1, 1]), (2, [1, 0.3, 2])]}, scene={"models": CUBES}),
    *(Moving(f"from-rest-{key}", {f"models[0].{key}": [(0, rest), (2, moved)]}, scene={"models": [{"shape": "cube"}]})
      for key, rest, moved in (("position", [0, 0, 0], [1, 0.5, -1]), ("rotation", [0, 0, 0], [0, 90, 0]), ("spin", [0, 0, 0], [0, 30, 0]),
                               ("size", 1, 0.5), ("scale", [1, 1, 1], [1, 0.3, 2]))),
    Moving("jumps-between-fractions", {"models[0].rotation": [(0, [0, 0, 0], "hold"), (0.3, [0, 40, 0], "hold"), (0.7, [20, 40, 0])],
                                       "material.color": [(0.1, [1, 1, 1, 1]), (0.3, [1, 0.3, 0.1, 1]), (1.3, [0.2, 0.7, 1, 1])]},
           scene={"models": [{"shape": "cube"}]}),
    Moving("shade-model", {"material.shadeModel": [(0, "GL_SMOOTH"), (1, "GL_FLAT"), (3, "GL_SMOOTH")]}, scene={"models": [{"shape": "sphere"}]},
           pass_={"lighting": True}, only_fixed="material.shadeModel"),
    Moving("spins-on", {"view.azimuth": [(0, 0), (2, 90)]}, scene={"models": [{"shape": "cube", "spin": [10, 20, 30]}]}),
    Moving("environment-color", {"passes[0].units[0].envColor": [(0, [1, 0, 0, 1]), (2, [0, 0.5, 1, 1])]}, unit=COLOR),
    Moving("environment-mode", {"passes[0].units[0].envMode": [(0, "GL_MODULATE"), (1, "GL_REPLACE"), (2, "GL_BLEND")]},
           unit={"envColor": [0, 0, 1, 1]}, only_fixed="passes[0].units[0].envMode"),
    Moving("samplers", {"textures[0].wrapS": [(0, "GL_REPEAT"), (1, "GL_CLAMP_TO_EDGE"), (2, "GL_MIRRORED_REPEAT")],
                        "textures[0].minFilter": [(0, "GL_NEAREST"), (1, "GL_LINEAR_MIPMAP_LINEAR"), (3, "GL_LINEAR")],
                        "textures[0].magFilter": [(0, "GL_NEAREST"), (2, "GL_LINEAR")], "textures[0].lodBias": [(0, 0), (2, 2.5)],
                        "textures[0].maxLevel": [(0, 5), (3, 1)], "passes[0].units[0].lodBias": [(0, 0), (2, 1)]},
           unit={"matrix": [{"op": "scale", "amount": [3, 3, 1]}]}),
    Moving("border", {"textures[0].borderColor": [(0, [1, 0, 0, 1]), (2, [0, 1, 0, 1])]},
           scene={"textures": [{"wrapS": "GL_CLAMP_TO_BORDER", "wrapT": "GL_CLAMP_TO_BORDER", "mipmaps": "generated"}]},
           unit={"matrix": [{"op": "scale", "amount": [3, 3, 1]}]}),
    Moving("matrix", {"passes[0].units[0].matrix[0].angle": [(0, 0), (2, 200)], "passes[0].units[0].matrix[0].pivot": [(0, [0, 0, 0]), (2, [0.5, 0.5, 0])],
                      "passes[0].units[0].matrix[1].amount": [(0, [1, 1, 1]), (2, [3, 2, 1])], "passes[0].units[0].matrix[2].rate": [(0, [0, 0, 0]), (2, [0.5, 0, 0])],
                      "passes[0].units[0].matrix[3].matrix": [(0, [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]),
                                                              (3, [1, 0.5, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.25, 0, 0, 1])]},
           unit={"matrix": [{"op": "rotate", "amount": [0, 0, 1]}, {"op": "scale"}, {"op": "translate"}, {"op": "multiply"}]}),
    Moving("generated", {"passes[0].units[0].texGenS.objectPlane": [(0, [1, 0, 0, 0]), (2, [0.3, 0.6, 0, 0.5])],
                         "passes[0].units[0].texGenT.eyePlane": [(0, [0, 1, 0, 0]), (2, [0, 0.25, 0.5, 0])]},
           unit={"texGenS": {"enabled": True, "mode": "GL_OBJECT_LINEAR"}, "texGenT": {"enabled": True, "mode": "GL_EYE_LINEAR"}}),
    Moving("light", {"light.position": [(0, [2, 3, 4, 1]), (2, [-3, 1, 2, 1])], "light.diffuse": [(0, [1, 1, 1, 1]), (3, [1, 0.2, 0, 1])],
                     "light.specular": [(0, [0, 0, 0, 1]), (3, [1, 1, 1, 1])]}, scene={"models": CUBES}, pass_={"lighting": True}),
    Moving("light-comes-nearer", {"light.position": [(0, [2, 3, 4, 0]), (2, [-3, 1, 2, 1])]}, pass_={"lighting": True}, only_fixed="light.position"),
    Moving("material", {"material.shininess": [(0, 1), (2, 80)], "material.specular": [(0, [0, 0, 0, 1]), (2, [1, 1, 0.5, 1])],
                        "models[1].material.diffuse": [(0, [0.8, 0.8, 0.8, 1]), (2, [0, 0.4, 1, 1])], "material.color": [(0, [1, 1, 1, 1]), (3, [1, 0.5, 0, 1])]},
           scene={"material": {"colorMaterial": False},
                  "models": [CUBES[0], {**CUBES[1], "ownMaterial": True, "material": {"colorMaterial": False}}]},
           pass_={"lighting": True}),
    Moving("vertex-color", {"material.color": [(0, [1, 1, 1, 1]), (3, [1, 0.5, 0, 1])]}, scene={"models": CUBES}),
    Moving("blending", {"passes[0].blend": [(0, False), (1, True), (2, False)], "passes[0].blendSrc": [(0, "GL_ONE"), (1.25, "GL_SRC_ALPHA")],
                        "passes[0].depthTest": [(0, True), (2, False)], "material.color": [(0, [1, 1, 1, 0.2]), (2, [1, 1, 1, 0.8])]},
           scene={"models": CUBES}, pass_={"blendDst": "GL_ONE"}),
    Moving("alpha-reference", {"passes[0].alphaRef": [(0, 0), (3, 1)]}, pass_={"alphaTest": True, "alphaFunc": "GL_GREATER"},
           scene={"textures": [{"pattern": "tree"}]}),
    Moving("fog", {"passes[0].fog.density": [(0, 0.02), (2, 0.2)], "passes[0].fog.color": [(0, [0, 0, 0, 1]), (2, [1, 0.9, 0.8, 1])]},
           pass_={"fog": {"enabled": True, "mode": "GL_EXP"}}),
    Moving("fog-modes", {"passes[0].fog.enabled": [(0, False), (1, True)], "passes[0].fog.mode": [(0, "GL_EXP"), (2, "GL_LINEAR")]},
           pass_={"fog": {"density": 0.1, "start": 3, "end": 9}}, only_fixed="passes[0].fog.enabled"),
    Moving("lit-at-times", {"passes[0].lighting": [(0, False), (1, True), (2, False)]}, scene={"models": CUBES}, only_fixed="passes[0].lighting"),
    Moving("textured-at-times", {"passes[0].units[0].enabled": [(0, False), (1, True), (3, False)]}, only_fixed="passes[0].units[0].enabled"),
    Moving("flipbook", {"passes[0].units[0].texture": [(0, 0), (1, 1), (2, 2)], "textures[2].wrapS": [(0, "GL_REPEAT"), (3, "GL_CLAMP_TO_EDGE")]},
           scene={"textures": [{"pattern": "checker", "minFilter": "GL_LINEAR"}, {"pattern": "checker-red", "minFilter": "GL_LINEAR"},
                               {"pattern": "gradient", "minFilter": "GL_LINEAR"}]}),
    Moving("two-passes", {"passes[1].units[0].envColor": [(0, [1, 0, 0, 1]), (2, [0, 0.5, 1, 1])], "passes[0].units[0].matrix[0].angle": [(0, 0), (2, 90)],
                          "passes[1].blendDst": [(0, "GL_ONE"), (2, "GL_ONE_MINUS_SRC_ALPHA")], "textures[0].minFilter": [(0, "GL_NEAREST"), (1, "GL_LINEAR")],
                          "light.position": [(0, [2, 3, 4, 0]), (2, [-3, 1, 2, 0])], "material.shininess": [(0, 1), (2, 80)]},
           scene={"models": CUBES, "passes": [
               {"lighting": True, "depthTest": True, "units": [{"enabled": True, "matrix": [{"op": "rotate", "amount": [0, 0, 1]}]}]},
               {"lighting": True, "depthTest": True, "depthFunc": "GL_LEQUAL", "blend": True, "units": [{"enabled": True, **COLOR}]}]}),
    Moving("two-units", {"passes[0].units[1].envColor": [(0, [1, 0, 0, 1]), (2, [0, 0.5, 1, 1])], "textures[1].magFilter": [(0, "GL_NEAREST"), (1, "GL_LINEAR")],
                         "passes[0].units[1].matrix[0].amount": [(0, [0, 0, 0]), (2, [0.5, 0.25, 0])]},
           scene={"models": CUBES, "textures": [{"minFilter": "GL_LINEAR"}, {"pattern": "gradient", "minFilter": "GL_LINEAR"}],
                  "passes": [{"depthTest": True, "units": [{"enabled": True}, {"enabled": True, "texture": 1, **COLOR, "matrix": [{"op": "translate"}]}]}]}),
    Moving("lines", {"models[0].lineWidth": [(0, 1), (2, 7)]},
           scene={"models": [{"shape": "mesh", "mesh": {"primitive": "GL_LINE_STRIP", "positions": [[-1, -1, 0], [1, -1, 0], [0, 1, 0]]}}]}),
    Moving("slices", {"models[0].slices": [(0, 5), (2, 20)]}, scene={"models": [{"shape": "sphere"}]}, only_fixed="models[0].slices"),
    Moving("nothing-drawn", {"view.background": [(0, [0, 0, 0, 1]), (2, [1, 0.5, 0.25, 1])]},
           scene={"models": [{"shape": "mesh", "mesh": {"positions": positions}} for positions in ([], [[0, 0, 0], [1, 0, 0]])]}),
    Moving("shadow", {"models[0].position": [(0, [0, 1, 0]), (2, [1, 1.5, 0])], "models[0].rotation": [(0, [0, 0, 0]), (2, [45, 45, 0])]},
           example="shadow-map"),
)

# Of each path two values that a flavour can't go between.
REFUSED = {
    "fixed": {"models[0].shape": ("cube", "sphere"), "textures[0].pattern": ("checker", "brick"),
              "textures[0].internalFormat": ("GL_RGBA", "GL_LUMINANCE"), "view.projection": ("perspective", "orthographic")},
    "glsl": {"passes[0].units[0].envMode": ("GL_MODULATE", "GL_DECAL"), "passes[0].lighting": (True, False),
             "models[0].shape": ("cube", "sphere"), "textures[0].wrapS": ("GL_REPEAT", "GL_CLAMP")},
}


def keys(path, values):
    return [{"path": path, **dict(zip(("time", "value", "easing"), each))} for each in values]


def scene_of(texshot, moving):
    if moving.example:
        scene = json.loads(said(texshot, "scene", "--example", moving.example))
    else:
        scene = {"version": 1, "passes": [{"depthTest": True, **moving.pass_, "units": [{"enabled": True, **moving.unit}]}], **moving.scene}
    return {**scene, "timeline": [key for path, values in moving.keys.items() for key in keys(path, values)]}


def cases(texshot, folder):
    """A case for each, whose scene is a file in the folder with everything that it says."""
    found = []
    for moving in MOVING:
        short, file = folder / f"short-{moving.name}.json", folder / f"{moving.name}.json"
        short.write_text(json.dumps(scene_of(texshot, moving)))
        said(texshot, "scene", str(short), "-o", str(file))
        found.append(Case(moving.name, (str(file),), file))
    return found
