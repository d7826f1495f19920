#!/usr/bin/env bash
# practice.sh - the practice menu in play: a piece is chosen, tried, tried again, captured, and the records say so; what
# does not count; scores; a damaged file. The port is a script's (port_keys.c): no window, no clock.
. "$(dirname "$0")/../scripted.sh"
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

F2=59 R=21 Z=29 X=27 C=6 UP=82 DOWN=81 RIGHT=79 BACKSPACE=42 P=19
file=data/curtain/probe.practice
plays() { # OUT ARGUMENT...: standard input are the keys
    local out=$1
    shift
    ./player play g --seed 5 "$@" >"$out" 2>err
}
records() { rm -rf data; plays out "$@"; cat "$file" 2>/dev/null; }

# The menu's rows: title, difficulty, lives, power, invincible, hitbox, speed, a line, stage one, its mark, the queen,
# weak, strong. It opens on stage one.
weak() { press $F2 $DOWN $DOWN $Z; }

# ---- the menu ----

{ keys 20; press $F2; keys 8; press $DOWN $DOWN; keys 4; press $X; keys 30; } | plays menu
same 'it ends well' 0 $?
same 'the board stands still behind the menu' 1 "$(part menu 22 29 | sort -u | wc -l)"
check 'the menu is seen' test "$(part menu 20 20)" != "$(part menu 21 21)"
check 'what is chosen too' test "$(part menu 29 29)" != "$(part menu 31 31)"
rm -rf data
keys 60 | plays straight
same 'afterwards the game goes on as if nothing had been' "$(part straight 21 50)" "$(part menu 40 69)"
same 'nothing was practised' 'none' "$(cat "$file" 2>/dev/null || echo none)"

# ---- trying ----

# She flies in for 60 frames and breaks after 20: the second try begins in frame 84 or so.
same 'a try that is broken off' $'practice 1\n0 1 normal queen/weak' "$({ keys 20; weak; keys 40; } | records)"
same 'a try that is won, and the next one begins by itself' $'practice 1\n1 2 normal queen/weak' \
    "$({ keys 20; weak; keys 100; } | records)"
same 'another: the second phase' $'practice 1\n0 1 normal queen/strong' \
    "$({ keys 20; press $F2 $DOWN $DOWN $DOWN $Z; keys 40; } | records)"
same 'again, and again: each is a try' $'practice 1\n1 4 normal queen/weak' \
    "$({ keys 20; weak; keys 40; press $R; keys 30; press $R; keys 100; } | records)"
same 'again, after death' $'practice 1\n1 3 normal queen/weak' \
    "$({ keys 20; weak; keys 20; keys 1 $C; keys 10; press $R; keys 100; } | records)"
same 'a death, and the phase is no capture' $'practice 1\n0 2 normal queen/weak' \
    "$({ keys 20; weak; keys 20; keys 1 $C; keys 100; } | records)"
same 'a stage, from its start' $'practice 1\n1 2 normal one' "$({ keys 20; press $F2 $Z; keys 100; } | records)"
same 'and from a mark' $'practice 1\n2 3 normal one:late' "$({ keys 20; press $F2 $DOWN $Z; keys 100; } | records)"
same 'started from the command line' $'practice 1\n1 2 hard queen/weak' \
    "$(keys 100 | records --stage queen/weak --difficulty hard)"
same 'another difficulty, chosen in the menu' $'practice 1\n0 1 hard one' \
    "$({ keys 20; press $F2 $UP $UP $UP $UP $UP $UP $RIGHT $DOWN $DOWN $DOWN $DOWN $DOWN $DOWN $Z; keys 40; } |
    records)"

# The same start is the same run: the pictures of each try are alike.
{ keys 20; weak; keys 40; press $R; keys 60; } | plays again
same 'again is the same from its first frame on' "$(part again 28 67)" "$(part again 69 108)"

# ---- what does not count ----

same 'invincible' 'none' \
    "$({ keys 20; press $F2 $UP $UP $UP $RIGHT $DOWN $DOWN $DOWN $DOWN $DOWN $Z; keys 100; } | records
    [ -e "$file" ] || echo none)"
