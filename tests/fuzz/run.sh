#!/usr/bin/env bash
# run.sh - runs every libFuzzer target tests/fuzz/fuzz_*.c under AddressSanitizer and UndefinedBehaviorSanitizer.
#
#     FUZZ_SECONDS=60 tests/fuzz/run.sh [TARGET...]
#
# Seeds are in tests/fuzz/seeds/TARGET/; what a run finds of interest stays in build/fuzz/corpus/TARGET and is where the
# next run begins; an input that crashes is kept in build/fuzz/crashes/. Two targets at a time. Ends like tests/run.sh.
set -u
cd "$(dirname "$0")/../.." || exit 2
seconds=${FUZZ_SECONDS:-60}
OUT=build/fuzz

if [ "${1:-}" = --one ]; then
    target=$2 corpus=$OUT/corpus/$2 seeds=()
    mkdir -p "$corpus" "$OUT/crashes" "$OUT/log"
    [ ! -d "tests/fuzz/seeds/$target" ] || seeds=("tests/fuzz/seeds/$target")
    ASAN_OPTIONS=detect_leaks=1:allocator_may_return_null=1 \
        LSAN_OPTIONS=suppressions=$PWD/tests/lsan.supp:print_suppressions=0 UBSAN_OPTIONS=print_stacktrace=1 \
        tests/patient.py "$OUT/log/$target" \
        "$OUT/fuzz/$target" -max_total_time="$seconds" -timeout=300 -rss_limit_mb=2048 \
        -max_len=65536 -len_control=0 -print_final_stats=1 -artifact_prefix="$OUT/crashes/$target-" "$corpus" \
        "${seeds[@]}"
    rc=$?
    # "#123 DONE cov: 45 ft: 67 corp: 8/90b ..." and "stat::number_of_executed_units: 123"
    awk -v name="$target" -v rc=$rc -v seconds="$seconds" '
        / cov: / {
            for (i = 1; i < NF; i++) {
                if ($i == "cov:") edges = $(i + 1)
                if ($i == "corp:") corpus = $(i + 1)
            }
        }
        /^stat::number_of_executed_units/ { runs = $2 }
        /^stat::powered_boards/ { powered = $2 }
        /^stat::ran_to_the_end/ { ended = $2 }
        END {
            sub("/.*", "", corpus)
            printf "%sok - %s: ", (rc == 0 && runs > 0 ? "" : "not "), name
            printf "%d executions, corpus %d, %d edges", runs, corpus, edges
            if (powered != "") printf ", %d boards powered, %d ran to the end", powered, ended
            printf ", %s\n", (rc == 0 ? "no crash" : "CRASH")
        }' "$OUT/log/$target" >"$OUT/log/$target.line"
    cat "$OUT/log/$target.line"
    if [ $rc != 0 ]; then
        grep -aE 'ERROR|SUMMARY|runtime error|^    #[0-9]|Test unit written' "$OUT/log/$target" | head -40 |
            sed 's/^/# /'
        exit 1
    fi
    exit 0
fi

targets=("$@")
[ ${#targets[@]} != 0 ] || for f in tests/fuzz/fuzz_*.c; do targets+=("$(basename "$f" .c)"); done
mkdir -p $OUT
make --no-print-directory -s -j2 CC=clang CONFIG=fuzz \
    OPT="-O1 -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer" \
    "${targets[@]/#/$OUT/fuzz/}" >$OUT/said 2>&1 || { cat $OUT/said; echo "0 passed, 1 failed"; exit 1; }
rm -rf $OUT/log
printf '%s\n' "${targets[@]}" | xargs -n 1 -P 2 "$0" --one
# A target without its line was lost with its runner.
passed=$(cat $OUT/log/*.line | grep -c '^ok ')
failed=$((${#targets[@]} - passed))
echo "$passed passed, $failed failed"
[ $failed = 0 ]
