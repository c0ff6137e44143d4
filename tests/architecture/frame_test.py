"""A frame is as docs/develop/window.md shows it, and has few calls; panels change nothing, and need no OpenGL and no
thread."""

import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).parents[2]
PAGE = (ROOT / "docs/develop/window.md").read_text()
MAX_CALLS = 15
BELOW = {"state", "services", "model", "files", "editor"}
PANELS = [each for each in sorted((ROOT / "app/ui").iterdir()) if each.is_dir() and each.name not in BELOW]


def body_of(file, function):
    return re.search(rf"^[\w:]+ {function}\(.*?\{{\n(.*?)^\}}", (ROOT / file).read_text(), re.S | re.M)[1]


class Frame(unittest.TestCase):
    def test_its_calls_are_those_of_the_picture(self):
        """All of drawWorkbench, some of the others."""
        bodies, shown = {}, {}
        picture = PAGE.split("<!-- frame -->\n```\n")[1].split("```")[0]
        for file, function, name in re.findall(r"^.{9}(?:(app/\S+) +(\S+)|  (\w+))", picture, re.M):
            if file:
                bodies[function], names = body_of(file, function), shown.setdefault(function, [])
            else:
                names.append(name)
        for function, names in shown.items():
            calls = iter(re.findall(r"\b(\w+)\(", bodies[function]))
            self.assertEqual([name for name in names if name not in calls], [], f"{function} calls it in this order")
        body = bodies["drawWorkbench"]
        calls = re.findall(r"^    (?:const bool popup = |return )?(\w+)\(", body, re.M)
        self.assertEqual(len(calls), body.count(";"), "a statement is a call")
        self.assertEqual(calls, shown["drawWorkbench"])
        self.assertLessEqual(len(calls), MAX_CALLS)

    def test_the_names_of_the_page_are_in_the_sources(self):
        folders = [ROOT / "app", ROOT / "core/scene"]
        words = {word for folder in folders for source in folder.rglob("*.*") if source.suffix in (".h", ".cpp")
                 for word in re.findall(r"\w+", source.read_text())}
        named = {word for name in re.findall(r"`([\w:]+)`", PAGE) for word in name.split("::")}
        self.assertEqual(sorted(named - words), [])

    def test_the_folders_of_the_page_include_those_before(self):
        folders = re.findall(r"^\| `([\w/]+)` \|", PAGE.split("## Folders")[1], re.M)
        links = dict(re.findall(r"^(\S+) +→ (.*)$", (ROOT / "docs/develop/layers.md").read_text(), re.M))
        self.assertEqual([folder for folder in links if folder.startswith("app/ui/") and folder not in folders], [])
        for place, folder in enumerate(folders):
            self.assertEqual(set(folders[place:]) & set(links[folder].split(", ")), set(), f"{folder} includes them")

    def test_panels_only_read_the_session(self):
        """They request what they want changed."""
        acting = {"workbench.h", "shortcuts.h", "text_size.h", "notes.h"}  # the frame, and actions
        for folder in PANELS:
            for header in sorted(folder.glob("*.h")):
                if header.parent.name == "window" and header.name in acting:
                    continue
                text = header.read_text()
                found = re.findall(r"(?<!const )\b(?:Session|WindowState|Document|Workspace|Settings|Playback)&", text)
                self.assertEqual(found, [], header)

    def test_panels_look_at_the_workers_and_no_more(self):
        """They see const ones through workers(session), and request what these are to do."""
        for folder in PANELS:
            for source in sorted(folder.glob("*.*")):
                code = re.sub(r"^#include .*|//.*", "", source.read_text(), flags=re.M)
                self.assertEqual(re.findall(r".*\bservices\b.*", code), [], source)

    def test_no_includes_of_the_window_are_a_cycle(self):
        """A unit is a header with its source."""
        sources = [each for each in (ROOT / "app/ui").rglob("*.*") if each.suffix in (".h", ".cpp")]
        below = {}
        for source in sources:
            unit = str(source.relative_to(ROOT).with_suffix(""))
            found = re.findall(r'^#include "(app/ui/\S+)\.h"', source.read_text(), re.M)
            below.setdefault(unit, set()).update(each for each in found if each != unit)
        while lowest := [unit for unit, rest in below.items() if not rest]:
            for unit in lowest:
                del below[unit]
            for rest in below.values():
                rest.difference_update(lowest)
        self.assertEqual(below, {}, "they include each other, or units that do")

    def test_the_window_needs_no_opengl_and_no_thread(self):
        """A browser could be its host: it draws with stage::Graphics, and threads are those of core/base/worker.h."""
        foreign = re.compile(r'^\s*#\s*include\s+(?:"app/(?:render|opengl|offscreen|explorer)/|'
                             r"<(?:GL|GLES\d*|GLFW|EGL|KHR)/|<(?:thread|pthread\.h)>).*", re.M)
        self.assertTrue(foreign.search('#include <GL/glew.h>'))
        self.assertTrue(foreign.search('#include "app/render/gl_handle.h"'))
        for folder in "ui stage view".split():
            for source in sorted((ROOT / "app" / folder).rglob("*.*")):
                if source.suffix in (".h", ".cpp", ".inl"):
                    self.assertEqual(foreign.findall(source.read_text()), [], source)


if __name__ == "__main__":
    unittest.main()
