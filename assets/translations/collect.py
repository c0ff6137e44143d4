#!/usr/bin/python3
"""Collects the English texts that Texplorer's window shows, and brings the catalogues up to date.

The texts of a lesson are those of its lesson.json; its catalogues, zh_CN.po and ru.po, stand beside it.

    collect.py            writes every LANGUAGE/NAME.po anew: what is translated stays, what is new is empty,
                          what the sources no longer have goes
    collect.py --check    says what is missing, superfluous or not translated, and fails where there is something

A text is a string literal of the sources that a reader sees: every key of a Sentence, "{0} of {1}"; and what has a space
or begins with a capital letter. Words without either are found where they stand in words(…), tr(…) or label(…).
"""
import json
import pathlib
import re
import sys

FOLDER = pathlib.Path(__file__).resolve().parent
ROOT = FOLDER.parent.parent
LANGUAGES = {"zh_CN": ("Chinese (simplified)", 1, "nplurals=1; plural=0;"),
             "ru": ("Russian", 3, "nplurals=3; plural=(n%10==1 && n%100!=11 ? 0 : n%10>=2 && n%10<=4 && "
                                  "(n%100<10 || n%100>=20) ? 1 : 2);")}

# Which catalogue has the texts of which sources: folders, or beginnings of files' names.
CATALOGUES = {
    "vocabulary": ["core/gl/", "core/preset/", "core/mesh/", "core/image/patterns/", "app/view/",
                   "core/scene/renderer.h", "core/scene/scene.h", "core/scene/sampler_state.h",
                   "core/lesson/example", "core/emit/flavour.h"],
    "parameters": ["core/scene/params/params"],
    "diagnosis": ["core/diagnosis/"],
    "explanation": ["core/reference/"],
    "window": ["app/ui/window/", "app/ui/widgets/", "app/ui/state/", "app/ui/services/", "app/ui/model/", "app/ui/files/", "app/ui/editor/", "app/ui/view/", "app/ui/language/", "app/stage/"],
    "panels": ["app/ui/parameters/", "app/ui/texture_space/", "app/ui/details/", "app/ui/explain/", "app/ui/levels/", "app/ui/timeline/", "app/ui/lesson/", "app/ui/code/",
               "app/screenshot/reports/lesson_", "app/screenshot/reports/step_programs"],
    "figures": ["app/ui/figures/"],
    "messages": ["core/base/", "core/files/", "core/text/", "core/codec/", "core/compare/difference", "core/image/",
                 "core/s3tc/", "core/texture/", "core/scene/", "core/sheet/", "core/animation/", "core/emit/",
                 "core/lesson/lesson_json", "core/lesson/strict_json", "core/lesson/lesson_files", "core/lesson/lesson_keys",
                 "core/lesson/lesson_scene", "app/animation/", "app/lettering/", "app/render/", "app/opengl/",
                 "app/explorer/"],
}

TOKEN = re.compile(r'//[^\n]*|/\*.*?\*/|R"(?P<d>\w*)\((?P<raw>.*?)\)(?P=d)"|"(?P<text>(?:[^"\\\n]|\\.)*)"'
                   r"|'(?:[^'\\]|\\.)'", re.S)
ESCAPES = {"n": "\n", "t": "\t", '"': '"', "\\": "\\", "0": "\0", "'": "'"}
# Calls whose literals no reader sees.
UNSEEN = re.compile(r'(\bitem|noteItem|noteBox|PushID|GetID|BeginChild|InvisibleButton|wasUsed|static_assert|assert|getenv|rule'
                    r'|CallRow|[cC]odeLine|emit|cStyle)\(\s*(std::string\()?$|#include\s*$|PictureText\{\s*$|extern\s*$|since\s*=\s*$')
ALWAYS = re.compile(r'\b(words|tr|label|unit|word|Sentence)\(\s*$')
PLACE = re.compile(r'\{\d(:[^{}]*)?\}')  # of a Sentence: "{0:.2f}"
# Of what writes programs: why it can't; the rest is C.
REFUSAL = re.compile(r'(\b(fail|refuse)\(|\bFailureWords \w+\{)[^;]*$')
PLURAL = re.compile(r'\bplural\(\s*$')


# One word for one thing: what a translation must not say, and what it says instead.
TERMS = {"zh_CN": {"滤波": "过滤", "回答": "答案", "探测点": "采样点", "眼坐标系": "眼坐标", "眼空间": "眼坐标", "最近点": "最邻近",
                   "mipmap 级别": "mip 级别"},
         "ru": {r"режим\w* повторения": "режим наложения", r"[Тт]екстурн\w+ блок": "текстурный модуль",
                r"рису\w+ эталон(ом)?\b": "эталонный рендерер"}}

