#!/bin/sh
# harden.sh - prints which of the guards against memory errors a compiler has, and its linker: stack protector, checked
# calls of the C library, indirect jumps that land on marks only; tables of addresses that are read-only once the
# program runs, and a program that is loaded anywhere.
#
#     tools/harden.sh compile|link COMPILER [FLAG...]
#
# A guard is printed when a program that uses it compiles and links by these flags without a word.
set -eu
what=$1
shift
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT

cat >"$dir/probe.c" <<'END'
#include <stdio.h>
#include <string.h>
int main(int argc, char **argv)
{
    char text[64];
    snprintf(text, sizeof text, "%s", argv[argc - 1]);
    return puts(strcat(text, "!")) == EOF;
}
END

has() { # COMPILER FLAG...: compiled and linked in two steps, as the Makefile does
    if [ "$what" = compile ]; then
        "$@" -Werror -c "$dir/probe.c" -o "$dir/probe.o" && "$@" $pie "$dir/probe.o" -o "$dir/probe"
    else
        "$@" "$dir/probe.c" -o "$dir/probe"
    fi >"$dir/said" 2>&1 && [ ! -s "$dir/said" ]
}

case $what in
compile)
    # Level 3 asks more than 2 of compiler and library.
    all="-fPIE -fstack-protector-strong -fcf-protection"
    all="$all -U_FORTIFY_SOURCE%-D_FORTIFY_SOURCE=3 -U_FORTIFY_SOURCE%-D_FORTIFY_SOURCE=2"
    ;;
link) all="-pie -Wl,-z,relro -Wl,-z,now" ;;
*)
    echo "tools/harden.sh: \"$what\" is neither compile nor link" >&2
    exit 2
    ;;
esac

compiler=$*
found=""
for guard in $all; do
    flags=$(echo "$guard" | tr % ' ') pie=""
    case $guard:$compiler:$found in
    *pie:*-static* | *PIE:*-static*) continue ;; # has its addresses already
    -U_FORTIFY*:*FORTIFY*) continue ;;
    -fPIE:*) pie=-pie ;;
    esac
    # shellcheck disable=SC2086
    if has $compiler $flags; then found="$found $flags"; fi
done
echo "${found# }"
