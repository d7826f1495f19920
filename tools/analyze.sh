#!/usr/bin/env bash
# analyze.sh - make analyze: cppcheck over all C of the repository and gcc -fanalyzer over what is in the program.
#
#     tools/analyze.sh [cppcheck] [gcc]      without arguments: both
#
# A finding is "TOOL ID FILE:LINE: TEXT". Those that tools/analyze.list names, with the reason, are not reported; an
# entry that matches none is. Exit 1: something is reported. All findings stay in build/analyze/TOOL.
set -u
cd "$(dirname "$0")/.." || exit 2
export LC_ALL=C
out=build/analyze
mkdir -p $out

# cppcheck reads no system header, so it is told what float.h says; and it takes the C name "not" for C++'s.
run_cppcheck() {
    tests/files.sh 'src/*.c' 'fb/*.c' 'platform/*.c' 'tools/*.c' 'roms/*.c' 'tests/fuzz/*.c' 'tests/inject/*.c' \
        >$out/files
    cppcheck --quiet -j2 --std=c11 --enable=warning,performance,portability --suppress=missingIncludeSystem \
        --template='cppcheck {id} {file}:{line}: {message}' -D_DEFAULT_SOURCE -DFLT_RADIX=2 -DDBL_MANT_DIG=53 \
        -DFLT_EVAL_METHOD=0 -Dnot=negated --file-list=$out/files 2>&1
}

flags="-std=c11 -fwrapv -ffp-contract=off -O1 -D_DEFAULT_SOURCE -fanalyzer $(pkg-config --cflags lua5.4 sdl2 |
    sed 's/-I/-isystem /g')"
analyzed() { # FILE: 300 s and 3 GB are enough for each
    ulimit -v 3000000
    # shellcheck disable=SC2086
    timeout 300 gcc $flags -c "$1" -o "$2" 2>&1 ||
        echo "$1:1:1: warning: the analysis did not end [-Wanalyzer-unfinished]"
}
run_gcc() {
    export flags
    export -f analyzed
    # what gcc says: FILE:LINE:COLUMN: warning: TEXT [CWE-...] [-Wanalyzer-ID]
    tests/files.sh 'src/*.c' 'fb/*.c' platform/{stdio,posix,posix_process,null,sdl2}.c |
        xargs -P 2 -I % bash -c 'said=$0/$(echo % | tr / -); analyzed % "$said.o" >"$said.said"' $out
    cat $out/*.said |
        sed -nE 's/^([^ :]+):([0-9]+):[0-9]+: warning: (.*) \[-W(analyzer-[a-z-]*).*\]$/gcc \4 \1:\2: \3/p' |
        sed -E 's/ \[CWE-[0-9]+\]//; s/[^ -~]+/"/g' | sort -u
    rm -f $out/*.said $out/*.o
}

# report TOOL: what it found and the list does not know; what the list knows and it did not find
report() {
    awk -v tool="$1" '
        FNR == NR {
            if ($1 != tool) next
            split($0, part, / \| /)
            split(part[1], word, " ")
            n++; id[n] = word[2]; file[n] = word[3]; text[n] = part[2]; line[n] = FNR
            next
        }
        {
            at = $3; sub(/:.*/, "", at)
            known = 0
            for (i = 1; i <= n; i++)
                if (id[i] == $2 && (file[i] == at || file[i] == "*") && index($0, text[i])) { known = 1; used[i] = 1 }
            if (!known) { print; bad = 1 } else excused++
        }
        END {
            for (i = 1; i <= n; i++)
                if (!used[i]) { print "tools/analyze.list:" line[i] ": matches no finding of " tool; bad = 1 }
            print tool ": " (bad ? "something to look at" : "nothing new") ", " excused + 0 " known findings"
            exit bad
        }' tools/analyze.list "$out/$1"
}

bad=0
for tool in ${*:-cppcheck gcc}; do
    case $tool in cppcheck | gcc) ;; *)
        echo "tools/analyze.sh: \"$tool\" is neither cppcheck nor gcc" >&2
        exit 2
        ;;
    esac
    run_"$tool" >"$out/$tool"
    report "$tool" || bad=1
done
exit $bad
