#!/usr/bin/env bash
# launch.sh - a game's folder that is wrong when it is started: the window says so and waits, and the game begins as
# soon as the folder is right. What is no folder, or not the folder's fault, is refused at once.
. "$(dirname "$0")/../scripted.sh"

game g <<'LUA'
local dot = sprite.put { sprite = 'dot', x = 0, y = 30 }
task.go(function()
  while true do
    dot.x = dot.x + 1
    wait(1)
  end
end)
LUA
cp -R g right
right() { rm -rf g && cp -R right g; }
keys 160 | plays straight --seed 5

# waits NAME BREAK MEND [ARGUMENT]...: plays a g that BREAK has made wrong; after 60 pictures MEND is run.
waits() {
    local name=$1 break=$2 mend=$3 player
    shift 3
    right
    rm -f in && mkfifo in
    eval "$break"
    ./player play g --seed 5 "$@" <in >out 2>err &
    player=$!
    exec 7>in
    keys 60 >&7
    wait_for out 60
    eval "$mend"
    keys 100 >&7
    exec 7>&-
    wait $player
    code=$?
    same "$name: it ends well" 0 $code
    # The last pictures are of a game that has run for a while, and no others than without the detour.
    check "$name: then the game runs" [ "$(grep -cxF -f <(tail -n 30 out) straight)" -gt 20 ]
}
wrong() { # NAME BREAK SENTENCE
    waits "$1" "$2" right
    same "$1: it is reported" "curtain: g: $3
curtain: g: waiting for a file to change" "$(cat err)"
}
wrong 'a mistake of syntax' "echo 'x = = 3' >g/main.lua" "main.lua:1: unexpected symbol near '='"
wrong 'a picture that is not there' 'rm g/art/all.png' 'rom.lua:4: art/all.png does not exist'
wrong 'rom.lua' "sed -i 's/screen =/scren =/' g/rom.lua" 'rom.lua: scren: unknown key (did you mean "screen"?)'
waits 'mistake after mistake' "echo 'x = = 3' >g/main.lua" \
    "echo 'y = nothing.here' >g/main.lua; keys 60 >&7; wait_for out 120; right"
same '... each is reported' $'main.lua:1: unexpected symbol near \'=\'\nmain.lua:1: undeclared global "nothing"' \
    "$(grep -o 'main.lua:1:.*' err | grep -v metamethod | grep -v chunk | uniq)"

# A fault at power-on: with its traceback, and nothing is left of that board.
waits 'a fault at power-on' "echo \"print 'here' local function f() nothing() end f()\" >g/main.lua" right \
    --record one.demo
check '... is reported with its place' grep -q "^curtain: g: main.lua:1: undeclared global \"nothing\"$" err
check '... and traceback' grep -q $'^\tmain.lua:1: in .*\'f\'$' err
check '... and what the script printed' grep -qx here err
same '... the recording has no mark' 0 "$(flags one.demo)"
check '... and holds' "$curtain" verify g one.demo
check '... and there is no report of it' test ! -e "$XDG_DATA_HOME/curtain/reports"

# Settings that cannot be read are waited for, too; Enter does without them.
conf=data/curtain/curtain.conf
waits 'settings' 'settings "volume = loud"' 'settings "volume = 50"'
same 'settings: it is reported' \
    "curtain: $scratch/$conf:1: volume: expected a number from 0 to 100, got \"loud\"" "$(cat err)"
settings 'volume = loud'
{ keys 30; keys 1 $ENTER; keys 100; } | plays out
same 'settings: Enter plays without them' 0 $?
same 'settings: ... and the file is as it was' 'volume = loud' "$(cat $conf)"
{ keys 30; keys 1 $ESCAPE; keys 100; } | plays out
same 'settings: Escape leaves' '2 30' "$? $(pictures out)"
rm $conf

# Left before it is right.
right
echo 'x = = 3' >g/main.lua
{ keys 30; keys 1 $ESCAPE; keys 100; } | plays out
same 'Escape leaves at once, with the exit code of what was wrong' '2 30' "$? $(pictures out)"
keys 30 | plays out
same 'so does closing the window' 2 $?

# What no change of the folder can mend.
"$curtain" pack right -o right.rom >none
head -c 300 right.rom >cut.rom
refused() { expect_error "$1" 2 "curtain: $2" ./player play "${@:3}"; } # NAME SENTENCE ARGUMENT...
refused 'a damaged file' "cut.rom: 300 bytes long, but its header says $(stat -c %s right.rom)" cut.rom
refused 'an option' '--difficulty: unknown difficulty "odd" (expected easy, normal or hard)' right --difficulty odd
mkdir empty
refused 'a folder without a game' 'empty: rom.lua: no such file' empty
input_error 'a port without a window' "g: main.lua:1: unexpected symbol near '='" play g
finish
