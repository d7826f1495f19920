#!/usr/bin/env bash
# uninitialised.sh - the readers of files never look at memory that nothing was written to: MemorySanitizer ends the
# program where one does. They read the seeds of their fuzz targets, and their unit tests run.
#
#     tests/machine/uninitialised.sh [whole] [lua]
#
# whole: also all that `make fuzz` has found so far. lua: what goes through Lua, whose library is not instrumented,
# under valgrind. `make msan` runs both, `make valgrind` the latter; what `make test` builds is there then.
. "$(dirname "$0")/../tap.sh"
sandbox
export MSAN_OPTIONS=halt_on_error=1:exit_code=77 CMOCKA_MESSAGE_OUTPUT=TAP
cd "$repo" || exit 2
msan=build/msan

whole="" lua=""
for word; do
    case $word in
    whole) whole=yes ;;
    lua) lua=yes ;;
    *) echo "Bail out! \"$word\" is neither whole nor lua"; exit 2 ;;
    esac
done

seeds() { # TARGET: files
    find "tests/fuzz/seeds/$1" ${whole:+$([ ! -d "build/fuzz/corpus/$1" ] || echo "build/fuzz/corpus/$1")} -type f |
        sort
}
clean() { # NAME COMMAND...
    local name=$1
    shift
    if "$@" >"$scratch/ran" 2>&1 </dev/null && ! grep -q '^not ok' "$scratch/ran"; then
        ok "$name"
    else
        not_ok "$name" \
            "$(grep -a -m 1 -A 12 'MemorySanitizer\|== .*ninitialised\|== Invalid' "$scratch/ran" ||
            tail -n 12 "$scratch/ran")"
    fi
}
given() { # PROGRAM TARGET
    seeds "$2" | xargs -d '\n' "$1/given/$2"
}

# What clang instruments.
instrumented() {
    local target name
    if ! make msan-short >"$scratch/made" 2>&1; then
        not_ok "it builds under MemorySanitizer" "$(tail -n 20 "$scratch/made")"
        return
    fi
    for target in fuzz_args fuzz_bisect fuzz_config fuzz_demo fuzz_symbols fuzz_game fuzz_lang fuzz_bdf \
        fuzz_nvram fuzz_png fuzz_records fuzz_card \
        fuzz_rom; do
        clean "$target: $(seeds "$target" | wc -l) files" given "$msan" "$target"
    done
    for name in keys png records rom stdio; do
        clean "unit/test_$name" "$msan/unit/test_$name"
    done
    planted "planted: a record that is not zeroed is found" src/player/replays/records.c 'struct record got = { 0 };' \
        'struct record got;' fuzz_records
}

grind() { valgrind -q --error-exitcode=77 --suppressions=tests/valgrind.supp "$@"; }
grind_given() {
    seeds "$1" | xargs -d '\n' valgrind -q --error-exitcode=77 --suppressions=tests/valgrind.supp "$OUT/given/$1"
}
through_lua() {
    local target name command
    for target in fuzz_manifest fuzz_board fuzz_recording; do
        clean "$target under valgrind: $(seeds "$target" | wc -l) files" grind_given "$target"
    done
    for name in cli demo manifest pack script; do
        clean "unit/test_$name under valgrind" grind "$OUT/unit/test_$name"
    done
    for command in "check examples/first" "list examples/first" "pack examples/first -o $scratch/first.rom" \
        "unpack $scratch/first.rom $scratch/first" "hash examples/first --frames 60 --record $scratch/first.demo" \
        "verify examples/first $scratch/first.demo" "render examples/first --frames 30 -o $scratch/out"; do
        clean "curtain ${command%% *} under valgrind" grind "$curtain" $command
    done
}

[ -n "$lua" ] && [ -z "$whole" ] || instrumented
[ -z "$lua" ] || through_lua
finish
