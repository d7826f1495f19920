# scripted.sh - tap.sh, and ./player: curtain with a port that is played by a script (machine/port_keys.c), without
# window and clock.
#
#     . "$(dirname "$0")/../scripted.sh"
. "$(dirname "${BASH_SOURCE[0]}")/tap.sh"
sandbox
${CC:-cc} -std=c11 -O1 -o player "$repo/tests/machine/port_keys.c" \
    $(find "$OUT/src" -name '*.o') "$OUT"/fb/*.o "$OUT/gen/std.o" "$OUT/gen/no_rom.o" "$OUT/platform/stdio.o" \
    $(pkg-config --libs lua5.4) -lm -pthread || exit 2

# USB HID usages of keys.
BACKSPACE=42 Z=29 P=19 T=23 B=5 DOT=55 BEFORE=47 AFTER=48 F5=62

keys() { # N [USAGE...]: so many polls with these held
    local n=$1
    shift
    for _ in $(seq "$n"); do echo "$*"; done
}
part() { sed -n "$2,$3p" "$1"; } # FILE FIRST LAST: picture n is of frame n
