#!/usr/bin/env bash
# sheets.sh - every page of a game, on contact sheets: of the game in pages/ at three sizes, for one player and two, in
# English and in katakana; of Glass Tide and of a new game at their own size. A game is played by a script of keys
# (port_keys.c), and a sheet is compared pixel by pixel.
#
#     OUT=build/release tests/golden/sheets.sh             TAP; a failing test names the pictures that differ
#     OUT=build/release tests/golden/sheets.sh --update    writes the sheets again; look at them
. "$(dirname "$0")/../scripted.sh"
here=$repo/tests/golden sheets=$repo/tests/golden/sheets failed=$repo/build/golden-failed game=$PWD/game
update=${1:-}
build_player "$repo/tests/machine/lookups.c" -Wl,--wrap=words_find
export KEYS_FEW=1
J=13 # fire of player 2

# ---- scripts of keys ----

rest() { keys "$1"; }        # N: frames without a key
tap() { # KEY...: each pressed for two frames, and 12 frames later
    local key
    for key; do keys 2 "$key"; keys 12; done
}
times() { # N KEY
    local i
    for i in $(seq "$1"); do tap "$2"; done
}
shot() { keys 1 "!$1"; } # NAME: the picture of this frame

# walk DIR [ARGUMENT...], standard input: the keys; the pictures are added to DIR, in the game `game`
walk() {
    local keys
    mkdir -p "$1"
    keys=$(find "$1" -name '*.keys' | wc -l)
    keys=$(printf '%02d.keys' "$keys")
    cat >"$1/$keys"
    (cd "$1" && ../player play "$game" --no-resume --seed 1 "${@:2}" <"$keys" >/dev/null 2>err) || {
        not_ok "$1 runs" "$(cat "$1/err")"
        return 1
    }
    cat "$1/lookups" >>"lookups-${1##*-}"
}

# The end of the menu of a title, from Quit up: How to Play, Settings; in pages/ also Tips, Extras, Music, Replays,
# Missions and Practice.
page() { # NAME N: the picture of the page of the Nth entry above Quit, opened from the title
    rest 40
    tap $ENTER
    times $(($2 + 1)) $UP
    tap $Z
    rest 60
    shot "$1"
}
begin() { # PLAYERS: from power-on into a run
    rest 40
    tap $ENTER
    [ "$1" = 1 ] || tap $DOWN
    tap $Z
    rest 30
    tap $ENTER
}
# start_pages DIR PLAYERS: the menu of the title, and the page Start as it opens and with other choices
start_pages() {
    { rest 40; tap $ENTER; rest 20; shot menu; [ "$2" = 1 ] || tap $DOWN; tap $Z; rest 90; shot start
        tap $DOWN $RIGHT $DOWN $RIGHT; rest 60; shot start-changed; } | walk "$1"
}
settings_pages() { # DIR
    { page settings 2; for i in 1 2 3 4 5 6; do tap $Z; rest 10; shot settings-$i; tap $X $DOWN; done; } | walk "$1"
}

# ---- the game in pages/ ----

menus() { # DIR PLAYERS
    { rest 85; shot title; } | walk "$1"
    start_pages "$1" "$2"
    { page how-to-play 1; tap $RIGHT; rest 60; shot how-to-play-2; tap $RIGHT $RIGHT; rest 60; shot how-to-play-4; } |
        walk "$1"
    { page settings 2; tap $Z; rest 20; shot settings-page; } | walk "$1"
    page tips 3 | walk "$1"
    page extras 4 | walk "$1"
    page music 5 | walk "$1"
    page replays 6 | walk "$1"
    { page missions 7; tap $Z; rest 40; tap $Z; rest 400; shot mission; } | walk "$1"
    page practice 8 | walk "$1"
}
river() { # DIR PLAYERS
    { begin "$2"; rest 30; shot banner; keys 100 $Z $J; rest 60; shot talk; tap $Z $Z $Z; rest 40; shot talk-2
        tap $Z $Z $Z; rest 150; shot warning; rest 190; shot boss; tap $ESCAPE; rest 10; shot pause; tap $ESCAPE
        rest 135; shot spell; rest 30; shot spell-moves; rest 40; shot bonus; rest 150; shot captured
        rest 270; shot results; tap $Z; rest 280; shot cast; rest 150; shot results-2; rest 280; tap $Z; rest 60
        shot all-clear; rest 250; shot ending; tap $Z; rest 150; shot staff; tap $ENTER; score_pages "$2"
        tap $X; rest 60; tap $ENTER; times 7 $UP; shot menu-full; tap $Z; rest 60; shot spells; } | walk "$1"
}
rapids() {
    { rest 40; tap $ENTER; [ "$2" = 1 ] || tap $DOWN; tap $Z; rest 30; tap $RIGHT $ENTER
        rest 400; shot continue; rest $((650 * $2)); shot game-over; } | walk "$1"
}

