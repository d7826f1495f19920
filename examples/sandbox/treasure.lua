-- treasure.lua - a demo stage for items: drops from enemies, items from cleared bullets, and how a ship attracts them.
item.def("plum",  { sprite = "power", bank = 1, radius = 10, gives = { score = 10, power = 1 }, full = "power" })
item.def("pearl", { sprite = "point", bank = 4, radius = 10, gives = { score = { 100, 1000 } } })
item.def("heart", { sprite = "life", bank = 6, radius = 10, gives = { lives = 1 }, gravity = 0.01, top = 0.8 })
item.def("flake", { sprite = "shard", bank = 3, radius = 8, gives = { score = 10 }, gravity = 0.02, top = 1 })

enemy.def("purse", { sprite = "wisp", hit = { box = { 16, 16 } }, hp = 8, spark = "glint", drops = { plum = 2, pearl = 3 } })

stage.def("treasure", function()
  local e = enemy.spawn { kind = "jelly", x = 120, y = 60 }
  for i = 1, forever do
    pattern.ring { from = e, kind = "orb", bank = 5, n = 20, dir = 7 * i, speed = 1.2 }
    wait(20)
    enemy.spawn { kind = "purse", x = 30 + i * 67 % 180, y = 100, drops = i % 8 == 7 and { heart = 1 } or nil }:kill()
    wait(20)
    if i % 6 == 0 then
      bullet.clear { items = "flake" }
      wait(30)
      item.group():pull()
    end
  end
end)
