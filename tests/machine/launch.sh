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
printf 'return 1\n' >bad.lua

# shown N: until so many pictures are there
shown() { for _ in $(seq 20000); do [ "$(wc -l <out)" -ge "$1" ] && return 0; sleep 0.025; done; return 1; }
# waits BREAK MEND [ARGUMENT]...: plays a g that BREAK has made wrong; after 60 pictures MEND is run.
waits() {
    local break=$1 mend=$2
    shift 2
    rm -rf g in && cp -R right g && mkfifo in
    eval "$break"
    ./player play g --seed 5 "$@" <in >out 2>err &
    local player=$!
    exec 7>in
    keys 60 >&7
    shown 60 || not_ok '60 pictures'
    eval "$mend"
    keys 100 >&7
    exec 7>&-
    wait $player
    code=$?
}
right() { rm -rf g && cp -R right g; }
says() { # SENTENCE: it, and that it waits, are all that was said
    [ "$(cat err)" = "$(printf 'curtain: g: %s\ncurtain: g: waiting for a file to change' "$1")" ] ||
        { cat err; return 1; }
}
# The last picture is of a game that has run for a while, and no other than without the detour.
ran() { [ "$(grep -cxF -f <(tail -n 30 out) straight)" -gt 20 ]; }
keys 160 | ./player play right --seed 5 >straight 2>none

wrong() { # NAME BREAK SENTENCE
    waits "$2" right
    same "$1: it ends well" 0 $code
    check "$1: the sentence, and that it waits" says "$3"
    check "$1: then the game runs" ran
}
wrong 'a slip of syntax' "echo 'x = = 3' >g/main.lua" "main.lua:1: unexpected symbol near '='"
wrong 'a picture that is not there' 'rm g/art/all.png' 'rom.lua:4: art/all.png does not exist'
wrong 'a picture that is none' 'echo no >g/art/all.png' 'art/all.png: not a PNG'
wrong 'rom.lua' "sed -i 's/screen =/scren =/' g/rom.lua" \
    'rom.lua: scren: unknown key (did you mean "screen"?)'
wrong 'a script that is not there' 'rm g/main.lua' 'rom.lua: entry: main.lua does not exist'

# Settings that cannot be read: the same of their file, and Enter does without it.
conf=data/curtain/curtain.conf shown_conf=$scratch/data/curtain/curtain.conf
mkdir -p data/curtain
waits 'echo "volume = loud" >$conf' 'echo "volume = 50" >$conf'
same 'settings: it ends well' 0 $code
same 'settings: the sentence' \
    "curtain: $shown_conf:1: volume: expected a number from 0 to 100, got \"loud\"" "$(cat err)"
check 'settings: then the game runs' ran
echo 'volume = loud' >$conf
{ keys 30; keys 1 40; keys 100; } | ./player play g --seed 5 >out 2>err
same 'settings: Enter plays without them' 0 $?
check 'settings: ... the game runs' ran
same 'settings: ... and the file is as it was' 'volume = loud' "$(cat $conf)"
{ keys 30; keys 1 41; keys 100; } | ./player play g --seed 5 >out 2>err
same 'settings: Escape leaves' '2 30' "$? $(wc -l <out)"
rm $conf

# A fault at power-on: with its traceback, and nothing is left of that board.
waits "echo \"print 'here' local function f() nothing() end f()\" >g/main.lua" right --record one.demo
same 'a fault at power-on: it ends well' 0 $code
check '... with place and traceback' grep -q "^curtain: g: main.lua:1: undeclared global \"nothing\"$" err
check '...' grep -q $'^\tmain.lua:1: in .*\'f\'$' err
check '... and what the script printed' grep -qx here err
check '... then the game runs' ran
check '... and its recording is whole, and of a run nobody touched' eval \
    '"$curtain" verify --verbose g one.demo >said && grep -q "holds" said && ! grep -q touched said'
check '... and there is no report of it' test ! -e "$XDG_DATA_HOME/curtain/reports"

# One mistake after another.
waits "echo 'x = = 3' >g/main.lua" \
    "echo 'y = = 4' >g/main.lua; keys 60 >&7; shown 120
     echo 'y = nothing.here' >g/main.lua; keys 60 >&7; shown 180; right"
same 'mistake after mistake: it ends well' 0 $code
same '... each is said' $'main.lua:1: unexpected symbol near \'=\'\nmain.lua:1: undeclared global "nothing"' \
    "$(grep -o 'main.lua:1:.*' err | grep -v metamethod | grep -v chunk | uniq)"
check '... then the game runs' ran

# Left before it is right.
rm -rf g && cp -R right g
echo 'x = = 3' >g/main.lua
{ keys 30; keys 1 41; keys 100; } | ./player play g >out 2>err
same 'Escape leaves, with the exit code of what was wrong' 2 $?
same '... at once' 30 "$(wc -l <out)"
keys 30 | ./player play g >out 2>err
same 'so does closing the window' 2 $?
check 'the picture changes with the sentence' test "$(sort -u out | wc -l)" = 1
cp -R g h
echo 'return = 1' >h/main.lua
keys 30 | KEYS_WHOLE=1 ./player play h >other 2>none
check '...' test "$(sort -u out)" != "$(sort -u other)"

# What no change of the folder can mend, and what is none.
now() { # NAME SENTENCE ARGUMENT...: refused at once, no picture
    local name=$1 sentence=$2
    shift 2
    keys 30 | ./player "$@" >out 2>err
    same "$name: exit code" 2 $?
    same "$name: the sentence alone" "curtain: $sentence" "$(cat err)"
    same "$name: no window" '' "$(cat out)"
}
"$curtain" pack right -o right.rom
head -c 300 right.rom >cut.rom
now 'a file' "cut.rom: 300 bytes long, but its header says $(stat -c %s right.rom)" play cut.rom
now 'an option' '--difficulty: unknown difficulty "odd" (expected easy, normal or hard)' play right --difficulty odd
mkdir empty
now 'a folder without a game' 'empty: rom.lua: no such file' play empty
waits "echo 'x = = 3' >g/main.lua" right --difficulty odd
same 'an option of a folder that was waited for: exit code' 2 $code
check '... the sentence' grep -q '^curtain: --difficulty: unknown difficulty "odd"' err

# Without a window: as before.
right
echo 'x = = 3' >g/main.lua
for command in play render hash; do
    "$curtain" $command g $([ $command = render ] && echo --frames 1) >out 2>err
    same "$command without a window: exit code" 2 $?
    same "$command without a window: the sentence" "curtain: g: main.lua:1: unexpected symbol near '='" "$(cat err)"
done
finish
