#!/usr/bin/env bash
# pacing.sh - docs/measured/pacing.md has the figures of `make pacing`: what is simulated is computed again and
# compared; costs are not, because times depend on the machine.
. "$(dirname "$0")/../tap.sh"
pacing=$OUT/pacing

mkdir "$scratch/new"
check "screens and switches are simulated" "$pacing" --exact --out "$scratch/new" screens latency
simulated() { sed '/^## Cost/,$d; /^Measured /d' "$1"; }
same_figures() { diff -B <(simulated "$1") <(simulated "$scratch/new/pacing.md"); }
check "docs/measured/pacing.md has these figures" same_figures docs/measured/pacing.md
sed '0,/| 59.94 Hz | yes | 36,000 |/s//| 59.94 Hz | yes | 35,964 |/' docs/measured/pacing.md >"$scratch/a.md"
detects "another number of ticks" "35,964" same_figures "$scratch/a.md"

# On a screen that is waited for there are 60 ticks a second, to a frame or two of ten minutes, and next to no refresh
# that the rates do not ask for.
even() {
    awk -F'|' '/^## Screens/ { on = 1 } /^In the next table/ { on = 0 }
        on && $3 ~ /yes/ {
            rows++
            ticks = $4; gsub(/[ ,]/, "", ticks)
            if (ticks < 35997 || ticks > 36003 || $9 + 0 > 2) { print "uneven:" $0; bad = 1 }
        }
        END { exit bad || !rows }' "$1"
}
check "60 ticks a second on each screen, without a refresh too many or too few" even docs/measured/pacing.md
finish
