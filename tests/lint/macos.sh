#!/usr/bin/env bash
# macos.sh - the program compiles with what macOS has, and its build there uses no GNU linker option or tool. Without a
# Mac, this system's headers are used, less the names in tests/macos/lacks; see docs/internals/macos.md.
. "$(dirname "$0")/../tap.sh"
export LC_ALL=C
macos=$repo/tests/macos
words() { sed 's/#.*//' "$1" | tr -s ' \n' '\n' | sort -u | sed '/^$/d'; }
words "$macos/lacks" >"$scratch/lacks"
words "$macos/headers" >"$scratch/headers"

# ---- the header set ----

# The names that a header declares and macOS lacks. glibc hides the rest, since no file may define a feature macro.
lacking() { # HEADER
    gcc -std=c11 -D_DEFAULT_SOURCE -E -dD -x c - <<<"#include <$1>" | grep -oE '[A-Za-z_][A-Za-z0-9_]*' | sort -u |
        comm -12 - "$scratch/lacks" | grep -v '_SOURCE'
}

# Writes a header that includes the system's, and makes these names errors. The first header that declares a name does
# this: a file that includes no such header may use the name itself.
header() { # HEADER
    local name
    mkdir -p "$(dirname "$set/$1")"
    {
        echo '#if !defined MACOS_SET && (defined _GNU_SOURCE || defined _POSIX_C_SOURCE || defined _XOPEN_SOURCE)'
        echo '#error on macOS this feature macro hides functions, see tests/macos/lacks'
        echo '#endif'
        echo '#define MACOS_SET'
        echo "#include_next <$1>"
        echo '#undef __GLIBC__'
        for name in $(lacking "$1"); do
            printf '#ifndef LACKS_%s\n#define LACKS_%s\n#undef %s\n' "$name" "$name" "$name"
            printf '#pragma GCC poison %s\n#endif\n' "$name"
        done
    } >"$set/$1"
}
set=$scratch/include
for name in $(grep -v '^stb/' "$scratch/headers"); do
    ! gcc -E -x c - <<<"#include <$name>" >/dev/null 2>&1 || header "$name"
done

# ---- the program ----

# The commands that build goals on macOS. Hardening options are empty: the linker there is asked which ones it has.
build() {
    make -n -B V=1 CC=gcc UNAME=Darwin BREW=/brew HARDEN_C= HARDEN_L= CONFIG=release "$@" 2>&1
}
build build/release/curtain build/release/curtain-null >"$scratch/commands"
grep -oE ' -c [a-z0-9_/]+\.c ' "$scratch/commands" | sed 's/ -c //; s/ //g' | grep -v '^build/' | sort -u \
    >"$scratch/files"

known_headers() { # FILE...
    awk -v headers="$(tr '\n' ' ' <"$scratch/headers")" '
        BEGIN { n = split(headers, name); for (i = 1; i <= n; i++) known[name[i]] }
        FNR == 1 || /^#endif/ { skip = 0 }
        /^#ifdef __linux__/ { skip = 1 }
        /^#include </ && !skip && !(substr($2, 2, length($2) - 2) in known) {
            print FILENAME ":" FNR ": macOS has no " $2
            bad = 1
        }
        END { exit bad }' "$@"
}
check "macOS has all headers that they include" known_headers $(cat "$scratch/files") $(tree 'src/*.h' 'fb/*.h') \
    platform/{host,platform}.h

compiles() { # FILE...
    printf '%s\n' "$@" | xargs -P 2 -n 48 gcc -std=c11 -fsyntax-only -Werror -D_DEFAULT_SOURCE \
        -U__linux__ -U__linux -U__gnu_linux__ -U__unix__ -U__unix -U__ELF__ -D__APPLE__ -D__MACH__ \
        -Dst_mtimespec=st_mtim -iquote platform -iquote src/base -iquote src/workbench/survive \
        -isystem "$set" -isystem "$macos/include" $(pkg-config --cflags lua5.4 sdl2)
}
check "they compile" compiles $(cat "$scratch/files")

{ cat platform/posix_process.c; echo 'int f(int e[2]); int f(int e[2]) { return pipe2(e, O_CLOEXEC); }'; } \
    >"$scratch/planted.c"
detects "pipe2" "pipe2" compiles "$scratch/planted.c"

# ---- the build ----

gnu_link=' -Wl,(-z|--|-Map|-soname|-rpath-link)|[a-z0-9]\.so\b| -l:|-static\b|objcopy|-lquadmath'
gnu_tools='\bnproc\b|readlink -f|sed [^|]*-i|grep -[a-zA-Z]*P|install -D|cp -[a-z]*[dT]|xargs -[a-z]*d|-printf|stat -c|'
gnu_tools+='date -d|rmdir --|ln -[a-z]*[rT]|sort -V|sed .*:a;|\bmktemp --'
without() { # PATTERN FILE...: no line matches
    local pattern=$1
    shift
    ! grep -nE -- "$pattern" "$@"
}
build build/curtain build/curtain-null build/curtain.1 build/curtain-null.1 build/release/unit/test_stdio test \
    >>"$scratch/commands"
check "make uses no GNU linker option or tool" without "$gnu_link|$gnu_tools" "$scratch/commands"
check "nor do its scripts" without "$gnu_tools" tools/{harden,install,manpage,play}.sh tools/macos/deps.sh \
    "$macos/run.sh"
check "the program finds Homebrew's libraries" grep -q -- '-Wl,-rpath,/brew/lib' "$scratch/commands"

finish
