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
child= xvfb= wm=
trap 'for p in $child $wm $xvfb; do kill -KILL $p 2>/dev/null; done; cd /; rm -rf "$scratch"' EXIT

# soon COMMAND...: tries until it holds. Gives up when the program has used 10 s of the processor's time, however long
# that takes; one that uses none is given 2000 tries. The last try comes after that look: a program that ended between
# the two has no time to read.
soon() {
    local from try=0
    from=$(used)
    until "$@"; do
        try=$((try + 1))
        [ $try -lt 2000 ] && { [ $try -lt 100 ] || [ $(($(used) - from)) -lt 1000 ]; } || { "$@"; return; }
        sleep 0.05
    done
}
# Hundredths of a second of the processor's time that the program has used: how far it has gone round, on any machine.
used() { awk '{ sub(/.*\) /, ""); print $12 + $13 }' "/proc/$child/stat" 2>/dev/null || echo 999999999; }
# rounds N: until it has gone on for that much.
rounds() {
    local from
    from=$(used)
    until [ $(($(used) - from)) -gt "$1" ]; do sleep 0.05; done
}
says() { grep -qx -- "$1" "$scratch/out"; }
# A program that has ended stays as a zombie where the machine's first process does not collect those of others.
gone() { ! readlink "/proc/$child/exe" >/dev/null; }

# X picks a free display number and writes it down.
Xvfb -displayfd 3 -screen 0 1100x1000x24 -nolisten tcp 3>"$scratch/display" >/dev/null 2>&1 &
xvfb=$!
soon test -s "$scratch/display" || { echo "xserver.sh: Xvfb does not start" >&2; exit 2; }
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
        soon found && break
        leave
    done
    if [ -z "$child" ]; then
        check "a window for: $*" cat "$scratch/err" /none
        return 1
    fi
    soon focused
}
# The window that is still there a moment after it got the keys.
focused() {
    local first
    found && first=$win && timeout 100 xdotool windowfocus --sync "$win" 2>/dev/null &&
        xdotool windowmove "$win" 0 0 2>/dev/null && sleep 0.2 && found && [ "$win" = "$first" ]
}
found() { win=$(xdotool search --onlyvisible --name "^$title\$" 2>/dev/null | head -1) && [ -n "$win" ]; }
# shot FORMAT:FILE: what the window shows, as rgb:FILE; its whole dump is $scratch/shot.xwd.
shot() {
    found && xwd -silent -id "$win" -out "$scratch/shot.xwd" 2>/dev/null &&
        convert "xwd:$scratch/shot.xwd" -depth 8 "$1" 2>/dev/null
}
leave() {
    kill -KILL "$child" 2>/dev/null
    wait "$child" 2>/dev/null
    child=
}
stop() { # [KEY]: which ends it; the program's is ctrl+q
    local key=${1:-ctrl+q}
    case $key in
    ctrl+*) # seen by a poll each, however slow they are
        xdotool keydown ctrl && rounds 3
        xdotool keydown "${key#*+}" && sleep 0.3
        xdotool keyup "${key#*+}" keyup ctrl
        ;;
    *) xdotool key "$key" ;;
    esac
    check "ends on $key" soon gone
    gone || kill -KILL "$child"
    wait "$child"
    check "with exit code 0" [ $? = 0 ]
    leave
}
