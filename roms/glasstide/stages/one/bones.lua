-- stages/one/bones.lua - the bones of a whale: its ribs stop bullets, whoever hides behind them, and flowers of glass
-- open on its spine.
local habits = require "stages/one/habits"
local scene = require "stages/one/scene"
local bones = {}

-- Six ribs on each side: x from the spine, y from the snout.
local RIBS <const> = {}
for i = 0, 5 do
  for side = -1, 1, 2 do RIBS[#RIBS + 1] = { 67 * side, 448 - 50 * i } end
end

-- Each flower and its habit, from the tail to the eyes.
local FLOWERS <const> = {
  { 0, 560, "bloom" }, { 0, 494, "bloom" }, { 0, 388, "pollen" }, { 0, 288, "bloom" }, { 0, 194, "pollen" },
  { -33, 130, "gaze" }, { 33, 130, "gaze" },
}

function bones.grow(spine, middle)
  scene.settle(spine, middle, RIBS, "rib", function(e, at) e.flip_x = at[1] < 0 end)
  scene.settle(spine, middle, FLOWERS, "flower", function(e, at)
    wait(18)
    for _, name in ipairs { "ajar", "open" } do
      e.picture = name
      wait(9)
    end
    habits[at[3]](e)
  end)
end

return bones
