#!/usr/bin/env bash
# licences.sh - `curtain licences`: no library that the programs are linked with is missing in it, and the texts are
# those that the libraries come with.
. "$(dirname "$0")/../tap.sh"
sandbox
null=$curtain curtain=$OUT/curtain

# What a library is called in the list; a new one has no line here, and is reported.
# libm, the loader and what glibc 2.34 took in are glibc's; libgcc is the compiler's, whose licence excepts programs.
name_of() {
    case $1 in
    liblua*) echo Lua ;;
    libc.* | libm.* | libdl.* | libpthread.* | ld-linux*) echo glibc ;;
    libgcc_s.*) echo - ;;
    *) echo "unknown:$1" ;;
    esac
}
linked() { readelf -d "$1" | sed -n 's/.*NEEDED.*\[\(.*\)\]/\1/p'; }
listed() { # PROGRAM LIST: every library is in it
    local library name bad=0
    for library in $(linked "$1"); do
        name=$(name_of "$library")
        [ "$name" = - ] || grep -q "^$name " "$2" || { echo "$library is not in the list"; bad=1; }
    done
    [ "$(linked "$1" | wc -l)" -gt 1 ] && return $bad
}
"$curtain" licences >list
"$null" licences >null
check 'every library of curtain is listed' listed "$curtain" list
check 'every library of curtain-null is' listed "$null" null
grep -v '^Lua' list >fewer
detects 'one of curtain is not listed' 'liblua5.4.so.0 is not in the list' listed "$curtain" fewer
same 'curtain-null has no SDL' 0 "$(grep -c ^SDL null)"
for library in libsndfile libopenmpt; do
    check "$library is not linked" bash -c "! readelf -d '$curtain' | grep -q $library"
    check "... but named, for packing opens it" grep -q $library list
done
check 'stb, which is compiled in, is listed' grep -q '^stb ' list

# The texts.
words() { tr -s '[:space:]' ' ' | sed 's/^ //; s/ $//'; }
part() { # NAME: what --full says of it
    "$curtain" licences --full | awk -v name="^---- $1 " '/^---- / { on = $0 ~ name; next } on'
}
has() { # NAME TEXT
    case $(part "$1" | words) in *"$2"*) ;; *) echo "of $1 there is no: $2"; return 1 ;; esac
}
mit=$(sed '1,/^Permission/{/^Permission/!d}' "$repo/LICENSE" | words)
check "Curtain's is LICENSE, whole" has Curtain "$(sed 1,2d "$repo/LICENSE" | words)"
check "Lua's is MIT" has Lua "$mit"
check "the small Japanese font's is named" has Misaki 'These fonts are free software.'
check "the larger one's is named" has efont 'Neither the name of the team nor the names of its contributors'
finish
