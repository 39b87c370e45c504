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
except ImportError:
    webdriver = None

MISSING = [what for what, there in (("Chromium", BROWSER), ("chromedriver", DRIVER), ("python3-selenium", webdriver)) if not there]


class Page:
    def __init__(self, profile, *flags, size="1366,768"):
        options = webdriver.ChromeOptions()
        options.binary_location = BROWSER
        for flag in ("--headless=new", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", "--lang=en", f"--window-size={size}", f"--user-data-dir={profile}", *flags):
            options.add_argument(flag)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
        self.driver = webdriver.Chrome(service=Service(DRIVER), options=options)

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
        ActionChains(self.driver).move_to_element(self.find(selector)).click_and_hold().move_by_offset(right // 2, down // 2).move_by_offset(
            right - right // 2, down - down // 2).release().perform()

    def keys(self, *keys):
        ActionChains(self.driver).send_keys(*keys).perform()

    def chord(self, key, letter):
        ActionChains(self.driver).key_down(key).send_keys(letter).key_up(key).perform()

    def script(self, text, *arguments):
        return self.driver.execute_script(text, *arguments)

    def complaints(self):
        """What the console has; the refusals of the server that a test asks for are none."""
        return [line["message"] for line in self.driver.get_log("browser") if "422" not in line["message"]]
