-- cancel.lua - Bullets into items: When time is up, every bullet turns into a star, and the stars
-- fly to the player. A call to bullet.clear with `items` turns the bullets into stars; each star
-- adds to the score.
item.def("credit", { sprite = "shard", bank = 3, radius = 10, gives = { score = 10 },
                     gravity = 0.02, top = 1 })

local function run(e)
  while true do
    pattern.spiral { from = e, kind = "orb", bank = 1, n = 50, arms = 4, step = 9, every = 3,
                     speed = 1.5 }
    screen.flash { to = 0xffe858, over = 12, share = 0.5 }
    bullet.clear { items = "credit" }
    wait(30)
    item.group():pull()
    wait(70)
  end
end

return { run = run, hud = true }
