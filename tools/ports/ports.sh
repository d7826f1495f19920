#!/usr/bin/env bash
# ports.sh - make ports: tests every port whole, prints a table of them, and writes docs/ports.md.
#
#     OUT=build/release tools/ports/ports.sh [NAME...]      these; of the others what they said last
#
# A port is a row of `ports`: its name, its own files, what is built, and the tests it has; then words of those tests
# by which it is told that they showed what a port must. All that a test said is in build/ports/NAME. Exit 1: a test
# failed, or the page would not be true.
set -u
only=" $* "
cd "$(dirname "$0")/../.." || exit 2
export OUT=${OUT:-build/release}
into=build/ports
mkdir -p $into

# NAME | over | files | built | tests | demos or hashes | frame 120 | pressed | sound
ports='null|platform.h|platform/null.c|$OUT/curtain-null|tests/port.sh $OUT/curtain-null|the demo of|to the last pixel|pads that are pressed|the sound of
SDL2|platform.h|platform/sdl2.c|$OUT/curtain|tests/port.sh $OUT/curtain;tests/machine/window.sh;tests/machine/window_sound.sh|the demo of|to the last pixel|keys start the game|what was played is what
template|platform.h|platform/template.c||tests/template.sh|the test card has|||
example|curtain.h|ports/example/frames.c||tests/machine/library.sh|it plays a demo|its picture 000120||
libretro|curtain.h|ports/libretro/*.c ports/libretro/*.h|$OUT/curtain_libretro.so|ports/libretro/test.sh|the test card after\|the game after|to the last pixel|with a pad that is pressed|the sound is that
web|curtain.h|ports/web/web.c ports/web/no_host.c ports/web/*.html ports/web/*.css ports/web/player.js ports/web/worklet.js|build/web/player.html|ports/web/test.sh|the test card after\|the game after|to the last pixel|with keys that are pressed|the sound of'

failed=0
# showed FILE WORDS: yes when there are such tests, and all of them passed
showed() {
    [ -n "$2" ] || { echo ""; return; }
    if grep -E '^not ok ' "$1" | grep -q -e "$2"; then echo "**no**"
    elif grep -E '^ok ' "$1" | grep -q -e "$2"; then echo yes
    else echo "**no test**"; fi
}
wanted() { [ "$only" = "  " ] || case $only in *" $1 "*) ;; *) false ;; esac; }
row() {
    local name=$1 over=$2 files=$3 built=$4 tests=$5 hashes=$6 picture=$7 pressed=$8 sound=$9
    local log=$into/$1 test passed not size lines from=$SECONDS
    if wanted "$name"; then
        : >"$log"
        while IFS= read -r test; do
            echo "# $test" >>"$log"
            eval "$test" >>"$log" 2>&1 </dev/null || echo "not ok 0 - $test: exit code $?" >>"$log"
        done <<<"${tests//;/$'\n'}"
    fi
    passed=$(grep -c '^ok ' "$log") not=$(grep -c '^not ok ' "$log")
    # shellcheck disable=SC2086
    lines=$(cat $files | wc -l)
    size=
    [ -z "$built" ] || size=$(($(stat -c %s "$(eval echo "$built")") / 1024))
    [ "$not" = 0 ] && [ "$passed" -gt 0 ] || failed=1
    # shellcheck disable=SC2086
    printf '| %s | `%s` | `%s` | %d | %s | %s | %s | %s | %s | %s |\n' "$name" "$over" \
        "$(case $name in libretro | web | example) dirname $files | sort -u | head -n 1 ;; *) echo $files ;; esac)" \
        "$lines" "$size" "$(showed "$log" "$hashes")" "$(showed "$log" "$picture")" "$(showed "$log" "$pressed")" \
        "$(showed "$log" "$sound")" "$passed$([ "$not" = 0 ] || echo ", **$not failed**")"
    echo "  $name: $passed passed, $not failed, $((SECONDS - from)) s  $log" >&2
    grep -E '^not ok |^Bail out' "$log" | sed 's/^/    /' >&2
}

{
    echo '| port | over | its own files | lines | KiB built | demos, hashes | frame 120 | pressed | sound | tests passed |'
    echo '|---|---|---|---|---|---|---|---|---|---|'
    while IFS= read -r line; do
        IFS="|" read -r name over files built tests hashes picture pressed sound <<<"${line//\\|/$'\1'}"
        row "$name" "$over" "$files" "$built" "$tests" "${hashes//$'\1'/\\|}" "$picture" "$pressed" "$sound"
    done <<<"$ports"
} >$into/table
cat $into/table
"$OUT/need" roms/glasstide roms/testcard examples/first roms/torture >$into/need || failed=1
cat $into/need
{
    echo '| | as the program does it, plain | by libcurtain, compressed | ratio |'
    echo '|---|---|---|---|'
    "$OUT/curtain-null" pack roms/glasstide -o $into/glasstide.rom && "$OUT/libspeed" $into/glasstide.rom one
} >$into/speed || failed=1
cat $into/speed
{
    sed '/^@TABLE@$/,$d' tools/ports/page.txt
    cat $into/table
    sed '1,/^@TABLE@$/d; /^@SLOTS@$/,$d' tools/ports/page.txt
    sed '/^$/,$d' $into/need
    sed '1,/^@SLOTS@$/d; /^@GAMES@$/,$d' tools/ports/page.txt
    sed '1,/^$/d' $into/need
    sed '1,/^@GAMES@$/d; /^@SPEED@$/,$d' tools/ports/page.txt
    cat $into/speed
    sed '1,/^@SPEED@$/d' tools/ports/page.txt
} >$into/page
if [ $failed = 0 ]; then cp $into/page docs/ports.md; else echo "docs/ports.md is left as it is: something failed" >&2; fi
exit $failed
