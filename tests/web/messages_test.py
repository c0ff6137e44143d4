#!/usr/bin/env python3
"""messages_test.py PAGE: what program_test.mjs has sent and heard is as assets/schemas/messages.schema.json says."""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import jsonschema

HERE = pathlib.Path(__file__).parent
SCHEMA = json.loads((HERE.parents[1] / "assets/schemas/messages.schema.json").read_text())
PAGE = pathlib.Path()


class Messages(unittest.TestCase):
    maxDiff = None

    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "messages")
            subprocess.run(["node", "--test-name-pattern", "messages", HERE / "program_test.mjs", PAGE], timeout=600,
                           env={**os.environ, "TEXPLORER_MESSAGES": str(file)}, check=False, stdout=subprocess.DEVNULL)
            cls.messages = [json.loads(line) for line in file.read_text().splitlines()]

    def test_it_is_a_schema(self):
        jsonschema.Draft202012Validator.check_schema(SCHEMA)

    def test_the_messages_fit(self):
        validator = jsonschema.Draft202012Validator(SCHEMA)
        wrong = [json.dumps(each)[:200] for each in self.messages if not validator.is_valid(each)]
        self.assertEqual(wrong, [])

    def test_there_are_messages_of_each_kind(self):
        kinds = {each.get("do") or each.get("event") or ("error" if "error" in each else "answer") for each in self.messages}
        self.assertLessEqual({"set", "load", "open", "read", "answer", "error", "lesson"}, kinds)
        self.assertGreater(len(self.messages), 50)


if __name__ == "__main__":
    PAGE = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main()
