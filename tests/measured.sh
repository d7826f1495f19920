# shellcheck shell=bash disable=SC2154
# measured.sh - tap.sh, and what the tests of pages with measured figures ask of each: docs/measured/NAME.md, which
# shows the plots in docs/measured/NAME.
#
#     measured=NAME
#     . "$(dirname "$0")/../measured.sh"
. "$(dirname "${BASH_SOURCE[0]}")/tap.sh"
page=docs/measured/$measured.md

shown() { grep -o "]($measured/[a-z0-9_-]*\.svg)" "$1" | sed 's/.*\///; s/)//' | sort; }
well_formed() { # ELEMENT FILE...: each file has such elements
    python3 -c '
import sys, xml.dom.minidom as x
for f in sys.argv[2:]:
    assert x.parse(f).getElementsByTagName(sys.argv[1]), "%s: no %s" % (f, sys.argv[1])' "$@"
}
all_shown() { diff <(shown "$1") <(basename -a "docs/measured/$measured"/* | sort); }

# plots_hold ELEMENT: the page shows all plots, and each has such elements
plots_hold() {
    check "every plot is shown, and every plot shown exists" all_shown "$page"
    check "plots are well-formed and have their $1" well_formed "$1" "docs/measured/$measured"/*.svg
}

# planted NAME WORDS SED COMMAND...: in the long form, the command, given the page as SED changes it, fails and prints
# the words
planted() {
    local what=$1 words=$2 change=$3
    shift 3
    sed "$change" "$page" >"$scratch/planted.md"
    detects "$what" "$words" "$@" "$scratch/planted.md"
}
