-- shower.lua - Item shower: Items burst from a wisp, rise in an arc and fall. The ship attracts
-- nearby items; above the collect line, it attracts all of them. The higher the ship is, the more
-- each coin is worth.
item.def("coin", { sprite = "point", bank = 3, radius = 10, gives = { score = { 100, 1000 } } })
item.def("gem",  { sprite = "shard", bank = 5, radius = 9, gives = { score = 50 }, gravity = 0.03,
                   top = 1.4 })
enemy.def("purse", { sprite = "wisp", hit = { box = { 16, 16 } }, hp = 8, spark = "glint",
                     drops = { coin = 3 } })

player.def("collector", { sprite = "ship", hit = { circle = 2 }, magnet = 40, collect_line = 110,
                          pull = 7 })

local function run()
  for k = 0, forever do
    local e = enemy.spawn { kind = "purse", x = 40 + 67 * k % 160, y = 70 + 31 * k % 50 }
    wait(24)
    item.drop { kind = "gem", from = e, n = 13, spread = 240, speed = 2.4 }
    e:kill()
    wait(24)
    if k % 8 == 7 then item.group():pull() end -- all items fly to the ship
  end
end

return { run = run, ship = "collector", alone = true, hud = true }
