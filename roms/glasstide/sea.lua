-- sea.lua - the sea behind all: the shallows, a floor of sand with light on it between two reefs,
-- and the abyss, plates of stone that lead to where no light comes from. It flows as fast as a
-- stage asks for, and lives as long as the board does, under the title too.
local sea = {}

local now, wanted = 0.6, 0.6 -- px a frame that the floor moves
local still = false
local parts = {}             -- of what flows: { layer or plane, its part of that }

palette.cycle { first = 13 * 16 + 13, last = 13 * 16 + 15, every = 14 } -- what glimmers in bank 13

bg.def("shallows", function()
  bg.layer(1).map = "floor"
  bg.layer(2).map = "caustics"
  bg.layer(3).map, bg.layer(3).x = "reef", -14
  bg.lines(2, { wave = 6, every = 160, speed = 0.4 })
  parts = { { bg.layer(1), 1 }, { bg.layer(2), 1.2 }, { bg.layer(3), 1.75 } }
end)

bg.def("abyss", function()
  local glow, floor = bg.layer(1), bg.plane()
  glow.map, glow.blend = "caustics", "ghost"
  floor.map, floor.horizon, floor.height, floor.dir = "seabed", 70, 60, 270
  floor.fog = { to = 0x060a14, far = 700 }
  bg.lines(1, { wave = 9, every = 50, speed = 0.3 })
  parts = { { glow, 0.3 }, { floor, -2 } }
end)

-- The flow reaches this speed gently.
function sea.speed(v) wanted = v end

-- local still <close> = sea.still(): it stands until that block ends, however it ends.
function sea.still()
  still = true
  return setmetatable({}, { __close = function() still = false end })
end

function sea.run()
  while true do
    if not (bg.layer(1).map or bg.plane().map) then bg.show("shallows", { over = 0 }) end -- all was emptied
    now = now + (wanted - now) * 0.02
    for _, f in ipairs(parts) do f[1].vy = still and 0 or now * f[2] end
    wait(1)
  end
end

return sea