PIECES = []  # (catalogue, source, text) of half sentences


def literals(source):
    """(text before it, literal) of each, those beside each other as one."""
    tokens = [m for m in TOKEN.finditer(source) if m.group("text") is not None or m.group("raw") is not None
              or m.group(0).startswith("'") is False]
    run, begin, end = "", None, None
    for match in tokens:
        comment = match.group("text") is None and match.group("raw") is None
        if comment:
            continue
        text = match.group("raw")
        if text is None:
            text = re.sub(r'\\(.)', lambda m: ESCAPES.get(m.group(1), m.group(1)), match.group("text"))
        between = re.sub(r'//[^\n]*', '', source[end:match.start()]) if end is not None else "x"
        if begin is not None and not between.strip():
            run += text
        else:
            if begin is not None:
                yield source[max(0, begin - 200):begin], run
            run, begin = text, match.start()
        end = match.end()
    if begin is not None:
        yield source[max(0, begin - 200):begin], run


def is_text(text):
    letters = PLACE.sub('', text)
    if not re.search(r'[a-z]{2}', letters) and not re.search(r'[A-Z][a-z]', letters):
        return False
    if re.match(r'^[~!(]*(gl|GL_|glu|#|float |int |void |vec[234]\b|uniform |const |GL[a-z]+ )', text) and not re.search(r'(?<![\w])[a-z]{3,}[,:]? [a-z]{1,}', text):
        return False
    if re.match(r'^gl[A-Z]\w*[({]', text):
        return False
    if re.match(r'^[\w./*\[\]{}-]*(\.\w+|\[\]\.\w+)$', text):  # a path of a parameter, a file's name
        return False
    if re.match(r'^[a-z][a-z ]*:[^ ]', text):  # what tests call a widget
        return False
    if re.match(r'^https?:|^/usr|^\{[a-z ]*\}$|^##|^</?!?[a-z]', text):  # and HTML
        return False
    return " " in text.strip() or bool(re.match(r'^s?[A-ZÀ-Þ][a-z]', text)) or text[-1:] in ".…"


def collect():
    """Catalogue → {key: (plural or None, [sources])}. A key belongs to the first catalogue that has it."""
    found = {name: {} for name in CATALOGUES}
    owner = {}
    for name, folders in CATALOGUES.items():
        for folder in folders:
            for path in sorted(p for p in (ROOT / folder).parent.rglob("*") if p.suffix in (".cpp", ".h", ".inl")
                               and str(p.relative_to(ROOT)).startswith(folder)):
                where = str(path.relative_to(ROOT))
                if any(where.startswith(other) for others in list(CATALOGUES.values())[:list(CATALOGUES).index(name)]
                       for other in others):
                    continue
                if path.name == "shader_source.cpp" or ("json" in path.name and name == "window"):
                    continue
                texts = list(literals(path.read_text()))
                for i, (before, text) in enumerate(texts):
                    line = before.rsplit("\n", 1)[-1]
                    plural = texts[i + 1][1] if PLURAL.search(before) else None
                    if where.startswith("core/emit/") and name == "messages" and not REFUSAL.search(before):
                        continue
                    if i > 0 and PLURAL.search(texts[i - 1][0]):
                        continue
                    if UNSEEN.search(before) or line.lstrip().startswith("#"):
                        continue
                    if not plural and not ALWAYS.search(before) and not PLACE.search(text) and not is_text(text):
                        continue
                    key = text.split("##")[0] if "##" in text else text
                    if not key.strip() or '\0' in key or not re.search('[A-Za-z]', PLACE.sub('x', key)) or key.startswith("<"):
                        continue
                    if key != key.strip() and not PLACE.search(key):  # a piece of something: what becomes of it is looked up
                        if " " in key.strip() and not re.match(r"^ (--|[•-] Texplorer)", key):
                            PIECES.append((name, where, key))
                        continue
                    home = owner.setdefault(key, name)
                    old = found[home].get(key, (None, []))
                    found[home][key] = (plural or old[0], old[1] + ([where] if where not in old[1] else []))
    return found


def texts_of_lesson(lesson):
    """What a reader sees of a lesson.json, in order."""
    yield from (lesson["title"], lesson["about"])
    if "source" in lesson:
        yield lesson["source"]
    for step in lesson["steps"]:
        yield from (step["title"], step["text"])
        if "fallback" in step:
            yield step["fallback"]["text"]
        if "try" in step:
            yield step["try"]
        if "match" in step:
            yield step["match"]["task"]
        if "predict" in step:
            yield step["predict"]["question"]
            yield from (answer["text"] for answer in step["predict"]["answers"])
            yield step["predict"]["reason"]
    for key in lesson.get("keys", []):
        yield key["label"]
        yield from (choice["label"] for choice in key.get("cycle", []))


