#!/usr/bin/env bash
# commands.sh - records what command lines do, so that two programs can be compared: one from before a change, and one
# from after it.
#
#     OUT=build/release tests/commands.sh record DIR [TEXT]
#         runs every row of tests/commands.list, or those that contain TEXT, with the programs in $OUT: curtain,
#         curtain-null and curtain-player
#     tests/commands.sh compare DIR_A DIR_B
#         prints the rows whose results differ, as diffs, and "N same, N differ"; exit code 1 if a row differs
#     tests/commands.sh rows
#         prints every row, templates expanded
#
# DIR receives the file `rows` and a file for each row: exit code, standard output, standard error, and the SHA-256 of
# each file that the row wrote or removed. Two rows run at a time, each in a separate folder with copies of the files of
# the repository that it names; the folders for home, data and pictures are in it. Words replace what changes from run
# to run: folders, dates, measured times and Lua memory, exported programs. `record` lists the rows that were killed by
# a signal or ran for too long, and counts the exit codes.
set -u -o pipefail
cd "$(dirname "$0")/.." || exit 2
repo=$PWD OUT=${OUT:-build/release} list=tests/commands.list
limit=120 # seconds of the processor for a program of a row
export LC_ALL=C
shopt -s nullglob dotglob

fail() {
    echo "commands.sh: $1" >&2
    exit 2
}

# ---- templates ----

declare -A sets # NAME: the alternatives as they are in the list, "a | b | c"

# expand ROW: prints the row once for each alternative of its first template, which may contain others.
expand() {
    local row=$1 template alternatives one
    if [[ ! $row =~ \{([A-Z_]+|[^{}]*" | "[^{}]*)\} ]]; then
        echo "$row"
        return
    fi
    template=${BASH_REMATCH[0]} alternatives=${BASH_REMATCH[1]}
    if [ "${template/ | /}" = "$template" ]; then
        [ "${sets[$alternatives]+is}" ] || fail "$list: unknown set $template"
        alternatives=${sets[$alternatives]}
    fi
    while [ "$alternatives" ]; do
        one=${alternatives%%" | "*}
        alternatives=${alternatives#"$one"}
        alternatives=${alternatives#" | "}
        case $template in
        *" | "*) expand "${row/"$template"/"$one"}" ;;
        *) expand "${row//"$template"/"$one"}" ;;
        esac
    done
}

rows() {
    local line
    while IFS= read -r line; do
        case $line in
        '' | '#'*) ;;
        'set '*' = '*)
            line=${line#set }
            sets[${line%%" = "*}]=${line#*" = "}
            ;;
        *) expand "$line" ;;
        esac
    done <"$list" | awk '!seen[$0]++' # templates can make the same row
}

# ---- one row ----

# Times and Lua memory that commands measure. Other times are of the game, and the same in each run.
bench_times='s/ +[0-9]+\.[0-9]{3}( .*%.* of .*)?/ TIME/g; s/^(Time per tick|On a machine|on a machine).*/\1 TIME/
    s/"(tick|draw|sound|mean|p99|worst|late|worst_frame)":[0-9]+/"\1":TIME/g
    s/"worst_run":"[^"]*"/"worst_run":TIME/g; s/"phases":\{[^}]*\}/"phases":TIME/
    s/^(board\.lua_kib +[0-9]+) .*/\1 LUA/; s/[0-9,]+ KiB less with/LUA less with/
    s/("name":"board\.lua_kib","asked":[0-9]+),[^}]*/\1,LUA/; s/"bytes":[0-9]+/"bytes":LUA/g'
check_memory='s/Lua RAM [0-9]+ %/Lua RAM LUA %/'
test_times='s/(>| +)[0-9]+\.[0-9]+ s([ <,]|$)/ TIME s\2/g; s/time="[0-9.]+"/time="TIME"/g'
dates='s/20[0-9]{2}-[0-9]{2}-[0-9]{2}( [0-9:]{8} [+-][0-9]{4})?/DATE/g'

# tidy ROW FOLDER [FILE...]: replaces in the files what changes from run to run
tidy() {
    local times='' row=$1 here=$2
    shift 2
    case $row in
    *'curtain bench'*) times=$bench_times ;;
    *'curtain test'*) times=$test_times ;;
    *'curtain check'*) times=$check_memory ;;
    esac
    [ $# = 0 ] || sed -E -i "s,$here,HERE,g; s,$work/bin,PROGRAMS,g; $times; $dates" "$@"
}

sums() { (cd "$1" && find . -type f -exec sha256sum {} + | sort); }

