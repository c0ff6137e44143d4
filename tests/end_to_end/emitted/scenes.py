"""The scenes whose programs are proved: the one that Texplorer starts with, every example, every preset and every step of
every lesson."""

import json
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
    """Of scenes that are the same the first one. They are written into the folder."""
    presets = json.loads(said(texshot, "presets", "--json"))["presets"]
    lessons = json.loads(said(texshot, "lessons", "--json"))["lessons"]
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


def written(texshot, case):
    """The text of its file. A lesson is read from its folder, or its images would be named as if they lay beside the file."""
    words = [str(ASSETS / "lessons" / word) if before == "--lesson" else word for before, word in zip(("", *case.words), case.words)]
    said(texshot, "scene", *words, "-o", str(case.file))
    return case.file.read_text()


def said(texshot, *words):
    return subprocess.run([texshot, *words], capture_output=True, text=True, check=True).stdout
