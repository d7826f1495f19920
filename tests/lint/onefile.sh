#!/usr/bin/env bash
# onefile.sh - make docs: README and docs/ as one HTML file, whole, with no link that leads nowhere. With CURTAIN_LONG=1
# a browser opens it (chromium, 400 MB, which make test-all installs).
. "$(dirname "$0")/../tap.sh"
pages=$repo/tools/docs/docs.sh
look=$repo/tests/lint/onefile.py
made=$scratch/curtain.html

check "it is made" "$pages" -o "$made"
check "all pages, headings, pictures and links are there" "$look" "$made"
"$pages" -o "$scratch/again.html" >/dev/null
check "the same pages give the same bytes" cmp "$made" "$scratch/again.html"
check "each page says its file" grep -q 'data-file="docs/internals/porting.md"' "$made"
coloured() { grep -qF "<span class=\"kd\">local</span>" "$made" || grep -qF '<span class="k">local</span>' "$made"; }
check "code is coloured" coloured
named() {
    grep -qE 'href="#reference-api/patternring"><span' "$made" &&
        ! grep -qE 'href="#reference-api/wait">[^(]*</a> *(<[^>]*>)*=' "$made"
}
check "names in code lead to their entries, keys of tables do not" named

# Pages that say what is not so.
site() { # a small site in $scratch/site, with more on its page
    rm -rf "$scratch/site"
    mkdir -p "$scratch/site/docs/images" "$scratch/site/docs/guide"
    printf '# Curtain\n\n[there](docs/guide/one.md#a-part)\n' >"$scratch/site/README.md"
    printf '# Changes\n\n## 1.2.3 (today)\n' >"$scratch/site/CHANGELOG.md"
    cp docs/images/testcard.png "$scratch/site/docs/images/"
    printf '# One\n\n## A part\n\n![a](../images/testcard.png)\n\n%s\n' "$1" >"$scratch/site/docs/guide/one.md"
    remake
}
remake() { "$pages" --root "$scratch/site" -o "$scratch/site.html"; }
check "a small site is made" site 'Words.'
lost() { site 'Words.' >"$scratch/said" && echo '# Two' >"$scratch/site/docs/two.md" && remake; }
detects "a page in no group" "docs/two.md: no group" lost
detects "a link to no section" \
    'docs/guide/one.md:7: a link to "#b-part": docs/guide/one.md has no section "b-part"' \
    site '[b](#b-part)'
detects "a link to no page" 'docs/guide/one.md:8: a link to "two.md": there is no docs/guide/two.md' \
    site 'Words,
and [b](two.md).'
detects "a picture that is not there" 'docs/guide/one.md:7: there is no picture docs/images/b.png' \
    site '![b](../images/b.png)'
detects "HTML with another" 'there is no picture docs/guide/c.png' site '<img src="c.png" alt="c">'

# Files that are not what the pages say.
spoilt() { # SED-EXPRESSION
    sed "$1" "$made" >"$scratch/spoilt.html"
    ! cmp -s "$made" "$scratch/spoilt.html" || { echo "nothing is spoilt"; return 0; }
    "$look" "$scratch/spoilt.html"
}
detects "a heading without its id" 'a link to "#guide-09-bosses/bosses", which is not there' \
    spoilt 's,<h1 id="guide-09-bosses/bosses">,<h1>,'
detects "two of one id" 'the id "guide-09-bosses/bosses" is there twice' \
    spoilt 's,<h1 id="guide-08-stages/stages">,<h1 id="guide-09-bosses/bosses">,'
detects "a picture from elsewhere" '<img> fetches https://example.org/a.png' \
    spoilt 's,loading="lazy" src="data:image/svg[^"]*",src="https://example.org/a.png",'
detects "half a picture" 'a picture is not whole' \
    spoilt 's,\(src="data:image/png;base64\,[A-Za-z0-9+/]\{400\}\)[^"]*",\1",'
detects "a script from elsewhere" '<script> fetches' \
    spoilt 's,^<script>$,<script src="https://example.org/a.js">,'
detects "an open tag" 'is not closed' spoilt 's,</main>,,'
detects "a page is missing" 'docs/measured/speed.md is not in it' \
    spoilt 's,data-file="docs/measured/speed.md",data-file="x",'
detects "a heading is missing" 'docs/guide/09-bosses.md: ' \
    spoilt 's,<h1 id="guide-09-bosses/bosses">,<p id="guide-09-bosses/bosses">,'

if [ -n "${CURTAIN_LONG:-}" ]; then
    browse() { tests/lint/onefile_browser.py "$1" "$scratch/pictures"; }
    check "a browser opens it, follows its links, searches" browse "$made"
    sed 's,  if (!wanted.length),  if (true),' "$made" >"$scratch/spoilt.html"
    detects "a search that finds nothing" 'not ok' browse "$scratch/spoilt.html"
    sed 's,else target.scrollIntoView();,,' "$made" >"$scratch/spoilt.html"
    detects "links that lead nowhere" 'every link within the file is followed' browse "$scratch/spoilt.html"
fi
finish
