#!/usr/bin/env bash
# cross.sh - docs/internals/determinism.md has a build for each machine, and the last hashes of all of them are what
# this build computes; a build that diverges is found out. make cross makes the builds for other machines.
. "$(dirname "$0")/../tap.sh"
curtain=$OUT/curtain-null
demos() { ls roms/*/demos/*.demo tests/demos/*.demo; }
rom() { case $1 in tests/*) echo "${1%-*}.rom" ;; *) echo "${1%/demos/*}" ;; esac; }
key() { echo "$(basename "$(rom "$1")" .rom)-$(basename "$1" .demo)"; }

# What the page must say of each demo: "KEY N: `HASH`".
for demo in $(demos); do
    n=$(python3 tests/cli/demo_read.py "$demo" | sed -n 's/^end \([0-9]*\) .*/\1/p')
    echo \
        "$(key "$demo") $("$curtain" hash "$(rom "$demo")" --demo "$demo" --every "$n" 2>/dev/null | tail -n 1 |
        sed 's/ \(.*\)/: `\1`/')"
done >"$scratch/now"
# Both tables of the page, a row a line, fields without their blanks.
rows() { sed -n '/^<!-- cross/,/^<!-- end/p' "$1" | sed -n 's/^| *\(.*\) *|$/\1/p' | sed 's/ *| */|/g; s/ *$//'; }
hashes() { rows "$1" | awk -F '|' '/^build/ { on = /frames/ } on && !/^-/'; }
builds() { rows "$1" | awk -F '|' '/^build/ { on = /file/; next } on && !/^-/'; }

same_hashes() { # PAGE: a column for each demo and no other, every row of it what was computed
    hashes "$1" | awk -F '|' -v now="$scratch/now" '
        BEGIN {
            while ((getline line < now) > 0) {
                at = index(line, " ")
                want[substr(line, 1, at - 1)] = substr(line, at + 1)
                n++
            }
        }
        NR == 1 {
            for (i = 2; i <= NF - 2; i++) name[i] = $i
            if (NF - 3 != n) { print NF - 3 " demos on the page, " n " here"; bad = 1 }
            next
        }
        { for (i in name) if ($i != want[name[i]]) { print $1 ": " name[i] " " $i ", now " want[name[i]]; bad = 1 } }
        { frames[$(NF - 1)]; pictures[$NF]; rows++ }
        END { exit bad || length(frames) != 1 || length(pictures) != 1 }'
}
check "the page's last hashes are this build's" same_hashes docs/internals/determinism.md

# PAGE: its machines with their words and byte order
machines() { builds "$1" | grep -v trixie | cut -d '|' -f 1,3 | sort | paste -sd ' '; }
same "the page has all machines" "arm64|64-bit little-endian armhf|32-bit little-endian i386|32-bit little-endian \
s390x|64-bit big-endian wasm32|32-bit little-endian x86-64|64-bit little-endian" \
    "$(machines docs/internals/determinism.md)"

sed "/^| s390x |/s/[0-9a-f]\{16\}/0123456789abcdef/" docs/internals/determinism.md >"$scratch/planted.md"
detects "another hash of one build" "s390x: " same_hashes "$scratch/planted.md"

# ---- a build that diverges ----

"$curtain" hash tests/cross/keys --record "$scratch/keys.demo" --frames 120 --every 120 >"$scratch/.said"
found_out() {
    tools/lab/cross/unsorted.sh "$OUT" "$scratch/keys.demo" | grep -E 'keys\.demo: frames? [0-9]+.* differs?$'
}
check "unsorted pairs differ, in a frame and a part" found_out
check "as it is, the demo holds" "$curtain" verify tests/cross/keys "$scratch/keys.demo"
finish
