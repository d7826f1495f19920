#!/usr/bin/env bash
# helplua.sh - `curtain help lua WORD` finds what has the word in its name or its text, the nearest first and each once;
# `curtain help lua` begins with functions by task, all of which are there.
. "$(dirname "$0")/../tap.sh"
curtain=$OUT/curtain-null

find_word() { "$curtain" help lua "$1"; }
names() { find_word "$1" | grep -oE '^[a-z_]+([.:][a-z_]+)?([({]|  )' | tr -d '({ '; } # entries, in their order
place() { names "$1" | grep -nxF "$2" | cut -d : -f 1; } # WORD NAME: its line
before() { # WORD NAME OTHER: the first stands before the other one
    local a b
    a=$(place "$1" "$2") b=$(place "$1" "$3")
    [ -n "$a" ] && [ -n "$b" ] && [ "$a" -lt "$b" ] || { echo "$2: ${a:-not there}, $3: ${b:-not there}"; return 1; }
}
lacks() { # WORD NAME
    [ -n "$(names "$1")" ] && [ -z "$(place "$1" "$2")" ] || { names "$1"; return 1; }
}
says() { find_word "$1" | grep -qF -- "$2" || { find_word "$1"; return 1; }; }

check "a method is found, with its line" says turn 'bullet:turn(by)                                turns it by an angle'
check "a name that is the word stands before texts" before turn lasers:turn angle.difference
check "a name that has it stands before texts" before aim pattern.aimed bullet.fire
check "texts have words, not letters" lacks turn board.dip
check "a method of a variable is found" says p:push 'player:push(vx, vy)'
check "a method of several things, each" says e:move 'enemy:move'
check "arguments count as text" before radius query.near item.def
check "a step is found" says turn 'in each step of motion.def:'
check "a property is found by its text" says clockwise 'property spin of a laser: degrees a beam turns'
once() { # WORD: each entry stands there once
    [ -z "$(names "$1" | sort | uniq -d)" ]
}
check "each entry once" once remove
same "a table lists what it has, and nothing by its text" "" "$(names rng | grep -v '^rng\.')"
same "an entry's own name shows it alone" "wait(n)" "$(find_word wait | head -1)"
check "a synonym names the API's word" says homing 'homing: see home'
synonyms() { # every name in the table is explained
    local name
    for name in $(sed -n '/\*const synonyms/,/^};/s/.*{ "[a-z]*", "\(.*\)" },/\1/p' src/workbench/help/help.c); do
        find_word "$name" >/dev/null || { echo "$name is none"; return 1; }
    done
}
check "all synonyms lead somewhere" synonyms
refuse "what is nowhere" 'no entry for "xyzzy"' find_word xyzzy

tasks() { "$curtain" help lua | sed -n '1,/^$/s/^    .\{24\} //p'; }
real() { # every name by task is one that is explained
    local name
    for name; do
        find_word "$name" | head -1 | grep -qE "^$name([({ ]|\$)" || { echo "$name is none"; return 1; }
    done
}
check "the names by task are all there" real $(tasks)
detects "one that is not" "bullet.fyre is none" real $(tasks) bullet.fyre
finish
