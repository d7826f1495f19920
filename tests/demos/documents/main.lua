-- main.lua - documents one after another and side by side, at ranks from 0 to 1, turned, mirrored, steered, stopped, and
-- with bullets that a script writes.
bullet.def("orb", { sprite = "dot", hit = { circle = 2.25 } })
bullet.def("rice", { sprite = "dart", hit = { box = { 4, 2 } }, turns = true })
shot.def("bolt", { sprite = "dart", hit = { box = { 3, 5 } }, turns = true })
enemy.def("wisp", { sprite = "dot", hit = { box = { 8, 7 } }, hp = 900 })
player.def("ship", { sprite = "dot", hit = { circle = 1.5 }, speed = 2, focus = 1,
  run = function(p)
    while true do
      if pad.down("fire", p) then shot.fire { kind = "bolt", from = p, speed = 6 } end
      wait(8)
    end
  end })

local fired = 0
local function tell(b, label)
  fired = fired + 1
  b.bank = label and #label % 4 or fired % 3
  if fired % 50 == 0 then b.speed = b.speed * 0.5 end
end

stage.def("all", function()
  for i = 0, forever do
    local rank = i % 5 / 4
    local e = enemy.spawn { kind = "wisp", x = 60 + 40 * (i % 4), y = 50 }
    local all = bullet.ml { name = "all", kind = "orb", kinds = { spark = "rice" }, x = 180, y = 60, rank = rank,
      on_fire = tell, tag = "all", angle = 30 * i, mirror = i % 2 == 1 }
    local orrery = bullet.ml { name = "orrery", kind = "rice", from = e, steer = true, loop = true, speed = 0.8 }
    wait(90)
    bullet.group("all").frozen = 20
    orrery.rank = 1 - rank
    wait(60)
    local lotus = bullet.ml { name = "lotus", kind = "orb", x = 120, y = 70, rank = rank, params = { 2, 1.5 } }
    wait(60)
    bullet.each("all", function(b) if b.y > 150 then b:aim() end end)
    wait(40)
    orrery:stop()
    e:remove()
    bullet.ml { name = "gulls", kind = "rice", x = 120, y = 30, rank = rank }
    wait(120)
    if lotus.alive then lotus.rank = 0 end
    if all.alive then all:stop() end
  end
end)

boot.run { stages = { "all" }, players = { "ship" } }
