-- ship.lua - the kite: its shots, its bomb, and its death.
shot.def("dart", { sprite = "dart", hit = { box = { 6, 14 } }, damage = 1, turns = true, bank = 5 })
shot.def("side", { sprite = "side", hit = { box = { 6, 12 } }, damage = 1, turns = true, bank = 4 })

bomb.def("feast", { over = 80, safe = 150, run = function(p)
  screen.flash { to = 0xffd080, over = 20, share = 0.5 }
  screen.shake { size = 3, over = 30 }
  bullet.sweep { follow = p, radius = 10, radius_to = 300, over = 60, hurt = 30, by = p, spark = "glint" }
  for _ = 1, 8 do
    spark.burst { kind = "shock", from = p, speed = 0 }
    spark.burst { kind = "crumb", from = p, n = 16, radius = 16, speed = 4 }
    wait(8)
  end
end })

player.def("kite", { sprite = "kite", hit = { circle = 2 }, graze = 18, speed = 4, focus = 1.8, lives = 3,
  pictures = { left = "kite_left", right = "kite_right" }, -- it banks
  bomb = "feast", deathbomb = 8, registers = { bombs = { start = 3, max = 6, show = "icons" } },
  run = function(p)
    local ring = sprite.put { sprite = "halo", follow = p, layer = "middle", bank = 2 } -- shown while focused
    while true do
      ring.hidden = not p.focus
      if pad.down("fire", p) and board.frame() % 4 == 0 then
        for side = -1, 1, 2 do
          shot.fire { kind = "dart", from = p, dx = 5 * side, dy = -14, speed = 10 }
          spark.burst { kind = "muzzle", from = p, dx = 5 * side, dy = -18, speed = 0 }
          local wide = p.focus and 2 or 12
          shot.fire { kind = "side", from = p, dx = 11 * side, dy = -4, dir = 270 + wide * side, speed = 9 }
        end
      end
      wait(1)
    end
  end })

on.graze(function(p, b) score.add(50, p) spark.burst { kind = "glint", from = b } end)
on.death(function(p)
  fx.explode { from = p, size = "large" }
  bullet.clear { spark = "hoop" }
  p.bombs = 3
end)
