#!/usr/bin/env bash
# patient.sh - tests/patient.py ends what hangs, asleep or awake, with all that it started, and nothing that is slow;
# the runner says so; no test ends a program by the clock.
. "$(dirname "$0")/../tap.sh"
said=$scratch/output
runs() { # CODE LAST-LINE [OPTION]... COMMAND...: of bash
    local code=$1 last=$2
    shift 2
    tests/patient.py "${@:1:$#-1}" "$said" bash -c "${*: -1}"
    local got=$?
    [ "$got $(tail -1 "$said")" = "$code $last" ] || { echo "got $got $(tail -1 "$said")" && return 1; }
}
check 'output and exit code are the program'"'"'s' runs 7 'two words' 'echo two words; exit 7'
check 'an endless loop hangs' runs 124 '# it hangs: 1 s of the processor'"'"'s time without a line' --cpu 1 \
    'while :; do :; done'
check 'what waits for ever hangs' runs 124 '# it hangs: asleep for 1 s' --asleep 1 'sleep 1000'
check 'what prints lines does not' runs 0 10 --cpu 1 --asleep 1 'for i in $(seq 10); do sleep 0.2; echo $i; done'
gone() { # nothing is left of what hung
    tests/patient.py --asleep 1 "$said" bash -c "echo \$\$; setsid sleep 12345 & sleep 12345"
    ! pgrep -f '^sleep 12345$' >/dev/null
}
check 'all that it started is ended' gone

# The runner, with a test that hangs and one that does not.
mkdir -p "$scratch/tree/tests/cli" "$scratch/tree/build/release"
cp tests/run.sh tests/patient.py "$scratch/tree/tests/"
sed -i 's/^cpu=900/cpu=1/' "$scratch/tree/tests/run.sh"
printf '#!/bin/sh\necho "ok 1 - good"\necho 1..1\n' >"$scratch/tree/tests/cli/good.sh"
printf '#!/bin/sh\necho "ok 1 - begun"\nwhile :; do :; done\n' >"$scratch/tree/tests/cli/hangs.sh"
chmod +x "$scratch"/tree/tests/cli/*.sh
runner() {
    (cd "$scratch/tree" && OUT=build/release tests/run.sh >"$said" 2>&1) && return 1
    cat "$said"
    grep -q 'cli/good.sh  *1 passed' "$said" && grep -q "# it hangs: 1 s of the processor's time without a line" \
        "$said" && grep -qx '2 passed, 1 failed' "$said"
}
check 'the runner tells what hangs' runner

# A program that is ended by the clock is a verdict that depends on it. What may: a wait for the window system's answer,
# of which it is asked again.
by_the_clock() {
    grep -nE '(^|[^a-z_])timeout [^#]*[0-9]' "$@" | grep -vE 'timeout 100 xdotool|tests/lint/patient\.sh'
}
none() { ! by_the_clock "$@"; }
check 'no test ends a program by the clock' none $(tree 'tests/*.sh')
echo 'timeout 300 ./program' >"$scratch/planted.sh"
detects 'one that does' 'timeout 300' none "$scratch/planted.sh"
finish
