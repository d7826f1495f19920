#!/usr/bin/env bash
# translated.sh - a walk through the program's screens in a language that has every line of `curtain help lang`: each
# text that a screen shows has a translation, and the row Language shows the languages by their own names.
. "$(dirname "$0")/../tap.sh"
sandbox

build_player "$repo/tests/machine/lookups.c" -Wl,--wrap=words_find
game g <<'LUA'
enemy.def("e", { sprite = "dot", hit = { box = { 4, 4 } } })
player.def("ship", { sprite = "dot", hit = { circle = 2 }, registers = { power = 1 } })
boss.def("queen", { title = "queen", kind = "e", x = 32, y = 20, phases = {
  { id = "weak", hp = 5, time = 600, run = function(e) wait(forever) end } } })
stage.def("one", function() wait(50) stage.mark "late" wait(40) end)
boot.run { stages = { "one" }, players = { "ship" },
  screens = { title = function() wait_until(function() return pad.take("start", 0, 1) end) return "start", 1 end } }
LUA
mkdir -p g/lang data/curtain
"$curtain" help lang | sed -E 's/(.*) =$/\1 = ~\1/; :a; s/(= .*\\n)([^~])/\1~\2/; ta' >g/lang/px.txt
printf 'name = Pixel\nNext = ~Next\n' >>g/lang/px.txt # Next: on the results, a page of the game
echo 'name = Plain' >g/lang/en.txt
ENTER=40 ESCAPE=41 DELETE=76 MINUS=45 RIGHT=79 LEFT=80 DOWN=81 UP=82 X=27 Z=29
press() { for key; do keys 1 "$key"; keys 2; done; }
repeat() { local i; for i in $(seq "$1"); do press "${@:2}"; done; } # N KEY...
# Plays from the script, as an unfinished run if the title is left, and adds to the file seen.
play() { # [ARGUMENT...]
    printf 'lang = px\naway = go-on\nrun_ahead = 1\nvolume = 10\n' >data/curtain/curtain.conf
    ./player play g --seed 5 "$@" >out 2>>err && cat lookups >>seen
}
: >seen

# A run that is quit: the question is answered with its second row, so that there is a replay.
{ keys 20; press $ENTER; keys 60; keys 200 $Z; press $ESCAPE; keys 4; } | play
# The unfinished run: the question whether to resume it.
{ keys 20; press $DOWN $UP $DOWN $ENTER; keys 20; } | play
# The rows of a screen and their values, and what is asked and said on the way.
walk() {
    repeat 42 $RIGHT $RIGHT $RIGHT $RIGHT $DOWN
    press $UP $ENTER $X $DOWN $ENTER $ENTER $ESCAPE $DOWN $ENTER $Z $ENTER $DOWN $DELETE $DOWN $ENTER
    repeat 4 $DOWN
    press $UP $ENTER $ESCAPE $ESCAPE
}
for page in $(seq 0 6); do
    { keys 20; press $ESCAPE $DOWN $ENTER; repeat "$page" $DOWN; press $ENTER; walk; } | play --no-resume
done
{ keys 20; press $ESCAPE $DOWN $ENTER $DOWN $DOWN $DOWN $DOWN $DOWN $ENTER $UP $ENTER $DOWN $ENTER; } | play --no-resume
# In a run, each entry of the menu.
for entry in $(seq 0 10); do
    { keys 20; press $ENTER; keys 60; keys 200 $Z; press $ESCAPE; repeat "$entry" $DOWN; press $ENTER; walk; } |
        play --no-resume
    { keys 20; press $ENTER; keys 60; keys 200 $Z; press $ESCAPE; repeat "$entry" $DOWN
        press $ENTER $UP $ENTER $ESCAPE $ENTER $DOWN $ENTER $ESCAPE $ESCAPE; } | play --no-resume
done
{ keys 20; press $MINUS; keys 9; } | play --no-resume
cat >untranslated.py <<'PY'
import re, sys

rows = [line.rstrip("\n") for line in open("seen", encoding="utf-8")]
found = {row[1:] for row in rows if row[0] == "+"}
explained = lambda s: s in found or re.sub(r"\d+", "%d", s) in found or s.strip() in found
is_key = re.compile("[^A-Z]*|.|Num .*|(Ctrl|Alt)\\+.*|F[0-9]+|[LR][0-9]|D-pad .*|Start|Select|Guide|Up|Down|Left|Right|"
                    "Enter|Escape|Backspace|Home|Pause|Shift|Tab").fullmatch
for text in sorted({row[1:] for row in rows if row[0] == "-"}):
    for line in text.split("\r"):
        # text without small letters is a key's or the HUD's; ~ is a translation; %d is the second try
        if re.search("[a-z]", line) and not re.search("~|%", line) and not explained(line) and \
                not all(map(is_key, line.split(", "))):
            print(line)
PY
# The languages' own names, dates, the game's words and names, and the question in a language without words.
own="Pixel|Plain|2027.*|All Stages Clear|All Clear|Congratulations!|Player 1 .*|Stage [Oo]ne.*|One|Graze|Power|Speed"
own+="|Easy|Normal|Hard|Coins|Free|Ships| *(Late|Weak)|Restart to apply this.*"
same 'every text has a translation' '' "$(python3 untranslated.py | grep -vxE "$own" | sort -u)"
for text in 'Fill the whole screen.' Off 'Play time: %d:%d' 'Reset all key bindings?' 'Practise this section.' \
    Watch '%s: removed %s' 'Press a button to identify a controller.' 'Quit? You can resume this run next time.' \
    Confirm Paused 'Quit Game' 'Won/Tried' 'This game has no sound'; do
    check "... among them $text" grep -qxF -- "+$text" seen
done
same 'what is printed on keys is not translated' 0 "$(grep -cxF -- '-Enter, 1' seen)"
same 'nothing is printed' '' "$(cat err)"

# The row Language, the last one: en.txt has only a name, and is therefore the language of the scripts.
game own <<'LUA'
task.go(function() board.ask("settings") end)
LUA
sed -i 's/screen = { w = [0-9]*, h = [0-9]*/screen = { w = 240, h = 320/' own/rom.lua
mkdir own/lang
echo 'name = Plain' >own/lang/en.txt
printf 'name = Pixel\nSettings = Einstellungen\n' >own/lang/px.txt
choose() { # NAME LANG KEY... -- TEXT...: with this setting and after these keys, all of the text is looked up
    local name=$1 keys=()
    printf 'lang = %s\n' "$2" >data/curtain/curtain.conf
    shift 2
    while [ "$1" != -- ]; do keys+=("$1"); shift; done
    { keys 20; press $UP "${keys[@]}"; } >script
    ./player play own --no-resume <script >out 2>>err
    shift
    for text; do check "$name: $text" grep -qx -- "$text" <(tail -n 200 lookups); done
}
choose 'a language has its own name' px -- +Settings -Pixel
choose 'so has that of the scripts' '' -- -Settings -Plain
choose 'another language is chosen, and shown at once' '' $RIGHT -- +Settings -Pixel
choose 'and the first again' '' $RIGHT $RIGHT -- -Settings -Plain
rm own/lang/en.txt
choose 'without its file, it is the default' '' -- -Settings -Default
choose 'which alternates with the others' px $LEFT -- -Settings -Default
check 'and has no name in the settings' grep -qx 'lang =' data/curtain/curtain.conf
finish
