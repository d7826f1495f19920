#!/usr/bin/env bash
# paths.sh - where things are: settings and pictures are named by paths that can be opened, and `curtain help config`
# says all there is to say of settings.
. "$(dirname "$0")/../scripted.sh"
own=$XDG_DATA_HOME/curtain

game g <<'LUA'
local dot = sprite.put { sprite = 'dot', x = 0, y = 30 }
task.go(function()
  while true do
    dot.x = dot.x + 1
    wait(1)
  end
end)
LUA

# ---- settings ----
"$curtain" help config >guide
check 'help config names the file' grep -qx "    $own/curtain.conf" guide
check '... which is not there yet' grep -q 'The file does not exist yet' guide
"$curtain" help play | sed -n '/^Settings:/,$p' | sed 1d | while read -r line; do
    grep -qF -- "$line" guide || echo "$line"
done >missing
same 'help config lists every setting' '' "$(cat missing)"
settings "$(sed -n '/^Example/,$s/^    //p' guide)"
keys 5 | plays out
same 'the example is accepted' '0 ' "$? $(cat err)"
refuse 'help config takes no word' 'help: unexpected argument "volume"' "$curtain" help config volume
settings 'scale = 2' 'volum = 3'
keys 5 | plays out
same 'a wrong line is reported with its path' \
    "2 curtain: $own/curtain.conf:2: unknown setting \"volum\"" "$? $(cat err)"
mkdir at
rm "$own/curtain.conf"

# ---- pictures ----
{ keys 30; keys 1 $F12; keys 30; keys 1 $F12; keys 30; } | plays out --record one.demo
same 'two pictures' "saved $XDG_PICTURES_DIR/Curtain/probe-1.png
saved $XDG_PICTURES_DIR/Curtain/probe-2.png" "$(cat err)"
"$curtain" render g --demo one.demo --frames 30 -o pictures-of
check 'a picture is the one that was seen' cmp "$XDG_PICTURES_DIR/Curtain/probe-1.png" pictures-of/000030.png
{ keys 30; keys 1 $F12; } | HOME=$scratch/at env -u XDG_PICTURES_DIR -u XDG_CONFIG_HOME ./player play g >out 2>err
same 'without the desktop'"'"'s setting: ~/Pictures' "saved $scratch/at/Pictures/Curtain/probe-1.png" "$(cat err)"
rm -rf "$XDG_PICTURES_DIR" && echo file >"$XDG_PICTURES_DIR"
{ keys 30; keys 1 $F12; keys 30; } | plays out
picture="$XDG_PICTURES_DIR/Curtain/probe-1.png: cannot be written (Not a directory)"
same 'where it cannot be: reported, and at exit' "curtain: $picture
curtain: not saved: $picture" "$(cat err)"
finish
