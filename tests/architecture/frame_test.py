"""The calls of a frame are those of the table in docs/develop/panel.md, in its order, and few; panels change nothing,
and need no OpenGL and no thread."""

import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).parents[2]
MAX_CALLS = 15


class Frame(unittest.TestCase):
    def test_its_calls_are_those_of_the_table(self):
        source = (ROOT / "app/ui/window/workbench.cpp").read_text()
        body = re.search(r"^Requests drawWorkbench\(.*?\{\n(.*?)^\}", source, re.S | re.M)[1]
        calls = re.findall(r"^    (?:const bool popup = |return )?(\w+)\(", body, re.M)
        self.assertEqual(len(calls), body.count(";"), "a statement is a call")
        table = (ROOT / "docs/develop/panel.md").read_text().split("## A frame")[1].split("\n## ")[0]
        self.assertEqual(calls, re.findall(r"^\| `(\w+)` \|", table, re.M))
        self.assertLessEqual(len(calls), MAX_CALLS)

    def test_panels_only_read_the_session(self):
        """They request what they want changed."""
        acting = {"workbench.h", "shortcuts.h", "text_size.h", "notes.h", "lesson_keys.h"}  # the frame, and actions
        for folder in "details figures language parameters texture_space view widgets window".split():
            for header in sorted((ROOT / "app/ui" / folder).glob("*.h")):
                if header.parent.name == "window" and header.name in acting:
                    continue
                text = header.read_text()
                found = re.findall(r"(?<!const )\b(?:Session|WindowState|Document|Workspace|Settings|Playback)&", text)
                self.assertEqual(found, [], header)

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