# The files that the row has written or removed, a line each.
changes() { # ROW FOLDER
    local files=("$2"/*)
    [ ${#files[@]} != 0 ] || return 0
    find "$2" -type f -perm -100 -size +1M -exec sh -c 'for f; do echo a program >"$f"; done' - {} +
    mapfile -t files < <(grep -rlaF -e "$work" -e '<testsuites' -e '<!doctype html' -e 'Curtain report' "$2")
    tidy "$1" "$2" "${files[@]}"
    sums "$2" | comm -3 - "$2.before" | awk -F '\t' '
        { name = substr($NF, 67) }
        NF == 1 { print; written[name] = 1 }
        NF == 2 { before[name] = 1 }
        END { for (name in before) if (!(name in written)) print "removed  " name }' | sed -E "$dates" | sort -k 2
}

# run_row NUMBER ROW: writes $to/NUMBER. A program that ran for too long has exit code 137.
run_row() {
    local row=$2 rest=$2 here=$work/$1 name names=() code
    mkdir "$here"
    while [[ $rest =~ (roms|examples|tests)/[A-Za-z0-9_./-]*[A-Za-z0-9] ]]; do
        name=${BASH_REMATCH[0]} rest=${rest#*"${BASH_REMATCH[0]}"}
        [[ " ${names[*]} " == *" $name "* ]] || [ ! -e "$work/files/$name" ] || names+=("$name")
    done
    : >"$here.before"
    if [ ${#names[@]} != 0 ]; then
        for name in "${names[@]}"; do
            (cd "$work/files" && cp -r --parents "$name" "$here")
        done
        grep -F "${names[@]/#/-e  ./}" "$work/sums" >"$here.before"
    fi
    ( # discards Bash's message about a killed process
        cd "$here" || exit
        env -i PATH="$work/bin:$PATH" LC_ALL=C TZ=UTC HOME="$here/home" XDG_DATA_HOME="$here/data" \
            XDG_PICTURES_DIR="$here/pictures" SDL_VIDEODRIVER=dummy SDL_AUDIODRIVER=dummy \
            bash -o pipefail -c "ulimit -t $limit; $row" </dev/null >"$here.out" 2>"$here.err"
        exit $?
    ) 2>/dev/null
    code=$?
    [ ! -s "$here.out" ] || tidy "$row" "$here" "$here.out"
    [ ! -s "$here.err" ] || tidy "$row" "$here" "$here.err"
    {
        echo "\$ $row"
        echo "exit code $code"
        echo '---- standard output'
        cat "$here.out"
        echo '---- standard error'
        cat "$here.err"
        echo '---- files'
        changes "$row" "$here"
    } >"$to/$1"
    rm -rf "$here" "$here".*
}

# run_rows FIRST LAST: these rows of $to/rows
run_rows() {
    local n=$1 row
    while IFS= read -r row; do
        run_row "$(printf '%05d' "$n")" "$row"
        n=$((n + 1))
    done < <(sed -n "$1,$2p" "$to/rows")
}

# ---- commands ----

record() { # DIR [TEXT]
    local n
    [ ! -e "$1" ] || fail "$1: already exists"
    mkdir -p "$1" && to=$(cd "$1" && pwd) || exit 2
    work=$(mktemp -d) || exit 2
    trap 'rm -rf "$work"' EXIT
    export work to
    mkdir "$work/bin" "$work/files"
    cp "$OUT/curtain" "$OUT/curtain-player" "$OUT/curtain-null" "$work/bin" || exit 2
    tests/files.sh 'roms/*' 'examples/*' 'tests/demos/*' 'tests/bulletml/*' | tr '\n' '\0' |
        xargs -0 cp --parents -t "$work/files"
    sums "$work/files" >"$work/sums"
    rows >"$work/rows" || exit 2
    grep -F -- "${2:-}" "$work/rows" >"$to/rows" || fail "no row contains \"${2:-}\""
    n=$(wc -l <"$to/rows")
    seq 1 10 "$n" | xargs -P 2 -I '{}' "$repo/tests/commands.sh" run '{}'
    grep -H -a -m 1 -E '^exit code (12[5-9]|1[3-9].|2..)$' "$to"/[0-9]* | while IFS=: read -r file code; do
        echo "killed ($code): $(head -n 1 "$file")"
    done
    cat "$to"/[0-9]* | grep -a '^exit code' | sort | uniq -c
    echo "$n rows"
}

# compare A B: rows are matched by their text
compare() {
    local same=0 differ=0 n=0 row file
    declare -A other found
    for file in "$1/rows" "$2/rows"; do
        [ -f "$file" ] || fail "$file: no such file"
    done
    while IFS= read -r row; do
        n=$((n + 1))
        other[$row]=$2/$(printf '%05d' $n)
    done <"$2/rows"
    n=0
    while IFS= read -r row; do
        n=$((n + 1)) file=$1/$(printf '%05d' $n)
        if cmp -s "$file" "${other[$row]:-}"; then
            same=$((same + 1))
        else
            differ=$((differ + 1))
            echo "$row"
            diff -a -U 0 "$file" "${other[$row]:-/dev/null}" | sed '1,2d; /^@@ /d; s/^/    /' | cut -c 1-300 |
                head -n 20
        fi
        found[$row]=1
    done <"$1/rows"
    for row in "${!other[@]}"; do
        [ "${found[$row]+is}" ] || {
            differ=$((differ + 1))
            echo "only in $2: $row"
        }
    done
    echo "$same same, $differ differ"
    [ $differ = 0 ]
}

case "${1:-} $#" in
'record 2' | 'record 3') record "$2" "${3:-}" ;;
'compare 3') compare "$2" "$3" ;;
'rows 1') rows ;;
'run 2') run_rows "$2" $(($2 + 9)) ;; # for record
*) fail 'expected record DIR [TEXT], compare DIR_A DIR_B or rows' ;;
esac
