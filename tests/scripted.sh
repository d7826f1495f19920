# shellcheck shell=bash
# scripted.sh - tap.sh, a sandbox, and ./player in it (build_player).
#
#     . "$(dirname "$0")/../scripted.sh"
. "$(dirname "${BASH_SOURCE[0]}")/tap.sh"
sandbox
build_player

# USB HID usages of keys.
BACKSPACE=42 Z=29 P=19 T=23 B=5 DOT=55 BEFORE=47 AFTER=48 F5=62

part() { sed -n "$2,$3p" "$1"; } # FILE FIRST LAST: picture n is of frame n
press() { # KEY...: two polls each, the second without keys
    local key
    for key; do keys 1 "$key"; keys 1; done
}
flags() { python3 "$repo/tests/cli/demo_read.py" "$1" | sed -n 's/^flags //p'; } # DEMO: 2: touched, 4: assisted
