#!/usr/bin/env bash
# window_sound.sh - sound in a real (virtual) window, SDL's disk driver in place of a card: what was played is what
# `render --wav` makes of the recorded run; under load, with a card whose clock is another, there is no gap and nothing
# comes twice; no speaker is touched by a game that is silent or muted.
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

settings() { mkdir -p data/curtain && printf '%s\n' 'away = go-on' "$@" >data/curtain/curtain.conf; }
played() { [ -f played.raw ] && [ "$(wc -c <played.raw)" -ge "$1" ]; } # BYTES: as many at least
compare() { python3 "$repo/tests/machine/played.py" "$@"; }

# ---- to the bit: the card leads, four times as slow as a real one, so a busy machine keeps up ----
settings "resample = no"
if SDL_DISKAUDIODELAY=20 start Probe "$OUT/curtain" play g --seed 3 --scale 1 --record run.demo; then
    check "it sounds" wait_until played 400000
    stop
    check "the demo holds" "$curtain" verify g run.demo
    "$curtain" render g --demo run.demo --frames "$("$curtain" hash g --demo run.demo | tail -1 | cut -d' ' -f1)" \
        --wav want.wav >none
    check "what was played is what is rendered" compare same played.raw want.wav
fi

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
    check "no gap and no repeat, the card $ppm ppm faster" compare sine played.raw 880
    check "as the log says" grep -q "gaps 0, dropped blocks 0" err
done
kill -KILL $busy
wait $busy 2>/dev/null
busy=

# ---- what touches no speaker ----
settings
export SDL_DISKAUDIODELAY=20
for arguments in 'silent' 'g --mute'; do
    rm -f played.raw
    start Probe "$OUT/curtain" play $arguments --scale 1 || continue
    wait_cpu 20
    check "no speaker: $arguments" test ! -e played.raw
    if [ "$arguments" = 'g --mute' ]; then
        xdotool key --delay 150 m
        check "until M opens one" wait_until played 20000
    fi
    stop
done
if SDL_AUDIODRIVER=alsa AUDIODEV=none start Probe "$OUT/curtain" play g --scale 1; then
    wait_cpu 20
    stop
    check "without a card the game plays, and says so" grep -q "^no sound: " err
fi

# ---- a speaker that goes, and comes ----
${CC:-cc} -std=c11 -D_DEFAULT_SOURCE -O1 $(sdl2-config --cflags) -o port_sound "$repo/tests/machine/port_sound.c" \
    "$repo"/platform/{sdl2,stdio,posix,posix_process}.c $(sdl2-config --libs) || exit 2
check "a speaker that goes, and comes" env SDL_VIDEODRIVER=dummy SDL_AUDIODRIVER=dummy ./port_sound

# ---- one sound, heard ----
rm -f played.raw
check "a sound is over by itself" "$OUT/curtain" sound g hit --play
check "and was played" played 20000
finish
