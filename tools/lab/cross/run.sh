#!/usr/bin/env bash
# run.sh - make cross: builds the headless program for other machines and with other releases of Lua, and runs every
# demo of the repository in each build: the same hash of every part at every frame, the same pixels and sound, as on
# x86-64.
#
#     tools/lab/cross/run.sh [BUILD...]      without arguments: all of them, and the page docs/internals/determinism.md
#
# Two builds at a time, each made anew in build/cross/BUILD; one line a build. The page is written when all builds agree
# and nothing but the page differs from the commit. Exit 1: a build could not be made, run, or gave something else.
set -u
cd "$(dirname "$0")/../../.." || exit 2
export LC_ALL=C
page=docs/internals/determinism.md
cross=build/cross
reference=x86-64
# Machines by Debian's names; the suite whose Lua they have, if it is not bookworm.
builds="$reference arm64 armhf i386 s390x wasm32 x86-64-trixie s390x-trixie wasm32-trixie"
demos="roms/*/demos/*.demo tests/demos/*.demo" # the latter are of a ROM beside them that is never packed anew
every=60                                       # frames from picture to picture

# ---- what a build is made of ----

# Sets suite, cc, flags, link, and run, which runs the build's programs here. Other machines' libraries that read
# recordings are not here, and a static program opens none.
set_up() {
    suite=bookworm flags="" link="" run=""
    case $1 in *-trixie) suite=trixie ;; esac
    case ${1%-trixie} in
    x86-64) if [ $suite = trixie ]; then cc=clang; else cc=gcc; fi ;;
    arm64) cc=aarch64-linux-gnu-gcc flags=-static run=qemu-aarch64-static ;;
    armhf) cc=arm-linux-gnueabihf-gcc flags=-static run=qemu-arm-static ;;
    i386) cc=i686-linux-gnu-gcc flags="-static -msse2 -mfpmath=sse" run=qemu-i386-static ;;
    s390x) cc=s390x-linux-gnu-gcc flags=-static run=qemu-s390x-static ;;
    wasm32)
        cc="clang --target=wasm32-wasi" run="node --no-warnings tools/lab/cross/wasi/run.mjs"
        link="-Wl,--export=__stack_pointer -Wl,--export-table -Wl,--stack-first -Wl,-z,stack-size=8388608"
        ;;
    *) return 1 ;;
    esac
}

missing() { # BUILD: what it needs and this machine has not
    local tool
    set_up "$1" || { echo "there is no such build (there are $builds)"; return; }
    for tool in make git file pkg-config gcc ${cc%% *} ${run%% *}; do
        command -v "$tool" >/dev/null || { echo "there is no $tool here (tools/deps.sh cross installs it)"; return; }
    done
}

fetch() { # SUITE
    [ -d "$cross/lua-$1" ] || echo "Lua of Debian $1"
    tools/source.sh lua5.4 "$1" "$cross/lua-$1"
}

# Lua as Debian compiles it, but static; of its libraries only those the sandbox takes from.
build_lua() {
    local include="-I$cross/include" source
    case $cc in *wasm32*) include="$include -Itools/lab/cross/wasi -include tools/lab/cross/wasi/lua_try.h" ;; esac
    mkdir -p "$dir/lua"
    for source in "$cross/lua-$suite"/src/l*.c; do
        case ${source##*/} in
        lua.c | luac.c | linit.c | liolib.c | loslib.c | lcorolib.c | ldblib.c | loadlib.c) continue ;;
        esac
        # shellcheck disable=SC2086
        $cc -std=gnu99 -O2 -DLUA_COMPAT_5_3 $flags $include -c "$source" -o "$dir/lua/$(basename "$source" .c).o" ||
            return 1
    done
}

build() {
    local target include
    rm -rf "${dir:?}"
    mkdir -p "$dir"
    # Most x86-64 run i386 themselves, ten times faster.
    if [ "$run" = qemu-i386-static ]; then
        # shellcheck disable=SC2086
        echo 'int main(void) { return 0; }' | $cc $flags -x c - -o "$dir/probe" && "$dir/probe" && run=""
    fi
    set -- CC="$cc" BUILD_CC=gcc RUN="$run" CFLAGS="-Werror -DWITHOUT_LIBRARIES $flags"
    if [ "$name" != $reference ]; then
        build_lua || return 1
        case $cc in *wasm32*) include="-I$PWD/tools/lab/cross/wasi" ;; *) include="" ;; esac
        set -- "$@" LUA_C="-I$PWD/$cross/lua-$suite/src -I$PWD/$cross/include $include" \
            LUA_L="$(echo "$dir"/lua/*.o) $link"
    fi
    for target in curtain-null prove/digest; do
        make --no-print-directory -s CONFIG="cross/$name" "$@" "$dir/$target" || return 1
    done
}

