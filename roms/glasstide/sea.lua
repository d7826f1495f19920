-- sea.lua - how the sea behind all flows: as fast as a stage asks for, and for as long as the board
-- lives, under the title too. What it looks like is said by each stage's scene.
local sea = {}

local now, wanted = 0.6, 0.6 -- px a frame that the floor moves
local still = false
local parts = {}             -- of what flows: { layer or plane, its part of that }

palette.cycle { first = 13 * 16 + 13, last = 13 * 16 + 15, every = 14 } -- what glimmers in bank 13


-- What flows from now on, as a background's task says it: a list of { layer or plane, its part }.
function sea.flow(list) parts = list end

-- The flow reaches this speed gently.
function sea.speed(v) wanted = v end

-- A background comes, within so many frames or as bg.show has it, and flows so fast.
function sea.scene(name, v, over)
  bg.show(name, over and { over = over })
  sea.speed(v)
end

-- local still <close> = sea.still(): it stands until that block ends, however it ends.
function sea.still()
  still = true
  return setmetatable({}, { __close = function() still = false end })
end

function sea.run()
  wait(1) -- what is practised shows its own scene first
  while true do
    if not (bg.layer(1).map or bg.plane().map) then bg.show("shallows", { over = 0 }) end -- all was emptied
    now = now + (wanted - now) * 0.02
    for _, f in ipairs(parts) do f[1].vy = still and 0 or now * f[2] end
    wait(1)
  end
end

return sea
