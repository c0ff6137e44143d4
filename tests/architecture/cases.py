#!/usr/bin/env python3
"""cases.py SOURCE: what is wrong with how the tests are named, one sentence a line; exit status 1 where anything is.

A file of tests mirrors the path of what it tests, or its first line says what it is about. A case asserts something, by
itself or by what it calls, or says in its name that only a crash can fail it: ...WithoutACrash."""
import pathlib
import re
import sys

ASSERTS = re.compile(r"\b(?:(?:EXPECT|ASSERT)_\w+|ADD_FAILURE|FAIL)\b")
CASE = re.compile(r"^(?:TYPED_)?TEST(?:_F|_P)?\((\w+),\s*(\w+)\)\s*{", re.MULTILINE)
FUNCTION = re.compile(r"\b(\w+)\((?:[^;{}()]|\([^;{}()]*\)){0,300}\)[^;{}()]{0,40}{")
LAMBDA = re.compile(r"\b(\w+) = \[[^\]]*\][^;{}]{0,300}{")
CALL = re.compile(r"\b(\w+)(?:<[^<>;]*>)?\(")
CRASH = "WithoutACrash"


def body(text, start):
    """What is between the brace before `start` and the one that closes it."""
    depth = 1
    for match in re.finditer(r"[{}]", text[start:]):
        depth += 1 if match.group() == "{" else -1
        if depth == 0:
            return text[start:start + match.start()]
    return text[start:]


def plain(text):
    """Without what would be taken for code."""
    text = re.sub(r'R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'|//[^\n]*', '""', text, flags=re.DOTALL)
    return text.replace("{}", "")


def functions(text):
    """The functions and lambdas of a text: a pair of its name and its body for each."""
    return [(match.group(1), body(text, match.end())) for kind in (FUNCTION, LAMBDA) for match in kind.finditer(text)]


def asserting(all_functions):
    """The names of those that assert something, or call what does."""
    found = {name for name, text in all_functions if ASSERTS.search(text)}
    calls = [(name, set(CALL.findall(text))) for name, text in all_functions]
    while more := {name for name, called in calls if name not in found and called & found}:
        found |= more
    return found


def wrong_cases(texts):
    """Of {path: text}, those that assert nothing and don't say so."""
    texts = {path: plain(text) for path, text in texts.items()}
    shared = [each for path, text in texts.items() if not path.endswith("_test.cpp") for each in functions(text)]
    wrong = []
    for path, text in sorted(texts.items()):
        helpers = asserting(functions(text) + shared) - {"TEST", "TEST_F", "TEST_P"}
        for match in CASE.finditer(text):
            case = body(text, match.end())
            asserts = ASSERTS.search(case) or helpers.intersection(CALL.findall(case))
            if not asserts and CRASH not in match.group(2):
                wrong.append(f"{path}: {match.group(1)}.{match.group(2)} asserts nothing, and its name doesn't say {CRASH}")
    return wrong


def wrong_places(texts, exists):
    """Of {path: text}, the files of tests that mirror no source and don't say what they are about."""
    wrong = []
    for path, text in sorted(texts.items()):
        if not path.endswith("_test.cpp"):
            continue
        mirrored = path.removeprefix("tests/").removesuffix("_test.cpp")
        if not any(exists(folder + mirrored + end) for folder in ("", "app/", "tests/") for end in (".cpp", ".h")) \
                and not text.startswith("//"):
            wrong.append(f"{path}: there is no {mirrored}.cpp, and no first line that says what is tested")
    return wrong


def main():
    source = pathlib.Path(sys.argv[1])
    texts = {str(path.relative_to(source)): path.read_text()
             for end in ("cpp", "h") for path in (source / "tests").rglob(f"*.{end}")}
    wrong = wrong_cases(texts) + wrong_places(texts, lambda path: (source / path).exists())
    print(*wrong, sep="\n")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
