-- main.lua - Glass Tide: three small craft dive through a tide of glass creatures.
require "kinds"
require "players/heron"
require "players/petrel"
require "players/tern"
require "players/pilots"
require "stages/one"
require "stages/two"
require "stages/three"
require "stages/rush"
require "stages/caravan"
require "stages/lesson"
require "unlocks"
require "missions"
require "scores"
local moon = require "stages/moon"
local sea = require "sea"
local craft = require "players/craft"
local front = require "fx/front"
local grades = require "fx/grades"

hud.banks.plain, hud.banks.bright, hud.banks.faint, hud.banks.alarm = 0, 3, 9, 1
hud.low = hud.large and 4 or 3 -- rows left free for the bombs

-- The handlers see the craft where it was hit, before it respawns. A wave spreads from there and
-- clears the bullets.
on.death(function(p)
  fx.explode { from = p, size = "lost" }
  bullet.sweep { x = p.x, y = p.y, radius_to = 400, over = 30 }
  craft.refill(p)
end)

on.extend(function(p) spark.burst { kind = "glint", from = p, n = 24, speed = 3 } end)
on.phase(function(e, _, won)
  if e.alive then spark.burst { kind = "shock", from = e, speed = 0 } end
  if won then sound.play("phase", { from = e }) end
end)
on.stage(function(_, state)
  sea.speed(state == "start" and 1.6 or 0.6)
  if state == "start" then sound.play("ready") end
end)
on.game_over(function() sea.speed(0.4) end)

-- Plays a sound when a boss appears.
task.go(function()
  local was
  while true do
    local now = boss.now()
    if now and not was then sound.play("entrance") end
    was = now
    wait(4)
  end
end)

-- The music of each screen, and the list for the music room.
local pieces = require "pieces"
for screen, name in pairs { title = "title", opening = "opening", results = "clear",
                            clear = "clear", over = "over", ending = "ending", staff = "staff",
                            name = "scores", scores = "scores" } do
  pieces[screen] = name
end

task.go(sea.run)
task.go(front.run)
boot.run { modes = {
    { name = "dive", stages = { "one", "two", "three" }, text = "Dive from the shallows to the sea floor." },
    { name = "caravan", stages = { "caravan" }, text = "Score all you can in two minutes." },
    { name = "rush", stages = { "rush" }, needs = "rush", text = "Beat every boss against the clock." } },
  opening = require "opening",
  players = { "heron", "petrel", "tern" }, continues = 3, demo = "attract",
  difficulties = { easy = "Calm water.", normal = "The tide as it comes.",
                   hard = "Every wave is higher.",
                   abyss = "Nobody came back." },
  ships = require "players/forms",
  music = pieces, how_to_play = require "fx/how_to_play", grades = grades, ending = require "ending",
  staff = { { "Glass Tide" }, { "Story, Pictures, Patterns", "The Curtain authors" },
            { "Runs On", "Curtain" }, { "Thank You for Playing" },
            { "The Water Still Leans", "If you dive on Normal", "or harder and arrive",
              "with RATE at x3,", "look down once more.",
              when = function() return not moon.outlived() end } } }
