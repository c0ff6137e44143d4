"""The scenes whose programs are tested: the default scene, every example, every preset and every step of every
lesson."""

import json
import os
import random
import subprocess
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import NamedTuple

ASSETS = Path(__file__).parents[3] / "assets"


class Case(NamedTuple):
    name: str  # of a file, too
    words: tuple  # that name the scene to texshot
    file: Path  # where it is written out, with the whole paths of its images


def every_case(texshot, folder):
    """Removes duplicates of scenes and writes the rest into the folder."""
    presets = json.loads(said(texshot, "presets", "--json"))["results"]
    lessons = json.loads(said(texshot, "lessons", "--json"))["results"]
    words = {"start": ()}
    words |= {f"example-{file.stem}": ("--example", file.stem) for file in sorted((ASSETS / "scenes").glob("*.json"))}
    words |= {f"preset-{each['name']}": ("--preset", each["name"]) for each in presets}
    words |= {f"{lesson['name']}-{step}": ("--lesson", lesson["name"], "--step", str(step))
              for lesson in lessons for step in range(1, len(lesson["steps"]) + 1)}
    cases = [Case(name, each, Path(folder) / f"{name}.json") for name, each in words.items()]
    with ThreadPoolExecutor() as threads:
        texts = threads.map(lambda case: written(texshot, case), cases)
    first = {}
    for case, text in zip(cases, texts):
        first.setdefault(text, case)
    return list(first.values())


def chosen(cases):
    """One of TEXPLORER_PROOFS scenes, a tenth by default, always with the default scene. The seed is
    TEXPLORER_PROOF_SEED or the commit, so that each commit tests others."""
    share = int(os.environ.get("TEXPLORER_PROOFS", "10"))
    seed = os.environ.get("TEXPLORER_PROOF_SEED") or commit()
    if len(cases) < 140:
        raise AssertionError(f"found {len(cases)} scenes, expected at least 140")
    count = -(-len(cases) // share)
    print(f"{count} of {len(cases)} scenes: TEXPLORER_PROOF_SEED={seed} TEXPLORER_PROOFS={share}", flush=True)
    return cases[:1] + random.Random(seed).sample(cases[1:], count - 1)


def commit():
    done = subprocess.run(["git", "rev-parse", "--short", "HEAD"], cwd=ASSETS, capture_output=True, text=True, check=False)
    return done.stdout.strip() or "1"


def written(texshot, case):
    """The text of its file. A lesson is read from its folder, or the paths of its images would be relative to the
    file."""
    words = [str(ASSETS / "lessons" / word) if before == "--lesson" else word for before, word in zip(("", *case.words), case.words)]
    said(texshot, "scene", *words, "-o", str(case.file))
    return case.file.read_text()


def said(texshot, *words):
    return subprocess.run([texshot, *words], capture_output=True, text=True, check=True).stdout
