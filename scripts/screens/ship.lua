-- screens/ship.lua - each player's ship, both at once: its picture, a word about it, and figures.
local sys = ... -- functions that only the standard library gets; src/board/api/api_sys.c explains each
local page = sys.read("menu/page")

local SLIDE = 20 -- px from the side that a picture comes
local CELLS <const> = 5 -- of a bar, and icons in a row

local WIDEST = 26      -- cells of a column

local NAME = page.low and 8 or 10 -- rows from a column's top to the ship's name
local TEXT = NAME + 2             -- and to what is told of it

local LIFE, STAR = hud.glyph(137, "*"), hud.glyph(138, "*")
local LEFT, RIGHT = hud.glyph(139, "<"), hud.glyph(140, ">")

-- What is told of each ship: name, sprite, text, figures as { word, cells } each. A ship whose author gives figures,
-- from 1 to 5, has these; else they are what player.def says, as shares of the most that one of the ships has. Of one
-- that needs an unlock nothing is told but the hint.
local function tell(kinds, about)
  local ships, speed, focus, closed = {}, 0, 0, sys.read("boot/records").closed
  for i, kind in ipairs(kinds) do
    local s = sys.ship(kind)
    ships[i], speed, focus = s, math.max(speed, s.speed), math.max(focus, s.focus)
  end
  for i, kind in ipairs(kinds) do
    local s, more = ships[i], about[kind] or {}
    s.name, s.text, s.figures = menu.label(more.title or kind), more.text or "", {}
    for k, f in ipairs(more.figures or {}) do s.figures[k] = { text.lang(f[1]), STAR:rep(f[2]) } end
    if not more.figures then
      s.figures = {
        { text.lang("SPEED"), hud.bar(s.speed, speed, CELLS) }, { text.lang("FOCUS"), hud.bar(s.focus, focus, CELLS) },
        { text.lang("LIVES"), s.lives > CELLS and "x" .. s.lives or LIFE:rep(s.lives) },
      }
      for _, r in ipairs(s.registers) do
        if r.show == "icons" and r.value > 0 then
          s.figures[#s.figures + 1] = { menu.label(r.name), STAR:rep(math.min(r.value, CELLS)) }
        end
      end
    end
    s.closed = closed(s.needs)
    if s.closed then s.name, s.text, s.figures = "? ? ?", s.closed, {} end
  end
  return ships
end

local function column(p, players)
  local col, cols = page.column(p, players, WIDEST)
  return { p = p, switches = players > 1 and p or nil, col = col, cols = cols, at = 1, off = 0, age = 0 }
end

local function draw_figures(c, row, figures, apart)
  local widest = 0
  for _, f in ipairs(figures) do widest = math.max(widest, sys.cells(f[1])) end
  local col = c.col + math.max(1, (c.cols - widest - 1 - CELLS) // 2)
  for i, f in ipairs(figures) do
    local at = row + (i - 1) * apart
    local bank = page.bank(i, c.age, hud.banks.plain)
    if bank then
      hud.put(col, at, f[1], hud.banks.plain)
      hud.put(col + widest + 1, at, f[2], bank)
    end
  end
end

-- Words stand a cell off the plate, which is half a cell narrower than its column on each side.
local function inside(c) return c.col + 1, c.cols - 2 end

-- How many rows the words about a ship take in columns of that width, and a column in all: ships.figures, ships.rows.
-- Of what does not fit into so many rows the lines stand closer: ships.words_apart, ships.apart.
local function measure(ships, cols, room)
  local lines, figures = 0, 0
  for _, s in ipairs(ships) do
    lines = math.max(lines, s.text == "" and 0 or #hud.wrap(text.lang(s.text), cols - 4))
    figures = math.max(figures, #s.figures)
  end
  for tight = 0, 2 do
    ships.words_apart, ships.apart = tight > 0 and 1 or 2, tight > 1 and 1 or 2
    ships.figures = TEXT + (lines > 0 and lines * ships.words_apart + 1 or 0)
    ships.rows = ships.figures + figures * ships.apart
    if ships.rows <= room then return end
  end
end

local function put_plate(c, top, rows)
  c.plate = sprite.plate {
    x = c.col * 8 + 4, y = top * 8 - 12, w = c.cols * 8 - 8, h = rows * 8 + 16, bank = hud.banks.plain,
  }
end

-- All of a column but its picture, in rows from `top` on.
local function draw(c, ships, top, many)
  local s, row = ships[c.at], top + NAME
  page.clear(top, ships.rows, c.col, c.cols)
  if many then page.centre(top, text.lang("PLAYER %d"):format(c.p), hud.banks.plain, c.col, c.cols) end
  local arrows = #ships > 1 and not c.ready
  page.centre(row, (arrows and LEFT .. " %s " .. RIGHT or "%s"):format(s.name), hud.banks.bright, c.col, c.cols)
  local col, cols = inside(c)
  page.text(top + TEXT, s.text, hud.banks.plain, col, cols, ships.words_apart)
  row = top + ships.figures
  if not c.ready then return draw_figures(c, row, s.figures, ships.apart) end
  page.centre(row + 1, "READY", hud.banks.bright, c.col, c.cols)
end

local function draw_picture(c, ships, top)
  local x, y = (2 * c.col + c.cols) * 4, (top + (page.low and 4 or 5)) * 8
  c.picture = c.picture or sprite.put { sprite = ships[c.at].sprite, x = x, y = y, screen = true, layer = "over" }
  c.picture.hidden = ships[c.at].closed ~= nil
  c.off = c.off * 3 // 4
  c.picture.x, c.picture.y = x + c.off, y + (c.ready and 0 or 2 * angle.sin(4 * c.age))
end

-- One frame of a column; false for back.
local function go_on(c, ships)
  local step = c.ready and 0 or page.step("left", "right", c.switches) + page.step("up", "down", c.switches)
  if step ~= 0 then
    c.at, c.off, c.age = (c.at - 1 + step) % #ships + 1, step > 0 and SLIDE or -SLIDE, 0
    c.picture.sprite = ships[c.at].sprite
  elseif page.accepted(c.switches) and not ships[c.at].closed then
    c.ready, c.age = true, 0
  elseif page.pressed("bomb", c.switches) then
    if not c.ready then return false end
    c.ready, c.age = false, 0
  end
  return true
end

-- Until all are ready; false for back, or when nobody answers.
local function choose(columns, ships)
  local top, idle = page.head("YOUR SHIP?", 0), 0
  local room = page.row + page.rows - (page.low and 5 or 7) - top
  measure(ships, columns[1].cols, room)
  top = top + math.max(1, (room - ships.rows) // 3)
  for _, c in ipairs(columns) do
    put_plate(c, top, ships.rows)
    while ships[c.at].closed do c.at = c.at + 1 end
  end
  for age = 0, math.maxinteger do
    if page.opening(age, 0) then
      page.head("YOUR SHIP?", age)
      page.foot("FIRE: OK  BOMB: BACK", age)
    end
    local done = true
    for _, c in ipairs(columns) do
      if page.opening(c.age, 4) then draw(c, ships, top, #columns > 1) end
      draw_picture(c, ships, top)
      done = done and c.ready and c.age > 8 * #columns
    end
    if done then return true end
    sys.tell_keys()
    wait(1)
    idle = idle + 1
    for _, c in ipairs(columns) do
      c.age = c.age + 1
      if not go_on(c, ships) then return false end
      if c.age == 0 then idle = 0 end
    end
    if idle >= page.IDLE then return false end
  end
end

-- kinds: what can be chosen, players: how many choose, about: what boot.run says of some, by name. Returns a list of
-- names, one for each player; nil: back.
return function(kinds, players, about)
  local columns, names = {}, {}
  page.begin()
  for p = 1, players do columns[p] = column(p, players) end
  local done = choose(columns, tell(kinds, about))
  for p, c in ipairs(columns) do
    c.picture:remove()
    c.plate:remove()
    names[p] = kinds[c.at]
  end
  page.done()
  return done and names or nil
end
