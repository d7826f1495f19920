# shellcheck shell=bash
# xserver.sh - tap.sh, and an X server of our own with programs in its window.
#
#     . "$(dirname "$0")/../xserver.sh"
#
# Afterwards DISPLAY is set, $scratch is the working folder, and start TITLE COMMAND... runs a program whose window is
# $win.
. "$(dirname "${BASH_SOURCE[0]}")/tap.sh"
sandbox
for tool in Xvfb xdotool xwd xprop convert openbox setxkbmap sdl2-config; do
    command -v $tool >/dev/null || { not_ok "$tool is installed"; finish; }
done
child='' other='' busy='' xvfb='' wm='' # processes that end with the script
trap 'kill -KILL $child $other $busy $wm $xvfb 2>/dev/null; clean_up' EXIT

# wait_until COMMAND...: tries until it holds. Gives up when the program has used 10 s of the processor's time, however
# long that takes; one that uses none is given 2000 tries. The last try comes after that look: a program that ended
# between the two has no time to read.
wait_until() {
    local from try=0
    from=$(cpu_used)
    until "$@"; do
        try=$((try + 1))
        [ $try -lt 2000 ] && { [ $try -lt 100 ] || [ $(($(cpu_used) - from)) -lt 1000 ]; } || { "$@"; return; }
        sleep 0.05
    done
}
# Hundredths of a second of the processor's time that the program has used: how far it has gone round, on any machine.
cpu_used() { awk '{ sub(/.*\) /, ""); print $12 + $13 }' "/proc/$child/stat" 2>/dev/null || echo 999999999; }
# wait_cpu N: until it has gone on for that much.
wait_cpu() {
    local from
    from=$(cpu_used)
    until has_exited || [ $(($(cpu_used) - from)) -gt "$1" ]; do sleep 0.05; done
}
says() { grep -qx -- "$1" "$scratch/out"; }
# A program that has ended stays as a zombie where the machine's first process does not collect those of others.
has_exited() { ! readlink "/proc/$child/exe" >/dev/null; }

# X picks a free display number and writes it down.
Xvfb -displayfd 3 -screen 0 1100x1000x24 -nolisten tcp 3>"$scratch/display" >/dev/null 2>&1 &
xvfb=$!
wait_until test -s "$scratch/display" || { echo "xserver.sh: Xvfb does not start" >&2; exit 2; }
DISPLAY=:$(cat "$scratch/display")
export DISPLAY

# start TITLE COMMAND...: sets child, title and win (SDL may replace its window by another)
start() {
    local try
    title=$1
    shift
    # A window that is mapped while a window manager takes over can get lost: that is between those two, not the port's.
    for try in 1 2 3; do
        "$@" >"$scratch/out" 2>"$scratch/err" &
        child=$!
        wait_until find_window && break
        kill_program
    done
    if [ -z "$child" ]; then
        check "a window for: $*" cat "$scratch/err" /none
        return 1
    fi
    wait_until focus_window
}
# The window that is still there a moment after it got the keys.
focus_window() {
    local first
    find_window && first=$win && timeout 100 xdotool windowfocus --sync "$win" 2>/dev/null &&
        xdotool windowmove "$win" 0 0 2>/dev/null && sleep 0.2 && find_window && [ "$win" = "$first" ]
}
find_window() { win=$(xdotool search --onlyvisible --name "^$title\$" 2>/dev/null | head -1) && [ -n "$win" ]; }
# screenshot FORMAT:FILE: what the window shows, as rgb:FILE; its whole dump is $scratch/shot.xwd.
screenshot() {
    find_window && xwd -silent -id "$win" -out "$scratch/shot.xwd" 2>/dev/null &&
        convert "xwd:$scratch/shot.xwd" -depth 8 "$1" 2>/dev/null
}
window_size_is() { # WxH
    find_window &&
        [ "$(xdotool getwindowgeometry --shell "$win" | sed -n 's/^WIDTH=//p;s/^HEIGHT=//p' | paste -sd x)" = "$1" ]
}
is_managed() { xprop -root _NET_SUPPORTING_WM_CHECK 2>/dev/null | grep -q "window id"; }
start_openbox() {
    openbox --sm-disable >/dev/null 2>&1 &
    wm=$!
    check "a window manager" wait_until is_managed
}
kill_program() {
    kill -KILL "$child" 2>/dev/null
    wait "$child" 2>/dev/null
    child=
}
stop() { # [KEY]: which ends it; the program's is ctrl+q
    local key=${1:-ctrl+q}
    case $key in
    ctrl+*) # seen by a poll each, however slow they are
        xdotool keydown ctrl && wait_cpu 3
        xdotool keydown "${key#*+}" && wait_cpu 3
        xdotool keyup "${key#*+}" keyup ctrl
        ;;
    *) xdotool key "$key" ;;
    esac
    check "ends on $key" wait_until has_exited
    has_exited || kill -KILL "$child"
    wait "$child"
    check "with exit code 0" [ $? = 0 ]
    kill_program
}
