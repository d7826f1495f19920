#!/usr/bin/env bash
# film.sh - the key that films: a GIF of the last seconds, which are the frames of the recording to the last pixel, and
# nothing of the run is another for it: demo, scores and what is seen afterwards.
. "$(dirname "$0")/../scripted.sh"
pictures=$XDG_PICTURES_DIR/Curtain

game g <<'LUA'
bullet.def("orb", { sprite = "dot", hit = "none" })
local x = 0
task.go(function()
  for i = 1, forever do
    x = x + 1 + (pad.down 'fire' and rng.int(1, 5) or 0)
    if i % 5 == 0 then bullet.fire { kind = "orb", x = x % 64, y = 3, speed = 1, dir = rng.dir() } end
    if i % 40 == 0 then print("frame " .. i) palette.set(1, rng.int(0, 0xffffff)) end
    if i % 50 == 0 then save.set('x', x) end
    wait(1)
  end
end)
LUA
play() { # NAME [SETTING]: standard input are the keys; the folder frames gets the pictures
    rm -rf data frames
    settings "${@:2}"
    plays "$1" --seed 5 --record "$1.demo"
    mv err "$1.err"
    cp data/curtain/probe.nv "$1.nv"
    "$curtain" render g --demo "$1.demo" --frames 0:500 -o frames 2>/dev/null
}
film_same() { python3 "$repo/tests/cli/film_same.py" "$@"; }
keyed() { keys 100; keys 60 $Z; keys 1 "$1"; keys 60; keys 200 $Z; keys 1 "$1"; keys 30; }
keyed "" >script
play plain <script
keyed $F6 >script
play filmed <script
check 'the run is the same' cmp plain.demo filmed.demo
check 'and its scores' cmp plain.nv filmed.nv
same 'it says where they are' "saved $pictures/probe-1.gif saved $pictures/probe-2.gif" \
    "$(grep ^saved filmed.err | paste -sd ' ')"
same 'what scripts print is there once' "$(cat plain.err)" "$(grep -v ^saved filmed.err)"
check 'the first one has all frames up to there' film_same "$pictures/probe-1.gif" frames 0 161
check 'so has the other one, of ten seconds at most' film_same "$pictures/probe-2.gif" frames 0 422
same 'what is seen afterwards is the same' "$(part plain 350 420)" "$(part filmed 350 420)"

rm -rf "$pictures"
play short 'capture_seconds = 5' <script
check 'five seconds' film_same "$pictures/probe-2.gif" frames 123 422

# After time was turned back, in slow motion, while the clock stands, ahead of the present.
rm -rf "$pictures"
{
    keys 90 $Z; keys 20 $BACKSPACE; keys 30; keys 1 $COMMA; keys 40; keys 1 $F6; keys 20; keys 1 $P; keys 3; keys 1 $F6
    keys 3; keys 1 $P; keys 20
} >there
play way 'run_ahead = 1' <there
frames_of() { # FILM: its last frame, for which the film is the recording's
    local last
    for last in $(seq 90 130); do
        film_same "$1" frames 0 "$last" >/dev/null 2>&1 && { echo "$last"; return; }
    done
    return 1
}
check 'its film is the branch that was played on' frames_of "$pictures/probe-1.gif"
check 'and so is one that is made while the clock stands' frames_of "$pictures/probe-2.gif"

# Where it cannot be.
game broken <<'LUA'
task.go(function() wait(30) error("enough") end)
LUA
{ keys 60; keys 1 $F6; keys 20; } | ./player play broken >out 2>err
same 'nothing is filmed of a run that has stopped' '' "$(grep ^saved err)"
rm -rf "$pictures" && mkdir -p "$(dirname "$pictures")" && echo file >"$pictures"
play nowhere <script
check 'where it cannot be: said' grep -q "curtain: $pictures/probe-1.gif: cannot be written" nowhere.err
check 'and the run goes on' cmp plain.demo nowhere.demo
finish
