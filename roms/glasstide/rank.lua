-- rank.lua - the rank, 0 to 100, a register of the run. It rises over time and with each phase won,
-- and falls with each phase lost, death or bomb. Only waves and the bosses' non-spell phases use
-- it. A DIP switch shows it.
local rank = {}

local START <const>, MOST <const> = 20, 100
local EVERY <const> = 300      -- frames for each rise by one
local FASTER <const> = 0.15    -- most increase of a speed
local SOONER <const> = 0.2     -- most reduction of a pause

game.def { registers = { rank = { start = START, max = MOST, drain = -1, every = EVERY,
                                  show = board.dip("rank") == "shown" and "number" or "none" },
                         minions = { show = "none" } } } -- minions killed in the current phase of a boss

local function rise(by) game.rank = math.max(0, game.rank + by) end

on.death(function() rise(-24) end)
on.bomb(function() rise(-8) end)
on.phase(function(_, _, won, captured) rise(captured and 5 or won and 2 or -4) end)

-- Raises a speed, to at most 1.15 times.
function rank.faster(v) return v * (1 + FASTER * game.rank / MOST) end

-- Shortens a pause; whole frames, at least 1.
function rank.sooner(n) return math.max(1, math.floor(n * (1 - SOONER * game.rank / MOST))) end

return rank
