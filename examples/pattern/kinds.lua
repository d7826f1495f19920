-- kinds.lua - the bullets for your patterns. Hitboxes are smaller than the sprites. `bank` sets the colour: 0 pearl,
-- 1 ruby, 2 amber, 3 gold, 4 green, 5 cyan, 6 indigo, 7 magenta.
spark.def("hoop", { sprite = "hoop", life = 12 })
local shapes = {
  pellet = { circle = 2 }, orb = { circle = 3.5 }, star = { circle = 4 }, ring = { circle = 5 }, pearl = { circle = 6 },
  big = { circle = 8 },
}
for name, hit in pairs(shapes) do
  bullet.def(name, { sprite = name, hit = hit, cloud = "mist", vanish = "hoop" })
end
local long = { -- length and radius
  rice = { 5, 1.5 }, petal = { 4, 2 }, shard = { 4, 1.5 }, drop = { 4, 2 }, kunai = { 4, 2 }, needle = { 8, 1.2 },
}
for name, hit in pairs(long) do
  bullet.def(name, { sprite = name, hit = { capsule = hit }, turns = true, cloud = "mist", vanish = "hoop" })
end

enemy.def("keeper", { sprite = "keeper", hit = { box = { 44, 56 } }, hp = 10000, blink = 8, blink_soft = true })
shot.def("dart", { sprite = "dart", hit = { box = { 6, 14 } }, damage = 1, turns = true, bank = 5 })
player.def("kite", { sprite = "kite", hit = { circle = 2 }, speed = 4, focus = 1.8, lives = 99, run = function(p)
  while true do
    if pad.down("fire", p) then shot.fire { kind = "dart", from = p, dy = -14, speed = 10 } end
    wait(5)
  end
end })
