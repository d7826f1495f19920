#!/usr/bin/env bash
# faults.sh - the n-th call of malloc, open, fopen, fwrite, fflush, fsync, fclose, rename and mkdir fails, for every n,
# in pack, list, unpack, render, hash --record and verify --restamp: what was to be replaced is whole, old or new; a
# failure is one sentence and exit code 2 or 3, and leaves nothing behind, neither files nor memory; no call is missed
# by a crash. The game has a sheet of each kind of PNG that is read in a way of its own.
. "$(dirname "$0")/../tap.sh"
sandbox

cc -std=gnu11 -O1 -shared -fPIC "$repo/tests/inject/inject.c" -o inject.so -ldl || not_ok 'inject.c compiles'

game g <<'LUA'
task.go(function() while true do bullet.fire { kind = "d", x = 9, y = 9, speed = 1 } wait(3) end end)
bullet.def("d", { sprite = "dot", hit = { circle = 2 } })
LUA
for kind in rgba rgba16 indexed; do
    python3 "$repo/tests/cli/png_make.py" --$kind g/art/$kind.png 16 16 ffffff 3 3 888888
    sed -i "s,^  sheets = { ,&$kind = { file = \"art/$kind.png\" }\, ,
        s,^  sprites = { ,&$kind = { sheet = \"$kind\"\, x = 0\, y = 0\, w = 8\, h = 8 }\, ," g/rom.lua
done
"$curtain" pack g -o new.rom || not_ok 'the game is packed'
game h <<<'task.go(function() while true do wait(1) end end)'
"$curtain" pack h -o old.rom
"$curtain" hash g --frames 200 --record g.demo >/dev/null || not_ok 'a demo is recorded'
cp -r g g2
echo '-- a comment' >>g2/main.lua
cp g.demo fresh.demo
"$curtain" verify --restamp g2 fresh.demo >/dev/null || not_ok 'a demo is restamped'

# A run in a folder of its own, `at`. before: makes what is there; what a command replaces is `out`.
before() {
    rm -rf at
    mkdir at
    case $1 in
    pack) cp old.rom at/out ;;
    record | restamp) cp g.demo at/out ;;
    esac
}
command_of() {
    case $1 in
    pack) echo pack g -o at/out ;;
    list) echo list new.rom ;;
    unpack) echo unpack new.rom at/out ;;
    render) echo render g --frames 3 -o at/out ;;
    record) echo hash g --frames 70 --record at/out ;;
    restamp) echo verify --restamp g2 at/out ;;
    esac
}
inject() { # WHAT CALL N: exit code in $got
    env INJECT=$2:$3 INJECT_COUNT=count LD_PRELOAD="$PWD/inject.so" "$curtain" $(command_of "$1") >said 2>err
    got=$?
}
# What may stand in `at` afterwards: everything new, or as it was. A recording is a file that plays up to some frame.
whole() { # WHAT
    local files
    files=$(cd at && find . -type f | sort | tr '\n' ' ')
    case $1 in
    pack) [ "$files" = './out ' ] && { cmp -s at/out old.rom || cmp -s at/out new.rom; } ;;
    restamp) [ "$files" = './out ' ] && { cmp -s at/out g.demo || cmp -s at/out fresh.demo; } ;;
    record) [ "$files" = './out ' ] && { cmp -s at/out g.demo || "$curtain" verify g at/out >/dev/null 2>&1 ||
        grep -q truncated <("$curtain" verify g at/out 2>&1); } ;;
    unpack) [ "$files" = '' ] || { [ $got = 0 ] && [ "$files" = "$all" ]; } ;;
    render) [ "$files" = '' ] || { [ "$files" = './out/000003.png ' ] && cmp -s at/out/000003.png three.png; } ;;
    list) [ "$files" = '' ] ;;
    esac
}
said_well() { # CALL: a success, or one sentence; of short memory it says so
    [ $got = 0 ] && return
    { [ $got = 2 ] || [ $got = 3 ]; } && [ "$(grep -c . err)" = 1 ] && grep -q '^curtain: .*[a-z)]$' err || return
    ! grep -q 'out of memory$' err || [ $got = 3 ] || return
    [ "$1" != malloc ] || grep -q memory err
}

"$curtain" unpack new.rom first && all=$(cd first && find . -type f | sed 's,^\./,./out/,' | sort | tr '\n' ' ')
"$curtain" render g --frames 3 -o three && cp three/000003.png three.png

most=${CURTAIN_LONG:+1000000}
for what in pack list unpack render record restamp; do
    for call in malloc open fopen fwrite fflush fsync fclose rename mkdir; do
        before $what
        inject $what $call 0
        [ $got = 0 ] && [ ! -s err ] || { not_ok "$what, without a fault" "exit $got" "$(cat err)"; continue; }
        read -r count kept <count
        bad='' failed=0
        # all of them, or of very many: the first hundred, and then every few
        step=$(((count - 100) / ${most:-60} + 1))
        for ((n = 1; n <= count; n += n < 100 ? 1 : step)); do
            before $what
            inject $what $call $n
            [ $got != 0 ] && failed=$((failed + 1))
            read -r _ held <count
            ((held <= kept)) || bad+="$call $n: exit $got: $((held - kept)) pieces of memory are not given back"$'\n'
            said_well $call || bad+="$call $n: exit $got: $(head -c 300 err)"$'\n'
            whole $what || bad+="$call $n: exit $got: left $(cd at && find . | sort | tr '\n' ' ')"$'\n'
        done
        same "$what: each of $count $call, $failed of which end it" '' "$bad"
    done
done

# The faults are felt: a pack to which memory is short fails, and says so.
before pack
inject pack fwrite 1
same 'a write that fails is felt' 3 "$got"
finish
