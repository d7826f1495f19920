#!/usr/bin/env bash
# prove.sh - the proof programs in their sampled form: nothing is misrounded, in doubles and in integers, and
# every build gives the same results.
set -u
repo=$(cd "$(dirname "$0")/../.." && pwd)
scratch=${PROVE_SCRATCH:-}
CC=${CC:-cc}
FLAGS="-std=c11 -fwrapv -ffp-contract=off -D_DEFAULT_SOURCE"
LIBS="-lmpfr -lgmp -lm -pthread"
PROGRAMS="roots sines polar directions products"

# two COMMAND...: a word of standard input a run, two at a time.
two() { xargs -n 1 -P 2 "$@"; }

# make_program SOURCES PROGRAM TO FLAGS...: SOURCES holds src/base and tools/lab/prove.
make_program() {
    local tree=$1 program=$2 to=$3
    shift 3
    "$CC" $FLAGS "$@" "$tree/tools/lab/prove/$program.c" "$tree/src/base/trig.c" "$scratch/prove.o" \
        "$scratch/oracle.o" $LIBS -o "$to"
}

# The parts below are run by `two`, in processes of their own, in $scratch; what they say goes to files.
case ${1:-} in
--try) # PROGRAM: sampled, with doubles and with their integer twins
    for flag in -DPLAIN -DFX_INTEGER; do
        make_program "$repo" "$2" "$scratch/$2$flag" -O1 $flag >"$scratch/$2$flag.said" 2>&1 &&
            "$scratch/$2$flag" --sample --seed 1 >"$scratch/$2$flag.said" 2>&1 && touch "$scratch/$2$flag.good"
    done
    exit 0
    ;;
--digest) # COMPILER,FLAG,FLAG...
    read -r -a command <<<"${2//,/ }"
    "${command[@]}" -std=c11 -ffp-contract=off "$repo/tools/lab/prove/digest.c" "$repo/src/base/trig.c" -lm \
        -o "$scratch/digest-$2" &&
        "$scratch/digest-$2" --each >"$scratch/digest-$2.said" 2>&1
    exit 0
    ;;
esac

. "$repo/tests/tap.sh"
sandbox
export PROVE_SCRATCH=$scratch
self=$repo/tests/machine/prove.sh
for f in prove oracle; do
    "$CC" $FLAGS -O2 -c "$repo/tools/lab/prove/$f.c" -o "$scratch/$f.o" || { echo "Bail out! $f.c does not compile"
        exit 2; }
done
check "the oracles include nothing of src" sh -c \
    "! grep -n 'include.*src/' $repo/tools/lab/prove/oracle.[ch] $repo/tools/lab/prove/prove.[ch]"

printf '%s\n' $PROGRAMS | two "$self" --try
for program in $PROGRAMS; do
    for flag in -DPLAIN -DFX_INTEGER; do
        if [ -f "$program$flag.good" ]; then
            ok \
                "$program, sampled, $flag: $(awk '$3 ~ /^inputs/ { n += $2 } END { print n }' \
                "$program$flag.said") inputs, none misrounded"
        else
            not_ok "$program, sampled, $flag" "$(cat "$program$flag.said")"
        fi
    done
done

# A product that is rounded one unit too low.
mkdir -p wrong/src wrong/tools/lab
cp -r "$repo/src/base" wrong/src
cp -r "$repo/tools/lab/prove" "$repo/tools/lab/numbers.h" wrong/tools/lab
sed -i 's/(int64_t)a \* b + 0x8000)/(int64_t)a * b + 0x7fff)/' wrong/src/base/fx.h
make_program wrong products wrong/products -O1
detects "a product rounded down" "fx_mul" wrong/products --sample --seed 1 --only fx_mul

# Every build gives the same; the first is the one to compare with. The last but one must find no undefined behaviour,
# overflow included.
builds="gcc,-O0 gcc,-O3 clang,-O0 clang,-O3"
builds="$builds gcc,-O3,-DFX_INTEGER clang,-O0,-DFX_INTEGER clang,-O3,-DFX_INTEGER"
builds="$builds gcc,-O0,-DFX_NO_INT128 clang,-O3,-DFX_NO_INT128"
builds="$builds gcc,-O2,-DFX_INTEGER,-DFX_NO_INT128 gcc,-O1,-fsanitize=undefined,-fno-sanitize-recover=all"
builds="$builds gcc,-O1,-DFX_INTEGER,-fsanitize=undefined,-fno-sanitize-recover=all"
printf '%s\n' $builds | two "$self" --digest
for build in $builds; do
    same "the same results: ${build//,/ }" "$(cat digest-gcc,-O0.said)" "$(cat "digest-$build.said" 2>&1)"
done
finish
