-- stages/three/pace.lua - numbers for each difficulty as by.lua has them, which the rank presses:
-- speeds, and pauses of frames. For waves, and for what bosses do before their signs.
local by = require "stages/three/by"
local rank = require "rank"
local pace = {}

function pace.fast(easy, normal, hard, abyss) return rank.faster(by(easy, normal, hard, abyss)) end

function pace.soon(easy, normal, hard, abyss) return rank.sooner(by(easy, normal, hard, abyss)) end

return pace
