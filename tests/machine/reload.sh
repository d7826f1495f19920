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
sed -i 's/screen = { w = 64, h = 64/screen = { w = 256, h = 128/' g/rom.lua
echo 'return 1' >g/step.lua
cp -R g changed
echo 'return 3' >changed/step.lua
pressed() { keys 30; keys 40 $Z; keys 230; }
pressed | ./player play g --seed 5 >straight 2>err
pressed | ./player play changed --seed 5 >other 2>err
check 'the two games differ' test -z "$(comm -12 <(part straight 100 200 | sort) <(part other 100 200 | sort))"

# shown N: until so many pictures are there
shown() { for _ in $(seq 20000); do [ "$(wc -l <out)" -ge "$1" ] && return 0; sleep 0.025; done; return 1; }
# edited N COMMAND ARGUMENT...: plays g; after picture N the command is run
edited() {
    local n=$1 command=$2
    shift 2
    rm -f in out && mkfifo in
    ./player play g --seed 5 "$@" <in >out 2>err &
    local player=$!
    exec 7>in
    pressed | head -n "$n" >&7
    shown "$n" || not_ok "$n pictures"
    eval "$command"
    pressed | tail -n +$((n + 1)) >&7
    exec 7>&-
    wait $player
    code=$?
}
unchanged() { echo 'return 1' >g/step.lua; }

edited 100 'echo "return 3" >g/step.lua' --record one.demo
same 'it ends well' 0 $code
same 'until then it is the old game' "$(part straight 1 100)" "$(part out 1 100)"
same 'soon it is the changed one, at the same frame' "$(part other 180 250)" "$(part out 181 251)"
same 'which is reported' 'curtain: g: reloaded' "$(cat err)"
same 'the demo is of the changed game, from its first frame' "one.demo: holds, $(($(wc -l <out) - 2)) frames" \
    "$("$curtain" verify changed one.demo)"
unchanged

# What is reported covers more of the picture than the test leaves out: the demos say what was played.
played() { echo "$1: holds, $(($(wc -l <out) - $2)) frames"; } # DEMO PICTURES: so many are not of a tick
edited 100 'echo "return = 3" >g/step.lua' --record two.demo
same 'an error of syntax is none of the old game' 0 $code
same '... with file and line' 'curtain: reload failed: g: step.lua:1: unexpected symbol near '"'='" "$(cat err)"
unchanged
same '... and the old game goes on' "$(played two.demo 1)" "$("$curtain" verify g two.demo)"

edited 100 'echo "return {}" >g/step.lua' --record three.demo
same 'an error in the run is none of the old game' 0 $code
check '... with file and line and frame' grep -q '^curtain: reload failed: main.lua:5: .*(in frame 0 of the run)$' err
unchanged
same '... which goes on' "$(played three.demo 2)" "$("$curtain" verify g three.demo)"

edited 100 'rm g/step.lua' --record four.demo
check 'a lost file is reported' grep -q 'main.lua:1: .*step' err
unchanged
same '... and the old game goes on' "$(played four.demo 1)" "$("$curtain" verify g four.demo)"

edited 100 'echo "return = 3" >g/step.lua; pressed | sed -n "101,160p" >&7; shown 160; unchanged'
check 'what is put right again is not told twice' test "$(wc -l <err)" = 1

# While a demo is shown, twice: the demo's board is of a ROM that goes.
mkdir -p g/demos
sed -i "1i task.go(function() wait(120) board.attract 'a' end)" g/main.lua
cp g/main.lua attracts.lua
keys 60 | ./player play g --seed 5 --record g/demos/a.demo >out 2>err
edited 20 'echo "return 3" >g/step.lua; pressed | sed -n "21,150p" >&7; shown 150; unchanged'
same 'two reloads, one while a demo is shown' 0 $code
same '... are reported' 2 "$(grep -c reloaded err)"
rm -r g/demos
sed -i 1d g/main.lua

# Another screen and other capacities: the picture, and what it is drawn with, are of the changed game.
cp -R changed larger
sed -i 's/w = 256, h = 64/w = 320, h = 96/; s/sprites = 16/sprites = 4096/; s/bullets = 256/bullets = 65536/' \
    larger/rom.lua
