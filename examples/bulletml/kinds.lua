-- kinds.lua - the bullet kinds. Each shape has eight colours, petal0 to petal7: pearl, ruby, amber, gold, green, cyan,
-- indigo, magenta. `looks` maps labels to kinds, for all documents; other labels get kinds from `others` in order.
local round = { pellet = 2, orb = 3.5, star = 4, ring = 5, pearl = 6, big = 8 }
local long = { rice = 5, petal = 4, shard = 4, drop = 4, kunai = 4, needle = 8 } -- length
spark.def("hoop", { sprite = "hoop", life = 12 })

for bank = 0, 7 do
  for name, radius in pairs(round) do
    bullet.def(name .. bank, { sprite = name, bank = bank, hit = { circle = radius }, vanish = "hoop" })
  end
  for name, length in pairs(long) do
    bullet.def(name .. bank, { sprite = name, bank = bank, hit = { capsule = { length, 1.5 } }, turns = true,
      vanish = "hoop" })
  end
end

local looks = {
  petal = "petal7", pollen = "orb3", hour = "ring2", minute = "rice4", second = "needle5", chime = "star3",
  flake = "star0", crystal = "big5", needle = "needle5", frost = "pellet0", kite = "big1", knot = "shard2",
  seed = "star0", stalk = "rice4", drop = "drop5", crest = "pearl0", shuttle = "big3", thread = "rice6",
  weft = "kunai1", planet = "pearl2", moon = "orb6", rain = "drop0", wave = "orb5", quill = "rice4", eye = "ring6",
  fish = "petal5", horse = "kunai7", lamp = "orb2", log = "big1", spark = "pellet2", coal = "orb1", fold = "shard7",
  crane = "petal0", beam = "needle3", moth = "petal2", gull = "pearl0", feather = "petal5",
}
local others = { "orb5", "rice7", "petal1", "star3", "kunai6", "drop4", "pearl2", "shard0", "ring7", "needle1" }

return function(labels)
  local kinds, n = {}, 0
  for i = 1, math.min(#labels, 64) do
    local label = labels[i]
    if not looks[label] then n = n + 1 end
    kinds[label] = looks[label] or others[(n - 1) % #others + 1]
  end
  return kinds
end
