#!/usr/bin/env python3
"""make_page.py PROGRAM ROOT SOURCE PAGE: puts the folder together that a web server serves.

PROGRAM is texplorer.wasm, ROOT what packaging/web.sh has made, SOURCE the checkout. PAGE is replaced.
"""
import hashlib
import pathlib
import shutil
import subprocess
import sys
import tempfile

FONTS = pathlib.Path("/usr/share/fonts/truetype")
# Latin, Greek and Cyrillic, punctuation, currencies, arrows, mathematics, boxes, shapes and symbols.
LETTERS = ("U+0020-052F,U+1E00-1EFF,U+2000-20BF,U+2100-22FF,U+2300-23FF,U+2460-24FF,U+2500-27BF,U+2B00-2BFF,"
           "U+FFFD")


def subset(font, out, *letters):
    """Only these letters, without hints and features, which the program does not use."""
    subprocess.run(["/usr/bin/python3", "-m", "fontTools.subset", font, f"--output-file={out}", *letters,
                    "--no-hinting", "--layout-features=", "--desubroutinize", "--notdef-outline",
                    "--name-IDs=0,1,2", "--drop-tables+=GSUB,GPOS,GDEF,kern"], check=True, stderr=subprocess.DEVNULL)


def chinese_letters(source):
    texts = [*source.glob("assets/translations/zh*.po"), *source.glob("assets/lessons/*/zh*.po")]
    found = set("".join(path.read_text(encoding="utf-8") for path in texts))
    return "".join(sorted(each for each in found if ord(each) > 0x2E7F))


def main(program, root, source, page):
    program, root, source, page = map(pathlib.Path, (program, root, source, page))
    new = pathlib.Path(tempfile.mkdtemp(dir=page.parent, prefix=f"{page.name}-"))
    new.chmod(0o755)
    shutil.copytree(source / "app/web/page", new, dirs_exist_ok=True)
    for name in ("wasi", "reveal", "licences"):
        shutil.copytree(root / "share" / name, new / name)
    shutil.copy(source / "LICENSE", new / "licences/texplorer")
    shutil.copy(program, new / "texplorer.wasm")
    shutil.copy(source / "assets/texplorer.svg", new)
    (new / "fonts").mkdir()
    for name in ("DejaVuSans.ttf", "DejaVuSans-Bold.ttf", "DejaVuSansMono.ttf"):
        subset(FONTS / "dejavu" / name, new / "fonts" / name, f"--unicodes={LETTERS}")
    letters = new / "letters"
    letters.write_text(chinese_letters(source), encoding="utf-8")
    subset(FONTS / "droid/DroidSansFallbackFull.ttf", new / "fonts/Chinese.ttf", f"--text-file={letters}")
    letters.unlink()

    files = sorted(str(path.relative_to(new)) for path in new.rglob("*") if path.is_file())
    version = hashlib.sha256()
    for name in files:
        version.update(name.encode() + b"\0" + (new / name).read_bytes())
    # embed.json may be changed on the server; index.html is the folder itself; slides are an example.
    kept = [name for name in files if not name.startswith(("licences/", "reveal/", "slides."))
            and name not in ("worker.js", "embed.json", "index.html")]
    worker = (new / "worker.js").read_text()
    worker = worker.replace("@VERSION@", version.hexdigest()[:16]).replace("@FILES@", repr(["./", *kept]))
    (new / "worker.js").write_text(worker)
    for path in new.rglob("*"):
        path.chmod(0o755 if path.is_dir() else 0o644)
    shutil.rmtree(page, ignore_errors=True)
    new.rename(page)


if __name__ == "__main__":
    main(*sys.argv[1:])
