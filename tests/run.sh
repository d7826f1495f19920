#!/usr/bin/env bash
# run.sh - runs test programs, as many at a time as there are cores, and counts every single test case.
#
#     OUT=build/release tests/run.sh check|test|all|torture|sanitizer [WORD...]
#
# check, test and all are the tiers of tests/tiers: C programs below $OUT/unit and $OUT/machine, and the scripts
# tests/{machine,cli,golden,lint}/*.sh. torture: what has torture in its name; sanitizer: the C programs, where any
# finding ends the program. all and torture run the long forms of tests (CURTAIN_LONG=1). With WORDs, only programs with
# one of them in their names run, of every tier.
#
# Every program prints TAP. A crash, a missing or wrong plan and a skipped test count as failed. A program's output
# stays in $OUT/results, and is shown, with the command that repeats the program, when something in it failed. all
# resumes: in an unchanged tree, what has passed is not run again. Tests that open a window mostly wait, so two of them
# run beside the others. Exit 1: something failed. No verdict depends on the time: a test hangs if it makes no progress
# (tests/patient.py), however slow the machine is.
set -u
cd "$(dirname "$0")/.." || exit 2
what=${1:-test}
export cpu OUT=${OUT:-build/release} CMOCKA_MESSAGE_OUTPUT=TAP LC_ALL=C
results=$OUT/results
cpu=900 # seconds of the processor's time without a line are a hang; see patient.py

