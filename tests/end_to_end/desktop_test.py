"""What a desktop reads of Texplorer, read by the desktop's own programs; and the script that makes packages."""

import configparser
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from xml.etree import ElementTree

VERSION = sys.argv.pop(1)
SOURCE = Path(__file__).parents[2]
ASSETS = SOURCE / "assets"
SCENE = "application/x-texplorer-scene+json"


def entry():
    desktop = configparser.ConfigParser(interpolation=None, delimiters="=")
    desktop.optionxform = str
    desktop.read(ASSETS / "texplorer.desktop")
    return desktop["Desktop Entry"]


class Desktop(unittest.TestCase):
    def passes(self, *command):
        result = subprocess.run([*map(str, command)], capture_output=True, timeout=120)
        self.assertEqual(result.returncode, 0, (result.stdout + result.stderr).decode())
        return result.stdout.decode()

    def test_the_desktop_file(self):
        said = self.passes("desktop-file-validate", ASSETS / "texplorer.desktop")
        self.assertNotRegex(said, "error|warning")
        self.assertIn(SCENE, entry()["MimeType"].split(";"))
        self.assertTrue((ASSETS / (entry()["Icon"] + ".svg")).is_file())
        self.passes("xmllint", "--noout", ASSETS / "texplorer.svg")

    def test_the_metadata(self):
        file = ASSETS / "org.texplorer.Texplorer.metainfo.xml"
        self.passes("appstreamcli", "validate", "--no-net", file)
        root = ElementTree.parse(file).getroot()
        self.assertEqual(root.find("releases/release").get("version"), VERSION)
        self.assertEqual(root.find("launchable").text, "texplorer.desktop")
        self.assertEqual(root.find("name").text, entry()["Name"])
        self.assertEqual(root.find("summary").text, entry()["Comment"])
        self.assertIn(SCENE, [each.text for each in root.iterfind("provides/mediatype")])
        self.assertEqual({each.text for each in root.iterfind("categories/category")},
                         set(entry()["Categories"].strip(";").split(";")))

    def test_the_type_of_scenes(self):
        self.passes("xmllint", "--noout", ASSETS / "texplorer.mime.xml")
        with tempfile.TemporaryDirectory() as folder:
            packages = Path(folder) / "packages"
            packages.mkdir()
            shutil.copy(ASSETS / "texplorer.mime.xml", packages / "texplorer.xml")
            self.passes("update-mime-database", folder)
            self.assertIn(f"50:{SCENE}:*.texplorer.json\n", (Path(folder) / "globs2").read_text())
            self.assertIn(f"{SCENE} application/json\n", (Path(folder) / "subclasses").read_text())

    def test_one_extension(self):
        text = (SOURCE / "core/scene/params/json.h").read_text()
        self.assertEqual(re.search(r'sceneExtension = "(.*)"', text)[1], ".texplorer.json")

    def test_the_script_that_makes_packages(self):
        self.passes("shellcheck", "--severity", "warning", SOURCE / "packaging" / "package.sh")


if __name__ == "__main__":
    unittest.main()
