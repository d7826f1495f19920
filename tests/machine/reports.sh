#!/usr/bin/env bash
# reports.sh - what a script's fault and a crash of the program leave: one text with the message, the versions, the
# settings and the run up to there, which verify and play take for a demo.
. "$(dirname "$0")/../scripted.sh"
B=27 # X: bomb
reports=$XDG_DATA_HOME/curtain/reports

game g <<'LUA'
local dot = sprite.put { sprite = 'dot', x = 0, y = 30 }
task.go(function()
  while true do
    if pad.down 'bomb' then nothing() end
    if pad.pressed 'fire' then dot.x = dot.x + math.random(5) end
    wait(1)
  end
end)
LUA
sed -i 's/math.random(5)/rng.int(1, 5)/' g/main.lua
mkdir -p "$XDG_DATA_HOME/curtain"
echo 'volume = 70' >"$XDG_DATA_HOME/curtain/curtain.conf"
played() { for _ in $(seq 40); do keys 2 $Z; keys 2; done; }
count() { find "$reports" -name '*.txt' 2>/dev/null | wc -l; }
newest() { ls -t "$reports"/*.txt | head -n 1; }
# has WORDS...: the newest report has each
has() {
    local words
    for words in "$@"; do grep -qF -- "$words" "$(newest)" || { echo "not there: $words"; return 1; }; done
}

# ---- a fault ----
{ played; keys 20 $B; } | ./player play g --seed 7 >out 2>err
same 'a fault: exit code' 2 $?
same 'a fault: one report' 1 "$(count)"
today=$(basename "$(newest)" -1.txt)
check 'its name has game and date' eval 'echo "$today" | grep -qx "probe-20[0-9][0-9]-[01][0-9]-[0-3][0-9]"'
check 'the log says where' grep -qx "curtain: report: $(newest)" err
check 'it has what happened' has 'a fault, in frame 161' 'main.lua:4: undeclared global "nothing"' 'stack traceback:' \
    "in function <main.lua:2>"
version=$("$curtain" version | sed -n '1s/curtain \([^ ]*\) (core \([0-9]*\), \(.*\))/\1, core version \2, \3/p')
check 'it has versions' has "$version" "$(uname -s)" "$("$curtain" list g | sed -n 's/^game /game hash /p')"
check 'it has the settings' has 'volume = 70' 'fullscreen = no'
same 'its demo holds' "$(newest): holds, 161 frames, ends in the recorded fault" \
    "$("$curtain" verify g "$(newest)")"
keys 400 | ./player play g --demo "$(newest)" >other 2>none
same 'and is played, to the fault' 2 $?
same '... as it was' "$(part out 2 150)" "$(part other 2 150)"
same '... which leaves no report again' 1 "$(count)"
sed 's/$/\r/' "$(newest)" >mailed.txt
check 'with other ends of lines, too' "$curtain" verify g mailed.txt
sed '/BEGIN CURTAIN/,$d' "$(newest)" >none.txt
refuse 'a text without a demo is none' 'none.txt: not a demo' "$curtain" verify g none.txt
sed '/^[A-Za-z0-9+\/]\{72\}$/{20d}' "$(newest)" | sed '60d' >lost.txt
refuse 'a line that is lost is found' 'lost.txt: ' "$curtain" verify g lost.txt

# Gone back, and into the fault in another frame.
{ played; keys 3 $B; keys 10; keys 20 $BACKSPACE; keys 60 $B; } | ./player play g --seed 7 >out 2>err
same 'a report for each fault' 3 "$(count)"
check '... the demo of the second' eval '"$curtain" verify g "$(newest)" | grep -q "ends in the recorded fault"'

# ---- a crash ----
# killed SIGNAL [ARGUMENT]...: plays g and kills it after 100 pictures
killed() {
    local signal=$1
    shift
    rm -f in && mkfifo in
    ./player play g --seed 7 "$@" <in >out 2>err &
    local player=$!
    exec 7>in
    played | head -n 100 >&7
    for _ in $(seq 20000); do [ "$(wc -l <out)" -ge 100 ] && break; sleep 0.025; done
    kill "-$signal" $player
    exec 7>&-
    wait $player 2>/dev/null
    code=$?
}
reported() { sed -n 's/^curtain: crashed ([A-Z]*); report: //p' err; }
played | head -n 100 | ./player play g --seed 7 --record straight.demo >none 2>none
for signal in SEGV BUS FPE ILL ABRT; do
    before=$(count)
    killed $signal
    same "SIG$signal ends it as ever" $((128 + $(kill -l $signal))) $code
    same "SIG$signal: one report more" $((before + 1)) "$(count)"
    check "SIG$signal: which the log names" \
        grep -qx "curtain: crashed (SIG$signal); report: $reports/probe-.*txt" err
    file=$(reported)
    check "SIG$signal: it says so" grep -q "a crash: SIG$signal, in frame 100" "$file"
    same "SIG$signal: its demo holds" "$file: holds, 100 frames" "$("$curtain" verify g "$file")"
done
check 'nobody else may read it' test "$(stat -c %a "$file")" = 600
"$curtain" hash g --demo "$file" >one
"$curtain" hash g --demo straight.demo >two
same 'the run is the one that was played' "$(sed -n 101p two)" "$(sed -n 101p one)"
keys 30 | ./player play g --seed 7 >out 2>err
same 'the next start says so' "curtain: Curtain crashed last time. Report: $file" "$(cat err)"
keys 30 | ./player play g --seed 7 >out 2>err
same '... once' '' "$(cat err)"
killed SEGV --record own.demo
check 'with a recording of its own, too' eval '"$curtain" verify g "$(reported)"'

# In the middle of a tick: its pads are the last of the demo, which has no end mark.
cp -R g loops
sed -i 's/then nothing()/then while true do end/' loops/main.lua
used() { awk '{ sub(/.*\) /, ""); print $12 + $13 }' "/proc/$player/stat" 2>/dev/null || echo 999999999; }
rm -f in && mkfifo in
./player play loops --seed 7 <in >out 2>err &
player=$!
exec 7>in
played | head -n 100 >&7
for _ in $(seq 20000); do [ "$(wc -l <out)" -ge 100 ] && break; sleep 0.025; done
before=$(used)
keys 1 $B >&7
until [ $(($(used) - before)) -gt 12 ]; do sleep 0.02; done
kill -SEGV $player
exec 7>&-
wait $player 2>/dev/null
check 'in a tick: it says so' grep -qx 'reason    a crash: SIGSEGV, in the tick after frame 100' "$(reported)"
"$curtain" verify loops "$(reported)" >said 2>&1
same '... its demo is cut short' 2 $?
check '...' grep -q truncated said
"$OUT/curtain-short" hash loops --demo "$(reported)" >said 2>why
same '... and leads into that tick' 2 $?
check '... again' grep -q 'main.lua:4: infinite loop' why
same '... with all frames before it' 100 "$(tail -n 1 said | cut -d" " -f1)"

# In the middle of a run that was gone back in, the report ends where the player was.
rm -f in && mkfifo in
./player play g --seed 7 <in >out 2>err &
player=$!
exec 7>in
{ played | head -n 100; keys 30 $BACKSPACE; } >&7
for _ in $(seq 20000); do [ "$(wc -l <out)" -ge 130 ] && break; sleep 0.025; done
kill -SEGV $player
exec 7>&-
wait $player 2>/dev/null
file=$(reported)
at=$(sed -n 's/^reason .* in frame //p' "$file")
check 'gone back: it says where' test "$at" -lt 100
same '... its demo has no end mark' 2 "$("$curtain" verify g "$file" >none 2>said; echo $?)"
check '... and goes as far as that' eval '[ "$("$curtain" hash g --demo "$file" 2>none | wc -l)" = $((at + 1)) ]'

# ---- not too many ----
for i in $(seq 30); do
    echo x >"$reports/old-$i.txt"
    touch -d "2001-01-$i" "$reports/old-$i.txt"
done
echo mine >"$reports/notes"
{ played; keys 20 $B; } | ./player play g --seed 8 >out 2>err
same 'twenty are kept' 20 "$(count)"
check 'the newest of them' test -e "$reports/old-30.txt" -a ! -e "$reports/old-10.txt" -a -e "$(newest)"
check 'and what is no report' test -e "$reports/notes"
check 'the new one is there' has 'a fault, in frame 161'

# ---- nowhere ----
rm -rf "$reports" && echo file >"$reports"
{ played; keys 20 $B; } | ./player play g --seed 8 >out 2>err
same 'a report that cannot be written: exit code as ever' 2 $?
check '... said' grep -q "curtain: $reports/probe-.*: cannot be written (" err
killed SEGV
same 'a crash without: as ever' $((128 + 11)) $code
check '... said' grep -q "curtain: crashed (SIGSEGV); cannot write a report to $reports/" err
finish
