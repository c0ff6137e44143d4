#!/usr/bin/env python3
"""The layers of Texplorer, as CMake's targets have them.

layers.py SOURCE LAYERS check     an include that its folder's library doesn't link is an error, as is a cycle
layers.py SOURCE LAYERS compare   the picture in docs/develop/layers.md is that of the targets
layers.py SOURCE LAYERS draw      puts it there
"""
import pathlib
import re
import sys

# Of core they are "texplorer/…": the build's link to the folder, and what is installed.
INCLUDE = re.compile(r'^\s*#\s*include\s+"((?:texplorer|app)/[^"]+)"', re.MULTILINE)
# Others' headers that are for one folder: CLI11 takes seconds to compile, GLFW is for what has a display, Dear ImGui's
# backends for what has OpenGL.
ALONE = {"CLI": "app/command_line", "GLFW": "app/explorer", "backends": "app/opengl"}
OTHERS = re.compile(r"^\s*#\s*include\s+<(" + "|".join(ALONE) + r")/", re.MULTILINE)
# The window is told the time, by its host or by a test: it asks no clock.
TOLD_THE_TIME = ("app/ui/", "app/stage/")
CLOCK = re.compile(r"\b(\w+_clock::now|steadySeconds|glfwGetTime|ImGui::GetTime)\(")
PICTURE = re.compile(r"(<!-- layers -->\n```\n).*?(```\n<!-- /layers -->)", re.DOTALL)


class Layer:
    def __init__(self):
        self.inherited = set()  # folders that the layers above it may include, too
        self.links = set()  # folders that it links itself, those included


def read_layers(text):
    """Folder → Layer. A folder of several targets has the links of all of them."""
    lines = [line.split("|") for line in text.splitlines()]
    folder_of = {target: folder for target, folder, _, _ in lines}

    def folders(links):
        found = set()
        for link in links.split():
            link = re.sub(r"^\$<LINK_ONLY:(.*)>$", r"\1", link).replace("::", "_")
            if link in ("texplorer_core", "texplorer_core-NOTFOUND"):
                found |= {folder for target, folder in folder_of.items() if target.startswith("texplorer_core_")}
            elif link in folder_of:
                found.add(folder_of[link])
        return found

    layers = {}
    for _, folder, inherited, own in lines:
        layer = layers.setdefault(folder, Layer())
        public = {link for link in inherited.split() if not link.startswith("$<LINK_ONLY")}
        layer.inherited |= folders(" ".join(public)) - {folder}
        layer.links |= folders(inherited + " " + own) - {folder}
    return layers


def reach(layers, folder):
    """What the sources of a folder may include: what its library links, and what that passes on."""
    seen, waiting = set(), set(layers[folder].links)
    while waiting:
        below = waiting.pop()
        if below not in seen:
            seen.add(below)
            waiting |= layers[below].inherited
    return seen


def cycles(layers):
    """Sentences; empty where all arrows point down."""
    done, path = set(), []

    def visit(folder):
        if folder in path:
            return [" -> ".join(path[path.index(folder):] + [folder]) + " is a cycle"]
        if folder in done:
            return []
        path.append(folder)
        found = [sentence for below in sorted(layers[folder].links) for sentence in visit(below)]
        path.pop()
        done.add(folder)
        return found

    return [sentence for folder in sorted(layers) for sentence in visit(folder)]


def layer_of(layers, path):
    """The folder of a file, or of the nearest one above it, that is a layer."""
    for folder in pathlib.PurePosixPath(path).parents:
        if str(folder) in layers:
            return str(folder)
    return None


def wrong_includes(layers, files):
    """`files`: path → text. Sentences, one for each include that its library doesn't link."""
    found = []
    for path, text in sorted(files.items()):
        above = layer_of(layers, path)
        if above is None:
            found.append(f"{path} belongs to no library")
            continue
        may = reach(layers, above) | {above}
        for included in INCLUDE.findall(text):
            included = re.sub(r"^texplorer/", "core/", included)
            below = layer_of(layers, included)
            if below not in may:
                found.append(f"{path} includes {included}, but {above} does not link {below or 'it'}")
        found += [f"{path} includes <{name}/…>, which is for {ALONE[name]}"
                  for name in OTHERS.findall(text) if above != ALONE[name]]
        found += [f"{path} asks {name}, and is to be told the time"
                  for name in CLOCK.findall(text) if path.startswith(TOLD_THE_TIME)]
    return found


def sources(root):
    return {
        str(path.relative_to(root)): path.read_text(encoding="utf-8")
        for top in ("core", "app")
        for path in (root / top).rglob("*")
        if path.suffix in (".h", ".cpp", ".inl")
    }


def picture(layers):
    """Highest first, each with what it links that isn't below another of its links."""
    rank = {}

    def rank_of(folder):
        if folder not in rank:
            rank[folder] = 1 + max((rank_of(below) for below in layers[folder].links), default=-1)
        return rank[folder]

    def all_below(folder):
        return set().union(*({below} | all_below(below) for below in layers[folder].links), set())

    lines = []
    for folder in sorted(layers, key=lambda name: (-rank_of(name), name)):
        links = layers[folder].links
        hidden = set().union(*(all_below(below) for below in links), set())
        direct = sorted(links - hidden, key=lambda name: (-rank_of(name), name))
        lines.append(f"{folder:26}" + ("→ " + ", ".join(direct) if direct else ""))
    return "".join(line.rstrip() + "\n" for line in lines)


def main():
    root, table, command = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), sys.argv[3]
    layers = read_layers(table.read_text(encoding="utf-8"))
    if command == "check":
        problems = cycles(layers) + wrong_includes(layers, sources(root))
        print("\n".join(problems) or f"{len(layers)} layers, no include points up")
        return 1 if problems else 0
    document = root / "docs/develop/layers.md"
    old = document.read_text(encoding="utf-8")
    new = PICTURE.sub(lambda match: match[1] + picture(layers) + match[2], old)
    if command == "draw":
        document.write_text(new, encoding="utf-8")
    elif PICTURE.search(old) is None or new != old:
        print("the layers in docs/develop/layers.md are not those of the targets: ./dev picture draws them again")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
