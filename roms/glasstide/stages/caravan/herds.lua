-- stages/caravan/herds.lua - the formations of the caravan, easy ones first; they repeat, larger
-- and faster.
local herds = {}

local arch = path.def {
  { x = -20, y = 150 }, { x = 40, y = 70, over = 44, ease = "out" }, { x = 120, y = 44, over = 40 },
  { x = 200, y = 70, over = 40 }, { x = 264, y = 150, over = 44, ease = "in" } }
local loop = path.def {
  { x = 60, y = -20 }, { x = 60, y = 110, over = 56, ease = "out" },
  { x = 120, y = 170, over = 34 },
  { x = 180, y = 110, over = 34 }, { x = 120, y = 60, over = 34 }, { x = 60, y = 110, over = 34 },
  { x = -30, y = 160, over = 50, ease = "in" } }
local fall = path.def { { x = 120, y = -40 }, { x = 120, y = 96, over = 60, ease = "out" },
  { wait = 70 }, { x = 120, y = 380, over = 110, ease = "in" } }
local cross = path.def {
  { x = -30, y = 50 }, { x = 120, y = 110, over = 76, ease = "both" },
  { x = 280, y = 50, over = 76, ease = "both" } }
local snake = path.def {
  { x = 40, y = -20 }, { x = 40, y = 60, over = 36 }, { x = 200, y = 90, over = 60, ease = "both" },
  { x = 40, y = 130, over = 60, ease = "both" }, { x = 260, y = 170, over = 70, ease = "both" } }

-- A shot or two now and then: these creatures only pass through.
local function nip(e)
  wait(rng.int(30, by_difficulty { easy = 70, normal = 74, hard = 50, abyss = 40 }))
  if e.y < 200 and rng.chance(by_difficulty { easy = 0.6, normal = 1 }) then
    pattern.aimed { from = e, kind = "pellet", bank = 7, speed = 1.8, every = 9, delay = 14,
                    n = by_difficulty { easy = 1, hard = 3, abyss = 4 } }
  end
end

local function bloom(e)
  wait(80)
  while true do
    pattern.ring { from = e, kind = "orb", bank = 2, dir = rng.dir(), speed = 1.3,
                   n = by_difficulty { easy = 6, normal = 10, hard = 18, abyss = 26 } }
    wait(by_difficulty { easy = 90, normal = 76, hard = 56, abyss = 44 })
  end
end

local LIST <const> = {
  { kind = "krill", n = 8, every = 10, path = arch, both = true },
  { kind = "krill", n = 9, every = 0, path = fall, formation = "v", gap = 20 },
  { kind = "fish", n = 6, every = 12, path = loop },
  { kind = "krill", n = 14, every = 8, path = snake },
  { kind = "ray", n = 3, every = 30, path = cross, dy = 16, both = true },
  { kind = "krill", n = 12, every = 0, path = fall, formation = "circle", gap = 22 },
  { kind = "fish", n = 6, every = 12, path = loop, both = true },
  { kind = "jelly", n = 3, every = 0, path = fall, formation = "line", gap = 64, run = bloom },
  { kind = "krill", n = 16, every = 7, path = arch, both = true },
  { kind = "fish", n = 9, every = 0, path = fall, formation = "v", gap = 24 },
}

-- Sends the k-th herd; a long streak makes it longer and denser. Returns its number of creatures.
function herds.send(k, streak, tag)
  local h, n = LIST[(k - 1) % #LIST + 1], 0
  for side = 1, h.both and 2 or 1 do
    local many = h.n + (h.every > 0 and math.min(streak // 4, 6) or 0)
    local every = h.every > 0 and math.max(5, h.every - streak // 3) or 0
    stage.wave { kind = h.kind, n = many, every = every, path = h.path,
                 formation = h.formation, gap = h.gap, dy = h.dy,
                 mirror = side == 2 or not h.both and k % 2 == 0, tag = tag, run = h.run or nip }
    n = n + many
  end
  return n
end

return herds
