"""Draws a page of WebGL into its canvas, in headless Chromium on SwiftShader, frame by frame."""

import base64
import shutil

import numpy
from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service

from capture import PATIENCE, ProgramError

# Runs before the page's own scripts. The clock is set by the test, frames are drawn on request and not at the screen's
# rate, the picture stays readable, and OpenGL errors are checked after each frame. The page may call
# requestAnimationFrame or not.
WATCH = """
(() => {
  const watch = window.texplorerWatch = {milliseconds: 0, contexts: [], errors: []};
  let frames = []; // that the page has asked for
  performance.now = () => watch.milliseconds;
  Date.now = () => watch.milliseconds;
  window.requestAnimationFrame = (callback) => frames.push(callback);
  const getContext = HTMLCanvasElement.prototype.getContext;
  HTMLCanvasElement.prototype.getContext = function (kind, attributes) {
    const context = getContext.call(this, kind, {...attributes, preserveDrawingBuffer: true});
    if (context && kind === "webgl2" && !watch.contexts.includes(context)) watch.contexts.push(context);
    return context;
  };
  window.addEventListener("error", (event) => watch.errors.push(event.message));
  window.addEventListener("unhandledrejection", (event) => watch.errors.push(String(event.reason)));
  const readPixels = (gl) => {
    const error = gl.getError();
    if (error !== gl.NO_ERROR) watch.errors.push("gl.getError says 0x" + error.toString(16).padStart(4, "0"));
    const names = [gl.PACK_ALIGNMENT, gl.PACK_ROW_LENGTH, gl.PACK_SKIP_ROWS, gl.PACK_SKIP_PIXELS];
    const packs = names.map((name) => gl.getParameter(name));
    const buffer = gl.getParameter(gl.PIXEL_PACK_BUFFER_BINDING);
    const framebuffer = gl.getParameter(gl.READ_FRAMEBUFFER_BINDING);
    names.forEach((name) => gl.pixelStorei(name, name === gl.PACK_ALIGNMENT ? 1 : 0));
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, null);
    const pixels = new Uint8Array(gl.drawingBufferWidth * gl.drawingBufferHeight * 4);
    gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, framebuffer);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, buffer);
    names.forEach((name, i) => gl.pixelStorei(name, packs[i]));
    let text = "";
    for (let i = 0; i < pixels.length; i += 32768) text += String.fromCharCode(...pixels.subarray(i, i + 32768));
    return {width: gl.drawingBufferWidth, height: gl.drawingBufferHeight, pixels: btoa(text)};
  };
  watch.picture = (seconds) => {
    watch.milliseconds = seconds * 1000;
    const asked = frames;
    frames = [];
    try {
      for (const callback of asked) callback(watch.milliseconds);
    } catch (error) {
      watch.errors.push(error.message);
    }
    const alarm = document.querySelector("[role=alert]:not([hidden])"); // where a page says what it can't
    if (alarm) watch.errors.push(alarm.textContent);
    return {picture: watch.contexts.length === 1 ? readPixels(watch.contexts[0]) : null, contexts: watch.contexts.length,
            errors: watch.errors};
  };
})();
"""


class Pages:
    """A browser, in which one page is open at a time."""

    def __init__(self, width=640, height=480):
        options = Options()
        options.binary_location = shutil.which("chromium")
        for argument in ("--headless=new", "--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
                         "--disable-dev-shm-usage", "--hide-scrollbars", "--force-color-profile=srgb", "--disable-background-networking"):
            options.add_argument(argument)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
        self.driver = webdriver.Chrome(options=options, service=Service(shutil.which("chromedriver")))
        self.driver.set_page_load_timeout(PATIENCE)
        self.driver.set_script_timeout(PATIENCE)
        self.driver.execute_cdp_cmd("Page.addScriptToEvaluateOnNewDocument", {"source": WATCH})
        self.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                                    {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False})

    def quit(self):
        self.driver.quit()

    def run(self, page, times=(0,)):
        """The red, green and blue at these times, as arrays of rows, the top one first."""
        self.driver.get_log("browser")  # of a page that failed
        self.driver.get(page.resolve().as_uri())
        pictures = [self.picture(seconds) for seconds in (times[0], *times)]
        said = [entry["message"] for entry in self.driver.get_log("browser")]
        if said:
            raise ProgramError(f"the console says: {said}")
        if not numpy.array_equal(pictures[0], pictures[1]):
            raise ProgramError("its second frame differs from the first")
        return pictures[1:]

    def picture(self, seconds):
        found = self.driver.execute_script("return window.texplorerWatch.picture(arguments[0])", float(seconds))
        if found["errors"]:
            raise ProgramError(f"it fails: {found['errors']}")
        if not found["picture"]:
            raise ProgramError(f"expected one canvas with WebGL 2, found {found['contexts']}")
        drawn = found["picture"]
        pixels = numpy.frombuffer(base64.b64decode(drawn["pixels"]), numpy.uint8)
        return pixels.reshape(drawn["height"], drawn["width"], 4)[::-1, :, :3]
