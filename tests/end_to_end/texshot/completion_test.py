"""texshot --completion: the scripts, used in bash, zsh and fish as a user types."""

import os
import pty
import re
import select
import shlex
import shutil
import subprocess
import time
import unittest
from pathlib import Path

from texshot import TEXSHOT, Texshot, results, texshot

TEXPLORER = Path(TEXSHOT).parent / "texplorer"


def words_for_bash(line):
    """COMP_WORDS as readline makes them of a line: COMP_WORDBREAKS has = and :, which are words of their own."""
    return [part for word in line.split(" ") for part in re.split(r"([=:]+)", word) if part or word == ""]


class Shell(Texshot):
    """The offers that each shell must have. The subclasses query the shell."""

    shell = None
    commands = ("shot", "probe", "conform", "params", "schema", "compress", "lessons")

    @classmethod
    def setUpClass(cls):
        if cls is Shell:
            raise unittest.SkipTest("it has no shell")
        assert shutil.which(cls.shell), f"{cls.shell} is missing: ./dev setup"

    def setUp(self):
        super().setUp()
        self.script = self.path / "script" / {"bash": "texshot", "zsh": "_texshot", "fish": "texshot.fish"}[self.shell]
        self.script.parent.mkdir()
        self.script.write_bytes(self.succeeds("--completion", self.shell))
        self.work = self.path / "work"
        (self.work / "inner").mkdir(parents=True)
        (self.work / "brick.dds").touch()
        (self.work / "two words.json").touch()

    def offered(self, line):
        """What is offered for the last word of a line, as whole words."""
        raise NotImplementedError

    def choices(self, *arguments):
        """The values that texshot itself lists in its error for another value."""
        said = texshot(*arguments, "nonsense", "-o", self.path / "out.png").stderr.decode()
        found = re.search(r"expected one of (.*?), found", said)
        self.assertTrue(found, said)
        return set(found[1].split(", "))

    def test_commands(self):
        listed = re.findall(r"^  ([a-z]+)(?: |$)", self.succeeds("--help").decode(), re.MULTILINE)
        self.assertLessEqual(set(self.commands), set(listed))
        self.assertLessEqual(set(listed), self.offered("texshot "))
        self.assertEqual(self.offered("texshot sho"), {"shot"})

    def test_options(self):
        for command in self.commands:
            with self.subTest(command):
                text = self.succeeds(command, "--help").decode()
                expected = set(re.findall(r"^  (?:-\w,)?(--[a-z-]+)", text, re.MULTILINE))
                self.assertLessEqual(expected, self.offered(f"texshot {command} --"))
        self.assertEqual(self.offered("texshot shot --fig"), {"--figure"})
        self.assertIn("--version", self.offered("texshot --"))

    def test_choices_are_those_that_are_taken(self):
        for option in ("--tab", "--figure", "--layout", "--theme", "--language", "--section"):
            expected = self.choices("shot", "--ui", option)
            self.assertEqual(self.offered(f"texshot shot --ui {option} "), expected, option)
        for option in ("--renderer", "--show", "--anisotropy"):
            self.assertEqual(self.offered(f"texshot shot {option} "), self.choices("shot", option), option)
        self.assertEqual(self.offered("texshot shot --preset alpha-t"), {"alpha-test"})
        presets = results(self.succeeds("presets", "--json"))
        self.assertEqual(self.offered("texshot shot --preset "), {each["name"] for each in presets})
        lessons = results(self.succeeds("lessons", "--json"))
        self.assertEqual(self.offered("texshot shot --lesson "), {each["name"] for each in lessons})
        self.assertEqual(self.offered("texshot compress --format "), {
            "dxt1", "dxt1a", "dxt3", "dxt5", "bc4", "bc5", "bc1", "bc1a", "bc2", "bc3", "ati1", "ati2", "rgtc1", "rgtc2"})
        self.assertIn("trilinear", self.offered("texshot conform --feature "))
        self.assertEqual(self.offered("texshot --completion "), {"bash", "zsh", "fish"})

    def test_joined_choices(self):
        self.assertEqual(self.offered("texshot shot --ui --compare fixed,sha"), {"fixed,shader"})
        self.assertEqual(self.offered("texshot shot --renderer fixed,sha"), {"fixed,shader"})
        self.assertIn("no-s3tc,units=", self.offered("texshot probe --pretend no-s3tc,u"))

    def test_parameters(self):
        params = results(self.succeeds("params", "--json"))
        lists = {"points", "colors", "texCoords", "indices", "list"}
        paths = {each["path"].replace("[]", "[0]") + "=" for each in params if each["kind"] not in lists}
        self.assertGreater(len(paths), 150)
        self.assertEqual(self.offered("texshot shot --set "), paths)
        self.assertEqual(self.offered("texshot shot a.json --set textures[3].minF"), {"textures[3].minFilter="})
        self.assertEqual(self.offered("texshot shot --set passes[1].units[2].texGenS.mo"),
                         {"passes[1].units[2].texGenS.mode="})
        for path, start in (("textures[1].minFilter", ""), ("textures[0].wrapS", "GL_C"), ("view.projection", "")):
            row = next(each for each in params if each["path"] == re.sub(r"\d", "", path))
            expected = {f"{path}={each['name']}" for each in row["choices"] if each["name"].startswith(start)}
            self.assertGreater(len(expected), 1)
            self.assertEqual(self.offered(f"texshot shot --set {path}={start}"), expected)
        self.assertEqual(self.offered("texshot shot --set light.twoSide="), {"light.twoSide=true", "light.twoSide=false"})
        self.assertEqual(self.offered("texshot shot --set view.azimuth="), set())
        self.assertEqual(self.offered("texshot shot --set nonsense[0].wr"), set())

    def test_files(self):
        for line in ("texshot info br", "texshot shot -o br", "texshot convert brick.dds br", "texshot shot --ui br"):
            self.assertEqual(self.offered(line), {"brick.dds"}, line)
        self.assertEqual(self.offered("texshot shot tw"), {"two words.json"})
        self.assertEqual({each.rstrip("/") for each in self.offered("texshot conform -o ")}, {"inner"})
        for line in ("texshot presets ", "texshot shot --size "):  # zsh then offers options
            self.assertEqual([each for each in self.offered(line) if not each.startswith("-")], [], line)

    def test_what_is_joined_by_an_equals_sign(self):
        self.assertEqual(self.offered("texshot shot --figure=env"), {"--figure=environments"})
        self.assertEqual(self.offered("texshot shot --out=br"), {"--out=brick.dds"})


