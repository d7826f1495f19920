#!/usr/bin/env bash
# turns.sh - two builds of rows.c through the same scenes in turns: turns.sh BASE HERE BENCH GAME [START]
#
# A row is opened in both; then they run a slice of frames each, now one first, now the other, ROUNDS (9) times. A
# figure is the median of the rounds, the ratio that of the rounds' ratios, with half the distance of their quartiles.
# Both run on one core where taskset can say so. "the clock" is a loop of additions in both: what its ratio is off 1 is
# not the engines', and how far its times lie apart is what the machine's clock did meanwhile.
set -eu
export LC_ALL=C
: "${ROUNDS:=9}" "${ROWS:=}" "${LIMIT:=1.03}" "${SLICE:=9}"
engines=("$1" "$2")
shift 2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkfifo "$work"/{to,from}_{base,here}
pin=()
if command -v taskset >/dev/null && taskset -c 0 true 2>/dev/null; then pin=(taskset -c 0); fi
"${pin[@]}" "${engines[0]}" "$@" <"$work/to_base" >"$work/from_base" &
"${pin[@]}" "${engines[1]}" "$@" <"$work/to_here" >"$work/from_here" &
exec 3>"$work/to_base" 4>"$work/to_here" 5<"$work/from_base" 6<"$work/from_here"

# ask SIDE COMMAND: one answer, in $said.
ask() {
    if [ "$1" = base ]; then
        echo "$2" >&3 && read -r said <&5
    else
        echo "$2" >&4 && read -r said <&6
    fi || { echo "turns: the engine of $1 ended at \"$2\"" >&2; exit 2; }
}

names() { # of both, those that are asked for
    local one
    echo list >&3
    while read -r one <&5 && [ -n "$one" ]; do echo "$one"; done >"$work/names_base"
    echo list >&4
    while read -r one <&6 && [ -n "$one" ]; do echo "$one"; done >"$work/names_here"
    grep -E "${ROWS:-.}" "$work/names_base" | grep -Fxf "$work/names_here" || true
}

# row NAME ROUNDS: lines of "NAME|ROUND|SIDE|TICK DRAW".
row() {
    local k side why=fine
    for side in base here; do
        ask $side "open $1"
        [ "$said" = fine ] || why="$side: $said"
    done
    [ "$why" = fine ] || echo "turns: $1 is left out: $why" >&2
    for k in $(seq "$2"); do
        [ "$why" = fine ] || break
        for side in $([ $((k % 2)) = 0 ] && echo base here || echo here base); do
            ask "$side" "slice $SLICE"
            echo "$1|$k|$side|$said"
        done
    done
    ask base close
    ask here close
}

names >"$work/names"
while read -r name; do
    row "$name" "$ROUNDS"
    [ -t 2 ] && echo -n . >&2
done <"$work/names" >"$work/figures"
awk -v limit="$LIMIT" -v want=slower -f tools/lab/compare/turns.awk "$work/figures" >"$work/again"
while read -r name; do
    sed -i "/^$name|/d" "$work/figures"
    row "$name" $((ROUNDS * 3)) >>"$work/figures"
done <"$work/again"
awk -v limit="$LIMIT" -f tools/lab/compare/turns.awk "$work/figures"
