#!/usr/bin/env bash
# compare.sh - make compare: bytes and times of a game on this engine and on another; here on this one twice.
. "$(dirname "$0")/../tap.sh"

compare() { tools/compare/compare.sh "$@"; }
refuse "nothing to compare with" "make compare BASE=COMMIT" compare ""
refuse "no such commit" '"never" is neither a commit nor a folder' compare never
refuse "a folder without an engine" "docs is no checkout" compare docs
refuse "a folder without a game" "docs is no game" compare . docs

for n in 3 1 5; do
    printf 'base ram 100\nhere ram 150\nbase load_ns %d000000\nhere load_ns %d000000\n' $n $((3 * n)) # 3 times as long
done >"$scratch/figures"
echo 'here frame_ns 7' >>"$scratch/figures"
awk -f tools/compare/table.awk "$scratch/figures" >"$scratch/table"
same "medians, and the ratio of the rounds" "RAM, bytes 100 150 1.500|load, ms 3.000 9.000 3.000|" \
    "$(sed 1d "$scratch/table" | tr -s ' ' | tr '\n' '|')"

if [ "$OUT" = build/release ]; then
    itself() { ROUNDS=1 FRAMES=120 COUNT=none compare . examples/first "" >"$scratch/itself"; }
    check "this engine beside itself" itself
    for row in "ROM, bytes" "RAM, bytes" "Lua heap when loaded" "Lua heap at the end" "snapshot at the end" \
        "bullets at the end" "load, ms" "frame with picture"; do
        check "a row: $row" grep -q "^$row" "$scratch/itself"
    done
    same "each of bytes is the same, to the byte" 5 "$(grep -c 'bytes .* 1\.000$' "$scratch/itself")"
fi
finish
