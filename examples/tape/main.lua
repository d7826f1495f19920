-- main.lua - patterns that follow recorded music: a ring on each beat, a spiral from marker "turn" to the loop's end.
bullet.def("orb", { sprite = "orb", hit = { circle = 3.5 } })
shot.def("dart", { sprite = "dart", hit = { box = { 6, 12 } }, damage = 2, turns = true })
player.def("ship", { sprite = "ship", hit = { circle = 2 }, run = function(p)
  while true do
    if pad.down("fire", p) then shot.fire { kind = "dart", from = p, dy = -12, speed = 9 } end
    wait(5)
  end
end })

local function on_beats(e)
  while true do
    local beat = music.wait()
    pattern.ring { from = e, kind = "orb", bank = 5, n = beat % 4 == 0 and 18 or 9, speed = beat % 4 == 0 and 2 or 1.4 }
  end
end

local function on_turns(e)
  while true do
    music.wait("turn")
    pattern.spiral { from = e, kind = "orb", bank = 3, n = 32, arms = 2, step = 17, every = music.frames(8) // 32, speed = 1.8 }
  end
end

enemy.def("jelly", { sprite = "jelly", hit = { box = { 28, 26 } }, hp = 120, score = 1000, run = function(e)
  e:move { x = e.x, y = 70, over = music.frames(2) }
  task.go(on_turns, e)
  on_beats(e)
end })

stage.def("one", function()
  music.play("reel")
  for i = 1, 6 do
    enemy.spawn { kind = "jelly", x = i % 2 == 0 and 160 or 80, y = -24 }
    stage.clear()
    music.wait(2)
  end
  music.stop { fade = 60 }
end)
boot.run { stages = { "one" }, players = { "ship" } }
