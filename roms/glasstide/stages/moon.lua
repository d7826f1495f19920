-- stages/moon.lua - below the abyss: the Drowned Moon, who holds the other end of the tide. It
-- appears at the end of a good run, and can be practised.
require "stages/moon/creatures"
require "stages/moon/scene"
require "stages/moon/boss"
local meeting = require "stages/moon/meeting"
local kinds = require "kinds"
local sea = require "sea"

local SHARDS <const> = 300 -- hundredths: the multiplier that wakes it

local moon = {}

local outlived = false -- in this run

on.start(function() outlived = false end)
on.phase(function(_, id, won)
  if id == "eclipse" and won then outlived = true end
end)

-- Does it appear in this run? Not on easy, and only if one craft has enough shards.
function moon.open()
  if board.difficulty() == "easy" then return false end
  local open = false
  player.each(function(p) open = open or p.shards >= SHARDS end)
  return open
end

-- Was the eclipse survived in this run?
function moon.outlived() return outlived end

local function fight()
  sea.speed(0)
  music.stop { fade = 90 }
  wait(90)
  meeting()
  boss.fight("moon")
  music.stop { fade = 140 }
  wait(kinds.COLLAPSE)
end

-- The way down from the queen.
function moon.dive()
  if stage.skipping() then return end
  bg.show("moon", { over = 90 })
  fight()
end

stage.def("moon", function()
  bg.show("moon", { over = 0 })
  stage.mark("moon")
  fight()
end, { music = "abyss" })

return moon