# ---- what it does ----

runs() { # PROGRAM ARGUMENT...: of this build
    local program=$1
    shift
    $run "$dir/$program" "$@"
}

# The first frame that differs, and its parts.
first_difference() { # WANT GOT
    awk 'NR == FNR { want[FNR] = $0; next }
        $0 != want[FNR] {
            n = split(want[FNR], w)
            for (i = 3; i <= n; i++) if (w[i] != $i) { sub(/=.*/, "", w[i]); parts = parts (parts ? ", " : "") w[i] }
            print "frame " $1 ": " (parts ? parts " differ" : "no such frame"); found = 1; exit
        }
        END { if (!found) print "it has " FNR " frames" }' "$1" "$2"
}

same_files() { # WHAT WANT GOT
    [ "$name" = $reference ] || diff -rq "$2" "$3" >/dev/null ||
        { echo "$1 differ: $(diff -rq "$2" "$3" | head -n 1)"; return 1; }
}

play() { # GAME (a packed one) DEMO
    local key frames
    key=$(basename "$1" .rom)-$(basename "$2" .demo)
    runs curtain-null hash "$1" --demo "$2" --parts >"$dir/tracks/$key" || return 1
    cmp -s "$cross/$reference/tracks/$key" "$dir/tracks/$key" ||
        { echo "$2: $(first_difference "$cross/$reference/tracks/$key" "$dir/tracks/$key")"; return 1; }
    # One of an older core version may differ, in the same frame and parts everywhere.
    runs curtain-null verify "$1" "$2" >"$dir/verdicts/$key" ||
        grep -q '(recorded with core version' "$dir/verdicts/$key" || { cat "$dir/verdicts/$key"; return 1; }
    same_files "$2: verdict" "$cross/$reference/verdicts/$key" "$dir/verdicts/$key" || return 1
    frames=$(tail -n 1 "$dir/tracks/$key" | cut -d ' ' -f 1)
    runs curtain-null render "$1" --demo "$2" --frames "0:$frames:$every,$frames" -o "$dir/pictures/$key" \
        --wav "$dir/sounds/$key.wav" || return 1
    sha256sum <"$dir/sounds/$key.wav" >"$dir/sounds/$key" && rm "$dir/sounds/$key.wav"
    same_files "$2: sound" "$cross/$reference/sounds/$key" "$dir/sounds/$key" || return 1
    same_files "$2: pictures" "$cross/$reference/pictures/$key" "$dir/pictures/$key"
}

