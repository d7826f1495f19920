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
detects "a link to no section" \
    'docs/guide/one.md:7: a link to "#b-part": docs/guide/one.md has no section "b-part"' \
    site '[b](#b-part)'

if long; then
    browse() { tests/lint/onefile_browser.py "$1" "$scratch/pictures"; }
    check "a browser opens it, follows its links, searches" browse "$made"
    sed 's,else target.scrollIntoView();,,' "$made" >"$scratch/spoilt.html"
    detects "links that lead nowhere" 'every link within the file is followed' browse "$scratch/spoilt.html"
fi
finish
