#!/usr/bin/env bash
# mutants.sh - plants each fault of tests/mutants.list in a copy of the tree, builds what it touches, and runs tests
# until one fails: first those named with the fault, then all C programs and the golden frames.
#
#     tests/mutants.sh [NUMBER...]      all, or only these of the list, counted from 1
#
# Two at a time. Ends with "N killed, N survived"; exit 1 if one survived, could not be planted or does not compile, or
# if a test fails without any fault (MUTANTS_ANYWAY=1: goes on with the others). MUTANTS_KEEP=1 keeps the copies.
set -u
cd "$(dirname "$0")/.." || exit 2
CONFIG=mutant
export LC_ALL=C CMOCKA_MESSAGE_OUTPUT=TAP OUT=build/mutant
cpu=200 # a test that takes so many seconds of the processor for a line has been made endless

# plant TREE NUMBER: prints "FILE: OLD -> NEW"; the programs named go to $TREE/programs
plant() {
    python3 - "$1" "$2" tests/mutants.list <<'END'
import sys
tree, number = sys.argv[1], int(sys.argv[2])
entries = [e for e in open(sys.argv[3], encoding="utf-8").read().split("\n\n") if not e.startswith("#")]
head, old, new = entries[number - 1].strip("\n").split("\n")
path, *programs = head.split()
old, new = old[2:], new[2:]
text = open(tree + "/" + path, encoding="utf-8").read()
open(tree + "/programs", "w").write("\n".join(programs) + "\n")
print("%s: %s  ->  %s" % (path, old, new))
if text.count(old) != 1:
    print("found %d times" % text.count(old))
    sys.exit(1)
open(tree + "/" + path, "w", encoding="utf-8").write(text.replace(old, new))
END
}
count() { grep -c '^- ' tests/mutants.list; }

# run TREE PROGRAM: its output stays in TREE/said
run() {
    (
        cd "$1" || exit 2
        case $2 in
        *.sh) tests/patient.py --cpu $cpu --asleep $cpu said "tests/$2" ;;
        *) tests/patient.py --cpu $cpu --asleep $cpu said "$OUT/$2" ;;
        esac
    )
}
# Every program a fault is tried against. The bench's tests and the spoilt files take long and look at what others do
# too.
programs() {
    ls tests/unit/test_*.c tests/machine/test_*.c | sed 's,^tests/,,;s,\.c$,,' | grep -v -e test_readers -e test_bench
    echo golden/run.sh
}
build() { # TREE TARGET...
    local tree=$1
    shift
    make --no-print-directory -s -C "$tree" CONFIG=$CONFIG "$@" >"$tree/said" 2>&1
}
target() { # PROGRAM: what make calls it
    case $1 in
    machine/library.sh) echo "$OUT/curtain-null $OUT/libcurtain.a $OUT/libcurtain.so" ;;
    *.sh) echo "$OUT/curtain-null $OUT/curtain-short" ;;
    *) echo "$OUT/$1" ;;
    esac
}

if [ "${1:-}" = --one ]; then
    base=$2 number=$3 tree=$2-$SLOT
    rm -rf "$tree"
    cp -a --reflink=auto "$base" "$tree"
    what=$(plant "$tree" "$number") || { echo "NOT PLANTED $number $what" | tee "$base/result-$number"; exit 0; }
    # shellcheck disable=SC2046
    for program in $(cat "$tree/programs") $(programs); do
        cat "$tree/tried" "$base/broken" 2>/dev/null | grep -qxF "$program" && continue
        echo "$program" >>"$tree/tried"
        if ! build "$tree" $(target "$program"); then
            # A fault in a script may show when the built-in game is packed; one in C must compile.
            if grep -qE '(error|warning):' "$tree/said"
                then echo "DOES NOT COMPILE $number $what: $(grep -m 1 error "$tree/said")"
                else echo "killed $number $what: by the build"; fi | tee "$base/result-$number"
            exit 0
        fi
        if ! run "$tree" "$program"; then
            by=$(grep -am 1 '^not ok' "$tree/said" | sed 's/^not ok *[0-9]* *-* *//')
            echo "killed $number $what: $program ${by:-(stopped)}" | tee "$base/result-$number"
            exit 0
        fi
    done
    echo "SURVIVED $number $what" | tee "$base/result-$number"
    exit 0
fi

scratch=$(mktemp -d)
[ -n "${MUTANTS_KEEP:-}" ] && echo "in $scratch" || trap 'rm -rf "$scratch"' EXIT
base=$scratch/tree
mkdir "$base"
git ls-files -co --exclude-standard -z | while IFS= read -r -d '' f; do
    [ ! -f "$f" ] || cp -a --parents "$f" "$base"
done
git init -q "$base" # tests list the tree's files by git
# What is built already need not be built again: the same objects, by the same flags.
mkdir -p build/mutant
cp -a build/mutant --parents "$base"
make --no-print-directory -s -j2 -C "$base" CONFIG=$CONFIG programs >"$base/said" 2>&1 || { cat "$base/said"; exit 1; }
rm -rf build/mutant
cp -a "$base/build/mutant" build/
echo "without a fault:"
numbers=("$@")
[ ${#numbers[@]} != 0 ] || mapfile -t numbers < <(seq "$(count)")
named() { # the scripts that are named with these faults
    grep -E '^[a-z]' tests/mutants.list | awk -v only="${numbers[*]}" '
        BEGIN { n = split(only, list, " "); for (i = 1; i <= n; i++) wanted[list[i]] = 1 }
        NR in wanted' | grep -oE ' [a-z]+/[a-z_]+\.sh'
}
for program in $( (programs && named) | sort -u); do
    run "$base" "$program" || { echo "$program fails without a fault:"; grep -av '^ok ' "$base/said" | head -20
        echo "$program" >>"$base/broken"; }
done
[ ! -f "$base/broken" ] || [ -n "${MUTANTS_ANYWAY:-}" ] || exit 1
echo "planting ${#numbers[@]} faults"
printf '%s\n' "${numbers[@]}" | xargs -n 1 -P 2 --process-slot-var=SLOT "$0" --one "$base"
killed=$(cat "$base"/result-* | grep -c '^killed')
survived=$((${#numbers[@]} - killed))
echo "$killed killed, $survived survived"
[ $survived = 0 ]
