"""Chromium without a window, as the tests of pages drive it: by its DevTools and WebDriver."""

import io
import shutil
import time

from PIL import Image
from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.actions.action_builder import ActionBuilder
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys  # noqa: F401, for the tests

PATIENCE = 60  # seconds, of a machine that has much else to do


class Browser:
    def __init__(self, downloads):
        options = Options()
        options.binary_location = shutil.which("chromium")
        for argument in ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--hide-scrollbars",
                         "--force-color-profile=srgb", "--enable-unsafe-swiftshader", "--disable-background-networking"):
            options.add_argument(argument)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
        self.driver = webdriver.Chrome(options=options, service=Service(shutil.which("chromedriver")))
        self.driver.set_page_load_timeout(PATIENCE)
        self.driver.set_script_timeout(PATIENCE)
        self.tool("Page.setDownloadBehavior", behavior="allow", downloadPath=str(downloads))

    def tool(self, command, **arguments):
        return self.driver.execute_cdp_cmd(command, arguments)

    def size(self, width, height, phone=False):
        self.tool("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=phone)

    def media(self, scheme="light", kind=""):
        self.tool("Emulation.setEmulatedMedia", media=kind, features=[{"name": "prefers-color-scheme", "value": scheme}])

    def complaints(self):
        return [entry["message"] for entry in self.driver.get_log("browser") if entry["level"] in ("SEVERE", "WARNING")]

    def script(self, text, *arguments):
        return self.driver.execute_script(text, *arguments)

    def all(self, selector):
        return self.driver.find_elements(By.CSS_SELECTOR, selector)

    def one(self, selector):
        """Waited for: what a click brings may come after the click is over."""
        return self.wait(lambda: self.all(selector), selector)[0]

    def text(self, selector):
        return self.one(selector).text

    def texts(self, selector):
        return self.script("return [...document.querySelectorAll(arguments[0])].map((each) => each.textContent)", selector)

    def shown(self, selector):
        return [element for element in self.all(selector) if element.is_displayed()]

    def click(self, selector):
        self.one(selector).click()

    def keys(self, *keys):
        ActionChains(self.driver).send_keys(*keys).perform()

    def shift(self, *keys):
        ActionChains(self.driver).key_down(Keys.SHIFT).send_keys(*keys).key_up(Keys.SHIFT).perform()

    def wait(self, condition, what):
        """Until the condition gives something, which is returned."""
        end = time.monotonic() + PATIENCE
        while not (found := condition()):
            if time.monotonic() > end:
                raise AssertionError(f"waited {PATIENCE} s for {what}")
            time.sleep(0.02)
        return found

    def point(self, x, y, wheel=0):
        """Moves the mouse to a place of the window, and turns the wheel there."""
        if wheel:
            ActionChains(self.driver).scroll_from_origin(_origin(x, y), 0, wheel).perform()
            return
        actions = ActionBuilder(self.driver)
        actions.pointer_action.move_to_location(round(x), round(y))
        actions.perform()

    def drag(self, start, end):
        actions = ActionBuilder(self.driver)
        pointer = actions.pointer_action
        pointer.move_to_location(*map(round, start)).pointer_down()
        pointer.move_to_location(*(round((a + b) / 2) for a, b in zip(start, end)))
        pointer.move_to_location(*map(round, end)).pointer_up()
        actions.perform()

    def touch(self, *places):
        """A finger that goes down at the first place and up at the last one."""
        for i, (x, y) in enumerate(places):
            self.tool("Input.dispatchTouchEvent", type="touchMove" if i else "touchStart", touchPoints=[{"x": x, "y": y}])
        self.tool("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])

    def box(self, selector):
        return self.script("const box = document.querySelector(arguments[0]).getBoundingClientRect();"
                           "return [box.left, box.top, box.width, box.height]", selector)

    def screenshot(self):
        return Image.open(io.BytesIO(self.driver.get_screenshot_as_png())).convert("RGB")

    def quit(self):
        self.driver.quit()


def _origin(x, y):
    from selenium.webdriver.common.actions.wheel_input import ScrollOrigin
    return ScrollOrigin.from_viewport(round(x), round(y))
