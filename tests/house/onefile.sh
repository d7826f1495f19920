#!/usr/bin/env bash
# onefile.sh - make docs: README and docs/ as one HTML file, whole, with no link that leads nowhere. With CURTAIN_LONG=1
# a browser opens it (chromium, 400 MB, which make nightly installs).
. "$(dirname "$0")/../tap.sh"
pages=$repo/tools/docs/docs.sh
look=$repo/tests/house/onefile.py
made=$scratch/curtain.html

check "it is made" "$pages" -o "$made"
check "all pages, headings, pictures and links are there" "$look" "$made"
"$pages" -o "$scratch/again.html" >/dev/null
check "the same pages give the same bytes" cmp "$made" "$scratch/again.html"
check "each page says its file" grep -q 'data-file="docs/porting.md"' "$made"
coloured() { grep -qF "<span class=\"kd\">local</span>" "$made" || grep -qF '<span class="k">local</span>' "$made"; }
check "code is coloured" coloured
named() {
    grep -qE 'href="#api/patternring"><span' "$made" && ! grep -qE 'href="#api/wait">[^(]*</a> *(<[^>]*>)*=' "$made"
}
check "names in code lead to their entries, keys of tables do not" named

# Pages that say what is not so.
site() { # a small site in $scratch/site, with more on its page
    rm -rf "$scratch/site"
    mkdir -p "$scratch/site/docs/images"
    printf '# Curtain\n\n[there](docs/one.md#a-part)\n' >"$scratch/site/README.md"
    printf '# Changes\n\n## 1.2.3 (today)\n' >"$scratch/site/CHANGELOG.md"
    cp docs/images/testcard.png "$scratch/site/docs/images/"
    printf '# One\n\n## A part\n\n![a](images/testcard.png)\n\n%s\n' "$1" >"$scratch/site/docs/one.md"
    "$pages" --root "$scratch/site" -o "$scratch/site.html"
}
check "a page that no list names is there" site 'Words.'
refuse "planted: a link to no section" 'docs/one.md:7: a link to "#b-part": docs/one.md has no section "b-part"' \
    site '[b](#b-part)'
refuse "planted: a link to no page" 'docs/one.md:8: a link to "two.md": there is no docs/two.md' \
    site 'Words,
and [b](two.md).'
refuse "planted: a picture that is not there" 'docs/one.md:7: there is no picture docs/images/b.png' \
    site '![b](images/b.png)'
refuse "planted: HTML with another" 'there is no picture docs/c.png' site '<img src="c.png" alt="c">'

# Files that are not what the pages say.
spoilt() { # SED-EXPRESSION
    sed "$1" "$made" >"$scratch/spoilt.html"
    ! cmp -s "$made" "$scratch/spoilt.html" || { echo "nothing is spoilt"; return 0; }
    "$look" "$scratch/spoilt.html"
}
refuse "planted: a heading without its id" 'a link to "#manual/9-bosses", which is not there' \
    spoilt 's,<h2 id="manual/9-bosses">,<h2>,'
refuse "planted: two of one id" 'the id "manual/9-bosses" is there twice' \
    spoilt 's,<h2 id="manual/8-stages">,<h2 id="manual/9-bosses">,'
refuse "planted: a picture from elsewhere" '<img> fetches https://example.org/a.png' \
    spoilt 's,loading="lazy" src="data:image/svg[^"]*",src="https://example.org/a.png",'
refuse "planted: half a picture" 'a picture is not whole' \
    spoilt 's,\(src="data:image/png;base64\,[A-Za-z0-9+/]\{400\}\)[^"]*",\1",'
refuse "planted: a script from elsewhere" '<script> fetches' \
    spoilt 's,^<script>$,<script src="https://example.org/a.js">,'
refuse "planted: an open tag" 'is not closed' spoilt 's,</main>,,'
refuse "planted: a page is missing" 'docs/speed.md is not in it' spoilt 's,data-file="docs/speed.md",data-file="x",'
refuse "planted: a heading is missing" 'docs/manual.md: ' spoilt 's,<h2 id="manual/9-bosses">,<p id="manual/9-bosses">,'

if [ -n "${CURTAIN_LONG:-}" ]; then
    browse() { tests/house/onefile_browser.py "$1" "$scratch/pictures"; }
    check "a browser opens it, follows its links, searches" browse "$made"
    sed 's,  if (!wanted.length),  if (true),' "$made" >"$scratch/spoilt.html"
    refuse "planted: a search that finds nothing" 'not ok' browse "$scratch/spoilt.html"
    sed 's,else target.scrollIntoView();,,' "$made" >"$scratch/spoilt.html"
    refuse "planted: links that lead nowhere" 'every link within the file is followed' browse "$scratch/spoilt.html"
fi
finish
