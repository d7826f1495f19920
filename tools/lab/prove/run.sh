#!/usr/bin/env bash
# run.sh - make prove: runs the proof programs in full, one after the other, adds up their lines, and keeps what they
# said in docs/measured/proof.txt.
#
#     OUT=build/release tools/lab/prove/run.sh PROGRAM...
#
# The inputs found nearest to ties go to $OUT/prove/hard.inc, to be copied to hard.inc here when a function has changed.
# Exit 1: something was misrounded.
set -u
: "${OUT:=build/release}"
cd "$(dirname "$0")/../../.." || exit 2
dir=$OUT/prove failed=0
sed -n '/^\/\*/,/\*\//p' tools/lab/prove/hard.inc >"$dir/hard.new"
: >"$dir/said"
for program; do
    "$dir/$program" --hard "$dir/hard.new" | tee -a "$dir/said"
    [ "${PIPESTATUS[0]}" = 0 ] || { echo "prove: $program FAILED" | tee -a "$dir/said"; failed=1; }
done
# Of strides and of products, all are alike; of guesses, none is near a tie.
grep -v -e trig_stride -e trig_guess -e trig_turn -e fx_mul -e fx_lerp "$dir/hard.new" >"$dir/hard.inc"
summary=$(awk '$3 ~ /^inputs/ { functions++; inputs += $2; wrong += $4 }
    END {
        printf "prove: %d functions, %.0f inputs, %.0f misrounded\n", functions, inputs, wrong
        exit wrong > 0
    }' "$dir/said") || failed=1
{
    echo "$summary"
    echo "digest of all functions: $("$dir/digest")"
    echo
    echo "shapes against 256-bit integers:"
    "$dir/shapes" || echo "prove: shapes FAILED"
} | tee "$dir/end"
! grep -q FAILED "$dir/end" && [ $failed = 0 ] || exit 1
{
    echo "The last output of make prove. Each line has the number of inputs, the number misrounded, the largest error,"
    echo "the number of ties, the number of inputs near a tie and the nearest of them, and how the inputs were chosen."
    echo
    tools/docs/measured.sh
    cat "$dir/said" "$dir/end"
} | sed 's/ ([0-9.]* s)$//' >docs/measured/proof.txt
