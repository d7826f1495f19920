#!/usr/bin/env bash
# run.sh - the golden frames of tests/golden/list: the state's hash first, then the picture, pixel by pixel.
#
#     OUT=build/release tests/golden/run.sh             TAP, two tests a frame
#     OUT=build/release tests/golden/run.sh --update    makes hashes and frames/ anew
#
# Hashes differ: the run itself is another. Only the pixels differ: it is drawn in another way. A failure leaves
# expected, got and difference as PNG in build/golden-failed/.
. "$(dirname "$0")/../tap.sh"
here=tests/golden
failed=build/golden-failed
curtain=$OUT/curtain-null
[ -x "$curtain" ] || curtain=build/curtain-null

# run_options OPTIONS...: those of the run into $options; a view, which is the picture's alone, is left out.
run_options() {
    options=()
    while [ $# -gt 0 ]; do
        case $1 in
        --dim | --flashes | --colours) shift ;;
        *) options+=("$1") ;;
        esac
        shift
    done
}
# render NAME ROM FRAMES OPTIONS...: pictures and hashes of one line into $scratch/new
render() {
    local name=$1 rom=$2 frames=$3
    shift 3
    mkdir -p "$scratch/one" "$scratch/new"
    "$curtain" render "$rom" --frames "$frames" "$@" -o "$scratch/one" || return 1
    local png frame last=0 every=0 n
    for png in "$scratch"/one/*.png; do
        frame=$(basename "$png" .png)
        mv "$png" "$scratch/new/$name-$frame.png"
        echo "$((10#$frame))" >>"$scratch/wanted"
        last=$((10#$frame))
        for ((n = last; n > 0; )); do # the greatest step that meets all frames: hashing each frame takes long
            ((frame = every % n, every = n, n = frame))
        done
    done
    run_options "$@"
    "$curtain" hash "$rom" --frames "$last" --every "$((every ? every : 1))" "${options[@]}" |
        awk -v name="$name" 'NR == FNR { want[$1] = 1; next } want[$1] { printf "%s %06d %s\n", name, $1, $2 }' \
            "$scratch/wanted" - \
            >>"$scratch/hashes"
    rm -r "$scratch/one" "$scratch/wanted"
}
lines() { grep -vE '^#|^$' $here/list; }

if [ "${1:-}" = --update ]; then
    lines | while read -r -a line; do render "${line[@]}" || exit 1; done || exit 1
    mkdir -p $here/frames
    for old in $here/frames/*.png; do
        [ -f "$scratch/new/${old##*/}" ] || { [ -f "$old" ] && rm "$old" && echo "gone: $old"; }
    done
    for new in "$scratch"/new/*.png; do
        old=$here/frames/${new##*/}
        cmp -s "$new" "$old" || { cp "$new" "$old" && echo "new: $old"; }
    done
    cmp -s "$scratch/hashes" $here/hashes || { cp "$scratch/hashes" $here/hashes && echo "new: $here/hashes"; }
    echo "$(ls $here/frames | wc -l) golden frames"
    exit 0
fi

hash_holds() { # NAME-FRAME
    local want got
    want=$(grep "^${1%-*} ${1##*-} " $here/hashes)
    got=$(grep "^${1%-*} ${1##*-} " "$scratch/hashes")
    [ -n "$want" ] && [ "$want" = "$got" ] || { echo "state hash: $got, expected $want"; return 1; }
}
picture_holds() { # EXPECTED GOT NAME-FRAME
    cmp -s "$1" "$2" && return 0
    mkdir -p $failed
    python3 $here/png.py "$1" "$2" "$failed/$3.difference.png" && return 0
    cp "$1" "$failed/$3.expected.png"
    cp "$2" "$failed/$3.got.png"
    echo "see $failed/$3.{expected,got,difference}.png"
    return 1
}

while read -r -a line; do
    check "${line[0]}: ${line[1]} runs" render "${line[@]}"
done < <(lines)
for picture in $here/frames/*.png; do
    frame=$(basename "$picture" .png)
    check "$frame: hash" hash_holds "$frame"
    check "$frame: picture" picture_holds "$picture" "$scratch/new/$frame.png" "$frame"
done
complete() { diff <(ls $here/frames) <(ls "$scratch/new"); }
check "frames/ and the list name the same frames" complete

# A view is another picture of the same state.
of_state() { awk -v name="$1-$2" '$1 "-" $2 == name { print $3 }' $here/hashes; }
same_state() { [ -n "$(of_state "$1" "$2")" ] && [ "$(of_state "$1" "$2")" = "$(of_state "$3" "$2")" ]; }
check "a dim is another picture of the same state" same_state quarter 000300 stage
check "and so is a soft flash" same_state soft 014858 flash
check "and colours" same_state protan 000300 flower
check "and all of them" same_state together 014858 flash
finish