# A whole game of the built-in one, another on each build: verify compares it with what x86-64 recorded.
clear_of() { # BUILD
    local n=0 build demos=(tests/demos/glasstide/*.demo)
    for build in $builds; do
        [ "$build" != "$1" ] || echo "${demos[n % ${#demos[@]}]}"
        n=$((n + 1))
    done
}

play_all() {
    local demo rom keys=$cross/$reference/keys.demo
    mkdir -p "$dir"/{roms,tracks,pictures,sounds,verdicts}
    runs curtain-null version >"$dir/version" && runs prove/digest --each >"$dir/digest" || return 1
    same_files "the functions of base" "$cross/$reference/digest" "$dir/digest" || return 1
    for rom in $(ls -d roms/*/demos | sed 's,/demos$,,') tests/cross/keys; do
        runs curtain-null pack "$rom" -o "$dir/roms/$(basename "$rom").rom" || return 1
    done
    cp tests/demos/*.rom "$dir/roms/" || return 1
    same_files "packed games" "$cross/$reference/roms" "$dir/roms" || return 1
    if [ "$name" = $reference ]; then
        runs curtain-null hash "$dir/roms/keys.rom" --record "$keys" --frames 600 --every 600 >"$dir/said" || return 1
    fi
    for demo in $demos "$keys"; do
        case $demo in
        roms/*) rom=$(basename "${demo%/demos/*}") ;;
        tests/*) rom=$(basename "${demo%-*}") ;;
        *) rom=keys ;;
        esac
        play "$dir/roms/$rom.rom" "$demo" || return 1
    done
    demo=$(clear_of "$name")
    runs curtain-null verify "$dir/roms/glasstide.rom" "$demo" >"$dir/clear" || { cat "$dir/clear"; return 1; }
}

one() { # BUILD: its line; $dir/good when it agrees
    name=$1 dir=$cross/$1
    local from=$SECONDS said=$cross/$1.said what
    set_up "$name" || return 1
    { build && play_all; } >"$said" 2>&1 && touch "$dir/good"
    if [ -f "$dir/good" ]; then
        what="$(cat "$dir"/tracks/* | wc -l) hashes, $(find "$dir/pictures" -name '*.png' | wc -l) pictures: equal"
        [ "$name" != $reference ] || what="the reference"
        printf '%-14s %s, %d s\n' "$name" "$what" $((SECONDS - from))
    else
        printf '%-14s FAILED\n%s\n' "$name" "$(tail -n 12 "$said" | sed 's/^/    /')"
    fi
}

# ---- the page ----

fact() { # BUILD WORD: what its version line that begins so goes on with
    sed -n "s/^$2 //p" "$cross/$1/version"
}
lua_of() { # BUILD
    sed -n 's/^curtain .*, Lua \([0-9.]*\))$/\1/p' "$cross/$1/version"
}

table() {
    local name key keys kind
    keys=$(ls "$cross/$reference/tracks" | grep -v '^keys-')
    echo "| build | \`file\` | word size, byte order | compiler | Lua |"
    echo "|---|---|---|---|---|"
    for name in $builds; do
        kind=$(file -b "$cross/$name/curtain-null" |
            sed 's/, BuildID[^,]*//; s/, with debug_info//; s/, for GNU.*//; s/, not stripped//')
        echo "| $name | $kind | $(fact "$name" machine) | $(fact "$name" compiler) | $(lua_of "$name") |"
    done
    echo
    echo "Each build also verified one complete game of *Glass Tide*:"
    echo
    for name in $builds; do echo "* $name: $(sed 's,^tests/demos/glasstide/,,' "$cross/$name/clear")"; done
    echo
    echo "Hash of the state after the last frame:"
    echo
    echo "| build$(for key in $keys; do echo " | $key"; done | tr -d '\n') | frames | pictures |"
    echo "|---$(for key in $keys; do echo "|---"; done | tr -d '\n')|---:|---:|"
    for name in $builds; do
        printf '| %s' "$name"
        for key in $keys; do
            printf ' | %s: `%s`' $(tail -n 1 "$cross/$name/tracks/$key" | cut -d ' ' -f 1,2)
        done
        # shellcheck disable=SC2086
        echo " | $(cd "$cross/$name/tracks" && cat $keys | wc -l) |" \
            "$(cd "$cross/$name/pictures" && find $keys -name '*.png' | wc -l) |"
    done
}

changes() { # files that are not as committed, but for the page
    { git status --porcelain 2>/dev/null || echo "   there is no git repository here"; } | grep -v " $page\$"
}

contents() {
    echo "Made by \`make cross\` from commit $(git rev-parse --short=12 HEAD):"
    echo
    table
    echo
    echo "All builds agree on the hash of every part in every frame, on the bytes of the packed games, and on the" \
        "digest of all"
    echo "functions in \`src/base\` (\`tools/lab/prove/digest.c\`). The comparison also detects an x86-64 build in" \
        "which \`pairs\` uses"
    echo "Lua's own order: \`$(basename "$(tail -n 1 "$cross/unsorted.said")")\`."
}

write_page() {
    contents >"$cross/contents"
    sed -e "/^<!-- cross/r $cross/contents" -e '/^<!-- cross/,/^<!-- end/{/^<!--/!d}' "$page" >"$cross/page" &&
        cp "$cross/page" "$page"
}

if [ "${1:-}" = --one ]; then
    one "$2"
    exit
fi

chosen=${*:-$builds}
for name in $chosen; do
    what=$(missing "$name")
    [ -z "$what" ] || { echo "tools/lab/cross/run.sh: $name: $what" >&2; exit 3; }
done
before=$(changes; git rev-parse HEAD 2>/dev/null)
mkdir -p "$cross/include"
ln -sfn /usr/include/stb "$cross/include/stb"
echo '#define DEB_HOST_MULTIARCH "none"' >"$cross/include/lua5.4-deb-multiarch.h" # Debian's build makes this
for suite in bookworm trixie; do
    fetch $suite || exit 3
done

one $reference
[ -f "$cross/$reference/good" ] || exit 1
# shellcheck disable=SC2086
printf '%s\n' $chosen | grep -vx $reference | xargs -r -n 1 -P 2 "$0" --one
for name in $chosen; do
    [ -f "$cross/$name/good" ] || exit 1
done
tools/lab/cross/unsorted.sh "$cross/$reference" "$cross/$reference/keys.demo" | tee "$cross/unsorted.said"
[ "${PIPESTATUS[0]}" = 0 ] || exit 1
[ $# = 0 ] || exit 0
if [ -n "$(changes)" ] || [ "$before" != "$(changes; git rev-parse HEAD 2>/dev/null)" ]; then
    echo "$page is as it was, for these are not as committed:"
    changes
    table
    exit 0
fi
write_page
