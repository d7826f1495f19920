# measured.sh - tap.sh, and what the tests of pages with measured figures ask of each: docs/measured/NAME.md, which
# shows the plots in docs/measured/NAME.
#
#     measured=NAME
#     . "$(dirname "$0")/../measured.sh"
. "$(dirname "${BASH_SOURCE[0]}")/tap.sh"
page=docs/measured/$measured.md

shown() { grep -o "]($measured/[a-z0-9_-]*\.svg)" "$1" | sed 's/.*\///; s/)//' | sort; }
all_shown() { # PAGE HOW_MANY: those there are, and so many at least
    diff <(shown "$1") <(basename -a "docs/measured/$measured"/* | sort) && [ "$(shown "$1" | wc -l)" -ge "$2" ]
}
well_formed() { # HOW_MANY ELEMENT FILE...: each has so many of them at least
    python3 -c '
import sys, xml.dom.minidom as x
for f in sys.argv[3:]:
    n = len(x.parse(f).getElementsByTagName(sys.argv[2]))
    assert n >= int(sys.argv[1]), "%s: %d of %s" % (f, n, sys.argv[2])' "$@"
}

# plots_hold HOW_MANY LINES ELEMENT: the page shows all plots, so many at least, and each has so many of the elements
plots_hold() {
    local last
    last=$(shown "$page" | tail -n 1)
    check "every plot is shown, and every plot shown is there" all_shown "$page" "$1"
    grep -v "]($measured/$last)" "$page" >"$scratch/unshown.md"
    detects "a plot that is not shown" "> $last" all_shown "$scratch/unshown.md" "$1"
    check "plots are well-formed and hold their lines" well_formed "$2" "$3" "docs/measured/$measured"/*.svg
    sed "s/<$3 .*//" "docs/measured/$measured/$last" >"$scratch/$last"
    detects "a plot without its lines" "$last: 0 of $3" well_formed "$2" "$3" "$scratch/$last"
    sed '$d' "docs/measured/$measured/$last" >"$scratch/$last"
    detects "a plot that ends too early" "no element found" well_formed "$2" "$3" "$scratch/$last"
}

# planted NAME WORDS SED COMMAND...: the command, given the page as SED changes it, fails and says the words
planted() {
    local what="planted: $1" words=$2 change=$3
    shift 3
    sed "$change" "$page" >"$scratch/planted.md"
    if cmp -s "$page" "$scratch/planted.md"; then
        not_ok "$what" "nothing was planted"
        return
    fi
    refuse "$what" "$words" "$@" "$scratch/planted.md"
}
