#!/usr/bin/env python3
"""What layers.py must find, and must not."""
import unittest

import layers

TABLE = """\
texplorer_core_base|core/base|glm::glm|glm::glm
texplorer_core_image|core/image|texplorer::core_base|texplorer::core_base
texplorer_core_png|core/image/png|texplorer::core_base $<LINK_ONLY:texplorer::core_image>|texplorer::core_image PNG::PNG
texplorer_core_top|core/top|texplorer::core_png|texplorer::core_png
texplorer_ui|app/ui|texplorer::core|texplorer::core
"""


def wrong(**files):
    paths = {name.replace("__", "/") + ".cpp": text for name, text in files.items()}
    return layers.wrong_includes(layers.read_layers(TABLE), paths)


class Includes(unittest.TestCase):
    def test_what_is_linked_may_be_included(self):
        self.assertEqual(wrong(core__image__a='#include "texplorer/base/b.h"\n#include "texplorer/image/c.h"\n'), [])

    def test_an_include_that_points_up_is_named(self):
        self.assertEqual(
            wrong(core__base__a='#include <vector>\n#include "texplorer/image/b.h"\n'),
            ["core/base/a.cpp includes core/image/b.h, but core/base does not link core/image"])

    def test_what_a_layer_links_for_itself_alone_is_not_passed_on(self):
        self.assertEqual(wrong(core__image__png__a='#include "texplorer/image/b.h"\n'), [])
        self.assertEqual(
            wrong(core__top__a='#include "texplorer/image/b.h"\n'),
            ["core/top/a.cpp includes core/image/b.h, but core/top does not link core/image"])

    def test_a_folder_belongs_to_the_nearest_library_above(self):
        self.assertEqual(wrong(app__ui__details__a='#include "texplorer/top/b.h"\n#include "app/ui/c.h"\n'), [])
        self.assertEqual(wrong(core__top__a='#include "app/ui/c.h"\n'),
                         ["core/top/a.cpp includes app/ui/c.h, but core/top does not link app/ui"])

    def test_what_is_for_one_folder_is_not_for_another(self):
        self.assertEqual(wrong(app__ui__a="#include <CLI/CLI.hpp>\n#include <CLI11>\n"),
                         ["app/ui/a.cpp includes <CLI/…>, which is for app/command_line"])

    def test_who_is_told_the_time_asks_no_clock(self):
        asks = "auto now = std::chrono::steady_clock::now();\n"
        self.assertEqual(wrong(app__ui__a=asks + "system_clock::to_time_t(when);\n", core__base__a=asks),
                         ["app/ui/a.cpp asks steady_clock::now, and is to be told the time"])

    def test_a_file_without_a_library_is_named(self):
        self.assertEqual(wrong(core__new__a=""), ["core/new/a.cpp belongs to no library"])


class Cycles(unittest.TestCase):
    def test_none(self):
        self.assertEqual(layers.cycles(layers.read_layers(TABLE)), [])

    def test_one(self):
        table = TABLE.replace("core/base|glm::glm|glm::glm", "core/base|texplorer::core_top|texplorer::core_top")
        self.assertEqual(layers.cycles(layers.read_layers(table))[0],
                         "core/base -> core/top -> core/image/png -> core/base is a cycle")


class Picture(unittest.TestCase):
    def test_the_highest_comes_first_and_what_goes_without_saying_is_left_out(self):
        lines = layers.picture(layers.read_layers(TABLE)).splitlines()
        self.assertEqual([line.split() for line in lines], [
            ["app/ui", "→", "core/top"], ["core/top", "→", "core/image/png"],
            ["core/image/png", "→", "core/image"], ["core/image", "→", "core/base"], ["core/base"]])


if __name__ == "__main__":
    unittest.main()
