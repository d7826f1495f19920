-- bosses/keeper.lua - the boss: two phases, the second a spell card.
enemy.def("keeper", { sprite = "keeper", hit = { box = { 44, 56 } }, score = 50000, spark = "glint",
  blink = 8, blink_soft = true,
  on_hit = fx.hit, on_death = function(e) fx.collapse { from = e, sprite = "keeper", radius = 40 } end })

-- Like lanterns in the wind: they slow down, hang there, and fly on.
motion.def { name = "hang", { speed = 0.25, over = 50 }, { wait = 40 }, { speed = 2.2, over = 60 } }

boss.def("keeper", { title = "Keeper of the Lanterns", kind = "keeper", x = 120, y = 112, music = "keeper",
  warning = 120, phases = {
    { id = "wings", hp = 420, time = 30 * 60, safe = 30, run = function(e)
      e:wander { w = 70, h = 16, every = 150, over = 70 }
      for i = 1, forever do
        for side = -1, 1, 2 do -- from the eyes on both wings
          pattern.fan { from = e, dx = 34 * side, dy = -24, kind = "petal", bank = side < 0 and 7 or 3, speed = 1.8,
                        n = by_difficulty { easy = 5, normal = 8, hard = 11 }, spread = 120,
                        dir = 90 + 24 * side * angle.sin(21 * i) }
        end
        if i % 3 == 0 then
          pattern.aimed { from = e, kind = "kunai", bank = 1, n = 3, every = 5, speed = 3, lock = true }
        end
        wait(by_difficulty { easy = 46, normal = 34, hard = 26 })
      end
    end },
    { id = "feast", spell = "Thousand Lantern Feast", bg = "feast", hp = 520, time = 40 * 60, bonus = 50000,
      rest = 90, run = function(e)
      wait_for(e:move { x = 120, y = 112, over = 60, ease = "both" })
      local n = by_difficulty { easy = 10, normal = 16, hard = 22 }
      task.go(function() -- lights that hang in the air, then fly on
        for i = 1, forever do
          pattern.ring { from = e, kind = "pearl", bank = 2, n = n, dir = 11 * i, speed = 2.6, motion = "hang" }
          sound.play("spell", { volume = 0.5 })
          wait(110)
        end
      end)
      for i = 1, forever do -- two wheels in opposite directions
        pattern.ring { from = e, kind = "star", bank = 3, n = 4, dir = 7 * i, speed = 1.7 }
        pattern.ring { from = e, kind = "rice", bank = 1, n = 3, dir = -9 * i, speed = 2 }
        wait(by_difficulty { easy = 12, normal = 8, hard = 6 })
      end
    end } } })
