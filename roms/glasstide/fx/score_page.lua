-- fx/score_page.lua - HOW TO SCORE: a page with an animated picture for each way to score.
local page = {}

local PICTURE <const>, WORDS <const>, WIDTH <const> = 44, 10, 148 -- px; column; px
local APART <const> = 5 -- rows between parts

local function put(sprite_name, x, y, more)
  local s = { sprite = sprite_name, x = x, y = y, screen = true, layer = "over" }
  for k, v in pairs(more or {}) do s[k] = v end
  return sprite.put(s)
end

local function words(row, head, line)
  text.put { col = WORDS, row = row, text = text.lang(head), bank = hud.banks.bright, rim = true }
  text.line { x = 8 * WORDS, y = 8 * row + 10, text = text.lang(line), width = WIDTH,
              screen = true }
end

-- Bullets that pass a craft.
local function graze(y)
  put("heron", PICTURE, y)
  local list = {}
  for i = 1, 3 do list[i] = put("orb", 0, 0, { bank = 1 }) end
  return function(age)
    for i, s in ipairs(list) do
      s.x, s.y = PICTURE + (i % 2 == 0 and 15 or -15), y - 18 + (age + 14 * i) % 42
    end
  end
end

-- Nearby bullets become prisms, which fly to the craft.
local function release(y)
  put("heron", PICTURE, y)
  local list = {}
  for i = 1, 6 do list[i] = put("prism", 0, 0, { bank = 4 }) end
  return function(age)
    local far = math.max(0, 26 - age % 70 // 2)
    for i, s in ipairs(list) do
      s.hidden = far < 4
      s.x, s.y = PICTURE + far * angle.cos(60 * i + age), y + far * angle.sin(60 * i + age) * 0.7
    end
  end
end

local function prisms(y)
  local s = put("prism", PICTURE, y - 7, { bank = 4 })
  return function(age)
    s.y = y - 7 + 2 * angle.sin(4 * age)
    text.put { col = PICTURE // 8 - 2, row = y // 8 + 1, bank = hud.banks.bright, rim = true,
               text = ("x%d.%02d"):format(1 + age // 3 % 200 // 100, age // 3 % 100) }
  end
end

local function chain(y)
  local list = {}
  local name = rom.has("krill") and "krill" or "glint"
  for i = 1, 3 do list[i] = put(name, PICTURE + 18 * (i - 2), y) end
  local flash = put("fire_a", PICTURE, y)
  return function(age)
    local beat = age % 90
    local k = beat // 22 + 1
    for i, s in ipairs(list) do s.hidden = i < k or i == k and beat % 22 > 14 end
    flash.hidden = k > 3 or beat % 22 < 14
    flash.x = PICTURE + 18 * (math.min(k, 3) - 2)
    if beat % 22 == 14 then flash.sprite = "fire_a" end
  end
end

local function pearls(y)
  local list = {}
  for i = 1, 3 do list[i] = put("nacre", PICTURE + 16 * (i - 2), y, { bank = 4 }) end
  return function(age)
    for i, s in ipairs(list) do s.y = y + 4 * angle.sin(3 * age + 60 * i) end
  end
end

local PARTS <const> = {
  { graze, "GRAZE", "Graze bullets to fill the glass." },
  { release, "SPECIAL", "Nearby bullets become prisms." },
  { prisms, "PRISMS", "Each one raises the multiplier." },
  { chain, "CHAIN", "Break enemies without a pause." },
  { pearls, "PEARLS", "Worth up to 10x near the top." },
}

function page.show(row, rows)
  local moves, apart = {}, math.min(APART, rows // #PARTS)
  for i, part in ipairs(PARTS) do
    local at = row + (i - 1) * apart
    words(at, part[2], part[3])
    moves[i] = part[1](at * 8 + 12)
  end
  for age = 0, forever do
    for _, move in ipairs(moves) do move(age) end
    wait(1)
  end
end

return { name = "how_to_score", show = page.show }
