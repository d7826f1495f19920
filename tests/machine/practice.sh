#!/usr/bin/env bash
# practice.sh - the practice menu in play: a piece is chosen, tried, tried again, captured, and the records say so; what
# does not count; scores; a damaged file. The port is a script's (port_keys.c): no window, no clock.
. "$(dirname "$0")/../kept.sh"
export KEYS_WHOLE=1

# The queen breaks after 80 frames, the knight never does; a dot moves with the frames; a score is kept from the title
# on.
game g <<'LUA'
bullet.def("dot", { sprite = "dot", hit = { circle = 4 } })
enemy.def("e", { sprite = "dot", hit = { box = { 4, 4 } } })
player.def("ship", { sprite = "dot", hit = { circle = 2 }, safe = 9, registers = { power = 1 }, run = function(p)
  while true do
    if pad.down("special", p) then bullet.fire { kind = "dot", from = p, speed = 3 } end
    wait(1)
  end
end })
boss.def("queen", { title = "Queen", kind = "e", x = 32, y = 20, phases = {
  { id = "weak", hp = 5, time = 600, run = function(e) wait(20) e:hurt(5) end },
  { id = "strong", hp = 5, time = 60, run = function(e) wait(forever) end } } })
stage.def("one", function() wait(50) stage.mark "late" wait(40) end)
local had = save.get("seen", 0)
local dot = sprite.put { sprite = "dot", x = 0, y = 0, screen = true }
task.go(function()
  for i = 1, forever do
    if not dot.alive then dot = sprite.put { sprite = "dot", x = 0, y = 0, screen = true } end
    dot.x, dot.y = i * 7 % 64, (i // 9 + 23 * had) % 64
    if i == 40 then save.set("seen", save.get("seen", 0) + 1) end
    wait(1)
  end
end)
boot.run { stages = { "one" }, players = { "ship" } }
LUA

file=data/curtain/probe.practice
play() { plays out --seed 5 "$@"; } # ARGUMENT...: standard input are the keys
# tried NAME RECORD [ARGUMENT...]: with the keys of standard input, the records get this line; none: no file
tried() {
    local name=$1 record=$2
    shift 2
    rm -rf data
    play "$@"
    same "$name" "$record" "$(sed 1d "$file" 2>/dev/null)"
}

# The page's rows: Start, section, difficulty, a heading, lives, power, invincible, hitbox, speed. The list's: stage
# one, its mark, the queen, weak, strong.
choose() { press $DOWN $Z "$@" $Z $Z; } # KEY...: from Start to the list, then these keys, and Start
weak() { press $F2; choose $DOWN $DOWN; }

# ---- the menu ----

keys 60 | plays straight --seed 5
rm -rf data
{ keys 20; press $F2; keys 8; press $DOWN $DOWN; keys 4; press $X; keys 30; } | plays menu --seed 5
same 'the board stands still behind the menu' 1 "$(part menu 22 29 | sort -u | wc -l)"
check 'which shows the chosen row' test "$(part menu 29 29)" != "$(part menu 31 31)"
same 'afterwards the game goes on' "$(part straight 21 50)" "$(part menu 40 69)"
check 'without an attempt there is no file' test ! -e "$file"

# ---- trying ----

# She flies in for 60 frames and breaks after 20; the result is shown for 75: the second try begins in frame 160 or so.
tried 'a try that is broken off' '0 1 normal queen/weak' < <(keys 20; weak; keys 40)
tried 'a try that is won, and the next one begins by itself' '1 2 normal queen/weak' < <(keys 20; weak; keys 180)
tried 'the second phase' '0 1 normal queen/strong' < <(keys 20; press $F2; choose $DOWN $DOWN $DOWN; keys 40)
tried 'again, and again: each is a try' '1 4 normal queen/weak' \
    < <(keys 20; weak; keys 40; press $R; keys 30; press $R; keys 180)
tried 'a death, and the phase is no capture' '0 2 normal queen/weak' < <(keys 20; weak; keys 20; keys 1 $C; keys 180)
tried 'a stage, from its start' '1 2 normal one' < <(keys 20; press $F2 $Z; keys 180)
tried 'and from a mark' '2 3 normal one:late' < <(keys 20; press $F2; choose $DOWN; keys 256)
tried 'started from the command line' '1 2 hard queen/weak' --stage queen/weak --difficulty hard < <(keys 180)
tried 'another difficulty, chosen in the menu' '0 1 hard one' \
    < <(keys 20; press $F2 $DOWN $DOWN $RIGHT $UP $UP $Z; keys 40)

{ keys 20; weak; keys 40; press $R; keys 60; } | play
same 'again is the same from its first frame on' "$(part out 34 73)" "$(part out 75 114)"

# ---- what does not count ----

tried 'invincible' '' \
    < <(keys 20; press $F2 $UP $UP $UP $RIGHT $DOWN $DOWN $DOWN; choose $DOWN $DOWN; keys 180)
tried 'after time ran backwards' '0 1 normal queen/weak' < <(keys 20; weak; keys 30; keys 5 $BACKSPACE; keys 150)
tried 'but the next try does' '1 3 normal queen/weak' \
    < <(keys 20; weak; keys 30; keys 5 $BACKSPACE; keys 50; press $R; keys 180)
"$curtain" hash g --stage queen/weak --frames 120 --record one.demo >/dev/null 2>&1
rm -rf data
{ keys 20; press $F2; keys 120; } | plays out --demo one.demo
check 'a demo' test ! -e "$file"

# ---- records that were there ----

rm -rf data
mkdir -p data/curtain
printf 'practice 1\n# mine\n7 9 normal queen/weak\n1 1 easy one\n' >"$file"
{ keys 20; weak; keys 180; } | play
same 'they count on' $'practice 1\n# mine\n8 11 normal queen/weak\n1 1 easy one' "$(cat "$file")"
printf 'practice 1\n9 7 normal queen/weak\n' >"$file"
{ keys 20; weak; keys 180; } | play
same 'a damaged file is reported' "curtain: $scratch/$file: line 2: expected CAPTURES ATTEMPTS DIFFICULTY MARK; \
attempts are not counted, and the file is not changed" "$(cat err)"
same 'and left alone' $'practice 1\n9 7 normal queen/weak' "$(cat "$file")"

# ---- scores ----

rm -rf data
keys 180 | play
cp data/curtain/probe.nv before.nv
{ weak; keys 180; } | play
check 'practice saves no scores' cmp data/curtain/probe.nv before.nv
keys 60 | plays with --seed 5 --stage queen/weak
rm -rf data
keys 60 | plays without --seed 5 --stage queen/weak
check 'and starts with none' cmp without with
mkdir -p data/curtain
cp before.nv data/curtain/probe.nv
{ weak; keys 60; press $ESCAPE $UP $UP $Z $DOWN $Z; keys 100; } | play
check 'Quit to Title saves them again' files_differ data/curtain/probe.nv before.nv

# ---- sections that were reached ----

"$curtain" pack g -o g.rom >/dev/null
packed() { ./player play g.rom --seed 5 --no-resume >out 2>err; } # standard input are the keys
rm -rf data
late() { keys 20; press $F2 $DOWN $Z $DOWN $Z $Z; keys 20; } # the section after the first, if it is open
late | packed
check 'in a packed game a section that was not reached is locked' test ! -e "$file"
{ begin; keys 30; } | packed
same 'a game reaches its sections' $'reached one\nreached one:late' "$(sed 1d "$file")"
late | packed
same 'which can then be practised' '0 1 normal one:late' "$(tail -1 "$file")"
rm -rf data
{ keys 20; press $F2 $Z; keys 40; } | packed
same 'the start of the first stage is open from the first time on' '0 1 normal one' "$(sed 1d "$file")"
sed -i 's/return {/return { practice = "all",/' g/rom.lua
"$curtain" pack g -o g.rom >/dev/null
rm -rf data
{ keys 20; press $F2 $Z; keys 40; } | packed
same 'practice = "all" opens all of them' '0 1 normal one' "$(sed 1d "$file")"
sed -i 's/practice = "all"/practice = "reached"/' g/rom.lua
rm -rf data
late | play
check 'and practice = "reached" locks them in a folder too' test ! -e "$file"

# ---- recording ----

rm -rf data
{ keys 20; weak; keys 40; } | play --record game.demo
same 'a game that is recorded is not left for a piece' 'game.demo: holds, 74 frames' "$("$curtain" verify g game.demo)"
{ keys 20; press $R; keys 40; } | play --stage queen/weak --record piece.demo
same 'a piece that is recorded restarts' 'piece.demo: holds, 42 frames' "$("$curtain" verify g piece.demo)"

finish
