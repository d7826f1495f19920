#!/usr/bin/env bash
# ports.sh - make ports: tests every port whole, prints a table of them, and writes docs/measured/ports.md.
#
#     OUT=build/release tools/lab/ports/ports.sh [NAME...]      these; of the others what they said last
#
# The ports are those of the file list. All that a test said is in build/ports/NAME. Exit 1: a test failed, or the page
# would not be true; then it is left as it is.
set -u
only=" $* "
cd "$(dirname "$0")/../../.." || exit 2
export OUT=${OUT:-build/release}
into=build/ports
mkdir -p $into
failed=0

# showed FILE WORDS: yes when there are such tests, and all of them passed
showed() {
    [ -n "$2" ] || { echo ""; return; }
    if grep -E '^not ok ' "$1" | grep -q -e "$2"; then echo "**no**"
    elif grep -E '^ok ' "$1" | grep -q -e "$2"; then echo yes
    else echo "**no test**"; fi
}
wanted() { [ "$only" = "  " ] || case $only in *" $1 "*) ;; *) false ;; esac; }

# row: of the words in $is, and the tests in $tests
row() {
    local name=${is[name]} log=$into/${is[name]} from=$SECONDS test files shown passed not lines size=
    if wanted "$name"; then
        : >"$log"
        for test in "${tests[@]}"; do
            echo "# $test" >>"$log"
            eval "$test" >>"$log" 2>&1 </dev/null || echo "not ok 0 - $test: exit code $?" >>"$log"
        done
    fi
    passed=$(grep -c '^ok ' "$log") not=$(grep -c '^not ok ' "$log")
    # shellcheck disable=SC2206
    files=(${is[files]}) shown=${files[0]}
    case $shown in platform/*/*) shown=$(dirname "$shown") ;; esac
    lines=$(cat "${files[@]}" | wc -l)
    [ -z "${is[built]:-}" ] || size=$(($(stat -c %s "$(eval echo "${is[built]}")") / 1024))
    [ "$not" = 0 ] && [ "$passed" -gt 0 ] || failed=1
    echo "| $name | \`${is[over]}\` | \`$shown\` | $lines | $size | $(showed "$log" "${is[hashes]:-}")" \
        "| $(showed "$log" "${is[picture]:-}") | $(showed "$log" "${is[pressed]:-}")" \
        "| $(showed "$log" "${is[sound]:-}") | $passed$([ "$not" = 0 ] || echo ", **$not failed**") |"
    echo "  $name: $passed passed, $not failed, $((SECONDS - from)) s  $log" >&2
    grep -E '^not ok |^Bail out' "$log" | sed 's/^/    /' >&2
}

{
    echo '| port | API | files | lines | KiB built | demos, hashes | frame 120 | input | sound | passed |'
    echo '|---|---|---|---|---|---|---|---|---|---|'
    declare -A is=()
    tests=()
    while read -r key value; do
        case $key in
        '#'*) ;;
        test) tests+=("$value") ;;
        '')
            [ -z "${is[name]:-}" ] || row
            is=() tests=()
            ;;
        *) is[$key]=$value ;;
        esac
    done < <(cat tools/lab/ports/list; echo)
} >$into/table
cat $into/table
small=()
for n in 64 512 4096; do # the same game with smaller capacities
    rest='shots = 64, enemies = 64, sparks = 0, sprites = 64, tasks = 64, nvram = 4, lua_kib = 512'
    mkdir -p $into/first-$n && cp -r examples/first/* $into/first-$n
    sed -i "s/First Light\"/First Light, $n bullets\", board = { bullets = $n, $rest }/" $into/first-$n/rom.lua
    small+=($into/first-$n)
done
"$OUT/need" roms/glasstide roms/testcard roms/torture examples/first "${small[@]}" >$into/need || failed=1
cat $into/need
{
    echo '| | direct, uncompressed | libcurtain, compressed | ratio |'
    echo '|---|---|---|---|'
    "$OUT/curtain-null" pack roms/glasstide -o $into/glasstide.rom && "$OUT/libspeed" $into/glasstide.rom one
} >$into/speed || failed=1
cat $into/speed
while IFS= read -r line; do
    case $line in
    @MEASURED@) tools/docs/measured.sh "$(${CC:-cc} --version | head -n 1)" ;;
    @TABLE@) cat $into/table ;;
    @SLOTS@) sed '/^$/,$d' $into/need ;;
    @GAMES@) sed '1,/^$/d' $into/need ;;
    @SPEED@) cat $into/speed ;;
    *) echo "$line" ;;
    esac
done <tools/lab/ports/page.txt >$into/page
[ $failed = 0 ] || { echo "docs/measured/ports.md is left as it is: something failed" >&2; exit 1; }
cp $into/page docs/measured/ports.md
