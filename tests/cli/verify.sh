#!/usr/bin/env bash
# verify.sh - what `verify` says of a demo that does not hold: the very frame in which a script acts differently; the
# frames between two rows of hashes when it is another part that differs.
. "$(dirname "$0")/../tap.sh"

# play [FRAME ACT]...: the game; in these frames its script does that too. narrow: its bullet is gone in frame 61.
play() {
    {
        echo 'bullet.def("orb", { sprite = "dot", hit = "none" })'
        echo 'task.go(function() for frame = 1, 1000 do'
        echo '  if frame == 1 then bullet.fire { kind = "orb", x = 20, y = 32, speed = 1, dir = 0 } end'
        while [ $# -gt 0 ]; do
            echo "  if frame == $1 then $2 end"
            shift 2
        done
        echo '  wait(1)'
        echo 'end end)'
    } | game g
    sed -i 's/screen = {/field = { x = 0, y = 0, w = 64, h = 64, margin = 1000 }, screen = {/' g/rom.lua
}
narrow() { sed -i 's/margin = 1000/margin = 16/' g/rom.lua; }
record() { # NAME FRAMES
    "$curtain" hash g --frames "$2" --every 1000 --record "$1.demo" >/dev/null 2>&1
}
says() { # NAME CODE DEMO LINE
    local got
    got=$("$curtain" verify g "$3.demo" 2>&1)
    same "$1" "$2 $3.demo: $4" "$? $got"
}
differs() { says "$1" 1 "$2" "$3 (recorded on another build)"; }

play
record a 200
record first 60
record second 61
says 'the same game' 0 a 'holds, 200 frames'

# ---- a script that acts differently ----

for frame in 1 2 59 60 61 75 119 120 121 180 181 199 200; do
    play $frame 'board.note(1)'
    differs "a script differs in frame $frame" a "frame $frame: script differs"
done
play 201 'board.note(1)'
says 'a script differs after the end' 0 a 'holds, 200 frames (recorded on another build)'
for act in 'rng.int(1, 6)' 'task.go(function() end)' 'bullet.group():turn(0)' 'bullet.fire { kind = "orb", x = 1, y = 1, speed = 0 }'; do
    play 75 "$act"
    differs "a script differs by $act" a 'frame 75: script differs'
done
play 75 'board.note(1)' 76 'board.note(2)' 130 'board.note(3)'
differs 'the first of several frames' a 'frame 75: script differs'
"$curtain" verify g a.demo first.demo second.demo >out 2>&1
same 'a demo that ends before it holds' "1 first.demo: holds, 60 frames (recorded on another build)" "$? $(sed -n 2p out)"
play
sed -i '1s/^/board.note(1) /' g/main.lua
differs 'a script differs at power-on' a 'frame 0: script, board differ'

# ---- another part: the bullet leaves a smaller field, which no script sees ----

play
narrow
differs 'a part differs between two rows' a 'frames 61 to 120: bullets differ'
differs 'a part differs in the one frame of a row' second 'frame 61: bullets differ'
says 'a part differs after the end' 0 first 'holds, 60 frames (recorded on another build)'
play 75 'board.note(1)'
narrow
differs 'a script differs before the row' a 'frame 75: script differs'
play 120 'board.note(1)'
narrow
differs 'a script differs in the frame of the row' a 'frame 120: script differs'
play 121 'board.note(1)'
narrow
differs 'a script differs after the row' a 'frames 61 to 120: bullets differ'

# ---- a demo that ends in a fault ----

end='error("the end", 0)'
play 100 "$end"
record fault 200
says 'the same fault' 0 fault 'holds, 100 frames, ends in the fault it was recorded with'
for frame in 61 75 99; do
    play $frame 'board.note(1)' 100 "$end"
    differs "a script differs in frame $frame, in the second of the fault" fault "frame $frame: script differs"
done
play 95 "$end"
differs 'a fault that comes too soon' fault 'frame 95: a fault that is not in the demo: main.lua:4: the end'
play
differs 'a fault that does not come' fault 'frame 100: the fault it was recorded with does not happen'
finish
