#!/usr/bin/env bash
# strings.sh - `curtain help lang` lists the text of the program's screens as tools/strings.py finds it in their
# sources, and `curtain check` notes how much of it a language lacks.
. "$(dirname "$0")/../tap.sh"
sandbox

"$curtain" help lang >list
same 'tools/strings.py --write has been run' '' "$(diff <("$repo/tools/strings.py" | sed 's/$/ =/') list)"
for text in 'Fill the whole screen.' VSync '%s: removed %s' 'Quit and lose this run?' 'Player %d' '%d frame'; do
    check "the list has $text" grep -qxF "$text =" list
done
mkdir -p g/lang
echo 'return { id = "g" }' >g/rom.lua
echo 'text.put { col = 0, row = 0, text = text.lang("gate") }' >g/main.lua
n=$(wc -l <list)
noted() { # NAME WANT: the findings of check about translations
    same "$1" "$2" "$("$curtain" check g 2>&1 | grep translat)"
}
{ echo 'gate = Tor'; sed 's/=$/= x/' list; } >g/lang/de.txt
noted 'a language that has all' ''
sed -i '/^VSync/d' g/lang/de.txt
noted 'one that lacks a text' \
    "lang/de.txt: note: 1 string of the program's screens is not translated (curtain help lang prints all)"
echo 'gate = Tor' >g/lang/de.txt
noted 'one of the game alone' \
    "lang/de.txt: note: $n strings of the program's screens are not translated (curtain help lang prints all)"
echo 'name = English' >g/lang/de.txt
noted 'a name alone needs no translations' ''
finish
