#!/usr/bin/env bash
# desync.sh - from "it does not hold" to the value that differs, with the program alone: a changed script, tracks and
# traces of two builds, and files that are neither. tests/machine/test_desync.c flips the bits of demos; test_trace.c
# plants bits.
. "$(dirname "$0")/../tap.sh"
sandbox
rom=$repo/roms/glasstide
"$curtain" pack "$rom" -o game.rom
cp "$rom/demos/run.demo" .
"$curtain" verify game.rom --restamp --prints every run.demo >/dev/null

# ---- a changed script byte ----

mkdir changed && cp -r "$rom" changed/glasstide
sed -i '0,/stage.at(\([0-9]*\)0)/s//stage.at(\11)/' changed/glasstide/stages/one.lua
same 'a script has one other byte' 1 "$(cmp -l "$rom/stages/one.lua" changed/glasstide/stages/one.lua | wc -l)"
line=$("$curtain" verify changed/glasstide run.demo)
frame=$(sed -n 's/.*: frame \([0-9]*\): .*script.* (recorded with another game version)$/\1/p' <<<"$line")
check "it is found: $line" [ -n "$frame" ]
"$curtain" hash game.rom --demo run.demo --parts >a.track 2>/dev/null
"$curtain" hash changed/glasstide --demo run.demo --parts --frames $((frame + 200)) 2>/dev/null |
    head -n $((frame + 150)) >b.track
head -n $((frame + 150)) a.track >a2.track
"$curtain" verify --bisect a2.track b.track >out
same 'tracks of both builds say the same frame' "1 first difference: frame $frame" "$? $(head -1 out)"
command=$(sed -n 's/^to compare columns and slots.*: hash ROM --demo DEMO //p' out)
"$curtain" hash game.rom --demo run.demo $command >a.trace 2>/dev/null
"$curtain" hash changed/glasstide --demo run.demo $command >b.trace 2>/dev/null
"$curtain" verify --bisect a.trace b.trace >out
code=$?
same 'and their traces, by the command it prints' "1 first difference: frame $frame" "$code $(head -1 out)"
check 'a column, and both values' grep -Eq '^  script digest: [0-9a-f]{16} in a.trace, [0-9a-f]{16} in b.trace$' out

# ---- bisect ----

bisect() { # NAME CODE LINES A B
    local got code
    got=$("$curtain" verify --bisect "$4" "$5" 2>&1)
    code=$?
    same "$1" "$2 $3" "$code $got"
}
"$curtain" hash game.rom --demo run.demo --frames 200 >whole 2>/dev/null
"$curtain" hash game.rom --demo run.demo --frames 200 --parts >parts 2>/dev/null
"$curtain" hash game.rom --demo run.demo --frames 2198:2200 --trace input,player,pal >trace 2>/dev/null
bisect 'equal tracks' 0 'whole and whole are equal: 201 frames, 0 to 200' whole whole
sed $'1s/^/\xef\xbb\xbf/' whole >marked
bisect 'a track with a byte order mark' 0 'whole and marked are equal: 201 frames, 0 to 200' whole marked
bisect 'equal traces' 0 'trace and trace are equal: 3 frames, 2198 to 2200' trace trace
"$curtain" verify --bisect parts - <parts >out
same 'standard input' '0 parts and standard input are equal: 201 frames, 0 to 200' "$? $(cat out)"
sed '101s/ ./ g/' whole >bad
bisect 'no hash' 2 'curtain: bad:101: expected a line printed by "hash" or "hash --trace"' whole bad
sed '101s/ [0-9a-f]\{4\}/ 0000/' whole >other
hash=$(sed -n '101s/^100 //p' whole)
bisect 'a track without parts' 1 "first difference: frame 100
  $hash in whole, 0000${hash:4} in other; use hash --parts to compare parts" whole other
sed '51s/ pal=[0-9a-f]*/ pal=0123456789abcdef/; 51s/ input=[0-9a-f]*//; 60s/bullets/bulets/' parts >other
pal=$(sed -n '51s/.* pal=\([0-9a-f]*\).*/\1/p' parts) input=$(sed -n '51s/.* input=\([0-9a-f]*\).*/\1/p' parts)
bisect 'several parts, one of them missing' 1 "first difference: frame 50
  input: $input in parts, missing in other
  pal: $pal in parts, 0123456789abcdef in other
to compare columns and slots, run in both builds: hash ROM --demo DEMO --trace input,pal --frames 49:50" \
    parts other
head -n 100 whole >short
bisect 'a shorter track' 2 'curtain: short ends in frame 99; whole is longer, and the two are equal up to that frame' \
    whole short
sed 1d whole >other
bisect 'other frames' 2 'curtain: whole:1 has frame 0, but other:1 has frame 1: the traces cover different frames' \
    whole other
bisect 'a track and a trace' 2 'curtain: whole is a track, trace a trace' whole trace
: >empty
bisect 'an empty file' 2 'curtain: empty: empty' whole empty
head -c 100 whole >part
bisect 'a line cut short' 2 "curtain: part:$(($(head -c 100 whole | wc -l) + 1)): truncated line" part whole
sed '7p' whole >other
bisect 'a line twice' 2 'curtain: other:8: out of order' whole other
line=$(grep -nm1 ' pal [0-9]' trace | cut -d: -f1)
sed "${line}{h;d};$((line + 1)){G}" trace >other
bisect 'slots out of order' 2 "curtain: other:$((line + 1)): out of order" other other
sed '2s/ held=/ held /' trace >other
bisect 'a column without its value' 2 'curtain: other:2: expected a line printed by "hash" or "hash --trace"' trace \
    other
sed '2s/held=/hold=/' trace >other
bisect 'a column of another name' 1 "first difference: frame 2198
  input 0 held: $(sed -n '2s/.*held=\([^ ]*\).*/\1/p' trace) in trace, 0 in other
  input 0 hold: 0 in trace, $(sed -n '2s/.*held=\([^ ]*\).*/\1/p' trace) in other" trace other
python3 - >many <<'END'
import re
for line in open("trace"):
    print(re.sub(r"rgb=[0-9a-f]{8}", "rgb=77777777", line), end="")
END
"$curtain" verify --bisect trace many >out
code=$?
same 'many differences are counted' "1 42 1 $(($(grep -c '^2198 pal .*rgb=' trace) - 40))" \
    "$code $(wc -l <out) $(grep -c '^first difference: frame 2198' out) $(sed -n 's/^  and \([0-9]*\) more$/\1/p' out)"

# Files of any size: a megabyte of trace or a hundred, the memory is the same.
"$curtain" hash game.rom --demo run.demo --frames 1000:1100 --trace all >little 2>/dev/null
"$curtain" hash game.rom --demo run.demo --frames 1000:2900 --trace all >large 2>/dev/null
peak() {
    python3 - "$curtain" "$1" <<'END'
import resource, subprocess, sys
code = subprocess.call([sys.argv[1], "verify", "--bisect", sys.argv[2], sys.argv[2]], stdout=subprocess.DEVNULL)
print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss if code == 0 else "fails")
END
}
a=$(peak little) b=$(peak large)
check "memory: $a KiB for $(($(stat -c %s little) >> 20)) MiB, $b KiB for $(($(stat -c %s large) >> 20)) MiB" [ "$b" \
    -le $((a + 512)) ]
finish