# game_of SIZE PLAYERS: the game in pages/ in the folder game
game_of() {
    local field=${1%x*}
    [ "$1" != 384x288 ] || field=264 # with a side panel
    rm -rf game && cp -r "$here/pages" game && mkdir game/art
    cp "$repo"/examples/shooter/art/{palette,font,bullets,shots,kite,keeper}.png game/art
    python3 "$here/kana.py" "$here/kana.txt" >game/art/kana.bdf
    sed -i "s/screen = { w = 240, h = 320 }/screen = { w = ${1%x*}, h = ${1#*x} }/
        s/field = { w = 240, h = 320 }/field = { w = $field, h = ${1#*x} }/; s/players = 2/players = $2/" game/rom.lua
}

# ---- Glass Tide and a new game ----

# shorten FILE STAGE BOSS: the stage is only the boss, whose phases take seven seconds, and nobody is hit
shorten() {
    sed -i '/^stage\.def("'"$2"'", function()$/a\
  task.go(function() while true do wait(10) player.each(function(p) p.safe = 30 end) end end)\
  task.go(function() while true do wait(420) enemy.each(nil, function(e) e.hp = 0 end) end end)\
  player.each(function(p) score.add(123456, p) end)\
  wait(120)\
  boss.fight("'"$3"'")\
  do return end' "$game/$1"
}
glass_tide() {
    rm -rf game && cp -r "$repo/roms/glasstide" game && rm -rf game/{source,tests,demos/run.demo}
    sed -i 's/stages = { "one", "two", "three" }/stages = { "one" }/' game/main.lua
}
new_game() { # PLAYERS
    rm -rf game && "$curtain" new game >/dev/null
    sed -i "s/^  difficulties = /  players = $1, &/" game/rom.lua
}
results_pages() { # the results, and what follows them
    shot verdict
    rest 260
    shot results
    tap $Z
    rest 60
    shot all-clear
    rest 440
    shot ending
}
score_pages() { # PLAYERS: the name entry and the table, from the picture of the name entry on
    rest 60
    shot name
    keys 1 "'ANN"
    rest 10
    shot name-typed
    tap $ENTER
    [ "$1" = 1 ] || { keys 1 "'BEN"; tap $ENTER; }
    rest 60
    shot scores
}
glass_tide_tour() { # DIR
    { rest 200; shot opening; tap $ENTER $X; rest 75; shot title; } | walk "$1"
    { page how-to-play 1; for i in 2 3 4 5 6 7; do tap $RIGHT; rest 60; shot how-to-play-$i; done; } | walk "$1"
    settings_pages "$1"
    page extras 3 | walk "$1"
    page music 4 | walk "$1"
    page replays 5 | walk "$1"
    page missions 6 | walk "$1"
    page practice 7 | walk "$1"
    { rest 90; shot warning; rest 300; shot talk; } | walk "$1" --stage one:crab
}
glass_tide_run() { # DIR PLAYERS
    shorten stages/one.lua one nautilus
    { begin "$2"; rest 60; shot banner; keys 80 $Z $J; shot play; rest 150; shot boss; tap $ESCAPE; rest 10; shot pause
        tap $ESCAPE; rest 170; shot spell; rest 190; shot bonus; rest 170; results_pages
        for i in $(seq 12); do tap $Z; rest 20; done; shot staff; tap $ENTER; score_pages "$2"; } | walk "$1"
}
new_game_tour() { # DIR
    { rest 85; shot title; } | walk "$1"
    page how-to-play 1 | walk "$1"
    settings_pages "$1"
    page replays 3 | walk "$1"
    page practice 4 | walk "$1"
}
new_game_run() { # DIR PLAYERS
    shorten stages/river.lua river keeper
    { begin "$2"; rest 60; shot banner; rest 85; shot warning; rest 180; shot boss; tap $ESCAPE; rest 10; shot pause
        tap $ESCAPE; rest 160; shot spell; rest 180; shot bonus; rest 180; results_pages
        tap $Z; score_pages "$2"; } | walk "$1"
}

# ---- sheets ----

# sheet NAME: the pictures of the walks in the folder NAME, against the sheet of that name
sheet() {
    grep -ho '![a-z0-9-]*' "$1"/*.keys | tr -d '!' >"$1/names"
    if [ -n "$update" ]; then
        python3 "$here/sheet.py" "$sheets/$1.png" "$1" "$1/names" "$failed" --update
    else
        check "$1" python3 "$here/sheet.py" "$sheets/$1.png" "$1" "$1/names" "$failed"
    fi
}

for size in 240x320 320x240 384x288; do
    for players in 1 2; do
        for lang in en ja; do
            name=pages-$size-${players}p-$lang
            rm -rf data
            settings "lang = $lang"
            game_of $size $players
            menus $name $players
            river $name $players
            rapids $name $players
            sheet $name
        done
    done
done
# The game's name and the names in it. The program's text is tested in translated.sh.
untranslated() {
    "$curtain" help lang | sed 's/ =$//' >known
    printf '%s\n' 'P A P E R  B O A T S' 'A. Heron' 'B. Tern' ANN BEN >>known
    grep -a '^-.*[A-Za-z][A-Za-z]' lookups-ja | cut -c2- | sort -u | sed 's/[0-9][0-9]*/%d/g' | grep -vxFf known
}
same 'every text of the library and of the game has a translation' '' "$(untranslated)"
art=$repo/roms/glasstide/art
for players in 1 2; do
    for lang in en ja; do
        name=glasstide-${players}p-$lang
        [ $lang = en ] || { [ -e "$art/misaki_gothic.ttf" ] && [ -e "$art/efont_12.bdf" ]; } ||
            { ok "$name # SKIP a Japanese font is missing: make deps"; continue; }
        rm -rf data
        settings "lang = $lang"
        glass_tide
        start_pages $name $players
        [ $players = 2 ] || glass_tide_tour $name
        glass_tide_run $name $players
        sheet $name
    done
    name=new-${players}p
    rm -rf data
    new_game $players
    start_pages $name $players
    [ $players = 2 ] || new_game_tour $name
    new_game_run $name $players
    sheet $name
done
finish
