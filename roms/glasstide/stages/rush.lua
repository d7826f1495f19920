-- stages/rush.lua - all bosses, one after another, against the clock. Each fight has its boss's
-- own scene.
local clock = require "clock"
local sea = require "sea"

-- In the order of the dive.
local ORDER <const> = {
  { "nautilus", "shallows" }, { "crab", "shallows" },
  { "bellows", "hearth" }, { "eels", "hearth" },
  { "angler", "lightless" }, { "queen", "court" }, { "moon", "moon" },
}

local rush = {}

-- The best time on this difficulty in frames, or nil.
function rush.best() return save.get("rush/" .. board.difficulty()) end

local function keep(frames)
  local best = rush.best()
  if not best or frames < best then save.set("rush/" .. board.difficulty(), frames) end
end

-- Drops a conch for each player, so that each fight starts with a bomb.
local function provide()
  player.each(function(p)
    if p.alive then item.drop { kind = "conch", x = p.x, y = 60 } end
  end)
end

local function fight(who)
  sea.scene(who[2], 0.8, who == ORDER[1] and 0 or 20)
  stage.mark(who[1])
  wait(50)
  boss.fight(who[1])
end

stage.def("rush", function()
  local frames = 0 -- frames in boss fights only
  task.go(function()
    while true do
      if boss.now() then frames = frames + 1 end
      wait(1)
    end
  end)
  local shown <close> = clock.show(function() return boss.now() and frames or nil end)
  for i, who in ipairs(ORDER) do
    local before = frames
    fight(who)
    wait(90)
    if not stage.skipping() then
      hud.banner({ ("%d/%d"):format(i, #ORDER), clock.text(frames - before) }, 120)
      provide()
    end
    wait(120)
  end
  if stage.skipping() then return end
  local best = rush.best()
  keep(frames)
  local slower = best and best < frames and text.lang("BEST %s"):format(clock.text(best))
  hud.banner({ "ALL OF THEM", clock.text(frames), slower or "BEST TIME" }, 240)
  wait(240)
end, { music = "tide" })

return rush
