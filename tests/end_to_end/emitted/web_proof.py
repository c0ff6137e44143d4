"""A page that texshot emits, held against the reference by the rules of texshot conform."""

import json
import subprocess
from queue import SimpleQueue

from PIL import Image

from capture import PATIENCE, ProgramError
from proof import TIMES, Flavour, Proof

WEBGL = Flavour("webgl", "demo.html", "reference", 2)
# The share of a picture's pixels that nothing explains: less than the rules of conform allow, as judge_picture knows how
# SwiftShader draws. A floor that reaches far needs more bits than floats have (0.27 %); how one filters under anisotropy is left
# open, and only that it does so can be asked for (2.1 %).
ALLOWED = {"ellipse": 0.05}
WIDTH, HEIGHT = 320, 240  # of the window: what there is to see is there, too, in a quarter of the pixels of 640x480


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

    def compare(self, case, path, drawn, expected):
        asked = []
        for time, picture in zip(self.times, drawn):
            Image.fromarray(picture).convert("RGBA").save(path / f"program-{time}.png", compress_level=1)
            asked += [time, path / f"program-{time}.png", path / f"texshot-{time}.png"]
        done = subprocess.run([self.judge, case.file, case.file.parent, *asked], capture_output=True, text=True, timeout=PATIENCE)
        if done.returncode != 0:
            raise ProgramError(f"it can't be judged: {done.stderr}")
        wrong = []
        for time, line in zip(self.times, done.stdout.splitlines()):
            if sentence := refusal(line):
                self.run("compare", f"texshot-{time}.png", f"program-{time}.png", "--rgb", "--tolerance", str(self.flavour.bound),
                         "-o", f"difference-{time}.png", cwd=path)
                wrong.append(f"at {time} s {sentence}")
        if wrong:
            raise ProgramError("; ".join(wrong))


def refusal(line):
    """What a judgement has against a picture, or nothing."""
    judgement = json.loads(line)
    allowed = min(1 - judgement["explained"], ALLOWED.get(judgement["rule"], 0.005))
    if judgement["unexplained"] <= allowed * judgement["pixels"]:
        return ""
    return (f"{judgement['unexplained']} of {judgement['pixels']} pixels differ by more than {judgement['bound']}/255 and are not "
            f"explained by the rule {judgement['rule']}, which allows {allowed:.2%}; the worst differs by {judgement['max']}/255")
