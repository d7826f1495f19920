-- entrance.lua - Entrance: A warning band announces the boss, who is invulnerable for a second,
-- then armoured for three. The boss's portrait crosses the field with the spell's name. boss.def
-- sets up the whole entrance.
local function bloom(e)
  for k = 0, forever do
    pattern.rose { from = e, kind = "petal", bank = 7 - k % 2 * 6, n = 48, petals = 6, dir = 15 * k,
                   speed = 2, speed_to = 1.2 }
    wait(50)
  end
end

boss.def("rose", { title = "The Rose Queen", kind = "queen", x = 120, y = 100,
                   portrait = "queen_200",
  warning = 150, phases = {
  { id = "bloom", spell = "Rose Sign: Six Petals", hp = 600, time = 20 * 60, bonus = 20000,
    safe = 60, armour = 180, cut_in = true, run = bloom } } })

return { run = function() boss.fight("rose") end, ship = "gun", alone = true, hud = true }
