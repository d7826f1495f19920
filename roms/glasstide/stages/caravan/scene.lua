-- stages/caravan/scene.lua - the sea road at dusk: sand that rushes by below, light on it, reefs
-- on both sides.
local FIRST <const>, LAST <const> = 0x140c1c, 0x4c3c58 -- of the scenery's colour ramp

local GLIMMER <const> = { 0x40284c, 0x5c3c68, 0x8c6890 }

local function mixed(i)
  local rgb = 0
  for shift = 0, 16, 8 do
    local a, b = FIRST >> shift & 255, LAST >> shift & 255
    rgb = rgb | (a + (b - a) * i // 12) << shift
  end
  return rgb
end

bg.def("caravan", function()
  palette.load("one")
  for i = 1, 12 do palette.set(13 * 16 + i, mixed(i)) end
  for i, rgb in ipairs(GLIMMER) do palette.set(13 * 16 + 12 + i, rgb) end
  local sand, light, left = bg.plane(), bg.layer(2), bg.layer(3)
  sand.map, sand.horizon, sand.height, sand.dir, sand.vy = "floor", 24, 44, 270, -4
  sand.x = 120 -- keeps the seam of the sand at the sides
  sand.fog = { to = 0x060a14, far = 520 }
  light.map, light.blend, light.vy = "caustics", "ghost", 2.4
  left.map, left.x, left.vy = "reef", -22, 6
  bg.lines(2, { wave = 8, every = 70, speed = 1 })
end)
