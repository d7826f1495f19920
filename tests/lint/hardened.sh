#!/usr/bin/env bash
# hardened.sh - the programs as built have the guards that tools/harden.sh asks the compiler and linker for.
. "$(dirname "$0")/../tap.sh"

has() { # FILE COMMAND WORDS: what the command prints of the file has the words
    local file=$1 words=$3
    $2 "$file" | grep -qE -- "$words" || { echo "$file: no \"$words\" in what $2 prints"; return 1; }
}
lacks() { ! has "$@" >/dev/null || { echo "$1: \"$3\" in what $2 prints"; return 1; }; }

bound_early() { has "$1" "readelf -dW" '(BIND_NOW|FLAGS_1.*\bNOW\b)' && has "$1" "readelf -lW" GNU_RELRO; }
anywhere() { has "$1" "readelf -hW" 'Type: *DYN' && lacks "$1" "readelf -dW" '(TEXTREL|RPATH|RUNPATH)'; }
no_code_in_data() { has "$1" "readelf -lW" 'GNU_STACK.* RW ' && lacks "$1" "readelf -lW" 'LOAD.* RWE '; }
watches_stack() { has "$1" "nm -D" '__stack_chk_fail'; }
checked_calls() {
    local n
    n=$(nm -D "$1" | grep -oE '__(mem|str|v?s?n?printf|v?fprintf)[a-z]*_chk' | sort -u | wc -l)
    [ "$n" != 0 ] || { echo "$1: no checked functions of the C library"; return 1; }
}
# The C library's own objects may lack them, so the linked program cannot tell.
marked() { # OBJECT...
    local o bad=0
    for o in "$@"; do
        readelf -nW "$o" | grep -q 'IBT, SHSTK' || { echo "$o: its jumps have no marks"; bad=1; }
    done
    return $bad
}
objects() { sed -n "s,^LOAD \($OUT/[^ ]*\.o\)$,\1,p" "$OUT/curtain-null.map"; }

# What this compiler has; the usual one of x86-64 has all.
compiler=${CC:-cc}
guards="$(tools/harden.sh compile "$compiler" -O2) $(tools/harden.sh link "$compiler" -O2)"
offers() { case " $guards " in *" $1 "*) ;; *) return 1 ;; esac }
all_offered() {
    local guard
    for guard in -fPIE -fstack-protector-strong -fcf-protection -pie -Wl,-z,relro -Wl,-z,now; do
        offers $guard || { echo "$compiler does not take $guard"; return 1; }
    done
    case $guards in *-D_FORTIFY_SOURCE=[23]*) ;; *) echo "$compiler checks no calls"; return 1 ;; esac
}
[ "$(uname -m)" != x86_64 ] || check "the compiler of this machine has all guards" all_offered

for program in curtain curtain-null; do
    check "$program: addresses are bound at its start, and read-only then" bound_early "$OUT/$program"
    check "$program: is loaded anywhere" anywhere "$OUT/$program"
    check "$program: nothing is both written and run" no_code_in_data "$OUT/$program"
    check "$program: its stack is watched" watches_stack "$OUT/$program"
    check "$program: calls of the C library are checked" checked_calls "$OUT/$program"
done
if offers -fcf-protection; then
    check "every object marks where jumps may land" marked $(objects)
fi

cat >"$scratch/bare.c" <<'END'
#include <stdio.h>
int main(int argc, char **argv) { char a[64]; snprintf(a, sizeof a, "%s", argv[argc - 1]); return puts(a) < 0; }
END
if [ "$(uname -m)" = x86_64 ] && long; then
    "$compiler" -fno-stack-protector "$scratch/bare.c" -o "$scratch/bare"
    detects "an unwatched stack" "__stack_chk_fail" watches_stack "$scratch/bare"
fi
finish
