bullet.def("orb", { sprite = "orb", hit = { circle = 3.5 } })
shot.def("dart", { sprite = "dart", hit = { box = { 6, 12 } }, damage = 2, turns = true })
player.def("ship", { sprite = "ship", hit = { circle = 2 }, run = function(p)
  while true do
    if pad.down("fire", p) then shot.fire { kind = "dart", from = p, dy = -12, speed = 9 } end
    wait(5)
  end
end })
enemy.def("jelly", { sprite = "jelly", hit = { box = { 28, 26 } }, hp = 40, score = 1000, run = function(e)
  wait(30)
  pattern.spiral { from = e, kind = "orb", bank = 5, n = forever, arms = 3, step = 13, every = 9, speed = 1.6 }
end })
local dive = path.def { { x = 60, y = -24 }, { x = 90, y = 90, over = 60 }, { wait = 150 }, { x = 290, y = 60, over = 90 } }
stage.def("one", function()
  for i = 1, 8 do
    stage.wave { kind = "jelly", n = 2, every = 60, path = dive, mirror = i % 2 == 0, dx = 20 }
    wait(240)
  end
  stage.clear()
end)
boot.run { stages = { "one" }, players = { "ship" } }
