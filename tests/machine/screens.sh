#!/usr/bin/env bash
# screens.sh - every screen of a game, reached by keys in a window of a real (virtual) X server. The game's pieces are
# the library's own, each of which says that it is shown; a key is pressed when the screen before has said so, so
# nothing depends on how fast the machine is. What was played is recorded, and verified.
. "$(dirname "$0")/../xserver.sh"
cd "$repo" || exit 2
export SDL_AUDIODRIVER=dummy

# game_of DIR SCREEN: Glass Tide's pictures, two short stages of its own, and all that boot.run can show.
game_of() {
    mkdir -p "$1" && cp -r roms/glasstide/{art,maps,lang,players,fx,sfx,music} roms/glasstide/*.lua "$1" || exit 2
    sed -i "s/screen = { w = 240, h = 320 }/$2/; s/title = \"Glass Tide\"/title = \"Screens\"/" "$1/rom.lua"
    mkdir -p "$1/std/screens" "$1/demos"
    for piece in scripts/screens/*.lua; do
        { echo "print('shown: $(basename "$piece" .lua)')"; cat "$piece"; } >"$1/std/screens/$(basename "$piece")"
    done
    cat >"$1/main.lua" <<'LUA'
require "kinds"
require "players/heron"
require "players/petrel"
hud.banks.plain, hud.banks.bright, hud.banks.faint = 0, 3, 13
enemy.def("buoy", { sprite = "float", hit = { circle = 15 }, touch = false })
boss.def("crab", { title = "Crab", kind = "buoy", x = 100, y = 60, phases = {
  { id = "shell", spell = "Shell Sign: A Second", survive = true, time = 60, rest = 0, run = function() end } } })
score.tally { { label = "GRAZE", value = "grazes", points = 10, stage = true } }
unlock.def("shell", { when = { spell = "crab/shell" }, hint = "Outlive it" })
unlock.def("owl", { when = { score = 999999999 }, hint = "Be very good" })
stage.def("one", function()
  print "stage one"
  wait(30)
  boss.fight("crab")
  player.each(function(p) score.add(1000 * p.index, p) end)
end)
stage.def("doom", function()
  print "stage doom"
  while true do
    player.each(function(p)
      p.lives, p.safe = 0, 0
      bullet.fire { kind = "orb", x = p.x, y = p.y, dir = 0, speed = 0 }
    end)
    wait(10)
  end
end)
boot.run {
  players = { "heron", "petrel" }, continues = 1, demos = { "a" },
  modes = { { name = "story", stages = { "one" }, text = "One stage." }, { name = "doom", stages = { "doom" } } },
  difficulties = { easy = "For a calm dive." }, ships = { heron = { text = "Fast and narrow." } },
  staff = { { "ART", "A. Heron" } }, music = { { name = "tide", text = "Stage one" }, { name = "queen" } },
}
LUA
    "$curtain" hash "$1" --frames 30 --every 30 --record "$1/demos/a.demo" >"$scratch/none" || exit 2
}

count() { grep -cx -- "$1" "$scratch/err"; }
more() { [ "$(count "$1")" -gt "$2" ]; } # LINE BEFORE
# press LINE KEY...: these keys, one after the other, and then the program says that line once more.
press() {
    local line=$1 before
    before=$(count "$1")
    shift
    for key in "$@"; do
        xdotool key --delay 60 "$key"
        wait_cpu 2
    done
    check "$game: $* leads to \"$line\"" wait_until more "$line" "$before"
    wait_cpu 3 # it takes keys from its second frame on
}

# way PLAYERS: title, mode, difficulty, ship, pause, results, ending, staff, name, scores, and back; then the other
# mode.
way() {
    local two=
    [ "$1" = 2 ] && two=Down
    check "$game: the title" wait_until more "shown: title" 0
    wait_cpu 3
    press "shown: mode" Return $two z
    press "shown: difficulty" z
    press "shown: ship" Up z
    if [ "$1" = 2 ]; then press "stage one" Right z d j; else press "stage one" Right z; fi
    press "shown: pause" Return
    xdotool key --delay 60 Return
    check "$game: results" wait_until more "shown: results" 0
    check "$game: an ending" wait_until more "shown: ending" 0
    wait_cpu 25
    press "shown: staff" z
    press "shown: name" Return
    if [ "$1" = 2 ]; then press "shown: scores" z z Return j j 2; else press "shown: scores" z z Return; fi
    press "shown: title" z
    press "shown: scores" Return Down Down z
    press "shown: title" Up Right z
    press "shown: history" Down z
    press "shown: title" Left Down z
    press "shown: music" Down z
    press "shown: title" Down x
    press "shown: unlocks" Down z
    press "shown: title" z
    xdotool key --delay 60 x # from the list back to PRESS START
    wait_cpu 2
    press "shown: mode" Return z
    press "shown: difficulty" Down z
    press "shown: ship" z
    press "stage doom" z
    check "$game: a continue" wait_until more "shown: continue" 0
    wait_cpu 3
    names=$(count "shown: name")
    xdotool key --delay 60 Return # goes on, with the one continue there is
    check "$game: a name after the last life" wait_until more "shown: name" "$names"
    wait_cpu 3
    press "shown: scores" z z Return
    press "shown: title" z
    press "shown: scores" # nobody comes: a demo, and then the scores
    press "shown: title"
}

# play DIR PLAYERS [OPTION]...
play() {
    local name=$1 players=$2
    shift 2
    game="$name, $players players"
    start "Screens" "$OUT/curtain" play "$name" --seed 0 --scale 1 --record "$name.demo" "$@" || return
    way "$players"
    stop
    check "$game: nothing went wrong" not_said
    check "$game: the demo holds" "$curtain" verify "$name" "$name.demo"
}
not_said() { ! grep -E "fault|curtain: " "$scratch/err"; }

game_of "$scratch/tall" "screen = { w = 240, h = 320 }"
game_of "$scratch/wide" "screen = { w = 320, h = 240 }"
game_of "$scratch/panel" "screen = { w = 640, h = 480 }, field = { x = 32, y = 16, w = 384, h = 448 }"
cd "$scratch" || exit 2
play tall 1
play wide 2 --lang ja
play panel 2
finish
