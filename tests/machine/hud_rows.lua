-- hud_rows.lua - every row of the HUD at its longest: registers, a banner, a boss with all pips and a spell, then a
-- cast. test_hud.c runs it, after a line that sets string.many, the number of players.
local sys, many = string.sys, string.many

game.def { registers = { tide = { start = 100, max = 100, show = "number" } } }
player.def("craft", { sprite = "dot", hit = { circle = 2 }, lives = 7, registers = {
  bombs = { start = 6, max = 9, show = "icons" }, power = { start = 128, max = 128, show = "number" },
  gauge = { start = 9, max = 9, show = "bar", at = "low", label = "GLASS" },
  chain = { start = 9999, max = 9999, show = "times", at = "low", label = "CHAIN" } } })
enemy.def("e", { sprite = "dot", hit = { circle = 2 } })

local function phase(id, args)
  args.id, args.time, args.rest, args.run = id, 600, 0, function() end
  return args
end
local phases = { phase("spell", { hp = 100, spell = "Light Sign: Waltz of a Lamp", bonus = 9999999 }) }
for i = 2, 7 do phases[i] = phase("wait" .. i, { hp = 100 }) end
boss.def("queen", { title = "Queen of the Glass Tide, Sunken", kind = "e", x = 99, y = 99, phases = phases })
boss.def("two", {
  title = "Two", cast = { { name = "a", title = "Cinder the Elder", kind = "e", x = 9, y = 99 },
                          { name = "b", title = "Quench the Younger", kind = "e", x = 99, y = 99 } },
  phases = { phase("both", { hp = { a = 100, b = 50 }, spell = "Twin Sign: Hammer and Quenching Water", bonus = 99 }),
             phase("wait", { hp = { a = 9, b = 9 } }) } })

for i = 1, many do
  sys.join(i, "craft")
  score.add(999999999, i)
end
sys.start(sys.scope())
hud.start(sys.scope(), many)
for _ = 1, 34 do sys.history("queen", "spell", 1) end
for _ = 1, 12 do sys.history("queen", "spell", 2) end
task.go(function()
  for i = 1, many do player.get(i).lives = 7 end
  hud.banner({ "A BANNER", "of two lines" }, 40)
  wait(60)
  local fight = task.go(boss.fight, "queen")
  wait(240)
  task.stop(fight)
  wait(2)
  boss.fight("two")
end)
