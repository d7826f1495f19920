-- rank.lua - how hard the sea presses: 0 to 100, a register of the run. It rises while all goes
-- well, and falls with a craft or a bomb. Only the waves of stages and what bosses do before their
-- signs ask for it.
local rank = {}

local START <const>, MOST <const> = 20, 100
local EVERY <const> = 300      -- frames in which it rises by one
local FASTER <const> = 0.15    -- of a speed, at most
local SOONER <const> = 0.2     -- of a pause, at most

game.def { registers = { rank = { start = START, max = MOST, drain = -1, every = EVERY },
                         minions = { show = "none" } } } -- those killed in the boss's phase that goes on

local function rise(by) game.rank = math.max(0, game.rank + by) end

on.death(function() rise(-24) end)
on.bomb(function() rise(-8) end)
on.phase(function(_, _, won, captured) rise(captured and 5 or won and 2 or -4) end)

-- A speed, at most 1.15 times as high.
function rank.faster(v) return v * (1 + FASTER * game.rank / MOST) end

-- A pause of whole frames, at least 1.
function rank.sooner(n) return math.max(1, math.floor(n * (1 - SOONER * game.rank / MOST))) end

return rank
