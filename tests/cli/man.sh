#!/usr/bin/env bash
# man.sh - the manual page, which tools/manpage.sh makes of what `curtain help` says: all of it is there, no checker
# finds anything in it, and its examples run.
. "$(dirname "$0")/../tap.sh"
curtain=$OUT/curtain-null
page=$scratch/curtain.1

check "the page is made" bash -c "tools/manpage.sh '$curtain' >'$page'"
# As a reader sees it: one line, single blanks, plain hyphens.
shown() { mandoc -T ascii "$1" | sed $'s/.\b//g' | tr -s ' \n' '  '; }

# What the help has in its tables, a line each: its first word.
words() { sed -nE 's/^  (curtain )?([^ ]+) .*/\2/p'; }
has() { # PAGE: every command, option, key, setting and exit code
    local word text
    text=$(shown "$1")
    for word in $({ "$curtain" help; "$curtain" help play; } | words | sort -u); do
        case $text in *" $word "*) ;; *) echo "$word is not on the page"; return 1 ;; esac
    done
}
check "all of the help's tables are on it" has "$page"
sed '/rerecord/d' "$page" >"$scratch/short.1"
detects "an option is missing" "--rerecord is not on the page" has "$scratch/short.1"

quiet() { # COMMAND...: finds nothing
    local said
    said=$("$@" 2>&1 >/dev/null; "$@" 2>/dev/null | grep -E '(STYLE|WARNING|ERROR|UNSUPP|BASE):')
    echo "$said"
    [ -z "$said" ]
}
check "mandoc finds nothing in it" quiet mandoc -T lint -W all "$page"
if command -v man >/dev/null && man --version 2>/dev/null | grep -q 'man 2'; then
    check "man does not warn of it" quiet env LC_ALL=C MANROFFSEQ= man --warnings -l "$page"
else
    echo "# no man of man-db here: its warnings are not looked at"
fi

# The examples, in a folder with a game; a run without a window takes the place of `play`, which needs one.
examples() ( # PAGE
    local line
    mkdir -p "$scratch/here" && cp -r examples/first "$scratch/here/mygame" && cd "$scratch/here" || return
    echo ff8844 >warm.hex
    curtain() {
        [ "$1" != play ] || set -- hash "${@:2}" --frames 60
        "$program" "$@"
    }
    while read -r line; do
        eval "$line" >"$scratch/.ran" || { echo "$line"; return 1; }
    done < <(sed -n '/^\.RS/,/^\.RE/{/^\./d; s/\\-/-/g; p}' "$1")
    [ -s atlas.png ] && [ -s mine/main.lua ] && [ -s one.png ] && [ -s my.gif ] && [ -s one.gif ] &&
        [ -s best.demo ] && [ -s .curtain.lua ]
)
program=$(realpath "$curtain")
check "its examples run" examples "$page"
finish
