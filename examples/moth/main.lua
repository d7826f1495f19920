-- main.lua - Lamplight: moths from an Aseprite file. A slice in that file is their hitbox.
bullet.def("orb", { sprite = "orb", hit = { circle = 3.5 } })
shot.def("dart", { sprite = "dart", hit = { box = { 6, 12 } }, damage = 2, turns = true })
player.def("ship", { sprite = "ship", hit = { circle = 2 }, run = function(p)
  while true do
    if pad.down("fire", p) then shot.fire { kind = "dart", from = p, dy = -12, speed = 9 } end
    wait(5)
  end
end })
enemy.def("moth", { sprite = "moth", hit = { sprite = "moth" }, hp = 12, score = 300,
  pictures = { hurt = "moth_hurt" }, run = function(e)
  for i = 1, 3 do
    wait(45)
    pattern.ring { from = e, kind = "orb", bank = 7, n = 10, dir = 18 * i, speed = 1.2 }
  end
end })
enemy.def("queen", { sprite = "moth_200", hit = { sprite = "moth_200" }, hp = 160, score = 5000, run = function(e)
  wait(60)
  pattern.spiral { from = e, kind = "orb", bank = 2, n = forever, arms = 5, step = 9, every = 7, speed = 1.4 }
end })
local flit = path.def { { x = 40, y = -20 }, { x = 90, y = 110, over = 70 }, { wait = 120 },
                        { x = 60, y = -30, over = 80 } }
local come = path.def { { x = 120, y = -40 }, { x = 120, y = 80, over = 90 }, { wait = 600 } }
stage.def("one", function()
  for i = 1, 4 do
    stage.wave { kind = "moth", n = 3, every = 40, path = flit, mirror = i % 2 == 0, dx = 24 }
    wait(200)
  end
  stage.wave { kind = "queen", n = 1, every = 1, path = come }
  wait(700)
  stage.clear()
end)
boot.run { stages = { "one" }, players = { "ship" } }
