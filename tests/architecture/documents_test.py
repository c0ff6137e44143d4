#!/usr/bin/env python3
"""README.md, CONTRIBUTING.md and docs: every relative link and anchor leads somewhere, every path exists, every document is
linked from another one."""
import re
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FIRST = ("README.md", "CONTRIBUTING.md")
LINK = re.compile(r"\[[^\]]*\]\(([^)\s]+)\)")
PATH = re.compile(r"`((?:app|assets|cmake|core|docs|packaging|shaders|tests)/[\w./*-]*)`")
FENCE = re.compile(r"^```.*?^```$", re.MULTILINE | re.DOTALL)


def documents(root):
    return [root / name for name in FIRST] + sorted((root / "docs").rglob("*.md"))


def anchors(text):
    """Those of the headings, as GitHub makes them."""
    headings = re.findall(r"^#+ (.*)$", FENCE.sub("", text), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def problems(root):
    """Sentences; empty where all is right."""
    found, linked = [], set()
    for document in documents(root):
        name = document.relative_to(root)
        text = FENCE.sub("", document.read_text(encoding="utf-8"))
        for link in LINK.findall(text):
            if re.match(r"\w+:", link):
                continue
            file, _, anchor = link.partition("#")
            target = (document.parent / file).resolve() if file else document
            linked.add(target)
            if not target.exists():
                found.append(f"{name}: {link} leads to no file")
            elif anchor and anchor not in anchors(target.read_text(encoding="utf-8")):
                found.append(f"{name}: {link} leads to no heading")
        found += [f"{name}: there is no {path}" for path in PATH.findall(text) if not any(root.glob(path.rstrip("/")))]
    found += [f"no document links to {each.relative_to(root)}" for each in documents(root)
              if each.name not in FIRST and each not in linked]
    return found


class Documents(unittest.TestCase):
    def test_links_lead_somewhere(self):
        self.assertEqual(problems(ROOT), [])

    def test_finds_what_is_wrong(self):
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder).resolve()
            (root / "docs").mkdir()
            (root / "README.md").write_text("# A title: of two\n[a](docs/a.md#one-1) [b](docs/b.md) [c](#a-title-of-two)\n")
            (root / "CONTRIBUTING.md").write_text("\n```\n[d](d.md)\n```\n")
            (root / "docs" / "a.md").write_text("# One\n`core/nothing.h` `docs/*.md` [r](../README.md) <https://a.b/c.md>\n")
            (root / "docs" / "c.md").write_text("")
            self.assertEqual(problems(root), [
                "README.md: docs/a.md#one-1 leads to no heading",
                "README.md: docs/b.md leads to no file",
                "docs/a.md: there is no core/nothing.h",
                "no document links to docs/c.md",
            ])


if __name__ == "__main__":
    unittest.main()
