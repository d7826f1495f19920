-- boot/how_to_play.lua - the library's pages of How to Play. They show the game's first ship and a bullet of the game.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each

local SPEED <const> = 1.5 -- of the bullets, px per frame

local function move(area)
  area.ship()
  area.play(30)
  for _, way in ipairs { "left", "right", "right", "left", "up", "down" } do area.play(12, way) end
end

local function fire(area)
  area.ship()
  area.play(80, "fire")
  area.play(30)
end

local function focus(area)
  area.ship()
  for _, way in ipairs { "left", "right" } do
    area.play(40, way, "fire", "focus")
    area.play(20, "fire")
    area.play(40, way == "left" and "right" or "left", "fire", "focus")
  end
end

local function bullets(area, kind, n)
  for i = 1, n do bullet.fire { kind = kind, x = area.w * i // (n + 1), y = area.y, dir = 90, speed = SPEED } end
end

local function bomb(kind)
  return function(area)
    area.ship()
    for _ = 1, kind and 4 or 0 do
      bullets(area, kind, 6)
      area.play(12)
    end
    area.play(1, "bomb")
    area.play(150)
  end
end

-- Bullets that pass the ship inside its graze circle.
local function graze(kind, radius)
  return function(area)
    area.ship()
    for i = 1, 6 do
      local side = i % 2 == 0 and 1 or -1
      bullet.fire { kind = kind, x = area.w // 2 + side * radius, y = area.y, dir = 90, speed = SPEED }
      area.play(24)
    end
    area.play(40)
  end
end

local ARROWS <const> = hud.glyph(139, "<") .. hud.glyph(150, "^") .. hud.glyph(151, "v") .. hud.glyph(140, ">")

-- The library's pages by name, in order; only what the ship can do.
local function own_pages(ship, kind)
  local list = {
    { name = "move", title = "Move", text = text.lang("Move in all eight directions.") .. " " .. ARROWS, show = move },
    { name = "fire", title = "Fire", button = "fire", text = "Hold Fire to shoot.", show = fire },
    { name = "focus", title = "Focus", button = "focus", show = focus,
      text = "Hold Focus to fly slowly. Only the middle of your ship can be hit." },
  }
  if ship.bomb then
    list[4] = { name = "bomb", title = "Bomb", button = "bomb", text = "A bomb saves you when you are cornered.",
                show = bomb(kind) }
  end
  if ship.graze > 0 and kind then
    list[#list + 1] = { name = "graze", title = "Graze", text = "Let bullets pass close by: each one is a graze.",
                        show = graze(kind, ship.graze) }
  end
  return list
end

-- a: the arguments of boot.run. Returns the list of pages; names in the game's list stand for the library's pages.
return function(a)
  local own = own_pages(sys.ship(a.kinds[1]), sys.kinds("bullet")[1])
  if not a.how_to_play then return own end
  local list, by_name = {}, {}
  for _, p in ipairs(own) do by_name[p.name] = p end
  for _, p in ipairs(a.how_to_play) do list[#list + 1] = type(p) == "table" and p or by_name[p] end
  return list
end
