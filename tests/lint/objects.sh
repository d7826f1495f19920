#!/usr/bin/env bash
# objects.sh - what the objects below the program hold and call: no writable memory, and of C and Lua only what touches
# no host, no clock and no rounding that differs. It looks at the objects in the link map of curtain-null.
. "$(dirname "$0")/../tap.sh"

layers='src/base fb src/sound src/entities src/rom src/machine src/script src/board'
sources() { find $layers -name '*.c'; }
below=${layers// /\\|}
linked() { sed -n "s,^LOAD \($OUT/\($below\)/[^ ]*\.o\)$,\1,p" "$OUT/curtain-null.map"; }

all_linked() {
    diff <(sources | sed "s,^,$OUT/,;s,c\$,o," | sort) <(linked | sort)
}

# Sections that are loaded, not empty and not read-only; tables of pointers (.data.rel.ro) are made read-only by the
# loader.
writable() { # OBJECT...
    objdump -hw "$@" | awk '
        /file format/ { o = $1 }
        $1 ~ /^[0-9]+$/ && / ALLOC/ && !/READONLY/ && $3 !~ /^0+$/ && $2 !~ /^\.data\.rel\.ro/ {
            print o " writable section " $2 " of 0x" $3 " bytes"; bad = 1
        }
        END { exit bad }'
}

# allowed: why
cat >"$scratch/allowed" <<'EOL'
memcpy memmove memset memcmp memchr: bytes
strlen strcmp strncmp strcpy strchr strrchr strstr strspn strcspn strpbrk: text
snprintf vsnprintf: messages, into the caller's buffer
strtod: correctly rounded; host.c puts the locale aside
fegetenv fesetenv newlocale uselocale freelocale: host.h, which puts aside what the host has set
qsort: of names that all differ, so that how it sorts cannot show
sqrt fmod ldexp frexp floor fabs: exact or correctly rounded by IEEE 754
__assert_fail abort: the C programmer was wrong
_GLOBAL_OFFSET_TABLE_ __stack_chk_fail: the compiler's own
__memcpy_chk __memmove_chk __memset_chk __strcpy_chk: the same where the compiler fortifies
__snprintf_chk __vsnprintf_chk: the same where the compiler fortifies
luaopen_base luaopen_table luaopen_string luaopen_math luaopen_utf8: vm.c takes the good parts of them
EOL
sed 's/:.*//' "$scratch/allowed" | tr ' ' '\n' | sort -u >"$scratch/names_allowed"
# Lua: all but what allocates with malloc, reads files or reaches the host.
lua_forbidden='luaL_newstate|luaL_openlibs|luaL_loadfilex|luaL_fileresult|luaL_execresult|luaL_testudata'
lua_forbidden="^($lua_forbidden|luaopen_(os|io|debug|package|coroutine))$"

calls() {
    nm --defined-only "$@" | awk 'NF == 3 { print $3 }' | sort -u >"$scratch/defined"
    nm -uA "$@" | awk '{ print $NF, $1 }' | sort -u >"$scratch/undefined"
    awk -v forbidden="$lua_forbidden" '
        FILENAME ~ /defined$/ && FILENAME !~ /undefined$/ || FILENAME ~ /names_allowed$/ { ok[$1] = 1; next }
        ok[$1] || ($1 ~ /^luaL?_/ && $1 !~ forbidden) { next }
        { print $2 " calls " $1; bad = 1 }
        END { exit bad }' "$scratch/defined" "$scratch/names_allowed" "$scratch/undefined"
}

# The parts and the pictures know no script.
low_calls() {
    ! nm -uA $(linked | grep -v -e /src/script/ -e /src/board/) | grep -E ' (lua.*|strtod)$'
}

# What the host has set is known to host.c alone.
host_calls() {
    ! nm -uA $(linked | grep -v /src/base/host.o) | grep -E ' (fe(get|set|test|clear|raise|hold|update).*|.*locale.*)$'
}

check "the link map names every object below the program" all_linked
check "no writable memory below the program" writable $(linked)
check "nothing below the program calls what it must not" calls $(linked)
check "Lua and the reading of numbers are for scripts and the board alone" low_calls
check "what the host has set is for host.c alone" host_calls

# hit.c with a call of malloc
{
    sed "s,#include \",&$PWD/src/machine/collision/," src/machine/collision/hit.c
    echo '#include <stdlib.h>'
    echo 'void *planted(void) { return malloc(8); }'
} >"$scratch/planted.c"
${CC:-cc} -std=c11 -O2 -D_DEFAULT_SOURCE $(pkg-config --cflags lua5.4) -c "$scratch/planted.c" -o "$scratch/planted.o"
detects "malloc" "calls malloc" calls $(linked | grep -v /hit.o) "$scratch/planted.o"
finish
