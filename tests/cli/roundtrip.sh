#!/usr/bin/env bash
# roundtrip.sh - the same in, the same out: packing, unpacking, playing from folder and file, and other compilers.
#
# Builds the program once more with clang, with -O0, with -O3 and without doubles in its arithmetic (build/cross-*),
# which takes a while the first time.
. "$(dirname "$0")/../tap.sh"
sandbox
glasstide=$repo/roms/glasstide

torture=$repo/roms/torture

# ---- pack, list, unpack ----

for folder in "$torture" "$glasstide" "$repo/roms/testcard"; do
    name=$(basename "$folder")
    "$curtain" pack "$folder" -o "$name.1.rom"
    cp -r "$folder" "copy of $name"
    find "copy of $name" -exec touch -d 2001-02-03 {} +
    mkdir -p "elsewhere/$name" && cp -r "$folder/." "elsewhere/$name"
    "$curtain" pack "elsewhere/$name/" -o "$name.2.rom"
    check "$name: packs to the same bytes in another place and time" cmp "$name.1.rom" "$name.2.rom"
    "$curtain" list "$folder" >one
    "$curtain" list "$name.1.rom" >two
    same "$name: a list of the folder is that of the ROM" "$(cat two)" "$(cat one)"
    check "$name: the list is sorted" bash -c "head -n -2 one | cut -d' ' -f1 | LC_ALL=C sort -c"
    "$curtain" unpack "$name.1.rom" "un$name"
    same "$name: every lump becomes a file" "$(($(wc -l <two) - 2))" "$(find "un$name" -type f | wc -l)"
    while read -r lump size crc; do
        case $lump in
        script/@std/*) file=un$name/std/${lump#script/@std/} ;;
        script/*) file=un$name/${lump#script/} ;;
        data/*) file=un$name/${lump#data/} ;;
        demo/*) file=un$name/demos/${lump#demo/}.demo ;;
        *) file=un$name/lumps/$lump ;;
        esac
        printf '%s\t%s\n' "$file" "$size $crc"
    done < <(head -n -2 two) >wanted
    wrong=$(python3 - wanted 2>&1 <<'END'
import sys, zlib
for line in open(sys.argv[1]):
    file, want = line.rstrip("\n").split("\t")
    data = open(file, "rb").read()
    got = "%d %08x" % (len(data), zlib.crc32(data))
    if got != want:
        print("%s: %s, the list says %s" % (file, got, want))
END
)
    same "$name: the files have the sizes and CRCs of the list" '' "$wrong"
    "$curtain" hash "$folder" --frames 200 --parts >one 2>&1
    "$curtain" hash "$name.1.rom" --frames 200 --parts >two 2>&1
    same "$name: folder and ROM hash alike" "$(cat one)" "$(cat two)"
done

# ---- the same in other builds ----

# What is compared: hash tracks, pictures, packed bytes.
tracks() { # PROGRAM FOLDER
    mkdir -p "$2/frames"
    "$1" pack "$torture" -o "$2/torture.rom"
    "$1" pack "$glasstide" -o "$2/glasstide.rom"
    "$1" hash "$torture" --demo "$torture/demos/torture.demo" --parts >"$2/everything" 2>&1
    echo "exit $?" >>"$2/everything"
    "$1" hash "$glasstide" --demo "$glasstide/demos/run.demo" --frames 3000 --every 10 --parts >"$2/demo" 2>&1
    echo "exit $?" >>"$2/demo"
    for rom in "$glasstide" "$torture" "$repo/roms/testcard"; do
        "$1" verify "$rom" "$rom"/demos/*.demo
        echo "exit $?"
    done >"$2/verify" 2>&1
    "$1" hash "$glasstide" --stage queen --difficulty hard --frames 900 --every 10 --seed 12345678901 \
        --parts >"$2/boss" 2>&1
    "$1" render "$torture" --demo "$torture/demos/torture.demo" --frames 1:600:117 -o "$2/frames" 2>/dev/null
    "$1" render "$glasstide" --demo "$glasstide/demos/run.demo" --frames 600:3000:300 -o "$2/frames" \
        --sheet "$2/sheet.png" 2>/dev/null
    "$1" render "$repo/roms/testcard" --frames 1,2,100 -o "$2/frames" 2>/dev/null
    "$1" capture "$glasstide" --stage one --press fire --frames 0:240 -o "$2/film.gif" 2>/dev/null
}
tracks "$curtain" here
same 'the script that uses everything runs to its end' 'exit 0' "$(tail -1 here/everything)"
same 'the demo runs to its end' 'exit 0' "$(tail -1 here/demo)"
tracks "$curtain" again
check 'twice the same: hashes, pictures, ROMs' diff -r here again

same 'all demos hold' 'exit 0' "$(grep '^exit' here/verify | sort -u)"
tracks "$OUT/curtain" window
check 'the same in the program with a window' diff -r here window

other() { # NAME MAKE-ARGUMENT...
    local name=$1
    shift
    if ! env -u MAKEFLAGS -u MFLAGS make -j2 -s -C "$repo" --no-print-directory CONFIG="cross-$name" "$@" \
        "build/cross-$name/curtain-bare" >make.log 2>&1; then
        not_ok "builds with $*" "$(tail -5 make.log)"
        return
    fi
    ok "builds with $*"
    same "$name: without a warning" '' "$(grep -i warning make.log)"
    tracks "$repo/build/cross-$name/curtain-bare" "$name"
    for file in everything demo verify boss torture.rom glasstide.rom frames sheet.png film.gif; do
        if diff -r "here/$file" "$name/$file" >differs 2>&1; then ok "$name: the same $file"
            else not_ok "$name: the same $file" "$(head -c 400 differs)"; fi
    done
}
command -v clang >/dev/null || not_ok 'clang is installed'
other clang CC=clang
other o0 CC=gcc OPT=-O0
other o3 CC=gcc OPT='-O3 -ftree-vectorize'
other twins CC=clang OPT=-O0 CFLAGS=-DFX_INTEGER
finish
