#!/usr/bin/env bash
# all.sh - make test-all: everything that can be tested here, part by part. A run that was stopped, or in which
# something failed, resumes: a part that has passed is not run again while no file of the repository changes.
#
#     FUZZ_SECONDS=600 tests/all.sh [PART...]      without arguments: all, in the order of `parts`
#
# One line a part: whether it passed, its time, and the file with all it said; of what failed, also its last lines. The
# same lines are in build/test-all/report. Exit 1: a part failed.
set -u
cd "$(dirname "$0")/.." || exit 2
parts="tests builds analyze walks asan ubsan monkey msan valgrind torture ports bulletml bare fuzz cross mutants"
out=build/test-all
export FUZZ_SECONDS=${FUZZ_SECONDS:-600}

run() { # PART
    case $1 in
    tests)
        make --no-print-directory -j"$(nproc)" build/curtain build/curtain-null programs tools \
            build/players/player.html build/players/curtain_libretro.so && tests/run.sh all
        ;;
    builds) tests/builds.sh ;;
    bare) tests/bare_root.sh ;;
    msan) tests/machine/uninitialised.sh whole ;;
    bulletml) make --no-print-directory deps-play-bulletml build/release/bulletml ;;
    *) make --no-print-directory "$1" ARGS= ;;
    esac
}

for part; do
    case " $parts " in *" $part "*) ;; *)
        echo "tests/all.sh: \"$part\" is none of $parts" >&2
        exit 2
        ;;
    esac
done
mkdir -p $out
digest=$(tests/files.sh --digest)
if [ "$digest" != "$(cat $out/tree 2>/dev/null)" ]; then
    rm -f $out/*.passed
    echo "$digest" >$out/tree
fi
failed=0
# shellcheck disable=SC2048
for part in ${*:-$parts}; do
    from=$SECONDS
    if [ ! -e $out/$part.passed ]; then
        if run "$part" >"$out/$part" 2>&1 </dev/null; then how=passed; else how=FAILED failed=1; fi
        line=$(printf '%-8s %s %6d s  %s' "$part" $how $((SECONDS - from)) "$out/$part")
        [ $how = FAILED ] || echo "$line" >$out/$part.passed
        echo "$line" >$out/$part.line
    fi
    cat $out/$part.line
    [ -e $out/$part.passed ] || tail -n 12 "$out/$part" | sed 's/^/    /'
done
for part in $parts; do cat $out/$part.line 2>/dev/null; done >$out/report
exit $failed
