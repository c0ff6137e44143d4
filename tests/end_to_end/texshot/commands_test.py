"""texshot commands: the OpenGL calls of a scene, which a C compiler takes."""

import shutil
import subprocess
import unittest

from texshot import Texshot, texshot


class Commands(Texshot):
    def test_the_calls_are_those_that_change_something(self):
        text = self.succeeds("commands", "--set", "textures[0].wrapS=GL_CLAMP").decode()
        self.assertIn("glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP);\n", text)
        self.assertNotIn("GL_TEXTURE_WRAP_T", text)
        everything = self.succeeds("commands", "--all").decode()
        self.assertIn("glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_REPEAT);\n", everything)

    @unittest.skipUnless(shutil.which("cc"), "there is no C compiler")
    def test_a_c_compiler_takes_them(self):
        source = self.path / "calls.c"
        source.write_text("#define GL_GLEXT_PROTOTYPES\n#include <GL/gl.h>\n#include <GL/glext.h>\n"
                          "#include <GL/glu.h>\nint main(void) {\n" + self.succeeds("commands").decode()
                          + "return 0;\n}\n")
        result = subprocess.run(["cc", "-std=c99", "-Wall", "-Wextra", "-Werror", "-fsyntax-only", source],
                                capture_output=True)
        self.assertEqual((result.returncode, result.stderr), (0, b""))

    def test_a_scene_that_is_not_there_is_one_sentence(self):
        result = texshot("commands", self.path / "nothing.json")
        self.assertEqual((result.returncode, result.stdout), (1, b""))
        self.assertEqual(result.stderr.count(b"\n"), 1)


if __name__ == "__main__":
    unittest.main()
