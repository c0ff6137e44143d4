"""The scenes whose programs are proved: the one that Texplorer starts with, every example, every preset and every step of
every lesson."""

import json
import subprocess
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import NamedTuple

EXAMPLES = Path(__file__).parents[3] / "assets" / "scenes"


class Case(NamedTuple):
    name: str  # of a file, too
    words: tuple  # that name the scene to texshot


def every_case(texshot):
    presets = json.loads(said(texshot, "presets", "--json"))["presets"]
    lessons = json.loads(said(texshot, "lessons", "--json"))["lessons"]
    cases = [Case("start", ())]
    cases += [Case("example-" + file.stem, ("--example", file.stem)) for file in sorted(EXAMPLES.glob("*.json"))]
    cases += [Case("preset-" + each["name"], ("--preset", each["name"])) for each in presets]
    cases += [Case(f"{lesson['name']}-{step}", ("--lesson", lesson["name"], "--step", str(step)))
              for lesson in lessons for step in range(1, len(lesson["steps"]) + 1)]
    return cases


def without_repeats(texshot, cases):
    """Of scenes that are the same the first one."""
    with ThreadPoolExecutor() as threads:
        texts = threads.map(lambda case: said(texshot, "scene", *case.words), cases)
    first = {}
    for case, text in zip(cases, texts):
        first.setdefault(text, case)
    return list(first.values())


def said(texshot, *words):
    return subprocess.run([texshot, *words], capture_output=True, text=True, check=True).stdout
