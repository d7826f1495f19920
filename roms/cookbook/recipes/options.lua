-- options.lua - Options: Options fly with the ship; their number depends on its power. They spread
-- wide, or gather in front of the ship while focus is held. Tables list their positions, and each
-- option fires from its own task.
option.def("bead", { sprite = "bead", run = function(o)
  while true do
    if pad.down("fire", o.by) then shot.fire { kind = "dart", from = o, dy = -8, speed = 9 } end
    wait(6)
  end
end })

player.def("carrier", { sprite = "ship", hit = { circle = 2 },
  registers = { power = { start = 1, max = 3, show = "number" } },
  options = { kind = "bead", by = "power", over = 10, levels = {
    { at = 1, wide = { { 0, -30 } } },
    { at = 2, wide = { { -28, 0 }, { 28, 0 } }, close = { { -9, -22 }, { 9, -22 } } },
    { at = 3, wide = { { -28, 4 }, { 28, 4 }, { -48, 14 }, { 48, 14 } },
              close = { { -7, -24 }, { 7, -24 }, { -16, -14 }, { 16, -14 } } } } } })

local function run(_, p)
  for k = 0, forever do
    p.power = k % 3 + 1
    for i = 1, 4 do enemy.spawn { kind = "wisp", x = 48 * i, y = 40 + 20 * (i % 2) } end
    wait(100)
  end
end

return { run = run, ship = "carrier", alone = true, hud = true }
