-- fortress.lua - Boss with parts: Four turrets move with the body, each with its own hp, shape and
-- task. The body is invulnerable until all turrets are destroyed.
enemy.def("turret", { sprite = "wisp", hit = { circle = 10 }, hp = 30, score = 500, bank = 1,
                      spark = "glint", blink = 4, run = function(e)
  wait(rng.int(30, 90))
  while true do
    pattern.aimed { from = e, kind = "rice", bank = 1, n = 3, every = 6, speed = 2.2 }
    wait(60)
  end
end })

local function run_body(e)
  e.rate = 0
  for i = 0, forever do
    wait_for(e:move { x = 120 + 50 * angle.sin(45 * i), y = 90, over = 50, ease = "both" })
    local open = #e:parts() == 0
    if open then e.rate = 1 end
    pattern.ring { from = e, kind = "orb", bank = open and 2 or 6, n = open and 24 or 12,
                   dir = 7 * i,
                   speed = 1.4 }
  end
end

enemy.def("fortress", { sprite = "queen", hit = { box = { 52, 56 } }, hp = 300, score = 20000,
  spark = "glint", blink = 4, run = run_body, parts = {
    { kind = "turret", dx = -60, dy = 6, share = 0.3 },
    { kind = "turret", dx = 60, dy = 6, share = 0.3 },
    { kind = "turret", dx = -34, dy = 44, share = 0.3 },
    { kind = "turret", dx = 34, dy = 44, share = 0.3 } } })

local function run() enemy.spawn { kind = "fortress", x = 120, y = 80 } end

return { run = run, ship = "gun", alone = true }
