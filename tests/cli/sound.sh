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
same "the list" "sound hit: 356 bytes, MML, tracks 1, limit 2
music tide: 444 bytes, MML, tracks 1, markers 1, endless" "$(cat list)"
"$curtain" sound g hit -o hit.wav >level
same "its length and level" "hit: 0.32 s, peak -16.9 dB, mean -30.3 dB" "$(cat level)"
same "as many frames as it says, 4 bytes each" $((44 + 19 * 3200)) "$(wc -c <hit.wav)"
"$curtain" render g --frames 300 --wav run.wav
same "a frame is 800 stereo frames" $((44 + 300 * 3200)) "$(wc -c <run.wav)"
same "the bytes of every machine" 951808de4a0bc947 "$(sha256sum <run.wav | cut -c1-16)"
check "and no pictures" bash -c '! ls *.png'
"$curtain" render g --frames 200:300 --wav again.wav
check "from the beginning, whichever frames are wanted" cmp run.wav again.wav
"$curtain" hash g --frames 300 --every 300 >quiet
"$curtain" render g --frames 300 --wav other.wav
"$curtain" hash g --frames 300 --every 300 >heard
check "hearing it changes nothing" cmp quiet heard

refuse "a name that is not there" 'sound: the game has no "hut" (did you mean "hit"?)' "$curtain" sound g hut
refuse "no game" 'curtain: sound: expected' "$curtain" sound
refuse "a file that cannot be" 'g/rom.lua/x.wav' "$curtain" sound g hit -o g/rom.lua/x.wav
printf 'A c7\n' >g/music/tide.mml
refuse "MML with a mistake: file, line and column" 'music/tide.mml:1:4: a length of 1/7' "$curtain" pack g -o g.rom
rm g/music/tide.mml
refuse "a file that is not there" 'there is no music/tide.mml' "$curtain" pack g -o g.rom
finish
