#!/usr/bin/env bash
# batch.sh - `verify ROM -` as a score server uses it: a thousand names, some of demos that are damaged in places this
# script knows; a line each, every one right, in the order of the names; and memory that does not grow with them.
. "$(dirname "$0")/../tap.sh"
sandbox

# Five demos of a game that draws random numbers and listens to the pads.
game g <<'LUA'
bullet.def("orb", { sprite = "dot", hit = "none" })
task.go(function()
  while true do
    if pad.down("fire") then bullet.fire { kind = "orb", x = 32, y = 32, speed = rng.int(1, 3), dir = rng.dir() } end
    if board.frame() % 7 == rng.int(0, 6) then board.note(rng.int(1, 99)) end
    wait(1)
  end
end)
LUA
frames=(1 60 125 200 333)
for i in 0 1 2 3 4; do
    "$curtain" hash g --seed $((i + 1)) --difficulty hard --frames "${frames[$i]}" --every 1000 --record "good$i.demo" \
        >/dev/null
done

# patch DEMO BYTE TO: one bit of it flipped, and the checksums made good again.
patch() { python3 "$repo/tests/cli/demo_repair.py" "$1" "$3" "$2"; }
# Where the record i of a demo starts.
record() {
    python3 -c '
import struct, sys
data, at = open(sys.argv[1], "rb").read(), 8
for _ in range(int(sys.argv[2])):
    at += 12 + struct.unpack_from("<I", data, at + 4)[0]
print(at)' "$1" "$2"
}

# Thirteen that are not good, and what has to be said of each.
declare -A want
for i in 0 1 2 3 4; do want[good$i.demo]="holds, ${frames[$i]} frames"; done
bad() { want[$1]=$2; }
size=$(stat -c %s good3.demo)
head -c 7 good3.demo >bad1.demo && bad bad1.demo 'not a demo'
head -c 20 good3.demo >bad2.demo && bad bad2.demo 'truncated header'
head -c "$(record good3.demo 3)" good3.demo >bad3.demo && bad bad3.demo 'truncated: 60 frames and no end mark'
head -c $((size - 1)) good3.demo >bad4.demo && bad bad4.demo 'truncated: 200 frames and no end mark'
{ cat good3.demo && printf 'x'; } >bad5.demo && bad bad5.demo '1 extra bytes after its end'
bad bad6.demo 'no such file'
at=$(record good3.demo 2)
cp good3.demo bad7.demo # a flipped bit that nobody repaired
printf '\x55' | dd of=bad7.demo bs=1 seek=$((at + 9)) conv=notrunc 2>/dev/null
bad bad7.demo "damaged record at byte $at (CRC)"
# Format 9; then with good checksums: the game's id, the first row, the seed, pads of the first second, the core
# version.
python3 -c 'd = bytearray(open("good3.demo", "rb").read()); d[4] = 9; open("bad8.demo", "wb").write(d)'
bad bad8.demo 'demo format 9; this build reads 2 to 5'
id=$(grep -abo probe good3.demo | head -1 | cut -d: -f1)
patch good3.demo "$id" bad9.demo && bad bad9.demo 'demo for another game ("qrobe"; this game is "probe")'
patch good3.demo $(($(record good3.demo 2) - 12)) bad10.demo && bad bad10.demo 'frame 0: camera differs'
seed=$((8 + 8 + 4 + 8 + 8 + 1 + 5 + 1 + $(strings -n 5 good3.demo | grep -om1 '5\.4\.[0-9]*' | tr -d '\n' | wc -c)))
patch good3.demo $seed bad11.demo && bad bad11.demo 'frame 0: board, sparks differ'
pads() { # DEMO RECORD: the byte of player 1's first run in that second
    echo $(($(record "$1" "$2") + 8 + 8 + 2))
}
patch good3.demo "$(pads good3.demo 2)" bad12.demo && bad bad12.demo 'frame 1: input differs'
core=$("$curtain" version | sed -n "s,.*(core \([0-9]*\).*,\1,p")
patch good3.demo 16 bad13.demo &&
    bad bad13.demo "holds, 200 frames (recorded with core version $((core ^ 1)); this is version $core)"

# A thousand names: each bad one once, between good ones.
python3 - >names <<'END'
import random
random.seed(7)
names = ["bad%d.demo" % i for i in range(1, 14)] + ["good%d.demo" % (i % 5) for i in range(987)]
random.shuffle(names)
print("\n".join(names))
END
while read -r name; do echo "$name: ${want[$name]}"; done <names >wanted
run() { # NAMES OUT: prints exit code and peak memory in KiB
    python3 - "$curtain" "$1" "$2" <<'END'
import resource, subprocess, sys
program, names, out = sys.argv[1:]
code = subprocess.call([program, "verify", "g", "-"], stdin=open(names), stdout=open(out, "w"))
print(code, resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)
END
}
read -r code most < <(run names got)
same 'a thousand names: the worst code is that of bad input' 2 "$code"
same 'a thousand lines' 1000 "$(wc -l <got)"
if cmp -s wanted got; then ok 'every verdict is right'; else not_ok 'every verdict is right' \
    "$(diff wanted got | head -20)"; fi
same 'nothing is said elsewhere' '' "$("$curtain" verify g - <names 2>&1 >/dev/null)"

# ---- memory ----

head -20 names >few
read -r code least < <(run few few.got)
same 'twenty of them' "$(head -20 wanted)" "$(cat few.got)"
check "memory is flat: $least KiB after 20 names, $most after 1000" [ "$most" -le $((least + 1024)) ]

# ---- names ----

sed 's/$/\r/' few | "$curtain" verify g - >got
same 'names may end in a carriage return' "$(head -20 wanted)" "$(cat got)"
tr '\n' '\0' <few | "$curtain" verify g - --null >got
same 'names may end in NUL' "$(head -20 wanted)" "$(cat got)"
printf '\n\ngood1.demo\n\n\ngood2.demo' | "$curtain" verify g - >got
code=$?
same 'empty lines are passed over, and the last may lack its end' \
    "0 $(printf 'good1.demo: %s\ngood2.demo: %s' "${want[good1.demo]}" "${want[good2.demo]}")" "$code $(cat got)"
cp good1.demo $'odd \n name.demo'
printf 'odd \n name.demo\0' | "$curtain" verify g - -0 >got
same 'a name with a newline is one line' 'odd   name.demo: holds, 60 frames' "$(cat got)"
{ printf '%02000d\n' 0 && echo good1.demo; } | "$curtain" verify g - >got
code=$?
same 'a name without end, and the one after it' \
    "2 $(printf '%01023d' 0): name too long|good1.demo: holds, 60 frames|" "$code $(tr '\n' '|' <got)"
"$curtain" verify g - </dev/null >got 2>&1
same 'no names' '0 ' "$? $(cat got)"
# A line comes before the next name is there.
coproc server { "$curtain" verify g - 2>&1; }
for i in 0 1 2; do
    echo "good$i.demo" >&"${server[1]}"
    read -r -t 60 line <&"${server[0]}"
    same "a name, and its line at once ($i)" "good$i.demo: ${want[good$i.demo]}" "$line"
done
# shellcheck disable=SC2093,SC1083
exec {server[1]}>&-
# shellcheck disable=SC2154 # coproc sets it
wait "$server_PID" 2>/dev/null

finish
