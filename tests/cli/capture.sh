#!/usr/bin/env bash
# capture.sh - `curtain capture`: films, decoded by ImageMagick, are the frames that `curtain render` writes, to the
# last pixel and at the right times; in sizes, speeds and colours of all kinds; and what cannot be filmed is told in a
# sentence.
. "$(dirname "$0")/../tap.sh"
sandbox

film_same() { python3 "$repo/tests/cli/film_same.py" "$@"; }
# filmed NAME GAME "OPTIONS" FIRST LAST SCALE SPEED: films in two formats, read and compared; $read has what was read
filmed() {
    local name=$1 game=$2 options=$3 first=$4 last=$5 scale=$6 speed=$7 kind
    rm -rf frames film.*
    "$curtain" render "$game" $options --frames "$first:$last" -o frames || { not_ok "$name: frames"; return; }
    read=""
    for kind in gif y4m; do
        check "$name: a $kind" "$curtain" capture "$game" $options --frames "$first:$last" --scale "$scale" \
            --speed "$speed" -o film.$kind
        check "$name: the $kind is the frames" film_same film.$kind frames "$first" "$last" "$scale" "$speed"
        read="$read$(cat .said);"
    done
}

game plain <<'LUA'
bullet.def("orb", { sprite = "dot", hit = "none" })
task.go(function()
  while true do
    bullet.fire { kind = "orb", x = 32, y = 32, speed = 1, dir = rng.dir() }
    wait(7)
  end
end)
LUA
filmed "small" plain "--seed 3" 0 90 1 1
same "pictures of a change, none but the first a whole one" "gif 76 75;y4m 91 0;" "$read"
filmed "from the middle, three times as large, twice as fast" plain "" 31 95 3 2
filmed "one frame" plain "" 30 30 1 1
same "one frame is one picture" "gif 1 0;y4m 1 0;" "$read"

filmed "a game's stage" "$repo/examples/sandbox" "--stage try --dim half --press left" 100 130 1 1

# Nothing changes: a picture that lasts. Longer than a delay can say, too.
game still </dev/null
filmed "nothing changes" still "" 0 59 1 1
same "nothing is one picture" "gif 1 0;y4m 60 0;" "$read"
"$curtain" render still --frames 0 -o long
python3 -c 'for i in range(1, 4201): __import__("os").link("long/000000.png", "long/%06d.png" % i)'
"$curtain" capture still --frames 0:4200 --speed 1/16 -o long.gif
check "a GIF that stands still for 18 minutes" film_same long.gif long 0 4200 1 1/16
same "... has a pixel more for what a delay cannot say" "2 1" "$(cut -d ' ' -f 2,3 .said)"

# The palette changes in the middle: pictures of a GIF get their own palette.
game colours <<'LUA'
bullet.def("orb", { sprite = "dot", hit = "none" })
task.go(function()
  bullet.fire { kind = "orb", x = 8, y = 8, speed = 1, dir = 45 }
  wait(20)
  for i = 0, 15 do palette.set(i, 0x203040 + i * 0x0b0703) end
  wait(20)
  for n = 1, 400 do
    for i = 0, 15 do palette.set(i, (n * 7919 + i * 104729) % 0x1000000) end
    wait(1)
  end
end)
LUA
filmed "other colours" colours "" 0 40 1 1
filmed "many colours" colours "" 10 420 1 1

# A demo to its end, without --frames; the sound as render gives it; standard output.
game music <<'LUA'
music.play("tide")
LUA
"$curtain" hash music --frames 100 --seed 9 --record m.demo >/dev/null
"$curtain" render music --demo m.demo --frames 0:100 -o song --wav song.wav
"$curtain" capture music --demo m.demo -o film.gif
check "a demo is filmed to its end" film_same film.gif song 0 100
"$curtain" capture music --demo m.demo -o film.wav
check "its sound is what render writes" cmp song.wav film.wav
"$curtain" capture music --demo m.demo --frames 51:100 -o part.wav
check "a part of it" cmp <(tail -c $((50 * 3200)) song.wav) <(tail -c +45 part.wav)
for kind in gif y4m wav; do
    "$curtain" capture music --demo m.demo --format $kind -o whole.$kind
    "$curtain" capture music --demo m.demo --format $kind -o - >out.$kind 2>err
    check "the same $kind on standard output" cmp whole.$kind out.$kind
    same "... and nothing else" "" "$(cat err)"
done

