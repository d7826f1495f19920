#!/usr/bin/env bash
# new_player.sh - the way of a new player in a real (virtual) X server: from the attract demo of Glass Tide to a flying
# ship, into the settings, back to the title and out, with keys and again with a controller alone. Presses are counted:
# three to the flying ship. What the window shows is known by the text that is looked up (lookups.c).
. "$(dirname "$0")/../xserver.sh"
. "$repo/tests/pads.sh"
export SDL_AUDIODRIVER=dummy SDL_JOYSTICK_ALLOW_BACKGROUND_EVENTS=1

${CC:-cc} -std=c11 -O1 -o window_player "$repo/tests/machine/lookups.c" -Wl,--wrap=words_find \
    $(find "$OUT/src" -name '*.o') "$OUT"/fb/*.o "$OUT"/gen/{std,no_rom}.o \
    "$OUT"/platform/{sdl2,stdio,posix,posix_process}.o $(pkg-config --libs lua5.4) $(sdl2-config --libs) -lm -pthread ||
    exit 2

seen=0 presses=0 device=
# shows TEXT: has been looked up since the last press; capitals do not matter
shows() { tail -n "+$((seen + 1))" lookups | grep -aqix -- "[-+]$1"; }
# press KEY SWITCH: on the device in use
press() {
    presses=$((presses + 1))
    seen=$(wc -l <lookups)
    if [ $device = keys ]; then xdotool key --delay 100 "$1"; else pad tap 1 "$2"; fi
}
# rows KEY SWITCH N: to the Nth row from here
rows() {
    local i
    for i in $(seq "$3"); do press "$1" "$2"; done
}
# step PLACE TEXT KEY SWITCH: this press leads to the place
step() {
    press "$3" "$4"
    arrive "press $presses: $1" shows "$2"
}
# arrive PLACE COMMAND...: holds soon; otherwise the way ends here
arrive() {
    wait_until "${@:2}" && ok "$device, $1" && return
    not_ok "$device, $1" "not reached; last looked up:" "$(tail -n 3 lookups)"
    return 1
}
way() {
    seen=0 presses=0
    xdotool keydown slash # the opening and the title pass faster while it is held
    arrive 'the attract demo, whose HUD is shown' shows "GRAZE"
    xdotool keyup slash
    step 'the menu of the title' 'HOW TO PLAY' Return start &&
        step 'the page Start' 'DIFFICULTY' Return start &&
        step 'the first stage' 'STAGE %s' Return start || return
    same "$device: presses from the attract demo to a flying ship" 3 $presses
    step 'the pause menu' 'Quit to Title' Escape start || return
    rows Down down 2
    step 'the settings' 'Accessibility' z south &&
        step 'the pause menu' 'Quit to Title' x east || return
    rows Down down 3
    step 'the question' 'Quit? A replay .*' z south || return
    rows Down down 1
    step 'the menu of the title again' 'HOW TO PLAY' z south || return
    rows Up up 1
    step 'the question' 'Quit the game?' z south || return
    rows Down down 1
    # The program ends before it could say that it has seen the switch.
    if [ $device = keys ]; then xdotool key z; else echo 'down 1 south' >>"$pads_script"; fi
    arrive "press $((presses + 1)): the program has ended" has_exited
}
for device in keys controller; do
    rm -rf data
    : >lookups
    pads_none
    pads_said=0
    if start "Glass Tide" "${padded[@]}" ./window_player play "$repo/roms/glasstide" --mute --scale 2; then
        [ $device = keys ] || check "a controller is plugged in" pad plug 1 xbox
        way
        kill_program
    fi
done
finish
