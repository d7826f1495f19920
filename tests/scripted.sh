# shellcheck shell=bash
# scripted.sh - tap.sh, a sandbox, ./player in it (build_player), and what the tests that play by a script share.
#
#     . "$(dirname "$0")/../scripted.sh"
#     { keys 40; press $ESCAPE; keys 60; } | plays menu --seed 5      # plays the folder g
. "$(dirname "${BASH_SOURCE[0]}")/tap.sh"
sandbox
build_player

# USB HID usages of keys, and masks of a controller.
B=5 G=10 H=11 P=19 R=21 T=23 X=27 C=6 Z=29 ENTER=40 ESCAPE=41 BACKSPACE=42 COMMA=54 DOT=55 SLASH=56 BACKQUOTE=53
BEFORE=47 AFTER=48 F1=58 F2=59 F5=62 F6=63 F8=65 F12=69 RIGHT=79 LEFT=80 DOWN=81 UP=82

press() { # KEY...: two polls each, the second without keys
    local key
    for key; do keys 1 "$key"; keys 1; done
}
# plays OUT [ARGUMENT...]: plays g; standard input are the keys, OUT gets a line a picture, err what is printed
plays() {
    local out=$1
    shift
    ./player play g "$@" >"$out" 2>err
}
part() { sed -n "$2,$3p" "$1"; }                             # FILE FIRST LAST: picture n is of frame n
pictures() { wc -l <"$1"; }                                  # FILE: how many it has
wait_for() { until [ "$(pictures "$1")" -ge "$2" ]; do sleep 0.02; done; } # FILE N: until it has so many pictures
flags() { python3 "$repo/tests/cli/demo_read.py" "$1" | sed -n 's/^flags //p'; } # DEMO: 2: touched, 4: assisted
reads() { python3 "$repo/tests/machine/words.py" picture.ppm "$@"; }             # TEXT...: picture.ppm has these words
settings() { # LINE...
    mkdir -p data/curtain
    printf '%s\n' "$@" >data/curtain/curtain.conf
}
screen_of() { # GAME WxH
    sed -i "s/screen = { w = [0-9]*, h = [0-9]*/screen = { w = ${2%x*}, h = ${2#*x}/" "$1/rom.lua"
}
