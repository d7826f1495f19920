#!/usr/bin/env python3
"""onefile_browser.py - opens what make docs wrote in a browser: onefile_browser.py FILE FOLDER

It reads as a person does: follows every link, searches, changes light and dark, and makes the window narrow. TAP; and
pictures of it in FOLDER, to be looked at.
"""
import os
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from browser import Browser  # noqa: E402

NOW = "const a = document.querySelector('main > article.now'); "
count = failed = 0


def same(name, want, got):
    global count, failed
    count += 1
    if want == got:
        print(f"ok {count} - {name}")
    else:
        failed = 1
        print(f"not ok {count} - {name}\n# want: {want}\n# got:  {got}")


def first(b, *keys):
    """What the search finds first for what is typed."""
    b.type("/", *keys)
    return b.settled("const a = document.querySelector('#found:not([hidden]) a[aria-selected=true]');"
                     "return a && a.getAttribute('href')")


def read(b, url, folder):
    b.go(url)
    same("it opens at README", "readme", b.settled(NOW + "return a && a.id"))
    same("one page is seen", 1, b.js("return [...document.querySelectorAll('main > article')]"
                                     ".filter(a => a.getClientRects().length).length"))
    same("its pictures are shown", 0, b.settled(
        "const i = [...document.images]; for (const one of i) one.loading = 'eager';"
        "return i.every(one => one.complete) && i.filter(one => !one.naturalWidth).length + ''") and 0)
    same("and have a size", [], b.js("return [...document.images].filter(i => !i.naturalWidth).map(i => i.alt)"))
    same("nothing was fetched", [], b.js("return performance.getEntriesByType('resource').map(e => e.name)"
                                         ".filter(name => !name.startsWith('data:'))"))
    b.picture(os.path.join(folder, "readme.png"))


def links(b):
    """Every place that a link names comes to the top of the window, in its page."""
    wrong = b.call("POST", "/execute/async", {"args": [], "script": """
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
    same("every link within the file is followed", [], wrong)


def search(b, url, folder):
    for words, want in [("bullet.fire", "#reference-api/bulletfire"),
                        ("motion programs", "#guide-04-motion/motion-programs"),
                        ("homing shots", "#cookbook/homing-shots"), ("GRAZE line", None),
                        ("sizes", "#guide-03-bullets/sizes")]:
        b.go(url + "#readme")
        b.js("document.getElementById('words').value = ''; document.activeElement.blur()")
        got = first(b, words)
        same(f'"{words}" is found', want or got or "something", got)
    b.picture(os.path.join(folder, "search.png"))
    b.type("enter")
    same("Enter goes there", "guide-03-bullets", b.settled(NOW + "return a.id === 'guide-03-bullets' && a.id"))
    same("the contents show where", "Bullets", b.settled(
        "const n = document.querySelector('#contents a.now'); return n && n.textContent === 'Sizes' &&"
        "n.closest('ul').parentElement.querySelector('a').textContent"))
    same("what was looked for is marked", True, b.js("return CSS.highlights.get('found').size > 0"))
    b.type("/")
    b.js("document.getElementById('words').value = ''")
    b.type("zzyzx")
    same("what is nowhere is said", "No section has this word.", b.settled(
        "const p = document.querySelector('#found:not([hidden]) p'); return p && p.textContent"))
    b.type("escape")
    same("Escape closes the list", True, b.settled("return document.getElementById('found').hidden"))
    b.js("location.hash = '#?spiral'")
    same("a search can be linked to", True, b.settled("return document.querySelectorAll('#found a').length > 5"))
    b.type("down", "down", "up")
    same("arrows choose", 1, b.settled("const all = [...document.querySelectorAll('#found a')];"
                                       "return all.findIndex(a => a.getAttribute('aria-selected') === 'true')"))
    b.type("escape")


def looks(b, url, folder):
    shade = "return getComputedStyle(document.body).backgroundColor"
    b.theme("dark")
    b.go(url + "#guide-05-patterns")
    dark = b.js(shade)
    b.picture(os.path.join(folder, "dark.png"))
    b.theme("light")
    light = b.js(shade)
    same("light and dark are the system's", True, sum(map(int, dark[4:-1].split(","))) < 120 and
         sum(map(int, light[4:-1].split(","))) > 700)
    b.js("document.getElementById('theme').click()")
    same("the button changes it", dark, b.js(shade))
    b.js("document.getElementById('theme').click()")
    b.window(360, 740)
    wide = []
    for page in b.js("return [...document.querySelectorAll('main > article')].map(a => a.id)"):
        b.js("location.hash = '#' + arguments[0]", page)
        if b.settled(NOW + "return a.id === arguments[0] && document.documentElement.scrollWidth", page) != 360:
            wide.append(page)
    same("no page is wider than a narrow window", [], wide)
    b.go(url + "#features/bullets-and-motion")
    b.picture(os.path.join(folder, "narrow.png"))
    seen = "return getComputedStyle(document.getElementById('contents')).visibility"
    same("its contents are out of the way", "hidden", b.js(seen))
    b.js("document.getElementById('menu').click()")
    same("and come by the button", "visible", b.settled(seen.replace("return", "const v =") +
                                                        "; return v === 'visible' && v"))
    b.picture(os.path.join(folder, "contents.png"))
    b.js("document.querySelector('#contents li[data-page=cookbook] a').click()")
    same("a choice closes them", "hidden", b.settled(seen.replace("return", "const v =") +
                                                     "; return v === 'hidden' && v"))
    same("and opens the page", "cookbook", b.settled(NOW + "return a.id === 'cookbook' && a.id"))


def main():
    url, folder = "file://" + os.path.abspath(sys.argv[1]), sys.argv[2]
    os.makedirs(folder, exist_ok=True)
    b = Browser(tempfile.mkdtemp(dir=folder))
    try:
        b.window(1400, 1000)
        b.theme("light")
        read(b, url, folder)
        links(b)
        search(b, url, folder)
        looks(b, url, folder)
    finally:
        b.quit()
    print(f"1..{count}")
    return failed


sys.exit(main())
