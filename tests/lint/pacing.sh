#!/usr/bin/env bash
# pacing.sh - docs/measured/pacing.md is a whole page of `make pacing`. What is simulated is computed again and
# compared; the tables of costs only have to exist, because times depend on the machine.
. "$(dirname "$0")/../tap.sh"
pacing=$OUT/pacing

mkdir "$scratch/new"
check "screens and switches are simulated" "$pacing" --exact --out "$scratch/new" screens latency
simulated() { sed '/^## Cost/,$d; /^Measured /d' "$1"; }
same_figures() { diff -B <(simulated "$1") <(simulated "$scratch/new/pacing.md"); }
check "docs/measured/pacing.md has these figures" same_figures docs/measured/pacing.md
sed '0,/| 59.94 Hz | yes | 36,000 |/s//| 59.94 Hz | yes | 35,964 |/' docs/measured/pacing.md >"$scratch/a.md"
detects "another number of ticks" "35,964" same_figures "$scratch/a.md"
sed '0,/ ms | [0-9.]* |$/s// ms | 0.10 |/' docs/measured/pacing.md >"$scratch/a.md"
detects "another latency" "0.10" same_figures "$scratch/a.md"

# On a screen that is waited for there are 60 ticks a second, to a frame or two of ten minutes, and next to no refresh
# that the rates do not ask for.
even() {
    awk -F'|' '/^## Screens/ { on = 1 } /^In the next table/ { on = 0 }
        on && $3 ~ /yes/ {
            rows++
            ticks = $4; gsub(/[ ,]/, "", ticks)
            if (ticks < 35997 || ticks > 36003 || $9 + 0 > 2) { print "uneven:" $0; bad = 1 }
        }
        END { exit bad || rows != 6 }' "$1"
}
check "60 ticks a second on six screens, without a refresh too many or too few" even docs/measured/pacing.md
sed 's/| 75 Hz | yes | 36,00. |/| 75 Hz | yes | 45,000 |/' docs/measured/pacing.md >"$scratch/a.md"
detects "a screen that makes the game faster" "uneven" even "$scratch/a.md"

whole() {
    local n
    n=$(awk '/^## Cost/ { on = 1 } on && /^\| [0-9]+ x [0-9]+ \|/' "$1" | wc -l)
    [ "$n" = 9 ] || { echo "$n windows"; return 1; }
    grep -q '^| roms/glasstide | ' "$1" && grep -qE '^Measured on: .+; (gcc|clang) .+; `-std=c11 .+`' "$1"
}
check "what it costs has nine windows and a game" whole docs/measured/pacing.md
sed '/^| 384 x 448 | 1280/d' docs/measured/pacing.md >"$scratch/a.md"
detects "a window that is missing" "8 windows" whole "$scratch/a.md"

# Where every refresh has a tick, the screen says how fast the game is.
mkdir -p "$scratch/copy"
sed 's|p->asleep = p->at / TICK < (int64_t)p->ticks + 1;|p->asleep = false;|' src/player/play/pace.c \
    >"$scratch/copy/pace.c"
another() {
    ! cmp -s src/player/play/pace.c "$scratch/copy/pace.c" || return 2
    ${CC:-cc} -std=c11 -fwrapv -ffp-contract=off -O2 -w -D_DEFAULT_SOURCE -iquote src/player/play \
        -c "$scratch/copy/pace.c" -o "$scratch/pace.o" || return 2
    # shellcheck disable=SC2046
    ${CC:-cc} -o "$scratch/pacing" "$OUT"/tools/pacing/*.o "$OUT"/tools/report/*.o "$scratch/pace.o" \
        $(find src -name '*.c' ! -path 'src/lib/*' ! -name pace.c ! -name main.c | sed "s,^,$OUT/,; s,c\$,o,") \
        "$OUT"/fb/*.o "$OUT"/gen/std.o "$OUT"/gen/no_rom.o "$OUT"/platform/{stdio,posix,posix_process}.o \
        $(pkg-config --libs lua5.4) -lm -pthread || return 2
    mkdir -p "$scratch/other" && "$scratch/pacing" --exact --out "$scratch/other" screens &&
        even "$scratch/other/pacing.md"
}
sed -i 's,"../../base/int.h","'"$PWD"'/src/base/int.h",' "$scratch/copy/pace.c"
detects "a tick at every refresh" "uneven" another
finish
