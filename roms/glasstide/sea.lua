-- sea.lua - the scrolling sea: floor, the light on it, the reef at both sides. It runs for as long
-- as the board does, under the title too, and puts its sprites again whenever the field was wiped.
local sea = {}

local TALL = 320
local now, wanted = 0.6, 0.6 -- px a frame the floor moves
local still = false

-- Sprite, x, its speed against the floor's. In the order they are drawn.
local SHEETS = {
  { sprite = "floor", x = 0, rate = 1 },
  { sprite = "caustics", x = 0, rate = 1.2 },
  { sprite = "reef", x = 22,  rate = 1.75 },
  { sprite = "reef", x = 218, rate = 1.75, flip = true, lead = 190 },
}

local function lay()
  local put = {}
  for i, s in ipairs(SHEETS) do
    local pair = {}
    for k = 1, 2 do
      pair[k] = sprite.put { sprite = s.sprite, x = s.x, y = -TALL, layer = "back" }
      if s.flip then pair[k].flip_x = true end
    end
    put[i] = pair
  end
  palette.cycle { first = 13 * 16 + 13, last = 13 * 16 + 15, every = 14 } -- the reef's buds glimmer
  return put
end

local function place(put, depth)
  for i, s in ipairs(SHEETS) do
    local y = (depth * s.rate + (s.lead or 0)) % TALL
    local sway = s.sprite == "caustics" and 6 * angle.sin(depth * 0.9) or 0
    for k, h in ipairs(put[i]) do
      h.y = y - (k - 1) * TALL
      h.x = s.x + sway
    end
  end
end

-- The floor reaches this speed gently.
function sea.speed(v) wanted = v end

-- local still <close> = sea.still(): it stands until that block ends, however it ends.
function sea.still()
  still = true
  return setmetatable({}, { __close = function() still = false end })
end

function sea.run()
  local put, depth = lay(), 0
  while true do
    if not put[1][1].alive then put = lay() end
    if not still then
      now = now + (wanted - now) * 0.02
      depth = depth + now
    end
    place(put, depth)
    wait(1)
  end
end

return sea