same 'after time ran backwards' $'practice 1\n0 1 normal queen/weak' \
    "$({ keys 20; weak; keys 30; keys 5 $BACKSPACE; keys 150; } | records)"
same 'but the next try does' $'practice 1\n1 3 normal queen/weak' \
    "$({ keys 20; weak; keys 30; keys 5 $BACKSPACE; keys 50; press $R; keys 100; } | records)"
rm -rf data
"$curtain" hash g --stage queen/weak --frames 120 --record one.demo >/dev/null 2>&1
keys 130 | ./player play g --demo one.demo >out 2>err
same 'a demo' 'none' "$([ -e "$file" ] || echo none)"
{ keys 20; press $F2; keys 20; } | ./player play g --demo one.demo >shown 2>err
keys 42 | ./player play g --demo one.demo >unshown 2>err
check 'in a demo there is no menu, but a word' test "$(part unshown 21 21)" != "$(part shown 21 21)"
same 'and it goes on' "$(tail -n +9 <<<"$(part unshown 43 43)")" "$(tail -n +9 <<<"$(part shown 43 43)")"

# ---- records that were there ----

rm -rf data
mkdir -p data/curtain
printf 'practice 1\n# mine\n7 9 normal queen/weak\n1 1 easy one\n' >"$file"
{ keys 20; weak; keys 100; } | plays out
same 'they count on' $'practice 1\n# mine\n8 11 normal queen/weak\n1 1 easy one' "$(cat "$file")"
printf 'practice 1\n9 7 normal queen/weak\n' >"$file"
{ keys 20; weak; keys 100; } | plays out
left='attempts are not counted, and the file is not changed'
same 'a damaged file is reported' \
    "curtain: $scratch/$file: line 2: expected CAPTURES ATTEMPTS DIFFICULTY MARK; $left" "$(cat err)"
same 'and left alone' $'practice 1\n9 7 normal queen/weak' "$(cat "$file")"

# ---- scores ----

rm -rf data
keys 100 | plays out
cp data/curtain/probe.nv before.nv
{ weak; keys 100; } | plays out
check 'practice keeps no scores' cmp data/curtain/probe.nv before.nv
keys 60 | plays with --stage queen/weak
rm -rf data
keys 60 | plays without --stage queen/weak
same 'and begins with none' "$(cat without)" "$(cat with)"
mkdir -p data/curtain
cp before.nv data/curtain/probe.nv
{ weak; keys 60; press $F2 $UP $UP $UP $UP $UP $UP $UP $UP $UP $Z; keys 100; } | plays out
check 'Start from Title does, from where they were' test "$(cksum <before.nv)" != \
    "$(cksum <data/curtain/probe.nv)"
cp data/curtain/probe.nv menu.nv
rm -rf data
keys 100 | plays out
keys 100 | plays out
check 'as without practice' cmp data/curtain/probe.nv menu.nv

# ---- recording ----

rm -rf data
{ keys 20; weak; keys 40; } | plays out --record game.demo
same 'a game that is recorded is not left for a piece' 'none' "$([ -e "$file" ] || echo none)"
same 'and holds' 'game.demo: holds, 68 frames' "$("$curtain" verify g game.demo)"
{ keys 20; press $R; keys 40; } | plays out --stage queen/weak --record piece.demo
same 'a piece that is recorded begins anew' 'piece.demo: holds, 42 frames' "$("$curtain" verify g piece.demo)"

# ---- what a demo holds of a start ----

"$curtain" hash g --stage one:late --lives 7 --register power=5 --invincible --difficulty easy --frames 70 \
    --record all.demo >all 2>&1
same 'all of a start is in the demo' 'all.demo: holds, 70 frames' "$("$curtain" verify g all.demo)"
"$curtain" hash g --demo all.demo >played 2>&1
same 'which plays the same' "$(cat all)" "$(cat played)"
for less in '--register power=5 --invincible' '--lives 7 --invincible'; do
    "$curtain" hash g --stage one:late $less --difficulty easy --frames 70 >less 2>&1
    check "each of them matters: $less" test "$(tail -1 all)" != "$(tail -1 less)"
done
finish
