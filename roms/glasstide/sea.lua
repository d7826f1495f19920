-- sea.lua - the scrolling of the sea in the background, at the speed that the stage sets. It never
-- stops, not even under the title. Each stage's scene defines its look.
local sea = {}

local now, wanted = 0.6, 0.6 -- px per frame: the floor's speed
local still = false
local parts = {}             -- what scrolls: { layer or plane, its share of that speed }

palette.cycle { first = 13 * 16 + 13, last = 13 * 16 + 15, every = 14 } -- the glimmering colours in bank 13


-- Called by a background's task: sets what scrolls, a list of { layer or plane, its share }.
function sea.flow(list) parts = list end

-- The scrolling approaches this speed gradually.
function sea.speed(v) wanted = v end

-- Shows a background, with `over` as for bg.show, and sets the speed.
function sea.scene(name, v, over)
  bg.show(name, over and { over = over })
  sea.speed(v)
end

-- local still <close> = sea.still() stops the sea until the block ends, however it ends.
function sea.still()
  still = true
  return setmetatable({}, { __close = function() still = false end })
end

function sea.run()
  wait(1) -- practice shows its own scene first
  while true do
    if not (bg.layer(1).map or bg.plane().map) then bg.show("shallows", { over = 0 }) end -- the field was wiped
    now = now + (wanted - now) * 0.02
    for _, f in ipairs(parts) do f[1].vy = still and 0 or now * f[2] end
    wait(1)
  end
end

return sea
