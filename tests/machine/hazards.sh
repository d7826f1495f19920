#!/usr/bin/env bash
# hazards.sh - scripts that differ in stock Lua between runs, machines and settings: on the board each gives the same in
# twenty processes, or ends in a fault that says why.
#
# A script's first line says what stock Lua does: differs between runs, shows an address or the machine, hangs, crashes.
# Its second line says what is to come:
#     -- board: same [as stock]         one output of prints and hashes, whatever the environment [stock Lua's]
#     -- board: fault LINE              in play: the last line on stderr, without its hint; exit code 2
#     -- board: refused LINE            before play
. "$(dirname "$0")/../tap.sh"
sandbox
short=$OUT/curtain-short # endless loops end sooner
mkdir locale
localedef -i de_DE -f UTF-8 locale/de_DE.UTF-8 >/dev/null 2>&1
export LOCPATH=$scratch/locale

settings=(LUA_PATH=./a/rather/long/path/that/is/not/there/?.lua LC_ALL=de_DE.UTF-8 TZ=Asia/Tokyo LUA_INIT=error
    "GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2_Usable,-FMA_Usable,-AVX2,-FMA" MALLOC_PERTURB_=85 MALLOC_ARENA_MAX=1)
hint='s/ ([^()]*not available: .*)$//; s/ (only a task can wait; .*)$//' # hints, which guards.sh looks at
twenty() { # the game in g, in twenty environments of other sizes; the outputs are files of outputs
    local n
    mkdir -p outputs
    for n in $(seq 20); do
        env PAD="$(printf "%$((n * 13))s")" "${settings[n % ${#settings[@]}]}" \
            "$short" hash g --frames 3 --parts >"outputs/$n" 2>&1
        echo "exit $?" >>"outputs/$n"
    done
}
hazard() { # NAME EXPECTATION
    local line=${2#* }
    rm -rf g
    game g <"$repo/tests/machine/hazards/$1.lua"
    twenty
    same "$1: the same in 20 processes" 1 "$(md5sum outputs/* | cut -c 1-32 | sort -u | wc -l)"
    check "$1: shows no address" eval '! grep -Eq "0x[0-9a-f]{6}" outputs/1'
    case $2 in
    same*) same "$1: runs" 'exit 0' "$(tail -1 outputs/1)" ;;
    fault*) same "$1: a fault that says why" "$line"$'\nexit 2' "$(tail -2 outputs/1 | sed "$hint")" ;;
    refused*) same "$1: refused with the reason" "curtain: g: $line"$'\nexit 2' "$(tail -2 outputs/1)" ;;
    esac
    [ "$2" != 'same as stock' ] || # print goes to stderr, before the hashes
        same "$1: as in stock Lua" "$(lua5.4 g/main.lua)" "$(grep -v '^[0-9]* [0-9a-f]\{16\}\|^exit' outputs/1)"
}
for file in "$repo"/tests/machine/hazards/*.lua; do
    hazard "$(basename "$file" .lua)" "$(sed -n '2s/^-- board: //p' "$file")"
done
finish
