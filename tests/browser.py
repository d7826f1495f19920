"""browser.py - a Chromium without a window, for tests: it opens a page, types, and says what the page is then.

Spoken to by WebDriver, which chromedriver understands; that and chromium are Debian's packages of these names.
"""
import base64
import json
import subprocess
import urllib.request

KEYS = {"enter": "\ue007", "down": "\ue015", "up": "\ue013", "escape": "\ue00c"}


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
        said = self.call("POST", "", {"capabilities": {"alwaysMatch": {"goog:chromeOptions": options}}})
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
        """Texts, or names of KEYS."""
        taps = []
        for key in "".join(KEYS.get(key, key) for key in keys):
            taps += [{"type": "keyDown", "value": key}, {"type": "keyUp", "value": key}]
        self.call("POST", "/actions", {"actions": [{"type": "key", "id": "keys", "actions": taps}]})

    def picture(self, path):
        with open(path, "wb") as f:
            f.write(base64.b64decode(self.call("GET", "/screenshot")))

    def quit(self):
        self.call("DELETE", "")
        self.driver.terminate()
        self.driver.wait()
