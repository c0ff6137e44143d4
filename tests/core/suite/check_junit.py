"""check_junit.py FILE: whether the XML of tests/core/suite/junit_test.cpp is JUnit's, by parsers that aren't ours."""
import pathlib
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

file = pathlib.Path(sys.argv[1])
schema = pathlib.Path(__file__).with_name("junit.xsd")
subprocess.run(["xmllint", "--noout", "--schema", schema, file], check=True, stderr=subprocess.DEVNULL)

root = ElementTree.parse(file).getroot()
assert root.tag == "testsuites", root.tag
counts = {name: int(root.get(name)) for name in ("tests", "failures", "errors", "skipped")}
# Eleven states and one case that was not run: failed, new, crashed, timed out, resized, missing and extra fail.
assert counts == {"tests": 12, "failures": 7, "errors": 3, "skipped": 1}, counts
cases = root.findall("./testsuite/testcase")
assert len(cases) == 12
for tag, count in (("failure", 7), ("error", 3), ("skipped", 1)):
    assert len(root.findall(f"./testsuite/testcase/{tag}")) == count, tag

failed = cases[1]
assert failed.get("name") == "failed/\"<&>'\ufffd\ufffd[2J\ufffd\t\n\U0001f600", ascii(failed.get("name"))
assert failed.get("classname") == "s" and failed.get("time") == "0.250"
failure = failed.find("failure")
assert failure.get("message") == "]]> 3 < 4 & \"5\"\r\n", ascii(failure.get("message"))
assert failure.get("type") == "failed"
assert failure.text == "]]> 3 < 4 & \"5\"\r\n\n\ns = 0.5\n<b>&\ufffd\ufffd", ascii(failure.text)
assert root.find("./testsuite/testcase[@name='late/fixed@8x8']/error").get("type") == "not-run"
