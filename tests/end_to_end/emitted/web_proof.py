"""A page that texshot emits, held against the reference by the rules of texshot conform."""

import json
import subprocess
from pathlib import Path
from queue import SimpleQueue

from PIL import Image

from capture import PATIENCE, ProgramError
from proof import TIMES, Flavour, Proof

LESSONS = Path(__file__).parents[3] / "assets" / "lessons"
WEBGL = Flavour("webgl", "demo.html", "reference", 2)


class PagesProof(Proof):
    """In several browsers side by side."""

    def __init__(self, texshot, judge, browsers, keep, times=TIMES):
        super().__init__(texshot, WEBGL, None, keep, times)
        self.judge, self.free = judge, SimpleQueue()
        for each in browsers:
            self.free.put(each)

    def draw(self, path):
        browser = self.free.get()
        try:
            return browser.run(path / self.flavour.file, self.times)
        finally:
            self.free.put(browser)

    def expect(self, cases, folder):
        return {}  # the judge draws it

    def difference(self, case, scene, path, time, picture, expected):
        (path / "scene.json").write_text(json.dumps(scene))
        Image.fromarray(picture).convert("RGBA").save(path / "found.png")
        images = LESSONS / case.words[1] if "--lesson" in case.words else path
        done = subprocess.run([self.judge, path / "scene.json", images, time, path / "found.png"], capture_output=True, text=True,
                              timeout=PATIENCE)
        if done.returncode != 0:
            raise ProgramError(f"it can't be judged: {done.stderr}")
        judgement = json.loads(done.stdout)
        allowed = 1 - judgement["explained"]
        if judgement["unexplained"] <= allowed * judgement["pixels"]:
            return ""
        return (f"{judgement['unexplained']} of {judgement['pixels']} pixels differ by more than {judgement['bound']}/255 and are not "
                f"explained by the rule {judgement['rule']}, which allows {allowed:.2%}; the worst differs by {judgement['max']}/255")
