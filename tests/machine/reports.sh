#!/usr/bin/env bash
# reports.sh - what a script's fault leaves: a text with the message, the versions and the settings, and a demo of the
# run up to there.
. "$(dirname "$0")/../scripted.sh"
reports=$XDG_DATA_HOME/curtain/reports

game g <<'LUA'
local dot = sprite.put { sprite = 'dot', x = 0, y = 30 }
task.go(function()
  while true do
    if pad.down 'bomb' then nothing() end
    if pad.pressed 'fire' then dot.x = dot.x + rng.int(1, 5) end
    wait(1)
  end
end)
LUA
settings 'volume = 70'
played() { for _ in $(seq 40); do keys 2 $Z; keys 2; done; }
count() { find "$reports" -name '*.txt' 2>/dev/null | wc -l; }
newest() { ls -t "$reports"/*.txt | head -n 1; }
demo() { newest | sed 's/txt$/demo/'; }
# has WORDS...: the newest report has each
has() {
    local words
    for words in "$@"; do grep -qF -- "$words" "$(newest)" || { echo "not there: $words"; return 1; }; done
}

# ---- a fault ----
{ played; keys 20 $X; } | plays out --seed 7
same 'a fault: exit code' 2 $?
same 'a fault: one report' 1 "$(count)"
check 'its name has game and date' eval 'basename "$(newest)" | grep -qx "probe-20[0-9-]*-1.txt"'
check 'the log says where' grep -qx "curtain: report: $(newest)" err
check 'it has what happened' has 'fault     in frame 161' 'main.lua:4: undeclared global "nothing"' 'stack traceback:' \
    "in function <main.lua:2>"
version=$("$curtain" version | sed -n '1s/curtain \([^ ]*\) (core \([0-9]*\), \(.*\))/\1, core version \2, \3/p')
check 'it has versions' has "$version" "$(uname -s)" "$("$curtain" list g | sed -n 's/^game /game hash /p')"
check 'it has the settings' has 'volume = 70' 'fullscreen = no'
check 'it names its demo' has "curtain play GAME --demo $(basename "$(demo)")"
same 'its demo holds' "$(demo): holds, 161 frames, ends in the recorded fault" "$("$curtain" verify g "$(demo)")"
keys 400 | ./player play g --demo "$(demo)" >other 2>none
same 'and is played, to the fault' 2 $?
same '... as it was' "$(part out 2 150)" "$(part other 2 150)"
same '... which leaves no report again' 1 "$(count)"

# ---- not too many ----
for i in $(seq 30); do
    echo x | tee "$reports/old-$i.demo" >"$reports/old-$i.txt"
    touch -d "2001-01-$i" "$reports/old-$i.txt"
done
echo mine >"$reports/notes"
{ played; keys 20 $X; } | plays out --seed 8
same 'twenty are kept' 20 "$(count)"
check 'the newest of them' test -e "$reports/old-30.txt" -a ! -e "$reports/old-10.txt" -a -e "$(newest)"
same 'with their demos' 20 "$(ls "$reports"/*.demo | wc -l)"
check 'and other files' test -e "$reports/notes"

# ---- nowhere ----
rm -rf "$reports" && echo file >"$reports"
{ played; keys 20 $X; } | plays out --seed 8
same 'a report that cannot be written: exit code as ever' 2 $?
check '... said' grep -q "curtain: $reports/probe-.*: cannot be written (" err
finish
