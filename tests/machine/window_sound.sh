#!/usr/bin/env bash
# window_sound.sh - sound in a real (virtual) window, SDL's disk driver in place of a card: what was played is what
# `render --wav` makes of the recorded run; under load, with a card whose clock is another, there is no gap and nothing
# comes twice; no speaker is touched by a game that is silent or muted; and none of it is seen in a demo.
. "$(dirname "$0")/../xserver.sh"
${CC:-cc} -std=c11 -O1 -shared -fPIC -o slow_clock.so "$repo/tests/machine/slow_clock.c" || exit 2
export SDL_AUDIODRIVER=disk SDL_DISKAUDIOFILE=$scratch/played.raw

game g <<'LUA'
music.play("tide")
task.go(function()
  while true do
    music.wait()
    sound.play("hit", { pan = music.beat() % 3 - 1 })
  end
end)
LUA
game steady <<'LUA'
music.play("tide")
local work = 0
task.go(function()
  for i = 1, forever do
    for _ = 1, i % 40 < 2 and 400000 or 0 do work = work + 1 end
    wait(1)
  end
end)
LUA
cat >steady/music/tide.mml <<'MML'
@s sine attack=20 decay=0 sustain=100
A t60 @s o5 V70 L a1^1^1^1^1^1^1^1^1^1^1^1^1^1^1^1
MML
game silent <<'LUA'
task.go(function() wait(forever) end)
LUA
mkdir -p data/curtain

settings() { printf '%s\n' 'away = go-on' "$@" >data/curtain/curtain.conf; }
played() { [ -f played.raw ] && [ "$(wc -c <played.raw)" -ge "$1" ]; } # BYTES: as many at least
last() { "$curtain" hash "$1" --demo "$2" | tail -1 | cut -d' ' -f1; } # GAME DEMO
rendered() { # GAME DEMO OUT
    "$curtain" render "$1" --demo "$2" --frames "$(last "$1" "$2")" --wav "$3"
}
same_frames() { python3 "$repo/tests/machine/played.py" same "$@"; }
unbroken() { python3 "$repo/tests/machine/played.py" sine "$@"; }

# ---- to the bit: the card leads, four times as slow as a real one, so a busy machine keeps up ----
settings "resample = no"
exactly() { # GAME TITLE BYTES [KEY...]
    local game=$1 title=$2 bytes=$3 key
    shift 3
    rm -f played.raw
    SDL_DISKAUDIODELAY=20 start "$title" "$OUT/curtain" play "$game" --seed 3 --scale 1 --record run.demo || return
    for key; do
        xdotool keydown "$key"
        wait_cpu 3
        xdotool keyup "$key"
        wait_cpu 3
    done
    check "$title sounds" wait_until played "$bytes"
    stop
    check "$title: the demo holds" "$curtain" verify "$game" run.demo
    rendered "$game" run.demo want.wav
    check "$title: what was played is what is rendered" same_frames played.raw want.wav
}
exactly g Probe 400000
exactly "$repo/roms/glasstide" "Glass Tide" 400000 Return z z z Left

# ---- under load, at a rate that is adjusted: twelve times as slow, and the card's clock is another by 0.4 % ----
settings "resample = yes"
for _ in 1 2 3; do
    while :; do :; done &
    busy="$busy $!"
done
for ppm in 4000 -4000; do
    rm -f played.raw
    SDL_DISKAUDIODELAY=5 start Probe env SLOWER=12 CARD_PPM=$ppm LD_PRELOAD="$scratch/slow_clock.so" \
        "$OUT/curtain" play steady --seed 0 --scale 1 --verbose || continue
    check "a tone under load" wait_until played 330000
    stop
    check "no gap and no repeat, the card $ppm ppm faster" unbroken played.raw 880
    check "which is what it says" grep -q "gaps 0, dropped blocks 0" err
done
kill -KILL $busy
wait $busy 2>/dev/null
busy=

# ---- what touches no speaker ----
export SDL_DISKAUDIODELAY=20
quiet() { # TITLE ARGUMENT...: plays, and writes no file
    rm -f played.raw
    start Probe "$OUT/curtain" play "$@" --scale 1 || return
    wait_cpu 20
    check "no speaker: $*" test ! -e played.raw
}
quiet silent && stop
quiet g --mute && {
    xdotool key --delay 150 m
    check "until M opens one" wait_until played 20000
    stop
}
settings "mute = yes"
quiet g && stop
settings "volume = 100"
export SDL_AUDIODRIVER=alsa AUDIODEV=none
if start Probe "$OUT/curtain" play g --scale 1 --verbose; then
    wait_cpu 20
    stop
    check "without a card the game plays, and says so in a line" grep -q "^no sound: " err
    same "and no other" 2 "$(wc -l <err)"
fi

# ---- a speaker that goes, and comes ----
${CC:-cc} -std=c11 -D_DEFAULT_SOURCE -O1 $(sdl2-config --cflags) -o port_sound "$repo/tests/machine/port_sound.c" \
    "$repo"/platform/{sdl2,stdio,posix,posix_process}.c $(sdl2-config --libs) || exit 2
check "a speaker that goes, and comes" env SDL_VIDEODRIVER=dummy SDL_AUDIODRIVER=dummy ./port_sound

# ---- one sound, heard ----
export SDL_AUDIODRIVER=disk AUDIODEV=
rm -f played.raw
check "a sound is over by itself" "$OUT/curtain" sound g hit --play
check "and was played" played 20000
if start "curtain: tide" "$OUT/curtain" sound g tide --play; then
    check "a piece goes on" wait_until played 200000
    stop Escape
fi

# ---- none of it is seen in a demo ----
export SDL_AUDIODRIVER=disk AUDIODEV=
again() { # OUT OPTION...: plays run.demo, recorded anew
    local out=$1
    shift
    start Probe "$OUT/curtain" play g --demo run.demo --record "$out" --scale 1 "$@" || return
    check "a playback ends: $out" wait_until has_exited
    kill_program
}
if start Probe "$OUT/curtain" play g --seed 3 --scale 1 --record run.demo; then
    wait_cpu 40
    stop
fi
again on.demo
again muted.demo --mute
"$curtain" hash g --demo run.demo --record off.demo --parts >off.hashes
"$curtain" render g --demo run.demo --frames "$(last g run.demo)" --wav x.wav --record wav.demo
for way in muted off wav; do check "the same run: $way" cmp on.demo $way.demo; done
check "and it holds" "$curtain" verify g on.demo muted.demo
finish
