# SPDX-License-Identifier: BSD-3-Clause
"""Headless Chromium for the tests of the page of `drill web`, and the bridge itself as a process."""
import base64
import contextlib
import os
import re
import shutil
import signal
import subprocess
import sys
import time

from rig_test import PATIENCE, wait_until

PROGRAMS = ("chromium", "chromedriver")


class Bridge:
    """What `drill web` starts, with the given words; `address`: as it has printed it."""

    def __init__(self, *words):
        self.process = subprocess.Popen([sys.executable, "-m", "drill_rig_sim.web_command", *words], stdout=subprocess.PIPE, text=True)
        line = self.process.stdout.readline()
        found = re.search(r"http://127\.0\.0\.1:\d+/[\w-]+/", line)
        if found is None:
            raise AssertionError("drill web has printed %r" % line)
        self.address = found.group()

    def close(self):
        self.process.terminate()
        self.process.wait(PATIENCE)
        self.process.stdout.close()


def chrome(width=1280, height=800, *more):
    """A browser window."""
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service
    options = webdriver.ChromeOptions()
    for word in ("--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--disable-gpu", "--force-device-scale-factor=1", *more):
        options.add_argument(word)
    options.binary_location = shutil.which("chromium")
    browser = webdriver.Chrome(service=Service(shutil.which("chromedriver")), options=options)
    resize(browser, width, height)
    return browser


def resize(browser, width, height, mobile=False):
    """To a page of this size [pixels]."""
    browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": mobile})


def picture(browser, name, folder=os.environ.get("DRILL_RIG_SIM_PICTURES")):
    """Saves what is seen, where there is a folder for it."""
    if folder:
        time.sleep(0.6)
        with open(os.path.join(folder, name + ".png"), "wb") as out:
            out.write(base64.b64decode(browser.execute_cdp_cmd("Page.captureScreenshot", {"format": "png"})["data"]))


def processes_below(pid):
    """Numbers of all that a process has started, and what those have."""
    children = subprocess.run(["pgrep", "-P", str(pid)], stdout=subprocess.PIPE, text=True, check=False).stdout.split()
    return [int(child) for child in children] + [one for child in children for one in processes_below(child)]


def processor_time(pid):
    """Of a process since its begin [s]; 0 where it has ended."""
    with contextlib.suppress(OSError), open("/proc/%d/stat" % pid, encoding="utf-8") as stat:
        words = stat.read().rpartition(")")[2].split()
        return (int(words[11]) + int(words[12])) / os.sysconf("SC_CLK_TCK")
    return 0.0


def draws_pages(pid):
    with contextlib.suppress(OSError), open("/proc/%d/cmdline" % pid, "rb") as words:
        return b"--type=renderer" in words.read()
    return False


def renderers_of(browser):
    """Numbers of the processes that draw pages, for hung(): to find them takes long on a loaded machine."""
    renderers = [pid for pid in processes_below(browser.service.process.pid) if draws_pages(pid)]
    assert renderers, "Chromium has no process that draws pages"
    return renderers


@contextlib.contextmanager
def hung(renderers):
    """Pages hang for as long as it lasts. The browser may not be asked for anything meanwhile: it would wait."""
    for pid in renderers:
        os.kill(pid, signal.SIGSTOP)
    try:
        yield
    finally:
        for pid in renderers:
            os.kill(pid, signal.SIGCONT)


def paper(browser):
    """The page as it would be printed: a PDF's bytes."""
    return base64.b64decode(browser.execute_cdp_cmd("Page.printToPDF", {"printBackground": True, "preferCSSPageSize": True})["data"])


BLANK_CHARTS = """
return [...document.querySelectorAll(".sheet:not(.empty)")].filter((sheet) => [...sheet.querySelectorAll("canvas")].some((canvas) =>
  canvas.width < 20 || canvas.height < 100 || !canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data.some((one) => one)))
  .map((sheet) => sheet.id);
"""


@contextlib.contextmanager
def on_paper(browser):
    """The page as it stands while it is printed."""
    browser.execute_script("window.dispatchEvent(new Event('beforeprint'))")
    try:
        yield
    finally:
        browser.execute_script("window.dispatchEvent(new Event('afterprint'))")


def blank_charts(browser):
    """Sheets that have something to show, and a chart without anything on it."""
    return browser.execute_script(BLANK_CHARTS)


class Page:
    """The page in a browser."""

    def __init__(self, browser, address):
        self.browser = browser
        browser.get(address)

    def one(self, selector):
        return self.browser.find_element("css selector", selector)

    def text(self, selector):
        return self.browser.execute_script("const e = document.querySelector(arguments[0]); return e ? e.textContent : ''", selector)

    def click(self, selector):
        self.one(selector).click()

    def figure(self, name):
        """A large number; None where it is empty."""
        text = self.text("#number_%s .figure" % name)
        return float(text) if re.fullmatch(r"-?[\d.]+", text) else None

    def wait_text(self, selector, pattern, patience=3.0 * PATIENCE):
        """The match, once it is there."""
        try:
            return wait_until(lambda: re.search(pattern, self.text(selector)), "%s in %s" % (pattern, selector), patience)
        except AssertionError as error:
            raise AssertionError("%s, which has %r" % (error, self.text(selector))) from None

    def remember(self, selector):
        """From now on every text of an element is kept, with the classes of the whole page and its clock, however short it stands."""
        self.browser.execute_script("""
            const element = document.querySelector(arguments[0]), clock = document.querySelector("#clock"), seen = window.seen = [];
            const watch = new MutationObserver(() => seen.push([element.textContent, document.body.className, clock.textContent]));
            watch.observe(element, { childList: true, characterData: true, subtree: true });
            watch.observe(document.body, { attributeFilter: ["class"] });""", selector)

    def remembered(self):
        """Rows of text, classes, clock."""
        return self.browser.execute_script("return window.seen")

    def fill(self, selector, text):
        script = "const [box, text] = arguments; box.value = text; box.dispatchEvent(new Event('input'));"
        self.browser.execute_script(script, self.one(selector), text)

    def errors(self):
        """What the browser complains of since it was asked last."""
        return [entry["message"] for entry in self.browser.get_log("browser") if entry["level"] == "SEVERE"]

    def cut(self, selector):
        """Texts below it that their boxes do not show whole."""
        return self.browser.execute_script("""
            return [...document.querySelectorAll(arguments[0] + " *")].filter((e) => e.scrollWidth > e.clientWidth + 1 && e.clientWidth > 0)
              .map((e) => e.textContent);""", selector)

    def coloured(self, selector):
        """How many pixels of a canvas are not empty."""
        return self.browser.execute_script("""
            const c = document.querySelector(arguments[0]), p = c.getContext("2d").getImageData(0, 0, c.width, c.height).data;
            let n = 0; for (let i = 3; i < p.length; i += 4) n += p[i] > 0; return n;""", selector)