def lessons():
    """As collect(): "lessons/NAME" → its texts."""
    found = {}
    for path in sorted(ROOT.glob("assets/lessons/*/lesson.json")):
        where = str(path.relative_to(ROOT))
        texts = texts_of_lesson(json.loads(path.read_text()))
        found["lessons/" + path.parent.name] = {text: (None, [where]) for text in texts}
    return found


def path_of(language, name):
    """Of a catalogue."""
    if name.startswith("lessons/"):
        return ROOT / "assets" / name / (language + ".po")
    return FOLDER / language / (name + ".po")


def unquote(line):
    text = line[line.index('"') + 1:line.rindex('"')]
    return re.sub(r'\\(.)', lambda m: ESCAPES.get(m.group(1), m.group(1)), text)


def read(path):
    """Key → list of forms, of a .po file. Fuzzy entries count as not translated."""
    entries, key, forms, last, fuzzy = {}, None, [], None, False
    for line in (path.read_text().splitlines() if path.exists() else []) + [""]:
        if line.startswith("#,"):  # python-brace-format lets msgfmt compare the placeholders
            fuzzy = "fuzzy" in line
        elif line.startswith("msgid "):
            key, last, forms = unquote(line), "key", []
        elif line.startswith("msgid_plural "):
            last = "plural"
        elif line.startswith("msgstr"):
            forms.append(unquote(line))
            last = "form"
        elif line.startswith('"'):
            if last == "key":
                key += unquote(line)
            elif last == "form":
                forms[-1] += unquote(line)
        elif not line and key is not None:
            if key and not fuzzy:
                entries[key] = forms
            key, fuzzy = None, False
    return entries


def quote(text):
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n").replace("\t", "\\t") + '"'


def write(path, language, entries, known):
    title, forms, plural = LANGUAGES[language]
    lines = ["# %s of Texplorer: %s." % (title, path.parent.name if path.stem == language else path.stem), 'msgid ""', 'msgstr ""',
             quote("Content-Type: text/plain; charset=UTF-8\n"), quote("Content-Transfer-Encoding: 8bit\n"),
             quote("Language: %s\n" % language), quote("Plural-Forms: %s\n" % plural), ""]
    for key, (plural_key, sources) in entries.items():
        lines += ["#: " + " ".join(sources)] + ["#, python-brace-format"] * bool(re.search(r"\{\w", key)) + ["msgid " + quote(key)]
        old = known.get(key, [])
        if plural_key:
            lines.append("msgid_plural " + quote(plural_key))
            lines += ["msgstr[%d] %s" % (i, quote(old[i] if i < len(old) else "")) for i in range(forms)]
        else:
            lines.append("msgstr " + quote(old[0] if old else ""))
        lines.append("")
    path.parent.mkdir(exist_ok=True)
    path.write_text("\n".join(lines))


def complaints(found):
    for language, (_, forms, _) in LANGUAGES.items():
        for name, entries in found.items():
            path = path_of(language, name)
            known = read(path)
            for key, (plural, _) in entries.items():
                texts = known.get(key)
                if not texts or not all(texts) or len(texts) != (forms if plural else 1):
                    yield "%s: not translated: %s" % (path.relative_to(ROOT), quote(key))
                for term, instead in TERMS[language].items() if name in CATALOGUES else ():
                    if any(re.search(term, text) for text in texts or []):
                        yield "%s: \"%s\" is called \"%s\": %s" % (path.relative_to(ROOT), term, instead, quote(key))
            for key in known:
                if key not in entries:
                    yield "%s: the sources no longer have %s" % (path.relative_to(ROOT), quote(key))
    for name, source, key in PIECES:
        if name != "messages":
            yield "%s: half a sentence can't be translated: %s" % (source, quote(key))


def main():
    found = {**collect(), **lessons()}
    if "--check" in sys.argv[1:]:
        said = list(complaints(found))
        print("\n".join(said[:60]))
        print("%d texts in %d languages, %d complaints" % (sum(map(len, found.values())), len(LANGUAGES), len(said)))
        return 1 if said else 0
    for language in LANGUAGES:
        everything = {}  # a text that moved to another catalogue stays translated
        for name in found:
            everything.update(read(path_of(language, name)))
        for name, entries in found.items():
            own = {**everything, **read(path_of(language, name))}
            write(path_of(language, name), language, entries, own)
    return 0


if __name__ == "__main__":
    sys.exit(main())
