#!/usr/bin/env python3
"""onefile_browser.py - opens what make docs wrote in a browser: onefile_browser.py FILE FOLDER

It reads as a person does: follows every link, searches, changes light and dark, and makes the window narrow. Prints
what is wrong. The browser is a Chromium without a window, by WebDriver; its files are in FOLDER.
"""
import json
import os
import subprocess
import sys
import urllib.request

NOW = "const a = document.querySelector('main > article.now'); "
ENTER = "\ue007"
wrong = []


def same(name, want, got):
    if want != got:
        wrong.append(f"{name}: want {want}, got {got}")


class Browser:
    def __init__(self, profile):
        self.driver = subprocess.Popen(["chromedriver", "--port=0"], stdout=subprocess.PIPE,
                                       stderr=subprocess.DEVNULL, text=True)
        self.at = ""
        for line in self.driver.stdout:
            if "successfully on port" in line:
                self.at = f"http://127.0.0.1:{int(line.rsplit('port', 1)[1].strip(' .' + chr(10)))}/session"
                break
        options = {"args": ["--headless=new", "--no-sandbox", "--disable-gpu", "--hide-scrollbars",
                            "--disable-dev-shm-usage", "--disable-ipc-flooding-protection",
                            f"--user-data-dir={profile}"]}
        said = self.call("POST", "", {"capabilities": {"alwaysMatch": {
            "goog:chromeOptions": options, "timeouts": {"script": 3600000}}}})
        self.at += "/" + next(said[key] for key in said if key.startswith("session"))

    def call(self, method, path, body=None):
        data = json.dumps(body or {}).encode() if method == "POST" else None
        request = urllib.request.Request(self.at + path, data, {"Content-Type": "application/json"}, method=method)
        try:
            with urllib.request.urlopen(request) as answer:
                return json.load(answer)["value"]
        except urllib.error.HTTPError as refused:
            raise SystemExit(f"the browser refuses {path}: {refused.read().decode()}") from None

    def go(self, url):
        self.call("POST", "/url", {"url": url})

    def js(self, script, *args):
        return self.call("POST", "/execute/sync", {"script": script, "args": list(args)})

    def settled(self, script, *args):
        """The script's value, as soon as it is true; after many frames, whatever it is."""
        wait = ("const done = arguments[arguments.length - 1], all = [...arguments].slice(0, -1); let n = 0;"
                f"const f = function () {{ {script} }};"
                "(function look() { const v = f(...all);"
                " if (v || ++n > 300) done(v); else requestAnimationFrame(look); })();")
        return self.call("POST", "/execute/async", {"script": wait, "args": list(args)})

    def command(self, name, **params):
        return self.call("POST", "/goog/cdp/execute", {"cmd": name, "params": params})

    def window(self, width, height):
        self.command("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1,
                     mobile=False)

    def theme(self, name):
        self.command("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": name}])

    def type(self, *keys):
        taps = []
        for key in "".join(keys):
            taps += [{"type": "keyDown", "value": key}, {"type": "keyUp", "value": key}]
        self.call("POST", "/actions", {"actions": [{"type": "key", "id": "keys", "actions": taps}]})

    def quit(self):
        self.call("DELETE", "")
        self.driver.terminate()
        self.driver.wait()


def read(b, url):
    b.go(url)
    same("it opens at README", "readme", b.settled(NOW + "return a && a.id"))
    same("one page is seen", 1, b.js("return [...document.querySelectorAll('main > article')]"
                                     ".filter(a => a.getClientRects().length).length"))
    same("its pictures are shown", True, b.settled(
        "const all = [...document.images]; for (const one of all) one.loading = 'eager';"
        "return all.every(one => one.complete && one.naturalWidth)"))


def links(b):
    """Every place that a link names comes to the top of the window, in its page."""
    lost = b.call("POST", "/execute/async", {"args": [], "script": """
        const done = arguments[0], wrong = [];
        const all = [...new Set([...document.querySelectorAll('a[href^="#"]')].map(a => a.getAttribute('href')))];
        (function next(i) {
            if (i === all.length) return done(all.length > 500 ? wrong : ['only ' + all.length + ' links']);
            location.hash = all[i];
            const look = tries => {
                const e = document.getElementById(all[i].slice(1));
                const now = document.querySelector('main > article.now'), top = e && e.getBoundingClientRect().top;
                const end = Math.ceil(scrollY + innerHeight) >= document.documentElement.scrollHeight;
                if (e && e.closest('article') === now && (Math.abs(top - 68) < 60 || end)) return next(i + 1);
                if (tries) return requestAnimationFrame(() => look(tries - 1));
                wrong.push(all[i] + ' at ' + top);
                next(i + 1);
            };
            requestAnimationFrame(() => look(20));
        })(0);"""})
    same("every link within the file is followed", [], lost)


def look_up(b, url, words):
    b.go(url + "#readme")
    b.js("document.getElementById('words').value = ''; document.activeElement.blur()")
    b.type("/", words)


def search(b, url):
    for words, page in [("bullet.fire", "#reference-api"), ("motion programs", "#guide-04-motion")]:
        look_up(b, url, words)
        same(f'"{words}" is found', True, b.settled(
            "const a = document.querySelector('#found:not([hidden]) a[aria-selected=true]');"
            "return !!a && a.getAttribute('href').startsWith(arguments[0])", page))
    b.type(ENTER)
    same("Enter opens the page", "guide-04-motion", b.settled(NOW + "return a.id === 'guide-04-motion' && a.id"))
    same("the words are marked", True, b.js("return CSS.highlights.get('found').size > 0"))
    look_up(b, url, "zzyzx")
    same("no section has an unknown word", "No section has this word.", b.settled(
        "const p = document.querySelector('#found:not([hidden]) p'); return p && p.textContent"))


def looks(b, url):
    shade = "return getComputedStyle(document.body).backgroundColor"
    b.theme("dark")
    b.go(url + "#guide-05-patterns")
    dark = b.js(shade)
    b.theme("light")
    same("light and dark are the system's", True, b.js(shade) != dark)
    b.js("document.getElementById('theme').click()")
    same("the button changes it", dark, b.js(shade))
    b.window(360, 740)
    b.js("document.getElementById('menu').click()")
    b.js("document.querySelector('#contents li[data-page=cookbook] a').click()")
    same("the contents open a page", "cookbook", b.settled(NOW + "return a.id === 'cookbook' && a.id"))


def main():
    url, folder = "file://" + os.path.abspath(sys.argv[1]), sys.argv[2]
    b = Browser(folder + "/profile")
    try:
        b.window(1400, 1000)
        b.theme("light")
        read(b, url)
        links(b)
        search(b, url)
        looks(b, url)
    finally:
        b.quit()
    print("\n".join(wrong))
    return bool(wrong)


sys.exit(main())
