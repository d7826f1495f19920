#!/usr/bin/env bash
# ports.sh - the short part of each port's test (make ports: all of it), and that docs/measured/ports.md names every
# port.
. "$(dirname "$0")/../tap.sh"

# part COMMAND...: its TAP is a part of this one
part() {
    local said line
    said=$("$@" 2>"$scratch/why")
    grep -qx "1\.\.$(grep -cE '^(not )?ok ' <<<"$said")" <<<"$said" || not_ok "$*: it did not come to its end" "$said" \
        "$(cat "$scratch/why")"
    while IFS= read -r line; do
        case $line in
        'ok '*) ok "$(basename "$(dirname "$1")"): ${line#ok * - }" ;;
        'not ok '*) not_ok "$(basename "$(dirname "$1")"): ${line#not ok * - }" ;;
        '# '*) echo "$line" ;;
        esac
    done <<<"$said"
}
part tests/template.sh
part tests/port.sh "$OUT/curtain-null"
part tests/port.sh "$OUT/curtain"
part platform/libretro/test.sh --short
part platform/web/test.sh --short

listed() { # PAGE
    local file bad=0
    for file in platform/*.c platform/*/; do
        case $file in platform/stdio.c | platform/posix.c | platform/iso.c | *_*.c) continue ;; esac
        grep -qF "\`${file%/}\`" "$1" || { echo "$1: no row of ${file%/}: make ports"; bad=1; }
    done
    return $bad
}
check 'docs/measured/ports.md has a row of each port' listed docs/measured/ports.md
finish
