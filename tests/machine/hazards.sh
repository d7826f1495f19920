#!/usr/bin/env bash
# hazards.sh - what makes stock Lua differ between runs, machines and settings, shown in stock Lua; then the same script
# on the board, which gives the same in twenty processes or ends in a fault that says why.
#
# A script's first two lines say what is to come:
#     -- stock: distinct                twenty processes, more than one output
#     -- stock: distinct with VAR=VALUE ...where every second process has VAR set
#     -- stock: distinct in de_DE       ...where every second process uses that locale
#     -- stock: address | crash | hang | same | native (the size of this machine's long) | text TEXT (is in the output)
#     -- board: same [as stock]         one output of prints and hashes, whatever the environment [stock Lua's]
#     -- board: fault LINE              in play: the last line on stderr, without its hint; exit code 2
#     -- board: refused LINE            before play
. "$(dirname "$0")/../tap.sh"
sandbox
hazards=$repo/tests/machine/hazards
short=$OUT/curtain-short # endless loops end sooner
[ -x "$short" ] || { echo "Bail out! $short is not built"; exit 2; }
command -v lua5.4 >lua_path || { echo "Bail out! no lua5.4"; exit 2; }
mkdir locale
localedef -i de_DE -f UTF-8 "$scratch/locale/de_DE.UTF-8" >/dev/null 2>&1
export LOCPATH=$scratch/locale

# Twenty outputs of COMMAND in files outputs/N; the environment of each has another size. alter N: sets `extra`.
twenty() {
    local n
    mkdir -p outputs
    rm -f outputs/*
    for n in $(seq 20); do
        alter "$n"
        env PAD="$(printf "%$((n * 13))s")" "${extra[@]}" "$@" >"outputs/$n" 2>&1
        echo "exit $?" >>"outputs/$n"
    done
}
distinct() { for f in outputs/*; do cksum <"$f"; done | sort -u | wc -l; }

# limited SECONDS COMMAND...: killed when it has used so much of the processor's time, however long that takes.
limited() { (ulimit -S -t "$1" && exec "${@:2}"); }
killed=$((128 + $(kill -l XCPU)))

stock() { # NAME EXPECTATION
    local how=${2%% *} what=${2#* }
    alter() { extra=(A=B); }
    case $2 in
    *' with '*) alter() { if (($1 % 2)); then extra=("${what#with }"); else extra=(A=B); fi; } ;;
    *' in '*) alter() { if (($1 % 2)); then extra=("LC_ALL=${what#in }.UTF-8"); else extra=(LC_ALL=C); fi; } ;;
    esac
    case $how in
    hang)
        limited 2 lua5.4 "$1.lua" >output 2>&1
        same "$1: hangs stock Lua" "$killed" $?
        return ;;
    crash)
        limited 20 lua5.4 "$1.lua" >output 2>&1
        check "$1: crashes stock Lua" [ $? -ge 128 ]
        return ;;
    esac
    case $2 in *' in '*) twenty lua5.4 -e 'os.setlocale("")' "$1.lua" ;; *) twenty lua5.4 "$1.lua" ;; esac
    case $how in
    distinct) check "$1: differs between runs of stock Lua ($(distinct) of 20)" [ "$(distinct)" -gt 1 ] ;;
    same) same "$1: the same in stock Lua" 1 "$(distinct)" ;;
    address) check "$1: stock Lua shows an address" grep -Eq '0x[0-9a-f]{6}' outputs/1 ;;
    native) same "$1: stock Lua shows the machine" "$(($(getconf LONG_BIT) / 8))" "$(head -1 outputs/1)" ;;
    text) check "$1: stock Lua says $what" grep -Fq -e "$what" outputs/1 ;;
    *) not_ok "$1: unknown expectation \"$2\"" ;;
    esac
}

settings=(LUA_PATH=./a/rather/long/path/that/is/not/there/?.lua LC_ALL=de_DE.UTF-8 TZ=Asia/Tokyo LUA_INIT=error
    "GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2_Usable,-FMA_Usable,-AVX2,-FMA" MALLOC_PERTURB_=85 MALLOC_ARENA_MAX=1)
hint='s/ ([^()]*not available: .*)$//; s/ (only a task can wait; .*)$//' # hints, which guards.sh looks at
board() { # NAME EXPECTATION
    local line=${2#* }
    alter() { extra=("${settings[$1 % ${#settings[@]}]}"); }
    rm -rf g
    game g <"$1.lua"
    twenty "$short" hash g --frames 3 --parts
    same "$1: the same in 20 processes on the board" 1 "$(distinct)"
    check "$1: shows no address" bash -c '! grep -Eq "0x[0-9a-f]{6}" outputs/1'
    case $2 in
    same*) same "$1: runs on the board" 'exit 0' "$(tail -1 outputs/1)" ;;
    fault*) same "$1: a fault that says why" "$line"$'\nexit 2' "$(tail -2 outputs/1 | sed "$hint")" ;;
    refused*) same "$1: refused with the reason" "curtain: g: $line"$'\nexit 2' "$(tail -2 outputs/1)" ;;
    *) not_ok "$1: unknown expectation \"$2\"" ;;
    esac
    # print goes to stderr, before the hashes.
    if [ "$2" = 'same as stock' ]; then
        same "$1: as in stock Lua" "$(cat stock)" "$(head -"$(wc -l <stock)" outputs/1)"
    fi
}

cp "$hazards"/*.lua .
for file in *.lua; do
    name=${file%.lua}
    stock "$name" "$(sed -n 's/^-- stock: //p' "$file")"
    grep -v '^exit ' outputs/1 >stock
    board "$name" "$(sed -n 's/^-- board: //p' "$file")"
done

# What gives a list its order, and where it came from, does not reach the hash either: the same game elsewhere.
game g <<'LUA'
local names = {}
for i = 1, 40 do names["key" .. i * 7] = i end
for k, v in pairs(names) do board.note(v) end
task.go(function() while true do board.note(rng.int(1, 1000000)) wait(1) end end)
LUA
mkdir -p "a/much longer/path/to/the"
cp -r g "a/much longer/path/to/the/game"
"$curtain" hash g --frames 20 --parts >one 2>&1
"$curtain" hash "a/much longer/path/to/the/game" --frames 20 --parts >two 2>&1
same 'the same game in another folder' "$(cat one)" "$(cat two)"
finish
