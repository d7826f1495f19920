#!/usr/bin/env bash
# calls.sh - 40 windows, opened, played by random hands and closed in the middle, under valgrind: none loses memory or
# uses what is not its own. What else the calls promise is test_calls.c's.
. "$(dirname "$0")/../tap.sh"
command -v valgrind >/dev/null || not_ok 'valgrind is there'
sandbox
cd "$repo" || exit 2
check '40 windows lose nothing' env GLIBC_TUNABLES=glibc.malloc.tcache_count=0 valgrind -q --error-exitcode=1 \
    --suppressions=tests/valgrind.supp --leak-check=full --show-leak-kinds=definite,indirect,possible \
    "$OUT/machine/test_calls" 40
finish
