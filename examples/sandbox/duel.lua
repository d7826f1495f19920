-- duel.lua - two bosses: a cast with one bar, then with one for each. `curtain play examples/sandbox --stage duel`.
local function rings(e, kind, turn)
  for k = 1, forever do
    pattern.ring { from = e, kind = kind, n = 14, dir = turn * 9 * k, speed = 1.6 }
    wait(40)
  end
end

local function sway(e, x)
  while true do
    e:move { x = x + rng.int(-30, 30), y = rng.int(50, 90), over = 50, ease = "both" }
    wait(70)
  end
end

-- One bar for each: a boss whose bar is empty stops, and the other fights on alone.
local function needles(e)
  while true do
    pattern.fan { from = e, kind = "rice", n = 7, spread = 80, dir = 90, speed = 2.2 }
    wait(26)
  end
end

boss.def("sisters", {
  title = "Iris and Opal", portrait = "queen", warning = 150,
  cast = { { name = "iris", title = "Iris", kind = "jelly", x = 70, y = 70 },
           { name = "opal", title = "Opal", kind = "jelly", x = 170, y = 70 } },
  phases = {
    { talk = function() wait(30) end },
    { id = "both", hp = 400, time = 25 * 60, bonus = 8000, run = function(iris, opal)
      task.go(sway, iris, 70)
      task.go(sway, opal, 170)
      task.go(rings, iris, "orb", 1)
      rings(opal, "star", -1)
    end },
    { id = "mirror", spell = "Mirror Sign: Two Rivers", hp = { iris = 260, opal = 320 }, time = 40 * 60,
      safe = 40, bonus = 30000, bonus_to = 10000,
      run = { iris = needles, opal = function(e) rings(e, "star", 1) end } },
    { id = "dusk", spell = "Last Sign: The Longest Dusk", last = true, survive = true, time = 20 * 60, bonus = 60000,
      run = function(iris, opal)
        task.go(rings, iris, "orb", 1)
        task.go(rings, opal, "star", -1)
        while true do
          pattern.line { x = 120, y = -8, kind = "rice", n = 9, width = 220, dir = 90, speed = rng.number(1, 2) }
          wait(30)
        end
      end },
    { talk = function() wait(60) end } } })

stage.def("duel", function()
  wait(30)
  boss.fight("sisters")
  wait(60)
end)
