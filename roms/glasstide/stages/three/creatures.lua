-- stages/three/creatures.lua - who lives in the abyss.
local kinds = require "kinds"

kinds.creature("queen",    kinds.COLD, 52, 56, 100, 90000, kinds.collapse, { pearl = 15 })
