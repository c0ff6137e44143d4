"""Suites for the tests of texshot test and merge, and drivers that go wrong."""

import json
import os
import subprocess
import xml.etree.ElementTree as ElementTree
from pathlib import Path

from texshot import TEXSHOT, Texshot, single, texshot

# Stands before OpenGL, and does to the process what the background's colour says.
BROKEN_DRIVER = r"""
#define _GNU_SOURCE
#include <dlfcn.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

static void *function(const char *name) {
    static const char *libraries[] = {"libOSMesa.so.8", "libOpenGL.so.0", "libGL.so.1"};
    for (int i = 0; i < 3; ++i) {
        void *library = dlopen(libraries[i], RTLD_LAZY | RTLD_NOLOAD);
        void *found = library ? dlsym(library, name) : NULL;
        if (found)
            return found;
    }
    abort();
}

void glClear(unsigned mask) {
    float color[4];
    ((void (*)(unsigned, float *))function("glGetFloatv"))(0x0C22 /* GL_COLOR_CLEAR_VALUE */, color);
    int what = (color[0] > 0.5f) * 4 + (color[1] > 0.5f) * 2 + (color[2] > 0.5f);
    if (what == 5) { /* magenta */
        printf("driver: assertion failed\n");
        fflush(stdout);
        abort();
    }
    if (what == 3) /* cyan */
        for (;;)
            pause();
    if (what == 6) /* yellow */
        raise(SIGKILL);
    if (what == 4) /* red */
        _exit(7);
    printf("\1\0\0\0a driver: cleared\n"); /* as if it were a message */
    fflush(stdout);
    ((void (*)(unsigned))function("glClear"))(mask);
}
"""

COLORS = {"crash": "1,0,1", "hang": "0,1,1", "killed": "1,1,0", "exit": "1,0,0", "grey": "0.2,0.2,0.2",
          "dark": "0.1,0.1,0.1", "blue": "0,0,0.4", "black": "0,0,0"}


class Suites(Texshot):
    """Tests that run suites. A case's name is its background's, as COLORS has it."""

    def suite(self, cases, name="s.suite.json", **defaults):
        file = self.path / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(json.dumps({"suite": 1, "defaults": {"size": "24x16", **defaults}, "cases": cases}))
        return file

    def backgrounds(self, *names, **settings):
        return [{"name": name, "set": f"view.background={COLORS[name]},1", **settings} for name in names]

    def run_of(self, *arguments, **options):
        return texshot("test", *arguments, **options)

    def passes(self, *arguments, **options):
        result = self.run_of(*arguments, **options)
        self.assertEqual((result.returncode, result.stderr), (0, b""), result.stdout)
        return result.stdout.decode()

    def record(self, *arguments, code=None, **options):
        """What --json says of a run: its cases by their names before the renderer's."""
        result = self.run_of(*arguments, "--json", "-", **options)
        if code is not None:
            self.assertEqual(result.returncode, code, result.stderr)
        run = single(result.stdout)
        self.assertEqual(run["status"], result.returncode)
        for case in run["cases"]:
            self.assertEqual("id" in case, "sentence" in case, case)
        return {case["name"].split("/")[0]: case for case in run["cases"]}

    def states(self, *arguments, **options):
        return {name: case["state"] for name, case in self.record(*arguments, **options).items()}

    def pictures_of(self, case):
        return [case[key] for key in ("expectedPicture", "actualPicture", "differencePicture") if case.get(key)]

    def broken_driver(self):
        """What makes OpenGL go wrong, as an environment."""
        source = self.path / "broken.c"
        source.write_text(BROKEN_DRIVER)
        library = self.path / "broken.so"
        subprocess.run(["cc", "-shared", "-fPIC", "-o", library, source, "-ldl"], check=True)
        preload = [each for each in (os.environ.get("LD_PRELOAD"), str(library)) if each]
        return {**os.environ, "LD_PRELOAD": " ".join(preload)}

    def children_of(self, process):
        try:
            return [int(each) for each in Path(f"/proc/{process}/task/{process}/children").read_text().split()]
        except FileNotFoundError:
            return []

    def junit(self, file):
        return ElementTree.parse(file).getroot()

    def begun(self, *arguments, **options):
        """A run that goes on in the background."""
        return subprocess.Popen([TEXSHOT, "test", *map(str, arguments)], stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, **options)