class Bash(Shell):
    shell = "bash"

    def offered(self, line):
        words = words_for_bash(line)
        run = (f"source {shlex.quote(str(self.script))}\n"
               f"COMP_WORDS=({' '.join(map(shlex.quote, words))}) COMP_CWORD={len(words) - 1}\n"
               "complete -p texshot >/dev/null && _texshot && (( ${#COMPREPLY[@]} == 0 )) || printf '%s\\n' \"${COMPREPLY[@]}\"")
        result = subprocess.run(["bash", "--norc", "-c", run], capture_output=True, cwd=self.work, timeout=60)
        self.assertEqual((result.returncode, result.stderr), (0, b""), line)
        # Readline replaces the text after the last of COMP_WORDBREAKS.
        typed = line.rsplit(" ", 1)[1]
        kept = typed[: max(typed.rfind("="), typed.rfind(":")) + 1]
        return {kept + each for each in result.stdout.decode().splitlines()}

    def test_it_works_without_break_characters(self):
        """If the user removed = from COMP_WORDBREAKS, the whole word is offered."""
        run = (f"source {shlex.quote(str(self.script))}\nCOMP_WORDS=(texshot shot '--figure=env') COMP_CWORD=2\n"
               "_texshot; printf '%s\\n' \"${COMPREPLY[@]}\"")
        result = subprocess.run(["bash", "--norc", "-c", run], capture_output=True, timeout=60)
        self.assertEqual(result.stdout, b"--figure=environments\n")

    def test_its_syntax(self):
        for program in (TEXSHOT, TEXPLORER):
            script = subprocess.run([program, "--completion", "bash"], capture_output=True, timeout=60)
            self.assertEqual((script.returncode, script.stderr), (0, b""))
            checked = subprocess.run(["shellcheck", "-s", "bash", "-"], input=script.stdout,
                                     capture_output=True, timeout=120)
            self.assertEqual(checked.stdout.decode(), "")


