#!/usr/bin/env bash
# reload.sh - a game's folder changes while it is played: the run goes on in the changed game at the same frame, as if
# it had always been so; and a change that does not run is reported, with file and line, and the old game goes on.
. "$(dirname "$0")/../scripted.sh"

game g <<'LUA'
local step = require 'step'
local x, dot = 0, sprite.put { sprite = 'dot', x = 0, y = 0 }
task.go(function()
  while true do
    x = x + step + (pad.down 'fire' and 5 or 0)
    dot.x, dot.y = x // 30 % 240, 60 + x % 30
    wait(1)
  end
end)
LUA
screen_of g 256x128
echo 'return 1' >g/step.lua
cp -R g before

pressed() { keys 30; keys 40 $Z; keys 230; }
# edited COMMAND [ARGUMENT...]: plays the folder before, as g; the command, of bash, is run after picture 100
edited() {
    local command=$1 player
    shift
    rm -rf g in && cp -R before g && mkfifo in
    ./player play g --seed 5 "$@" <in >out 2>err &
    player=$!
    exec 7>in
    pressed | head -n 100 >&7
    wait_for out 100
    eval "$command"
    pressed | tail -n +101 >&7
    exec 7>&-
    wait $player
    same "$command: it ends well" 0 $?
}
changes() { # COMMAND: from some frames later on, the pictures are those of a game that was always so
    rm -rf g && cp -R before g
    eval "$1"
    pressed | plays changed --seed 5
    edited "$1"
    same '... and is the changed game, at the same frame' "$(part changed 180 250)" "$(part out 181 251)"
}
goes_on() { # DEMO PICTURES: the demo is of the old game, with a tick for all pictures but so many
    same '... and the old game goes on' "$1: holds, $(($(pictures out) - $2)) frames" "$("$curtain" verify before "$1")"
}

pressed | plays straight --seed 5
changes 'echo "return 3" >g/step.lua'
same '... which is reported' 'curtain: g: reloaded' "$(cat err)"
check 'the two games differ' test -z "$(comm -12 <(part straight 100 200 | sort) <(part changed 100 200 | sort))"
same 'until then it is the old game' "$(part straight 1 100)" "$(part out 1 100)"
edited 'echo "return 3" >g/step.lua' --record one.demo
same 'the demo is of the changed game, from its first frame' "one.demo: holds, $(($(pictures out) - 2)) frames" \
    "$("$curtain" verify g one.demo)"

edited 'echo "return = 3" >g/step.lua' --record two.demo
same '... and an error of syntax is reported' \
    'curtain: reload failed: g: step.lua:1: unexpected symbol near '"'='" "$(cat err)"
goes_on two.demo 1
edited 'echo "return {}" >g/step.lua' --record three.demo
check '... and an error in the run is reported' \
    grep -q '^curtain: reload failed: main.lua:5: .*(in frame 0 of the run)$' err
goes_on three.demo 2
edited 'echo "return = 3" >g/step.lua; pressed | sed -n "101,160p" >&7; wait_for out 160; echo "return 1" >g/step.lua'
same '... and is reported once' 1 "$(pictures err)"
edited 'touch g/main.lua; cp g/art/all.png g/art/unused.png'
same '... and new times and files that the game does not name change nothing' "$(part straight 1 290)" \
    "$(part out 1 290)"
same '... and are not reported' '' "$(cat err)"

# While a demo is shown, twice: the demo's board is of a ROM that goes.
cp -R before plain
mkdir before/demos
sed -i "1i task.go(function() wait(120) board.attract 'a' end)" before/main.lua
keys 60 | ./player play before --seed 5 --record before/demos/a.demo >out 2>err
edited 'echo "return 3" >g/step.lua; pressed | sed -n "101,150p" >&7; wait_for out 150; echo "return 1" >g/step.lua'
same '... and both reloads are reported' 2 "$(grep -c reloaded err)"
rm -r before && mv plain before

# Another screen and other capacities: the picture, and what it is drawn with, are of the changed game.
changes 'screen_of g 320x192; sed -i "s/sprites = 16/sprites = 4096/; s/bullets = 256/bullets = 65536/" g/rom.lua'

# Music that plays: the dot follows its beat.
rm -rf before
game before <<'LUA'
local song = require 'song'
local dot = sprite.put { sprite = 'dot', x = 0, y = 0 }
task.go(function()
  wait(20)
  music.play(song)
  while true do
    dot.x, dot.y = music.beat() * 16 % 240, 13 + music.frames(1) % 30
    wait(1)
  end
end)
LUA
screen_of before 256x128
echo 'return "tide"' >before/song.lua
changes 'sed -i "s/c8d8e8/o4 g8g8g8/; s/t133.25/t260/" g/music/tide.mml'
renamed='sed -i "s/tide = {/deep = {/" g/rom.lua'
changes "echo 'return \"deep\"' >g/song.lua; $renamed"
same '... and the music that has gone is reported' 'curtain: g: reloaded
curtain: g: the music "tide" was playing and is no longer in the game' "$(cat err)"
edited "$renamed" --record five.demo
check '... and a name that a script still uses is reported' \
    grep -q 'reload failed: main.lua:[0-9]*: music.play: unknown music "tide"' err
goes_on five.demo 2

# A document of BulletML.
rm -rf before
game before <<'LUA'
bullet.def("dot", { sprite = "dot", hit = "none", graze = false })
task.go(function()
  bullet.ml { name = "fall", x = 30, y = 10, kind = "dot", loop = true }
  wait(forever)
end)
LUA
screen_of before 256x128
sed -i 's/board = { /&bulletml = 16, /' before/rom.lua
mkdir before/bulletml
cat >before/bulletml/fall.xml <<'XML'
<bulletml><action label="top"><fire><direction type="absolute">120</direction><speed>1</speed><bullet/></fire>
<wait>9</wait></action></bulletml>
XML
changes 'sed -i s/120/150/ g/bulletml/fall.xml'
finish
