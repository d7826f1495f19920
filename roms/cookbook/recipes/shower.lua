-- shower.lua - A shower of items: a wisp that dies throws its drops up in an arc; near the ship they fly to it, and above
-- the collect line all of them come. Points are worth more the higher the ship is.
item.def("coin", { sprite = "point", bank = 3, radius = 10, gives = { score = { 100, 1000 } } })
item.def("gem",  { sprite = "shard", bank = 5, radius = 9, gives = { score = 50 }, gravity = 0.03, top = 1.4 })

player.def("collector", { sprite = "ship", hit = { circle = 2 }, magnet = 40, collect_line = 110, pull = 7 })

local function run()
  for k = 0, forever do
    local e = enemy.spawn { kind = "wisp", x = 40 + 67 * k % 160, y = 60 + 31 * k % 50, drops = { coin = 7, gem = 9 } }
    wait(20)
    e:kill()
    item.drop { kind = "gem", x = e.x or 120, y = 60, n = 5, spread = 160, speed = 2.4 }
    wait(26)
    if k % 8 == 7 then item.group():pull() end -- all come at once
  end
end

return { run = run, ship = "collector", alone = true, hud = true }
