#!/usr/bin/env bash
# sound.sh - curtain sound and render --wav: lists, levels, files, the same bytes on every machine; and what is refused.
. "$(dirname "$0")/../tap.sh"
sandbox

game g <<'LUA'
music.play("tide")
task.go(function()
  while true do
    music.wait()
    sound.play("hit", { pan = music.beat() % 3 - 1 })
  end
end)
LUA

"$curtain" sound g >list
same "the list" "sound hit: 0.32 s, peak -16.9 dB, -24.5 LUFS, 356 bytes, MML, tracks 1, limit 2
music tide: 1.60 s, loop 1.60 s, peak -16.6 dB, -18.9 LUFS, 444 bytes, MML, tracks 1, markers 1" "$(cat list)"
"$curtain" sound g hit -o hit.wav >level
same "its length and level" "hit: 0.32 s, peak -16.9 dB, mean -30.3 dB, -24.5 LUFS" "$(cat level)"
same "as many frames as it says, 4 bytes each" $((44 + 19 * 3200)) "$(wc -c <hit.wav)"
"$curtain" render g --frames 300 --wav run.wav
same "a frame is 800 stereo frames" $((44 + 300 * 3200)) "$(wc -c <run.wav)"
same "the bytes of every machine" 951808de4a0bc947 "$(sha256sum <run.wav | cut -c1-16)"
"$curtain" render g --frames 200:300 --wav again.wav
check "from the beginning, whichever frames are wanted" cmp run.wav again.wav
"$curtain" hash g --frames 300 --every 300 >quiet
"$curtain" render g --frames 300 --wav other.wav
"$curtain" hash g --frames 300 --every 300 >heard
check "hearing it changes nothing" cmp quiet heard

while IFS='|' read -r words text; do
    refuse "$words" "$text" "$curtain" $words
done <<'END'
sound g hut|sound: no "hut" in this game (did you mean "hit"?)
sound g -o x.wav|-o needs the name of a sound or a piece of music
sound g hit -o x.wav --wav y.wav|--wav cannot be combined with -o
sound g hit --play|cannot open a window
END
"$curtain" sound g hit --play 2>/dev/null
same "which is the host's fault" 3 $?
check "nothing was written" test ! -e x.wav
refuse "a file that cannot be" 'g/rom.lua/x.wav' "$curtain" sound g hit -o g/rom.lua/x.wav
printf 'A c7\n' >g/music/tide.mml
refuse "MML with a mistake: file, line and column" 'music/tide.mml:1:4: a length of 1/7' "$curtain" pack g -o g.rom
echo 'A L c1' >g/music/tide.mml
"$curtain" sound g tide --notes | head -n 99 >notes
check "the notes of what repeats one event have an end" [ "$(wc -l <notes)" -lt 99 ]
finish
