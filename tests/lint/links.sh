#!/usr/bin/env bash
# links.sh - what refers to threads is linked with -pthread: glibc has had them in a library of its own until 2.34.
. "$(dirname "$0")/../tap.sh"

targets="programs tools build/release/curtain-bare build/release/curtain-null
    $(ls tools/lab/prove/{roots,sines,polar,directions,products,shapes}.c | sed 's,.*/,build/release/prove/,;s,\.c$,,')"

# links [VARIABLE=VALUE...]: the lines by which make links programs
links() {
    make -n -B CONFIG=release "$@" $targets | grep -E ' -o [^ ]+$' | grep -v ' -c '
}

# Reads such lines; says which program refers to threads and has no -pthread.
threads() {
    local line word source n=0 found=0
    local -A refers # of each source: 1 or 0
    while read -r line; do
        for word in $line; do
            case $word in
            build/release/gen/*) continue ;;
            build/release/*.o) source=${word#build/release/} source=${source%.o}.c ;;
            *.c) source=$word ;;
            *) continue ;;
            esac
            [ -n "${refers[$source]:-}" ] || refers[$source]=$(grep -cm 1 'pthread_' "$source" 2>/dev/null)
            [ "${refers[$source]:-0}" = 1 ] || continue
            n=$((n + 1))
            case " $line " in
            *' -pthread '*) ;;
            *) echo "${line##* }: $source refers to threads, and there is no -pthread"; found=1 ;;
            esac
            break
        done
    done
    [ $n != 0 ] || { echo "no program refers to threads"; found=1; }
    return $found
}

all_links() { links "$@" | threads; }
check "every program that refers to threads is linked with -pthread" all_links
detects "without it" "build/release/bench: tools/lab/bench/threads.c refers to threads" all_links THREADS=
check "WebAssembly has none" bash \
    -c "! make -n -B CONFIG=release CC='clang --target=wasm32-wasi' build/release/curtain-bare | grep -q pthread"

# Scripts that link the engine themselves.
by_hand() { grep -Hn '(pkg-config --libs lua5.4' "$@" | awk '!/-pthread/ { print; bad = 1 } END { exit bad || !NR }'; }
check "so are the programs that scripts link" by_hand $(tree 'tests/*.sh' 'tools/*.sh')
finish
