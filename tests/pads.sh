# shellcheck shell=bash disable=SC2154
# pads.sh - controllers for a program in a window (tests/inject/pads.c, which lists commands, kinds and switches).
#
#     . "$(dirname "$0")/../xserver.sh"
#     . "$repo/tests/pads.sh"
#     pads_none                                        # before each start: no controller, nothing to be done
#     start "Glass Tide" "${padded[@]}" "$OUT/curtain" play ...
#     pad plug 1 xbox                                  # returns when the program has seen it
#     pad tap 1 start south
#     pad down 1 lleft
pads_script=$scratch/pads.script pads_said=0
cc -std=gnu11 -O1 -shared -fPIC $(sdl2-config --cflags) "$repo/tests/inject/pads.c" -o "$scratch/pads.so" \
    $(sdl2-config --libs) -ldl || exit 2
padded=(env "PADS=$pads_script" "LD_PRELOAD=$scratch/pads.so")

pads_none() { : >"$pads_script"; }
# pad COMMAND...: false: the program did not get that far, or the library says that it is no command.
# tap P SWITCH...: one switch after the other is down for 4 polls and up for 4.
pad() {
    local switch
    if [ "$1" = tap ]; then
        for switch in "${@:3}"; do printf '%s\nwait 4\n' "down $2 $switch" "up $2 $switch"; done
    else
        printf '%s\n' "$*"
    fi >>"$pads_script"
    pads_said=$((pads_said + 1))
    printf 'wait 1\nsay %d\n' $pads_said >>"$pads_script"
    wait_until grep -qx "pads: $pads_said" "$scratch/err" || { tail -1 "$scratch/err" >&2; return 1; }
}
