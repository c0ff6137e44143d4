"""texshot commands: the program of a scene, as the window shows it."""

import unittest

from texshot import Texshot, single, texshot


class Commands(Texshot):
    def test_the_calls_are_those_that_change_something(self):
        text = self.succeeds("commands", "--set", "textures[0].wrapS=GL_CLAMP").decode()
        self.assertIn("glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP);\n", text)
        self.assertNotIn("GL_TEXTURE_WRAP_T", text)
        everything = self.succeeds("commands", "--all").decode()
        self.assertIn("glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_REPEAT);\n", everything)

    def test_it_is_the_program_of_emit(self):
        text = self.succeeds("commands", "--example", "cube").decode()
        self.assertEqual(self.succeeds("emit", "--example", "cube").decode(), text)
        told = single(self.succeeds("commands", "--example", "cube", "--json"))
        self.assertEqual(told["language"], "C99")
        self.assertEqual("".join(line + "\n" for line in told["lines"]), text)

    def test_a_scene_that_is_not_there_is_one_sentence(self):
        result = texshot("commands", self.path / "nothing.json")
        self.assertEqual((result.returncode, result.stdout), (1, b""))
        self.assertEqual(result.stderr.count(b"\n"), 1)


if __name__ == "__main__":
    unittest.main()
