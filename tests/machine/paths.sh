#!/usr/bin/env bash
# paths.sh - where things are: settings, scores, pictures and recordings are named by paths that can be opened, and
# `curtain help config` says all there is to say of settings.
. "$(dirname "$0")/../scripted.sh"
F12=69
own=$XDG_DATA_HOME/curtain
mkdir -p "$own"

game g <<'LUA'
local dot = sprite.put { sprite = 'dot', x = 0, y = 30 }
task.go(function()
  while true do
    dot.x = dot.x + 1
    wait(1)
  end
end)
LUA
plays() { ./player play g --seed 5 "$@" >out 2>err; }

# ---- settings ----
"$curtain" help config >guide
check 'help config names the file' grep -qx "    $own/curtain.conf" guide
check '... which is not there yet' grep -q 'The file does not exist yet' guide
settings() { "$curtain" help play | sed -n '/^Settings:/,$p' | sed 1d; }
lists() { # GUIDE: each line of the settings
    local line
    while read -r line; do
        grep -qF -- "$line" "$1" || { echo "not there: $line"; return 1; }
    done < <(settings)
}
check 'help config lists every setting' lists guide
example() { sed -n '/^Example/,$s/^    //p' guide; }
example >"$own/curtain.conf"
check '... and comments' grep -q '^#' "$own/curtain.conf"
keys 5 | plays
same 'the example is a file that is taken' '0 ' "$? $(cat err)"
check 'help config sees that it is there' eval '"$curtain" help config | grep -q "Settings that are not in"'
refuse 'help config takes no word' 'help: unexpected argument "volume"' "$curtain" help config volume
printf 'scale = 2\nvolum = 3\n' >"$own/curtain.conf"
keys 5 | plays
same 'a wrong line: exit code' 2 $?
same 'a wrong line: its path' "curtain: $own/curtain.conf:2: unknown setting \"volum\"" "$(cat err)"
head -c 70000 /dev/zero >"$own/curtain.conf"
keys 5 | plays
same 'a file too large: its path' "curtain: $own/curtain.conf: cannot be read, or is larger than 65536 bytes" \
    "$(cat err)"
rm "$own/curtain.conf"

# ---- pictures ----
{ keys 30; keys 1 $F12; keys 30; keys 1 $F12; keys 30; } | plays --record one.demo
same 'two pictures' "saved $XDG_PICTURES_DIR/Curtain/probe-1.png
saved $XDG_PICTURES_DIR/Curtain/probe-2.png" "$(cat err)"
"$curtain" render g --demo one.demo --frames 30 -o pictures-of
check 'a picture is the one that was seen' cmp "$XDG_PICTURES_DIR/Curtain/probe-1.png" pictures-of/000030.png
same 'none is in the current folder' '' "$(ls ./*.png 2>/dev/null)"
{ keys 30; keys 1 $F12; keys 30; } | KEYS_WHOLE=1 plays
keys 61 | KEYS_WHOLE=1 ./player play g --seed 5 >other 2>none
same 'the picture says where for a while' 0 "$(comm -12 <(part out 33 60 | sort) <(part other 33 60 | sort) | wc -l)"
mkdir at && (
    unset XDG_PICTURES_DIR XDG_CONFIG_HOME
    { keys 30; keys 1 $F12; } | HOME=$scratch/at plays
)
same 'without a word of the desktop: ~/Pictures' "saved $scratch/at/Pictures/Curtain/probe-1.png" "$(cat err)"
rm -rf "$XDG_PICTURES_DIR" && echo file >"$XDG_PICTURES_DIR"
{ keys 30; keys 1 $F12; keys 30; } | plays
picture="$XDG_PICTURES_DIR/Curtain/probe-1.png: cannot be written (Not a directory)"
same 'where it cannot be: said, and at exit' "curtain: $picture
curtain: not saved: $picture" "$(cat err)"

# ---- recordings ----
{ keys 30; keys 1 $T; keys 30; } | ./player play g --demo one.demo >out 2>err
check 'a take-over says where it records' grep -qx \
    "curtain: g: You are playing from here. Recording: $scratch/probe-1.demo" err
check '... and does' "$curtain" verify g probe-1.demo
finish
