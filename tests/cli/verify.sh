#!/usr/bin/env bash
# verify.sh - what `verify` says of a demo that does not hold: the very frame, and the parts; of a demo with checksums
# of seconds, the frames between two of them. What --verbose adds, and --restamp.
. "$(dirname "$0")/../tap.sh"
sandbox

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
narrow() { sed -i "s/margin = 1000/margin = ${1:-16}/" g/rom.lua; }
record() { # NAME FRAMES
    "$curtain" hash g --frames "$2" --every 1000 --record "$1.demo" >/dev/null 2>&1
    "$curtain" hash g --frames "$2" --every 1000 --prints seconds --record "sparse-$1.demo" >/dev/null 2>&1
}
says() { # NAME CODE DEMO LINE
    local got
    got=$("$curtain" verify g "$3.demo" 2>&1)
    same "$1" "$2 $3.demo: $4" "$? $got"
}
differs() { says "$1" 1 "$2" "$3 (recorded with another game version)"; }

play
record a 200
record first 60
record second 61
says 'the same game' 0 a 'holds, 200 frames'

# ---- a script that acts differently ----

for frame in 1 61; do
    play $frame 'bullet.group():turn(0)'
    differs "a script differs in frame $frame" a "frame $frame: script differs"
done
play 201 'board.note(1)'
says 'a script differs after the end' 0 a 'holds, 200 frames (recorded with another game version)'
while read -r parts act; do
    play 75 "$act"
    parts=${parts//_/ }
    differs "a script differs by $act" a "frame 75: ${parts//,/, }"
done <<'END'
script,board_differ rng.int(1, 6)
script,bullets_differ bullet.fire { kind = "orb", x = 1, y = 1, speed = 0 }
END
play
sed -i '1s/^/board.note(1) /' g/main.lua
differs 'a script differs at power-on' a 'frame 0: script, board differ'

# ---- another part: the bullet leaves a smaller field, which no script sees ----

for margin in 15 16; do
    play
    narrow $margin
    differs "a part differs in frame $((margin + 45))" a "frame $((margin + 45)): bullets differs"
done
play
narrow
differs 'a part differs between two rows of a sparse demo' sparse-a 'frames 61 to 120: bullets differs'
differs 'a part differs in the one frame of a row of a sparse demo' sparse-second 'frame 61: bullets differs'
play 75 'board.note(1)'
narrow
differs 'a part differs before the script' a 'frame 61: bullets differs'

# ---- a demo that ends in a fault ----

end='error("the end", 0)'
play 100 "$end"
record fault 200
says 'the same fault' 0 fault 'holds, 100 frames, ends in the recorded fault'
play 61 'bullet.group():turn(0)' 100 "$end"
differs 'a script differs in the second of the fault' fault 'frame 61: script differs'
play 95 "$end"
differs 'a fault that comes too soon' fault 'frame 95: fault that is not in the demo: main.lua:4: the end'
"$curtain" verify g fault.demo -v >out 2>&1
check 'verbose: the traceback' grep -qx '  stack traceback:' out
play
differs 'a fault that does not come' fault 'frame 100: the recorded fault does not occur'

# ---- verbose ----

# A practice start runs through these moments: a stage, a wave, a mark, a boss, a phase.
moments() { # [FRAME ACT]
    cat <<'LUA'
enemy.def("wisp", { sprite = "dot", hit = "none" })
enemy.def("queen", { sprite = "dot", hit = "none" })
player.def("ship", { sprite = "dot", hit = { circle = 1 } })
bullet.def("orb", { sprite = "dot", hit = { circle = 4 } })
task.go(function()
  wait(300)
  local p = player.get(1)
  local b = bullet.fire { kind = "orb", x = p.x, y = p.y, speed = 0 }
  wait(1)
  b:remove()
end)
boss.def("queen", { title = "Queen", kind = "queen", x = 32, y = 20,
  phases = { { id = "bloom", hp = 100, time = 270, run = function() end } } })
local across = path.def { { x = 10, y = 10 }, { x = 60, y = 10, over = 300 } }
stage.def("one", function()
  stage.at(10) stage.wave { kind = "wisp", n = 1, every = 1, path = across }
  stage.at(50) stage.mark("middle")
  stage.at(100) boss.fight("queen")
end)
boot.run { stages = { "one" }, players = { "ship" } }
LUA
    echo "task.go(function() for frame = 1, 2000 do if frame == ${1:-2000} then ${2:-} end wait(1) end end)"
}
moments | game g
"$curtain" hash g --stage one --frames 600 --every 1000 --record m.demo >/dev/null 2>&1
python3 "$repo/tests/cli/demo_read.py" m.demo >m.txt
at() { # NAME [KIND]: the first frame of such a moment
    awk -v name="$1" -v kind="${2:-}" '$1 == "moment" && $4 == name && (kind == "" || kind == $3) { print $2; exit }' \
        m.txt
}
same 'the moments of a run' \
    'start ,stage one,wave wisp,point middle,boss queen,phase bloom,death 1,lost bloom,clear one,start ,' \
    "$(awk '$1 == "moment" && n++ < 10 { printf "%s %s,", $3, $4 }' m.txt)"
line() { # NAME FRAME WORDS: where --verbose says the frame is
    moments "$2" 'board.note(7)' | game g
    "$curtain" verify g m.demo -v >out 2>&1
    same "$1" "m.demo: frame $2: script, board differ (recorded with another game version)|$3" \
        "$(sed -n 1p out)|$(grep -E '^  (in|[0-9.]+ s)' out)"
}
seconds() { awk -v a="$1" -v b="$2" 'BEGIN { printf "%.1f s", (b - a) / 60 }'; }
f=$(($(at wisp) + 30)) && line 'verbose: in a wave' $f '  in stage one, wave wisp, 0.5 s after its start'
f=$(($(at middle) + 10)) && line 'verbose: a mark ends a wave' $f '  in stage one, mark middle, 0.2 s after its start'
f=$(at queen) && line 'verbose: the very frame in which a boss comes' $f \
    '  in stage one, mark middle, boss queen, 0.0 s after its start'
f=$(($(at 1) + 90)) && line 'verbose: after a death' $f \
    "  in stage one, mark middle, boss queen, phase bloom, $(seconds $(at bloom) \
    $f) after its start; player 1 died 1.5 s earlier"
f=$(at one clear) && line 'verbose: after a stage' $f \
    "  $(seconds 0 $f) after power-on; player 1 died $(seconds $(at 1) $f) earlier"

play
record v 200
play 75 'board.note(1)'
"$curtain" verify g v.demo -v >out 2>&1
same 'verbose: prints of the parts that differ' 'board script' \
    "$(sed -n 's/^  \([a-z]*\): recorded checksum [0-9a-f]\{4\}, replayed [0-9a-f]\{4\}$/\1/p' out | sort | xargs)"
python3 "$repo/tests/cli/demo_read.py" v.demo >v.txt
for part in script board; do
    print=$(sed -n "s/^prints 75 .*\b$part=\([0-9a-f]*\).*/\1/p" v.txt)
    hash=$("$curtain" hash g --frames 75 --parts --every 75 |
        sed -n "s/^75 .* $part=[0-9a-f]*\([0-9a-f]\{4\}\)\b.*/\1/p")
    check "verbose: they are right, $part" grep -qx "  $part: recorded checksum $print, replayed $hash" out
done
play 120 'board.note(1)'
"$curtain" verify g v.demo -v >out 2>&1
check 'verbose: hashes where there is a row' grep -Eqx '  script: recorded [0-9a-f]{16}, replayed [0-9a-f]{16}' out
check 'verbose: nothing was held' grep -qx '  held: player 1 nothing; player 2 nothing' out

# ---- restamp ----

play
record r 200
cp r.demo was.demo
head -c -90 r.demo >short.demo
cp short.demo short.was
play 75 'board.note(1)'
record other 200
cp other.demo other.was
play 201 'board.note(1)' # another build, on which r holds
python3 "$repo/tests/cli/demo_read.py" r.demo >before
"$curtain" verify g --restamp r.demo sparse-r.demo >out 2>&1
status=$? good='holds, 200 frames, restamped (recorded with another game version)'
same 'restamp: two that hold' "0 r.demo: $good|sparse-r.demo: $good|" "$status $(tr '\n' '|' <out)"
says 'restamp: it is of this build now' 0 r 'holds, 200 frames'
python3 "$repo/tests/cli/demo_read.py" r.demo >after
same 'restamp: nothing else changed' 'game|rom|' "$(diff before after | sed -n 's/^> \([a-z]*\) .*/\1/p' | tr '\n' '|')"
got=$("$curtain" verify g --restamp other.demo 2>&1)
same 'restamp: one that differs' '1 other.demo: frame 75: script, board differ (recorded with another game version)' \
    "$? $got"
check 'restamp: is left alone' cmp other.demo other.was
got=$("$curtain" verify g --restamp short.demo 2>&1)
same 'restamp: one cut short' '2 curtain: short.demo: truncated: 180 frames and no end mark' "$? $got"
check 'restamp: is left alone too' cmp short.demo short.was
finish
