#!/usr/bin/env bash
# mutants.sh - plants each fault of tests/mutants.list in a copy of the tree, builds what it touches, and runs tests
# until one fails: first those named with the fault, then all C programs and the golden frames.
#
#     tests/mutants.sh [--restart] [WORD...]     all, or only those whose line in the list contains one of the words
#     tests/mutants.sh --sample COUNT SEED       COUNT of them, chosen by SEED, to compare the tests of two commits
#     tests/mutants.sh --plantable               only says which cannot be planted
#
# Two at a time. Results are saved in build/mutants as they come, and a run that was stopped resumes there; a change of
# the tree (documents and the list aside) discards them, and so does --restart. Ends with "N killed, N survived", after
# the lines of those that survived; exit 1 if one survived, could not be planted or does not compile, or if a test fails
# without any fault (MUTANTS_ANYWAY=1: continues without that test). MUTANTS_KEEP=1 keeps the copies.
set -u
cd "$(dirname "$0")/.." || exit 2
CONFIG=mutant
export LC_ALL=C CMOCKA_MESSAGE_OUTPUT=TAP OUT=build/mutant
cpu=200 # a test that takes so many seconds of the processor for a line has been made endless
saved=$PWD/build/mutants

mutants() { # COMMAND [ARGUMENT...]
    local command=$1
    shift
    tests/mutants.py "$command" "${list:-tests/mutants.list}" "$@"
}

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
    *.sh) echo "$OUT/curtain-null $OUT/curtain-short $OUT/curtain" ;;
    *) echo "$OUT/$1" ;;
    esac
}

if [ "${1:-}" = --one ]; then # BASE NUMBER DIGEST
    base=$2 number=$3 digest=$4 tree=$2-$SLOT list=$2/tests/mutants.list
    finish() { # LINE: the result, whole or not at all
        echo "$1" | tee "$saved/$digest.new"
        mv "$saved/$digest.new" "$saved/$digest"
        exit 0
    }
    [ -d "$tree" ] || cp -a "$base" "$tree"
    # The file of the fault before is made new, so that make builds it again.
    [ ! -f "$tree/planted" ] || cp "$base/$(cat "$tree/planted")" "$tree/$(cat "$tree/planted")"
    rm -f "$tree/tried"
    what=$(mutants plant "$tree" "$number") || finish "NOT PLANTED $number $what"
    echo "${what%%:*}" >"$tree/planted"
    for program in $(mutants tests "$number") $(programs); do
        cat "$tree/tried" "$saved/broken" 2>/dev/null | grep -qxF "$program" && continue
        echo "$program" >>"$tree/tried"
        if ! build "$tree" $(target "$program"); then
            # A fault in a script may show when the built-in game is packed; one in C must compile.
            grep -qE '(error|warning):' "$tree/said" || finish "killed $number $what: by the build"
            finish "DOES NOT COMPILE $number $what: $(grep -m 1 error "$tree/said")"
        fi
        if ! run "$tree" "$program"; then
            by=$(grep -am 1 '^not ok' "$tree/said" | sed 's/^not ok *[0-9]* *-* *//')
            finish "killed $number $what: $program ${by:-(stopped)}"
        fi
    done
    finish "SURVIVED $number $what"
fi

if [ "${1:-}" = --plantable ]; then
    mutants plantable .
    exit
fi
mutants check || exit 1
if [ "${1:-}" = --restart ]; then
    rm -rf "$saved"
    shift
fi
tree_is=$(tests/files.sh | grep -vE '\.md$|^docs/|^tests/mutants' | tr '\n' '\0' | xargs -0 sha1sum | sha1sum)
if [ -d "$saved" ] && [ "$(cat "$saved/tree" 2>/dev/null)" != "$tree_is" ]; then
    echo "the tree has changed since the results in build/mutants: starting again"
    rm -rf "$saved"
fi
mkdir -p "$saved"
echo "$tree_is" >"$saved/tree"

mapfile -t wanted < <(mutants list "$@") # "NUMBER DIGEST" each
[ ${#wanted[@]} != 0 ] || { echo "no line of tests/mutants.list contains: $*"; exit 1; }
todo=()
for one in "${wanted[@]}"; do [ -f "$saved/${one#* }" ] || todo+=("$one"); done
echo "${#wanted[@]} faults, $((${#wanted[@]} - ${#todo[@]})) of them done before"

if [ ${#todo[@]} != 0 ]; then
    scratch=$(mktemp -d)
    [ -n "${MUTANTS_KEEP:-}" ] && echo "in $scratch" || trap 'rm -rf "$scratch"' EXIT
    base=$scratch/tree
    mkdir "$base"
    tests/files.sh | tr '\n' '\0' | xargs -0 cp -a --parents -t "$base"
    # What is built already need not be built again: the same objects, by the same flags.
    mkdir -p build/mutant
    cp -a build/mutant --parents "$base"
    make --no-print-directory -s -j2 -C "$base" CONFIG=$CONFIG programs >"$base/said" 2>&1 ||
        { cat "$base/said"; exit 1; }
    rm -rf build/mutant
    cp -a "$base/build/mutant" build/
    echo "without a fault:"
    named() { # the scripts that are named with these faults
        mutants tests $(printf '%s\n' "${todo[@]}" | cut -d ' ' -f 1) | grep '\.sh$'
    }
    for program in $( (programs && named) | sort -u); do
        cat "$saved/fine" "$saved/broken" 2>/dev/null | grep -qxF "$program" && continue
        run "$base" "$program" && { echo "$program" >>"$saved/fine"; continue; }
        echo "$program fails without a fault:"
        grep -av '^ok ' "$base/said" | head -20
        echo "$program" >>"$saved/broken"
    done
    if [ -f "$saved/broken" ] && [ -z "${MUTANTS_ANYWAY:-}" ]; then
        rm "$saved/broken" # it is tried again next time
        exit 1
    fi
    printf '%s\n' "${todo[@]}" | xargs -n 2 -P 2 --process-slot-var=SLOT "$0" --one "$base"
fi
results() { for one in "${wanted[@]}"; do cat "$saved/${one#* }"; done; }
results | grep -v '^killed'
killed=$(results | grep -c '^killed')
survived=$((${#wanted[@]} - killed))
echo "$killed killed, $survived survived"
[ $survived = 0 ]
