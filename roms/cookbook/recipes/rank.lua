-- rank.lua - Rank: A register of the ship rises with grazing and survival and falls with each hit.
-- The pattern derives its bullet count and speed from the register, so the game adapts to the
-- player's skill.
player.def("ranked", { sprite = "ship", hit = { circle = 2 }, graze = 24,
                       registers = { rank = { start = 20, max = 100, show = "bar" } } })

on.graze(function(p) if p.kind == "ranked" then p.rank = p.rank + 1 end end)
on.hit(function(p) if p.kind == "ranked" then p.rank, p.safe = p.rank // 2, 60 end end)

local function run(e, p)
  for k = 0, forever do
    local hot = p.rank / 100
    pattern.fan { from = e, kind = "orb", bank = hot > 0.5 and 1 or 6, n = 5 + p.rank // 12,
                  spread = 150, aim = true, speed = 1.4 + hot }
    if k % 4 == 0 then p.rank = p.rank + 4 end
    wait(34 - p.rank // 6)
  end
end

return { run = run, ship = "ranked", hud = true }
