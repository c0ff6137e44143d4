#!/usr/bin/python3
"""commands_soak.py TEXSHOT SOAK [--count N] [--seed N] [--first N] [--keep DIR]: random scenes through every command of
texshot that takes a scene, with each renderer and at the ends of time. A command may refuse a scene with its sentence;
none may end by a signal, have no end, or say what a library says of its insides. `./dev soak commands` takes thousands."""

import argparse
import re
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

TIMES = ("0", "-3", "1e-30", "1e9")
RENDERERS = ("fixed", "shader", "reference")
SECONDS = 120

# What only the inside of a library says, and what Texplorer says instead.
INSIDES = re.compile(r"_M_|std::|__cxx|basic_string|vector::|\bmap::|\bstoi\b|json\.exception|what\(\)|terminate called"
                     r"|bad_(alloc|cast|function|optional|variant|weak|expected)|invalid_argument|out_of_range"
                     r"|filesystem error|Assertion|mistake in Texplorer")


def calls(scene, out):
    """Every call for a scene, as the words behind texshot."""
    for renderer in RENDERERS:
        for time in TIMES:
            yield "shot", scene, "--renderer", renderer, "--time", time, "--size", "48x40", "-o", out / "shot.png"
        yield ("sweep", scene, "--axis", "view.distance=4,9", "--renderer", renderer,
               "--time", "-3", "--size", "24x20", "-o", out / "sheet.png")
        yield ("animate", scene, "--renderer", renderer, "--seconds", "1", "--fps", "2", "--size", "24x20",
               "-o", out / "moves.gif")
    for time in TIMES:
        yield "probe", scene, "--at", "24,20", "--size", "48x40", "--time", time
        yield "probe", scene, "--at", "24,20", "--size", "48x40", "--time", time, "--json"
    yield "shot", scene, "--ui", "--size", "640x400", "-o", out / "window.png"
    yield "texture", scene, "-o", out / "texture.png"
    yield "check", scene
    yield "check", scene, "--json"
    yield "validate", scene
    yield "commands", scene
    for flavour in ("fixed", "glsl"):
        yield "emit", scene, "--as", flavour, "-o", out / "program"
    yield "scene", scene, "-o", out / "again.json"
    yield "scene", scene, "--short"
    yield "scene", "--diff", out / "start.json", scene
    yield "diff", scene, out / "start.json"


class Trial:
    def __init__(self, texshot, folder):
        self.texshot = texshot
        self.folder = folder

    def of(self, scene):
        """What went wrong with a scene, and how many calls were refused, or weren't."""
        wrong, statuses = [], {}
        out = self.folder / f"out-{scene.stem}"
        out.mkdir()
        shutil.copy(self.folder / "start.json", out)
        for words in calls(scene, out):
            words = [str(word) for word in words]
            try:
                result = subprocess.run([self.texshot, *words], capture_output=True, timeout=SECONDS)
            except subprocess.TimeoutExpired:
                wrong.append((words, f"no end within {SECONDS} s"))
                continue
            statuses.setdefault((words[0], result.returncode), 0)
            statuses[words[0], result.returncode] += 1
            said = result.stderr.decode(errors="replace")
            inside = INSIDES.search(said)
            if result.returncode not in (0, 1):
                wrong.append((words, f"status {result.returncode}: {said.strip()[:300]}"))
            elif inside:
                wrong.append((words, said.strip()[:300]))
            elif result.returncode == 1 and words[0] not in ("check", "diff", "validate", "scene") and not said:
                wrong.append((words, "it failed without a word"))
            elif any(line and not line.startswith("texshot: ") for line in said.splitlines()):
                wrong.append((words, f"who says this? {said.strip()[:300]}"))
        shutil.rmtree(out)
        return wrong, statuses


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("texshot")
    parser.add_argument("soak")
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--seed", default="1")
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--keep", type=Path)
    options = parser.parse_args()

    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        subprocess.run([options.soak, "write", name, "--count", str(options.first + options.count), "--seed", options.seed],
                       check=True)
        subprocess.run([options.texshot, "scene", "-o", str(folder / "start.json")], check=True)
        trial = Trial(options.texshot, folder)
        scenes = [folder / f"scene-{number}.json" for number in range(options.first, options.first + options.count)]
        failed, all_statuses = 0, {}
        with ThreadPoolExecutor(options.jobs) as threads:
            for scene, (wrong, statuses) in zip(scenes, threads.map(trial.of, scenes)):
                for key, count in statuses.items():
                    all_statuses[key] = all_statuses.get(key, 0) + count
                for words, what in wrong:
                    print(f"{scene.stem}: texshot {' '.join(words)}\n    {what}", flush=True)
                if wrong:
                    failed += 1
                    if options.keep:
                        options.keep.mkdir(parents=True, exist_ok=True)
                        shutil.copy(scene, options.keep)
        for (command, status), count in sorted(all_statuses.items()):
            print(f"{command}: {count} calls ended with {status}")
        print(f"{len(scenes)} random scenes: {'all well' if failed == 0 else f'{failed} not well'}")
        # That nothing but refusals was seen would tell nothing.
        drawn = all_statuses.get(("shot", 0), 0)
        if drawn == 0:
            print("no scene was drawn")
        return 1 if failed or drawn == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
