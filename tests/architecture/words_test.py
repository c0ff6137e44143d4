#!/usr/bin/env python3
"""Finds words that texts do without, in documents, comments, strings and lessons: words.txt has them with their
plain forms, words_pending.txt the files that still have some.

    words_test.py ROOT [--pending]   --pending: prints what words_pending.txt would be
"""
import pathlib
import re
import subprocess
import sys

HERE = pathlib.Path(__file__).parent
FOLDERS = ("app/", "core/", "shaders/", "tests/", "cmake/", "packaging/", "docs/")
DOCUMENTS = ("README.md", "CONTRIBUTING.md", "CMakeLists.txt", "dev")
CODE = {".h", ".cpp", ".c", ".vert", ".frag", ".glsl"}
TEXT = {".md", ".py", ".sh", ".cmake", ".txt", ".in", ".desktop", ".xml", ""}
OWN = {"tests/architecture/words.txt", "tests/architecture/words_test.py", "packaging/copyright"}

# A raw string, a string, a character (not the ' of 1'000), a comment.
TOKEN = re.compile(r'R"(?P<end>\w*)\((?P<raw>.*?)\)(?P=end)"|"(?P<text>(?:\\.|[^"\\\n])*)"'
                   r"|(?<!\w)'(?:\\.|[^'\\\n])+'|//[/!]?<?(?P<line>[^\n]*)|/\*(?P<block>.*?)\*/", re.DOTALL)


def blank(text, filler):
    return re.sub(r"[^\n]", filler, text)


def prose_of_code(text):
    """Comments and strings; the code between them is other characters, the marks of comments are spaces."""
    out, end = [], 0
    for token in TOKEN.finditer(text):
        between = text[end:token.start()]
        out.append(blank(between, " " if between.isspace() else "\0"))
        kind = token.lastgroup if token.lastgroup != "end" else "raw"
        start, stop = token.span(kind) if token.lastgroup else (token.end(), token.end())
        out += [blank(text[token.start():start], " "), text[start:stop], blank(text[stop:token.end()], " ")]
        end = token.end()
    return "".join(out)


def prose_of(path, text):
    if pathlib.PurePath(path).suffix in CODE:
        text = prose_of_code(text)
    elif not path.endswith((".md", ".json")):
        text = re.sub(r"^([ \t]*)#+", lambda found: found[0].replace("#", " "), text, flags=re.MULTILINE)
    text = re.sub(r"`[^`\n]*`", lambda found: blank(found[0], "\0"), text)  # names
    return text.replace("’", "'").replace("\\n", "  ").lower()


def words_of(text):
    """One expression, a group for each line, and the lines' plain forms."""
    rows = [line.split("\t") for line in text.splitlines() if line and not line.startswith("#")]
    words = [word.replace("(", "(?:").replace("(?:?", "(?").replace(" ", r"\s+") for word, _ in rows]
    groups = "|".join(f"(?P<w{i}>{word})" for i, word in enumerate(words))
    return re.compile(rf"\b(?:{groups})(?!\w)"), [plain for _, plain in rows]


def found_in(path, text, words):
    """(line, word, plain form), in the order of lines."""
    expression, plain = words
    prose = prose_of(path, text)
    return [(prose.count("\n", 0, found.start()) + 1, " ".join(found[0].split()), plain[int(found.lastgroup[1:])])
            for found in expression.finditer(prose)]


def is_checked(path):
    kind = pathlib.PurePath(path).suffix
    if path in OWN or path.startswith("tests/fixtures/"):
        return False
    if path.startswith("assets/lessons/"):
        return path.endswith("/lesson.json")
    return path in DOCUMENTS or path.startswith(FOLDERS) and kind in CODE | TEXT


def files_of(root):
    """What git knows; without it, what is there."""
    listed = subprocess.run(["git", "ls-files", "-z", "-co", "--exclude-standard"], cwd=root, capture_output=True, text=True)
    names = listed.stdout.split("\0") if listed.returncode == 0 else [
        str(path.relative_to(root)) for top in [*FOLDERS, "assets/lessons"] for path in (root / top).rglob("*")]
    return sorted(name for name in {*names, *DOCUMENTS} if is_checked(name) and (root / name).is_file())


def self_check(words):
    """Words are found in each kind of text, over the ends of lines too, and not in code or names."""
    code = 'int nobody = 1; // the caller gives\n  /// way\nauto x = "Besi\\" beside" R"(whoever)"; /* at\nlent */ int lent;'
    expected = [(1, "gives way"), (3, "beside"), (3, "whoever"), (4, "lent")]
    found = [row[:2] for row in found_in("a.h", code, words)]
    assert found == expected, f"planted {expected}, found {found}"
    for path, text in (("a.md", "of `lent`\nNobody’s"), ("a.py", "lent_x\n# nobody's"), ("lesson.json", "\n nobody's")):
        assert [row[:2] for row in found_in(path, text, words)] == [(2, "nobody's")], path


def main():
    root = pathlib.Path(sys.argv[1])
    words = words_of((HERE / "words.txt").read_text())
    self_check(words)
    pending = set((HERE / "words_pending.txt").read_text().split())
    found = {name: rows for name in files_of(root)
             if (rows := found_in(name, (root / name).read_text(errors="replace"), words))}
    if sys.argv[2:] == ["--pending"]:
        print("\n".join(found))
        return 0
    for name in sorted(found.keys() - pending):
        for line, word, plain in found[name]:
            print(f'{name}:{line}: "{word}": {plain}')
    for name in sorted(pending - found.keys()):
        print(f"words_pending.txt: {name} has none of the words any more: take it off the list")
    return int(found.keys() != pending)


if __name__ == "__main__":
    sys.exit(main())