# A run that ends in a fault is filmed up to there.
game faulty <<'LUA'
task.go(function() wait(30) error("enough") end)
LUA
"$curtain" capture faulty --frames 0:60 -o fault.gif 2>err
same "a fault is told" "2 1" "$? $(grep -c 'main.lua:1: enough' err)"
"$curtain" render faulty --frames 0:30 -o upto
check "... and what was before it is there" film_same fault.gif upto 0 30

# MP4 and WebM are another program's work: what it is given.
mkdir bin
cat >bin/ffmpeg <<'SH'
#!/bin/sh
cat >fed.y4m
for word; do
    case $word in file:*.wav) cp "${word#file:}" fed.wav ;; esac
    last=$word
done
echo "$*" >fed.words
[ ! -e broken ] || exit 1
echo film >"${last#file:}"
SH
chmod +x bin/ffmpeg
PATH=$scratch/bin:$PATH "$curtain" capture music --demo m.demo -o "it's one.mp4"
same "an MP4 is written" film "$(cat "it's one.mp4")"
check "ffmpeg gets the pictures" film_same fed.y4m song 0 100
check "and the sound, from frame 0 on" cmp <(tail -c +45 song.wav) <(tail -c +$((45 + 3200)) fed.wav)
same "nothing else is left" "it's one.mp4" "$(ls it*)"
rm fed.*
PATH=$scratch/bin:$PATH "$curtain" capture music --demo m.demo --speed 2 -o fast.webm
check "a faster film has its pictures" film_same fed.y4m song 0 100 1 2
refuse "... and no sound" "No such file" ls fed.wav
cp -r music loud
echo 'task.go(function() while true do print("frame " .. board.frame()) wait(100) end end)' >>loud/main.lua
PATH="$scratch/bin:$PATH" "$curtain" capture loud --frames 10:420 -o loud.mp4 2>err
same "what scripts print is there once, though the run was gone through twice" 5 "$(grep -c '^frame\|frame [0-9]' err)"

echo 'task.go(function() wait(350) error("late") end)' >>loud/main.lua
PATH="$scratch/bin:$PATH" "$curtain" capture loud --frames 10:420 --record l.demo -o loud.mp4 2>err
same "a fault in the second run is reported" "2 1" "$? $(grep -c 'late' err)"
check "... and the recording is all of the run" grep -q "holds, 351 frames" <("$curtain" verify loud l.demo)
touch broken
refuse "ffmpeg fails" "x.mp4: ffmpeg failed" env PATH="$scratch/bin:$PATH" "$curtain" capture plain -o x.mp4
refuse "... and leaves nothing" "No such file" ls x.mp4 x.mp4.part x.mp4.part.wav
mkdir none && ln -s "$(command -v sh)" none/sh
refuse "no ffmpeg" "mp4 needs ffmpeg, which is not installed" env PATH="$scratch/none" \
    "$curtain" capture plain -o x.mp4

# A sentence for each slip.
slip() { # WHY WORDS OPTIONS...
    local why=$1 words=$2
    shift 2
    refuse "$why" "curtain: $words" "$curtain" capture plain "$@"
    same "... in one line" 1 "$(wc -l <.said)"
}
while IFS='|' read -r options text; do
    slip "capture $options" "$text" $options
done <<'END'
|capture needs -o
-o -|-o - needs --format
--format avi -o film|--format: expected gif, y4m, wav, mp4 or webm, got "avi"
--format webm -o -|-o - cannot be combined with webm
--scale 2 -o a.wav|--scale cannot be combined with WAV
--frames 1,2 -o a.gif|--frames: capture takes one range
--frames 1 -o plain/main.lua/a.gif|plain/main.lua/a.gif: cannot be written
END
sed 's/w = 64, h = 64/w = 384, h = 448/' plain/rom.lua >rom.lua && mv rom.lua plain/rom.lua
slip "too large" "--scale: frames of 6144 x 7168 pixels are too large" --scale 16 --frames 0 -o a.gif

# No room on the disk.
mknod full c 1 7 2>/dev/null || ln -s /dev/full full # root would lose /dev/full to a program that replaces it
for kind in gif y4m wav; do
    slip "a full disk, $kind" "full: cannot be written (No space left on device)" --frames 0:9 --format $kind -o full
    "$curtain" capture plain --frames 0:9 --format $kind -o - >/dev/full 2>err
    same "full standard output, $kind" 3 $?
done

finish
