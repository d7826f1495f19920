# driven.sh - the program's screens in a real (virtual) X server, driven by keys and by a controller, at three sizes,
# upright and turned: to the last pixel as tests/golden/screens has them. CURTAIN_UPDATE=1 writes those anew; look at
# them.
#
#     . "$(dirname "$0")/../driven.sh"    # xserver.sh and pads.sh
#     for_each_way COMMAND...             # calls it with $size (WxH), $turned ("" or "-turned") and $by (keys or pad)
#
# Each size, each device, upright and turned are among four ways; CURTAIN_LONG=1 goes all twelve.
. "$(dirname "${BASH_SOURCE[0]}")/xserver.sh"
. "$repo/tests/pads.sh"
export SDL_JOYSTICK_ALLOW_BACKGROUND_EVENTS=1
cd "$scratch" || exit 2
goldens=$repo/tests/golden/screens
mkdir -p "$goldens"

for_each_way() {
    local way ways='240x320:keys 320x240:pad 384x448-turned:keys 240x320-turned:pad'
    [ -z "${CURTAIN_LONG:-}${CURTAIN_UPDATE:-}" ] || ways=$(echo {240x320,320x240,384x448}{,-turned}:{keys,pad})
    for way in ${WAYS:-$ways}; do
        by=${way#*:} size=${way%%[-:]*} turned=
        case $way in *-turned:*) turned=-turned ;; esac
        "$@"
    done
}

# set_size GAME: at this size and turn, with settings of its own, nothing plugged in.
set_size() {
    sed -i "s/screen = { w = [0-9]*, h = [0-9]*/screen = { w = ${size%x*}, h = ${size#*x}/" "$1/rom.lua"
    rm -rf data
    mkdir -p data/curtain
    printf 'scale = 1\naway = go-on\n%s' "${turned:+turn = left}" >data/curtain/curtain.conf
    pads_none
    : >last.rgb
}

is_golden() { screenshot rgb:shot.rgb && cmp -s shot.rgb want.rgb; }
# It stands still: two looks that are alike, and not what was seen last.
is_still() {
    screenshot rgb:before.rgb && ! cmp -s before.rgb last.rgb && sleep 0.3 && screenshot rgb:shot.rgb &&
        cmp -s shot.rgb before.rgb
}
# expect_screen NAME: the window shows the golden picture of that name.
expect_screen() {
    local golden=$goldens/$size$turned-$1-$by.png
    if [ "${CURTAIN_UPDATE:-}" ]; then
        wait_until is_still
        cp shot.rgb last.rgb
        convert "xwd:$scratch/shot.xwd" -strip -define png:exclude-chunks=date,time "png:$golden"
    fi
    convert "$golden" -depth 8 rgb:want.rgb 2>/dev/null || : >want.rgb
    check "$size$turned: $1, by $by" wait_until is_golden
}

# press_each WHAT...: one press each: up down left right yes no menu, of whoever drives. The program has seen one before
# the next comes.
press_each() {
    local what
    for what in "$@"; do
        case $by-$what in
        keys-yes) xdotool key Return ;;
        keys-no | keys-menu) xdotool key Escape ;;
        keys-*) xdotool key "${what^}" ;;
        pad-yes) pad tap 1 south ;;
        pad-no) pad tap 1 east ;;
        pad-menu) pad tap 1 guide ;;
        pad-*) pad tap 1 "$what" ;;
        esac
        pad wait 4
    done
}
