#!/usr/bin/env bash
# onefile.sh - make docs: README and docs/ as one HTML file, whole, with no link that leads nowhere. With CURTAIN_LONG=1
# a browser opens it (chromium, 400 MB, which make test-all installs).
. "$(dirname "$0")/../tap.sh"
made=$scratch/curtain.html

check "it is made" tools/docs/docs.sh -o "$made"
whole() { # every page is there, and nothing is fetched
    local page
    for page in README.md CONTRIBUTING.md CHANGELOG.md $(tree 'docs/*.md'); do
        grep -qF "data-file=\"$page\"" "$made" || { echo "$page is not there"; return 1; }
    done
    ! grep -oE '(src=|url\()"?https?:[^"]*|<link[^>]*http[^>]*' "$made"
}
check "all pages are there, and nothing is fetched" whole
tools/docs/docs.sh -o "$scratch/again.html" >/dev/null
check "the same pages give the same bytes" cmp "$made" "$scratch/again.html"
check "code is coloured" grep -qE '<span class="kd?">local</span>' "$made"
check "names in code lead to their entries" grep -qE 'href="#reference-api/patternring"><span' "$made"

site() { # makes a small site whose page has this text
    mkdir -p "$scratch/site/docs/guide"
    printf '# Curtain\n\n[there](docs/guide/one.md#a-part)\n' >"$scratch/site/README.md"
    printf '# Changes\n\n## 1.2.3 (today)\n' >"$scratch/site/CHANGELOG.md"
    printf '# One\n\n## A part\n\n%s\n' "$1" >"$scratch/site/docs/guide/one.md"
    tools/docs/docs.sh --root "$scratch/site" -o "$scratch/site.html"
}
detects "a link to no section" 'docs/guide/one.md:5: a link to "#b-part": docs/guide/one.md has no section "b-part"' \
    site '[b](#b-part)'
! long || check "a browser opens it, follows its links, searches" tests/lint/onefile_browser.py "$made" "$scratch"
finish
