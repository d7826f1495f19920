-- two.lua - the works: every phase of both bosses and the stage itself use only the colours reserved for
-- bullets.
local phases = require "helpers/phases"

local BANKS <const> = "0567"

phases.watch { banks = BANKS, first = 240, looks = 6, apart = 70,
               bosses = { { "bellows", "breath", "draught", "wheels" },
                          { "eels", "both", "furnace", "panes", "crossing", "press" } } }

-- The complete stage on abyss, with fire held.
local run = test.run { stage = "two", difficulty = "abyss", seed = 1, invincible = true, pads = "fire" }
while run.frame < 24000 and not run:moment("clear", "two") do
  run:step(120)
  phases.colours(run, BANKS, "the stage, frame " .. run.frame)
end
test.expect(run:moment("phase", "breath"), "the Bellows appears")
test.expect(run:moment("phase", "press"), "the eels appear")
test.equal(run:refused("bullets") + run:refused("enemies"), 0, "no pool is full")

-- With one eel down, the fight continues; with both down, it ends.
local duel = test.run { stage = "eels/both", seed = 1, invincible = true, frames = 200 }
duel:exec "enemy.each(nil, function(e) if e.kind == 'cinder' then e:hurt(4000) end end)"
duel:step(5)
test.equal(duel:moment("won"), nil, "the other eel fights on")
duel:exec "enemy.each(nil, function(e) if e.kind == 'quench' then e:hurt(4000) end end)"
duel:step(5)
test.expect(duel:moment("won", "both"), "the phase is beaten")

-- Shots break a pane into shards.
local cast = test.run { stage = "eels/panes", seed = 1, invincible = true, frames = 260 }
local panes = cast:eval "bullet.group('pane').count"
test.expect(panes > 3, "panes hang in a row")
cast:exec "bullet.each('pane', function(b) b.hp = 1 end)"
cast:press("fire")
cast:step(90)
test.expect(cast:eval "query.box { what = 'bullet', x = 120, y = 160, w = 240, h = 320 }[1] ~= nil", "shards fly")