# Reads a program's TAP and exit code; writes "passed failed".
count() {
    awk -v rc="$2" '
        /^1\.\.[0-9]+/ { plans++; planned += substr($1, 4) }
        /^(not )?ok([ \t]|$)/ {
            ran++
            if ($1 == "not" || toupper($0) ~ /# *(SKIP|TODO)/) failed++; else passed++
        }
        END {
            if (!plans || planned != ran) {
                print "# " (plans ? "planned " planned ", ran " ran + 0 : "no plan") >"/dev/stderr"
                failed++
            }
            if (rc != 0 && !failed) { print "# exit code " rc >"/dev/stderr"; failed++ }
            print passed + 0, failed + 0
        }' "$1" 2>>"$1.why"
}

# One program: its output, then its line. Lines of several programs do not mix: each is one write.
one() {
    local program=$1 name=${1#"$OUT/"} file
    name=${name#tests/}
    file=$results/${name//\//-}
    local from=${EPOCHREALTIME/./}
    LLVM_PROFILE_FILE=$PWD/$file.counts/%c%m.profraw tests/patient.py --cpu "$cpu" "$file" "./$program" # make coverage
    local rc=$? passed failed
    local took=$(((${EPOCHREALTIME/./} - from) / 100000))
    : >"$file.why"
    read -r passed failed < <(count "$file" $rc)
    echo "$passed $failed" >"$file.count"
    {
        printf '%-32s %5d passed' "$name" "$passed"
        [ "$failed" = 0 ] || printf ' %d FAILED' "$failed"
        printf ' %4d.%d s\n' $((took / 10)) $((took % 10))
        if [ "$failed" != 0 ]; then
            grep -avP '^ok (?!.*# *(SKIP|TODO))' "$file" | sed 's/^/    /'
            [ $rc -lt 128 ] || echo "    # killed by signal $((rc - 128))"
            sed 's/^/    /' "$file.why"
            echo "    repeat: make test ONLY=$name"
        fi
    } >"$file.line"
    cat "$file.line"
}

if [ "$what" = --one ]; then
    one "$2"
    exit 0
fi

shift
words=("$@")

# Does a program's name contain one of the words? Always, if there are none.
wanted() { # NAME
    local word
    [ ${#words[@]} != 0 ] || return 0
    for word in "${words[@]}"; do case $1 in *"$word"*) return 0 ;; esac; done
    return 1
}
tier_of() { # NAME: check, test or all
    local tier pattern
    while read -r tier pattern; do
        # shellcheck disable=SC2254
        case $1 in $pattern) echo "$tier" && return ;; esac
    done <<<"$tiers"
    echo test
}
tiers=$(grep -E '^(check|all) ' tests/tiers | sed 's/ *#.*//' | sort) # those of `all` first
in_tier() { # NAME
    [ ${#words[@]} = 0 ] || return 0
    case $what:$(tier_of "$1") in check:check | test:check | test:test | all:*) return 0 ;; esac
    return 1
}

programs=()
add() { # those of the globs that exist; what make built of a test that is gone is left out
    local f name
    for f in "$@"; do
        case $f in *.d | *.o) continue ;; esac
        [ -f "$f" ] || continue
        name=${f#"$OUT/"}
        name=${name#tests/}
        case $f in "$OUT"/*) [ -f "tests/$name.c" ] || continue ;; esac
        wanted "$name" && programs+=("$f")
    done
}
case $what in
check | test | all) # the longest first
    for f in tests/machine/*.sh "$OUT"/machine/test_* tests/golden/*.sh tests/cli/*.sh tests/lint/*.sh \
        "$OUT"/unit/test_*; do
        name=${f#"$OUT/"}
        ! in_tier "${name#tests/}" || add "$f"
    done
    [ "$what" != all ] || export CURTAIN_LONG=1
    ;;
torture)
    export CURTAIN_LONG=1
    cpu=3600
    add "$OUT"/unit/test_*torture* "$OUT"/machine/test_*torture* tests/machine/*torture*.sh
    ;;
sanitizer)
    export ASAN_OPTIONS=abort_on_error=1:detect_leaks=1:strict_string_checks=1 \
        LSAN_OPTIONS=suppressions=$PWD/tests/lsan.supp:print_suppressions=0 \
        UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1
    cpu=3600
    add "$OUT"/machine/test_* "$OUT"/unit/test_*
    ;;
*)
    echo "tests/run.sh: \"$what\" is none of check, test, all, torture, sanitizer" >&2
    exit 2
    ;;
esac

# In `all`, what has passed in the same tree is kept.
digest=""
[ "$what${words[*]}" != all ] || digest=$(tests/files.sh --digest)
if [ -z "$digest" ] || [ "$digest" != "$(cat "$results/tree" 2>/dev/null)" ]; then
    rm -rf "$results"
    mkdir -p "$results"
    [ -z "$digest" ] || echo "$digest" >"$results/tree"
fi
if [ ${#programs[@]} = 0 ]; then
    echo "tests/run.sh: no test${words:+ with \"${words[*]}\" in its name} below $OUT" >&2
    echo "0 passed, 1 failed"
    exit 1
fi
# at_once N PROGRAM...
at_once() {
    local n=$1
    shift
    [ $# = 0 ] || printf '%s\0' "$@" | xargs -0 -n 1 -P "$n" "$0" --one
}
has_passed() { # PROGRAM, in an earlier run
    local name=${1#"$OUT/"}
    grep -qs ' 0$' "$results/$(tr / - <<<"${name#tests/}").count"
}
windows=() others=()
for program in "${programs[@]}"; do
    ! has_passed "$program" || continue
    case $program in
    *.sh) if grep -q '/xserver\.sh"$' "$program"; then windows+=("$program"); else others+=("$program"); fi ;;
    *) others+=("$program") ;;
    esac
done
cores=$(nproc)
at_once 2 "${windows[@]}" &
at_once "$((cores > 2 ? cores : 2))" "${others[@]}"
wait
# A program whose count is missing was lost with its runner.
for program in "${programs[@]}"; do
    name=${program#"$OUT/"}
    name=${name#tests/}
    cat "$results/${name//\//-}.count" 2>/dev/null || echo "0 1"
done | awk '{ p += $1; f += $2 } END { print p + 0 " passed, " f + 0 " failed"; exit f > 0 }'
