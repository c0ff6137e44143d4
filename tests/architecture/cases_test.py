#!/usr/bin/env python3
"""What cases.py must find, and must not."""
import unittest

import cases


def wrong(text):
    return [each.split(": ")[1].split(" ")[0] for each in cases.wrong_cases({"tests/a_test.cpp": text})]


class Cases(unittest.TestCase):
    def test_one_that_asserts_nothing_is_named(self):
        self.assertEqual(wrong('TEST(A, B) {\n    if (x) {\n        run("EXPECT_EQ");\n    }\n}\n'), ["A.B"])
        self.assertEqual(wrong("TEST_F(A, B) {\n    run(); // EXPECT_EQ\n}\nTEST(A, C) {\n    EXPECT_EQ(1, 1);\n}\n"), ["A.B"])

    def test_one_that_asserts_is_not(self):
        self.assertEqual(wrong("TEST_P(A, B) {\n    for (;;) {\n        ASSERT_TRUE(x);\n    }\n}\n"), [])

    def test_one_that_calls_what_asserts_is_not(self):
        self.assertEqual(wrong("void all(int x) {\n    one(x);\n}\nvoid one(int x) {\n    EXPECT_EQ(x, 1);\n}\n"
                               "TEST(A, B) {\n    all(1);\n}\n"), [])
        self.assertEqual(wrong("TEST(A, B) {\n    const auto one = [&](int x) { EXPECT_EQ(x, 1); };\n    one(1);\n}\n"), [])

    def test_one_that_says_so_is_not(self):
        self.assertEqual(wrong("TEST(A, EndsWithoutACrash) {\n    run();\n}\n"), [])


class Places(unittest.TestCase):
    def test_a_file_mirrors_a_source_or_says_what_it_is_about(self):
        texts = {"tests/core/a_test.cpp": "", "tests/ui/b_test.cpp": "", "tests/c_test.cpp": "", "tests/d_test.cpp": "// D.\n"}
        places = {"core/a.cpp", "app/ui/b.h"}
        self.assertEqual(cases.wrong_places(texts, places.__contains__),
                         ["tests/c_test.cpp: there is no c.cpp, and no first line that says what is tested"])


if __name__ == "__main__":
    unittest.main()
