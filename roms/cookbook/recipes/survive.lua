-- survive.lua - Survival phase: The boss is invulnerable, and the player must outlast the clock;
-- rings come faster as time runs out. Four fields of boss.def set up the phase: `survive`, `time`,
-- `bonus`, `spell`.
local function rings(e)
  for k = 0, forever do
    pattern.ring { from = e, kind = "petal", bank = 1 + k % 2 * 5, n = 24, dir = 7.5 * k * k,
                   speed = 1.6 }
    wait(math.max(8, 40 - k))
  end
end

boss.def("keeper", { title = "Keeper of the Hill", kind = "queen", x = 120, y = 104, phases = {
  { id = "outlive", spell = "Last Sign: Outlive It", survive = true, time = 12 * 60, bonus = 30000,
    run = rings } } })

return { run = function() boss.fight("keeper") end, alone = true, hud = true }