class Fish(Shell):
    shell = "fish"

    def offered(self, line):
        run = f"source {shlex.quote(str(self.script))}; complete -C {shlex.quote(line)}"
        home = {**os.environ, "HOME": str(self.path), "XDG_CONFIG_HOME": str(self.path), "XDG_DATA_HOME": str(self.path)}
        result = subprocess.run(["fish", "--no-config", "-c", run], capture_output=True, cwd=self.work, env=home, timeout=60)
        self.assertEqual((result.returncode, result.stderr), (0, b""), line)
        return {each.split("\t")[0] for each in result.stdout.decode().splitlines()}


class Zsh(Shell):
    """Zsh completes only in its line editor, so it gets a terminal; compadd reports its arguments."""

    shell = "zsh"

    SPY = r"""
fpath=(%(script)s $fpath)
autoload -Uz compinit; compinit -u -D
compadd() {
    if [[ ${@[1,(i)(-|--)]} == *-(O|A|D)\ * ]]; then builtin compadd "$@"; return; fi
    local -a found
    builtin compadd -A found "$@"
    local before=$IPREFIX suffix= i
    for ((i = 1; i < $#; ++i)); do [[ $@[i] == -p ]] && before+=$@[i+1]; done
    (( $#found )) && print -rl -- $before$^found >>$OUT
    builtin compadd "$@"
}
bindkey '^I' complete-word
bindkey '^X' kill-whole-line
zstyle ':completion:*' completer _complete
done-with-it() { print -r -- END >>$OUT; zle kill-whole-line }
zle -N done-with-it; bindkey '^G' done-with-it
print -r -- READY >>$OUT
"""

    def setUp(self):
        super().setUp()
        self.out = self.path / "offered"
        self.out.touch()
        start = self.path / "start.zsh"
        start.write_text(self.SPY % {"script": shlex.quote(str(self.script.parent))})
        child, self.terminal = pty.fork()
        if child == 0:
            os.chdir(self.work)
            os.environ.update(OUT=str(self.out), TERM="dumb", HOME=str(self.path), ZDOTDIR=str(self.path))
            os.execlp("zsh", "zsh", "-f", "-i")
        self.addCleanup(os.waitpid, child, 0)
        self.addCleanup(os.close, self.terminal)  # which ends it
        self.type(f"source {shlex.quote(str(start))}\n")
        self.await_line("READY")

    def type(self, text):
        os.write(self.terminal, text.encode())

    def await_line(self, last):
        for _ in range(60 * 50):
            while select.select([self.terminal], [], [], 0.02)[0]:  # it blocks until its output is read
                os.read(self.terminal, 65536)
            lines = self.out.read_text().splitlines()
            if last in lines:
                self.out.write_text("")
                return lines[: lines.index(last)]
        self.fail(f"zsh said nothing: {self.out.read_text()}")

    def offered(self, line):
        self.type(line + "\t\a")  # the tabulator, and ^G when that is done
        offers = self.await_line("END")
        return {each.replace("\\", "") for each in offers}


class Calls(Texshot):
    def test_wrong_calls(self):
        self.complains(2, "--completion: expected one of bash, zsh, fish, found \"nu\"", "--completion", "nu")
        self.complains(2, "--completion: expected a value, found none", "--completion")
        self.complains(2, "--completion: expected no further argument, found \"a\"", "--completion", "bash", "a")
        self.assertEqual(self.succeeds("--completion=fish"), self.succeeds("--completion", "fish"))


if __name__ == "__main__":
    unittest.main()
