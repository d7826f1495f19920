#!/usr/bin/env bash
# nightly.sh - make nightly: what takes too long for make test, part by part.
#
#     FUZZ_SECONDS=600 tests/nightly.sh [PART...]      without arguments: all, in the order of `parts`
#
# One line a part: whether it passed, its time, and the file with all it said. What fails is also shown, its last lines.
# Exit 1: a part failed.
set -u
cd "$(dirname "$0")/.." || exit 2
parts="analyze walks asan ubsan monkey msan valgrind torture screens browser library ports bulletml bare fuzz mutants"
out=build/nightly
export FUZZ_SECONDS=${FUZZ_SECONDS:-600}

# Every screen at every size, turned too, by keys and by a controller.
screens() {
    local t
    make --no-print-directory build/curtain || return
    for t in window_screens window_pads; do
        CURTAIN_LONG=1 tests/machine/$t.sh || return
    done
}
run() { # PART
    case $1 in
    msan) tests/machine/uninitialised.sh whole ;;
    screens) screens ;;
    library) CURTAIN_LONG=1 tests/machine/library.sh ;;
    bulletml) make --no-print-directory deps-play-bulletml && make --no-print-directory build/release/bulletml ;;
    bare) tests/bare_root.sh ;;
    browser) CURTAIN_LONG=1 tests/lint/onefile.sh ;;
    *) make --no-print-directory "$1" ARGS= ;;
    esac
}

for part in "$@"; do
    case " $parts " in *" $part "*) ;; *)
        echo "tests/nightly.sh: \"$part\" is none of $parts" >&2
        exit 2
        ;;
    esac
done
mkdir -p $out
failed=0
make --no-print-directory build/curtain-null >$out/build 2>&1 || { tail -n 20 $out/build; exit 1; }
for part in ${*:-$parts}; do
    from=$SECONDS
    if run "$part" >"$out/$part" 2>&1 </dev/null; then how=passed; else how=FAILED failed=1; fi
    printf '%-8s %s %6d s  %s\n' "$part" $how $((SECONDS - from)) "$out/$part"
    [ $how = passed ] || tail -n 12 "$out/$part" | sed 's/^/    /'
done
exit $failed
