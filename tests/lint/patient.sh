#!/usr/bin/env bash
# patient.sh - tests/patient.py ends what hangs, asleep or awake, with all that it started, and nothing that is slow;
# no test ends a program by the clock.
. "$(dirname "$0")/../tap.sh"
output=$scratch/output
runs() { # CODE LAST-LINE [OPTION]... COMMAND: of bash
    local code=$1 last=$2
    shift 2
    tests/patient.py "${@:1:$#-1}" "$output" bash -c "${*: -1}"
    local got=$?
    [ "$got $(tail -1 "$output")" = "$code $last" ] || { echo "got $got $(tail -1 "$output")" && return 1; }
}
check 'output and exit code are those of the program' runs 7 'two words' 'echo two words; exit 7'
check 'an endless loop hangs' runs 124 "# it hangs: 1 s of the processor's time without a line" --cpu 1 \
    'while :; do :; done'
check 'what waits for ever hangs' runs 124 '# it hangs: asleep for 1 s' --asleep 1 'sleep 1000'
check 'what prints lines does not' runs 0 10 --cpu 1 --asleep 1 'for i in $(seq 10); do sleep 0.2; echo $i; done'
gone() { # nothing is left of what hung
    tests/patient.py --asleep 1 "$output" bash -c "setsid sleep 12345 & sleep 12345"
    ! pgrep -f '^sleep 12345$' >/dev/null
}
check 'all that it started is ended' gone

# A program that is ended by the clock is a verdict that depends on it. What may: a wait for the window system's answer,
# of which it is asked again.
no_clock() {
    ! grep -nE '(^|[^a-z_])timeout [^#]*[0-9]' "$@" | grep -vE 'timeout 100 xdotool|tests/lint/patient\.sh'
}
check 'no test ends a program by the clock' no_clock $(tree 'tests/*.sh')
finish