pressed | ./player play larger --seed 5 >other 2>err
edited 100 'cp larger/*.lua g/'
same 'a larger screen and board' "$(part other 180 250)" "$(part out 181 251)"
cp -R changed/*.lua g/
unchanged

edited 100 'touch g/main.lua'
same 'a file that only got another time changes nothing' "$(part straight 1 290)" "$(part out 1 290)"
same '... and nothing is reported' '' "$(cat err)"
edited 100 'cp g/art/all.png g/art/unused.png'
same 'nor does a file that the game does not name' "$(part straight 1 290)" "$(part out 1 290)"

# Music that plays: the dot follows its beat. Notes, tempo and name change.
rm -rf g
game g <<'LUA'
local dot = sprite.put { sprite = 'dot', x = 0, y = 0 }
task.go(function()
  wait(20)
  music.play(require 'song')
  while true do
    dot.x, dot.y = music.beat() * 16 % 240, 13 + music.frames(1) % 30
    wait(1)
  end
end)
LUA
sed -i 's/screen = { w = 64, h = 64/screen = { w = 256, h = 128/' g/rom.lua
sed -i "s/^task/local song = require 'song'\n&/; s/music.play(require 'song')/music.play(song)/" g/main.lua
echo 'return "tide"' >g/song.lua
cp -R g before
pressed | ./player play g --seed 5 >straight 2>err
sed -i 's/c8d8e8/o4 g8g8g8/' g/music/tide.mml
cp -R g notes
back() { rm -rf g old && cp -R before g; }
back
edited 100 'cp notes/music/tide.mml g/music/'
same 'other notes: it goes on at the same beat' "$(part straight 180 250)" "$(part out 181 251)"
same '... which is reported' 'curtain: g: reloaded' "$(cat err)"
back
sed -i 's/t133.25/t260/' notes/music/tide.mml
pressed | ./player play notes --seed 5 >other 2>err
edited 100 'cp notes/music/tide.mml g/music/'
same 'another tempo: it is where it would be' "$(part other 180 250)" "$(part out 181 251)"
back
sed -i 's/tide = {/deep = {/' notes/rom.lua
echo 'return "deep"' >notes/song.lua
pressed | ./player play notes --seed 5 >other 2>err
cp -R notes ready
edited 100 'mv g old; mv ready g'
same 'another name' "$(part other 180 250)" "$(part out 181 251)"
same '... and what played is gone' 'curtain: g: reloaded
curtain: g: the music "tide" was playing and is no longer in the game' "$(cat err)"
back
edited 100 'sed -i "s/tide = {/deep = {/" g/rom.lua' --record five.demo
same 'a piece that a script still names: the old game goes on' "$(played five.demo 2)" \
    "$("$curtain" verify before five.demo)"
check '... with file and line' grep -q 'reload failed: main.lua:[0-9]*: music.play: unknown music "tide"' err

# A document of BulletML, which is changed, and is then none.
rm -rf g before
game g <<'LUA'
bullet.def("dot", { sprite = "dot", hit = "none", graze = false })
task.go(function()
  bullet.ml { name = "fall", x = 30, y = 10, kind = "dot", loop = true }
  wait(forever)
end)
LUA
sed -i 's/screen = { w = 64, h = 64/screen = { w = 256, h = 128/; s/board = { /&bulletml = 16, /' g/rom.lua
mkdir g/bulletml
cat >g/bulletml/fall.xml <<'XML'
<bulletml><action label="top"><fire><direction type="absolute">120</direction><speed>1</speed><bullet/></fire>
<wait>9</wait></action></bulletml>
XML
cp -R g before
pressed | ./player play g --seed 5 >straight 2>err
cp -R g changed2
sed -i 's/120/150/' changed2/bulletml/fall.xml
pressed | ./player play changed2 --seed 5 >other 2>err
check 'the two differ' test "$(part straight 180 250)" != "$(part other 180 250)"
edited 100 'sed -i s/120/150/ g/bulletml/fall.xml'
same 'a document changes' "$(part other 180 250)" "$(part out 181 251)"
same '... which is reported' 'curtain: g: reloaded' "$(cat err)"
back
edited 100 'sed -i "s,</wait>,</waits>," g/bulletml/fall.xml'
same 'one that is wrong is reported with its place' \
    'curtain: reload failed: g: bulletml/fall.xml:2:8: </waits> has no opening tag, expected </wait>' "$(cat err)"
finish
