-- stages/three/pace.lua - values per difficulty, as in by.lua, adjusted by the rank: speeds, and
-- pauses in frames. For waves and for the bosses' non-spell phases.
local by = require "stages/three/by"
local rank = require "rank"
local pace = {}

function pace.fast(easy, normal, hard, abyss) return rank.faster(by(easy, normal, hard, abyss)) end

function pace.soon(easy, normal, hard, abyss) return rank.sooner(by(easy, normal, hard, abyss)) end

return pace
