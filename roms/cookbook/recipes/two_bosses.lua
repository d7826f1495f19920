-- two_bosses.lua - Duel with two: Two bosses fight side by side, each with her own bar. Iris throws
-- nets, and Opal fires needles through them. A boss whose bar is empty stops; the phase ends when
-- both bars are empty.
local function nets(e)
  for k = 0, forever do
    pattern.ring { from = e, kind = "orb", bank = 7, n = 22, dir = 8 * k, speed = 1.3 }
    wait(44)
  end
end

local function needles(e)
  while true do
    pattern.fan { from = e, kind = "rice", bank = 5, n = 5, spread = 44, aim = true, speed = 2.4 }
    wait(30)
  end
end

boss.def("sisters", { title = "Iris and Opal", cast = {
  { name = "iris", title = "Iris", kind = "queen", x = 64, y = 104 },
  { name = "opal", title = "Opal", kind = "queen", x = 176, y = 104 } }, phases = {
  { id = "duel", spell = "Twin Sign: Net and Needle", time = 30 * 60, bonus = 50000,
    hp = { iris = 260, opal = 200 }, run = { iris = nets, opal = needles } } } })

return { run = function() boss.fight("sisters") end, ship = "gun", alone = true, hud = true }
