-- looks.lua - a demo stage for looks: bullets of several sizes, with spin, frames, order, clouds and hp; sprites that are
-- turned, scaled and faded.
local names = { "rice_50", "rice", "rice_150", "rice_200", "star_50", "star", "star_150", "star_300" }
for i, name in ipairs(names) do
  bullet.def("look_" .. name, { sprite = name, hit = "none", graze = false, spin = name:find("rice") and 4 or 0, bank = i % 7 })
end
bullet.def("look_seed", { sprite = "orb", hit = { circle = 4 }, bank = 2, cloud = "halo", vanish = "glint" })
bullet.def("look_moon", { sprite = "big", hit = { circle = 9 }, bank = 5, order = 1, hp = 20, score = 100, spark = "glint" })

stage.def("looks", function()
  for i, name in ipairs(names) do
    bullet.fire { kind = "look_" .. name, x = 25 * i - 8, y = 40, speed = 0 }
  end
  for i = 0, 8 do -- turned, scaled and faded
    sprite.put { sprite = "dart", x = 24 * i + 24, y = 250, dir = 40 * i, scale = 1.5 }
    sprite.put { sprite = "jelly", x = 24 * i + 24, y = 290, scale = 0.25 + i / 8, alpha = i }
  end
  for i = 1, 3 do bullet.fire { kind = "look_moon", x = 60 * i, y = 200, speed = 0 } end
  for i = 0, forever do
    for k = 1, 8 do
      bullet.fire { kind = "look_seed", x = 27 * k, y = 100, dir = 90 + 9 * (i % 5 - 2), speed = 1.2, delay = 10 * k }
    end
    wait(100)
  end
end)
