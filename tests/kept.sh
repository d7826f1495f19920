# shellcheck shell=bash
# kept.sh - scripted.sh, and a game whose runs are kept: points for fire, an end by special, a fault by that with down.
#
#     . "$(dirname "$0")/../kept.sh"
#     kept_game <<'LUA'                # g: its stages and all else
#     { begin; keys 200 $Z; ends; }    # keys: from power-on to a run, 200 frames of fire, a death
. "$(dirname "${BASH_SOURCE[0]}")/scripted.sh"
export TZ=UTC
folder=data/curtain/replays/probe

kept_game() {
    { cat "$scratch/ship.lua" -; echo 'boot.run { stages = { "one" }, players = { "ship" } }'; } | game g
    sed -i "s/screen = { w = 64, h = 64 }/screen = { w = 160, h = 200 }/" g/rom.lua
}
cat >ship.lua <<'LUA'
bullet.def("dot", { sprite = "dot", hit = { circle = 4 } })
player.def("ship", { sprite = "dot", hit = { circle = 2 }, lives = 1, safe = 9, run = function(p)
  while true do
    if pad.down("fire", p) then score.add(10, p) end
    if pad.down("special", p) then bullet.fire { kind = "dot", from = p, speed = 0 } end
    if pad.down("special", p) and pad.down("down", p) then error "the end" end
    wait(1)
  end
end })
LUA
begin() { keys 30; keys 1 $ENTER; keys 30; keys 1 $Z; keys 40; keys 1 $Z; keys 60; keys 1 $Z; keys 10; } # to a run
ends() { keys 2; keys 60 $C; keys 120; }                                                                # by a death
