# SPDX-License-Identifier: GPL-3.0-or-later
"""A page in headless Chromium, by Selenium, with real clicks; nothing where one of them is missing."""
import shutil
import time
from contextlib import suppress

BROWSER = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
DRIVER = shutil.which("chromedriver")
try:
    from selenium import webdriver
    from selenium.common.exceptions import StaleElementReferenceException
    from selenium.webdriver.chrome.service import Service
    from selenium.webdriver.common.action_chains import ActionChains
    from selenium.webdriver.common.by import By
    from selenium.webdriver.common.keys import Keys  # noqa: F401
    from selenium.webdriver.support.ui import Select
except ImportError:
    webdriver = ActionChains = Keys = None

MISSING = [what for what, there in (("Chromium", BROWSER), ("chromedriver", DRIVER), ("python3-selenium", webdriver)) if not there]


class Page:
    def __init__(self, profile, *flags, size="1366,768"):
        options = webdriver.ChromeOptions()
        options.binary_location = BROWSER
        for flag in ("--headless=new", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", "--lang=en", f"--window-size={size}", f"--user-data-dir={profile}", *flags):
            options.add_argument(flag)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
        self.driver = webdriver.Chrome(service=Service(DRIVER), options=options)
        self.driver.set_script_timeout(120)  # a report draws for a while on a busy machine

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.driver.quit()

    def all(self, selector):
        return self.driver.find_elements(By.CSS_SELECTOR, selector)

    def find(self, selector, seconds=30):
        """The first element that is there and shown."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            with suppress(StaleElementReferenceException):
                for one in self.all(selector):
                    if one.is_displayed():
                        return one
            time.sleep(0.05)
        raise AssertionError(f"{selector} is not in the page: {self.text()[:2000]}")

    def click(self, selector):
        """One that the page draws anew meanwhile is looked for again."""
        for _ in range(20):
            try:
                return self.find(selector).click()
            except StaleElementReferenceException:
                time.sleep(0.05)

    def text(self, selector="body"):
        return self.script("return [...document.querySelectorAll(arguments[0])].map((one) => one.innerText).join('\\n')", selector)

    def drag(self, selector, right, down):
        """As click: one that the page draws anew before it is pressed is looked for again."""
        for _ in range(20):
            try:
                return ActionChains(self.driver).move_to_element(self.find(selector)).click_and_hold().move_by_offset(right // 2, down // 2).move_by_offset(
                    right - right // 2, down - down // 2).release().perform()
            except StaleElementReferenceException:
                time.sleep(0.05)

    def choose(self, selector, value):
        """The option of a list with a value, as a user chooses it."""
        Select(self.find(selector)).select_by_value(value)

    def click_in(self, selector, shapes, across, down):
        """A click in a picture, next to a place that is given by shares of what its shapes cover."""
        numbers = "one.getAttribute('d').match(/-?[\\d.]+/g).map(Number)"
        box = self.script(f"""const all = [...document.querySelectorAll(arguments[0])].flatMap((one) => {numbers});
          const x = all.filter((_, i) => i % 2 === 0), y = all.filter((_, i) => i % 2);
          return [Math.min(...x), Math.max(...x), Math.min(...y), Math.max(...y)];""", shapes)
        place = self.script("const box = arguments[0].getBoundingClientRect(); return [box.left, box.top];", self.find(selector))
        chain = ActionChains(self.driver)
        chain.w3c_actions.pointer_action.move_to_location(int(place[0] + box[0] + across * (box[1] - box[0]) + 1.5), int(place[1] + box[2] + down * (box[3] - box[2]) + 1.5)).click()
        chain.perform()

    def keys(self, *keys):
        ActionChains(self.driver).send_keys(*keys).perform()

    def chord(self, key, letter):
        ActionChains(self.driver).key_down(key).send_keys(letter).key_up(key).perform()

    def script(self, text, *arguments):
        return self.driver.execute_script(text, *arguments)

    def complaints(self):
        """What the console has; the refusals of the server that a test asks for are none."""
        return [line["message"] for line in self.driver.get_log("browser") if "422" not in line["message"]]
