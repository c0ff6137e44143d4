"""texshot diff: what differs between two scenes."""

import json
import unittest

from texshot import Texshot, results, texshot


class Diff(Texshot):
    def scene(self, name, **members):
        path = self.path / name
        path.write_text(json.dumps({"version": 1, **members}))
        return path

    def test_the_same_scene_says_nothing(self):
        a = self.scene("a.json")
        self.assertEqual(self.succeeds("diff", a, a), b"")
        self.assertEqual(results(self.succeeds("diff", a, self.scene("b.json"), "--json")), [])

    def test_each_difference_is_a_line(self):
        a = self.scene("a.json", textures=[{"wrapS": "GL_CLAMP"}])
        b = self.scene("b.json", textures=[{"wrapS": "GL_REPEAT"}, {}])
        result = texshot("diff", a, b)
        self.assertEqual((result.returncode, result.stderr), (1, b""))
        self.assertEqual(result.stdout.decode().splitlines(),
                         ["textures: 1 element -> 2 elements", "textures[0].wrapS: GL_CLAMP -> GL_REPEAT"])
        listed = results(texshot("diff", "--json", a, b).stdout)
        self.assertEqual([(each["path"], each["from"], each["to"]) for each in listed],
                         [("textures", "1 element", "2 elements"), ("textures[0].wrapS", "GL_CLAMP", "GL_REPEAT")])

    def test_what_can_not_be_read_has_a_status_of_its_own(self):
        a = self.scene("a.json")
        self.complains(2, "nothing.json", "diff", a, self.path / "nothing.json")
        broken = self.path / "broken.json"
        broken.write_text("{")
        self.complains(2, "broken.json", "diff", broken, a)
        self.complains(2, "TO", "diff", a)

    def test_control_characters_of_a_scene_are_printed_harmlessly(self):
        a = self.scene("a.json", passes=[{"name": "one"}])
        b = self.scene("b.json", passes=[{"name": "\u001b[31mtwo"}])
        result = texshot("diff", a, b)
        self.assertEqual(result.returncode, 1)
        self.assertNotIn(b"\x1b", result.stdout)


if __name__ == "__main__":
    unittest.main()
