#!/usr/bin/env bash
# compare.sh - make compare: bytes and times of a game on this engine and on another; here on this one twice.
. "$(dirname "$0")/../tap.sh"

compare() { tools/lab/compare/compare.sh "$@"; }
refuse "nothing to compare with" "make compare BASE=COMMIT" compare ""
refuse "no such commit" '"never" is neither a commit nor a folder' compare never
refuse "a folder without an engine" "docs is no checkout" compare docs

for n in 3 1 5; do
    printf 'base ram 100\nhere ram 150\nbase load_ns %d000000\nhere load_ns %d000000\n' $n $((3 * n)) # 3 times as long
done >"$scratch/figures"
echo 'here frame_ns 7' >>"$scratch/figures"
awk -f tools/lab/compare/table.awk "$scratch/figures" >"$scratch/table"
same "medians, and the ratio of the rounds" "RAM, bytes 100 150 1.500|load, ms 3.000 9.000 3.000|" \
    "$(sed 1d "$scratch/table" | tr -s ' ' | tr '\n' '|')"


# A row that is slower, one that is not, and one of too little time to be judged.
for k in 1 2 3; do
    echo "price a|$k|base|10000 2000" && echo "price a|$k|here|1${k}000 2000"
    echo "price b|$k|base|10000 500" && echo "price b|$k|here|10${k}00 900"
done >"$scratch/turns"
turns() { awk -v limit=1.03 "$@" -f tools/lab/compare/turns.awk "$scratch/turns"; }
same "the row that is slower is measured again" "price a" "$(turns -v want=slower)"
said() { turns | tr -s ' '; }
refuse "a slower row fails it" "1 of 3 figures are slower than 1.03 times" turns
same "its ratio is the rounds' median" "price a tick 10.00 12.00 1.200 0.050 SLOWER" "$(said | grep SLOWER)"
sed -i 's/|1[123]000 /|10000 /' "$scratch/turns"
check "without it all is well" turns

if [ "$OUT" = build/release ]; then
    itself() { ROUNDS=1 FRAMES=120 COUNT=none compare . examples/first "" >"$scratch/itself"; }
    check "this engine beside itself" itself
    table() {
        LIMIT=1000 ROUNDS=1 TABLE=1 ROWS='^(the clock|price (turn|frozen)|picture plain, 8 px|boss 3000)' \
            compare . >"$scratch/itself_table" 2>&1 && ! grep "left out" "$scratch/itself_table"
    }
    check "its scenes beside itself" table
    for row in "the clock" "price turn .* tick" "price frozen .* tick" "picture plain.* draw" "boss 3000 .* draw"; do
        check "a row: $row" grep -q "^$row" "$scratch/itself_table"
    done
    same "each of bytes is the same, to the byte" 5 "$(grep -c 'bytes .* 1\.000$' "$scratch/itself")"
fi
finish
